// Writes the machine of the printed file: its values, what depends on them, how it starts, how its drives move it.
#include "code/file.h"

void yk_file_line(YkFile *file, const char *before, YkRef value, const char *after)
{
    yk_text_puts(&file->text, before);
    yk_printer_value(&file->printer, value);
    yk_text_puts(&file->text, after);
}

static void write_defaults(YkFile *file)
{
    const YkModel *m = file->program.model;
    YkText *out = &file->text;
    yk_file_template(file, "@_parameters @_defaults(void)\n{\n    const @_parameters p = {\n");
    for (size_t k = 0; k < m->parameter_count; k++) {
        if (!yk_file_is_own(file, k)) continue;
        yk_text_format(out, "        .%s = ", file->program.names.parameter[k]);
        yk_printer_number(&file->printer, m->parameters[k].value);
        yk_text_puts(out, ",\n");
    }
    if (yk_file_own_parameters(file) == 0) yk_text_puts(out, "        .none = 0,\n");
    yk_text_puts(out, "    };\n    return p;\n}\n\n");
}

static void write_start(YkFile *file)
{
    YkText *out = &file->text;
    yk_file_template(file, "@_configuration @_start(void)\n{\n    const @_configuration c = {\n");
    for (size_t k = 0; k < file->configuration_count; k++) {
        const YkLeafNote *n = &file->configuration[k];
        yk_text_format(out, "        .%s = ", n->name);
        if (n->count == 0) {
            yk_printer_number(&file->printer, n->value);
        } else {
            yk_text_puts(out, "{");
            for (size_t i = 0; i < n->count; i++) {
                if (i > 0) yk_text_puts(out, ", ");
                yk_printer_number(&file->printer, file->state->groups.x[(size_t)n->value + i]);
            }
            yk_text_puts(out, "}");
        }
        yk_text_puts(out, ",\n");
    }
    if (file->configuration_count == 0) yk_text_puts(out, "        .none = 0,\n");
    yk_text_puts(out, "    };\n    return c;\n}\n\n");
}

static const char inline_prepare[] = "@_INLINE @_machine @_prepared(const @_parameters *p)\n{\n    @_machine machine;\n"
                                     "    machine.p = *p;\n";

void yk_file_write_machine(YkFile *file)
{
    write_defaults(file);
    yk_file_template(file, inline_prepare);
    yk_printer_machine(&file->printer);
    yk_file_template(file, "    return machine;\n}\n\n"
                           "@_machine @_prepare(const @_parameters *p)\n{\n    return @_prepared(p);\n}\n\n");
    write_start(file);
}

void yk_file_write_drives(YkFile *file)
{
    YkRef *roots = YK_NEW(file->program.arena, YkRef, file->drive_count + 1);
    if (file->drive_count == 0 || !roots) return;
    for (size_t k = 0; k < file->drive_count; k++) roots[k] = file->drives[k].value;
    yk_file_template(file, "/* The inputs at a time, as the file's drives move them. */\n"
                           "void @_drives(const @_machine *m, $ t, @_inputs *in)\n{\n    (void)m;\n    in->t = t;\n");
    yk_printer_body(&file->printer, roots, file->drive_count);
    for (size_t k = 0; k < file->drive_count; k++)
        yk_file_line(file, yk_graph_text(&file->program.graph, "    in->%s = ", file->drives[k].name), roots[k], ";\n");
    yk_text_puts(&file->text, "}\n\n");
}
