// The parts of the printed file: head, types, the machine, routines, drives.
#include <string.h>
#include "code/file.h"
#include "model/load.h"

static const char *real_of(const YkFile *file)
{
    return file->single ? "float" : "double";
}

// --- head
// ----------------------------------------------------------------------------------------------------------------

static void write_fixed(YkFile *file)
{
    const YkModel *m = file->program.model;
    bool any = false;
    for (size_t k = 0; k < m->parameter_count; k++) {
        if (!file->program.is_fixed[k]) continue;
        yk_text_format(&file->text, "%s%s = %g",
                       any ? ", " : "\n   Fixed, since laws or gears hang on them: ", m->parameters[k].name,
                       m->parameters[k].value);
        any = true;
    }
    if (any) yk_text_puts(&file->text, ".\n");
}

void yk_file_write_head(YkFile *file)
{
    const YkModel *m = file->program.model;
    YkText *out = &file->text;
    char *name = yk_program_text(&file->program, "%s", m->name); // must not end the comment
    for (char *c = name; *c; c++)
        if (*c == '*' && c[1] == '/') *c = ' ';
    yk_text_format(out, "/* %s\n\n", name);
    yk_file_template(
        file,
        "   C11 for this machine, printed by `yoke code`. SI units and radians throughout. Needs the C library's "
        "<math.h>\n"
        "   alone; allocates nothing, has no variables outside functions.\n\n"
        "       @_parameters p = @_defaults();         dimensions, masses ...: change what you like\n"
        "       @_machine m = @_prepare(&p);           what hangs on them alone, computed once\n"
        "       @_configuration c = @_start();         which way it is assembled\n"
        "       @_inputs in = {0};                     its independent coordinates, with rates and accelerations\n");
    if (file->drive_count > 0)
        yk_file_template(file, "       @_drives(&m, t, &in);                  as the file's drives move it\n");
    if (file->routine_count > 0)
        yk_text_format(out, "       %s_%s out;\n       int status = %s_find_%s(&m, &c, &in, &out);\n", file->prefix,
                       file->routines[0].name, file->prefix, file->routines[0].name);
    yk_file_template(
        file,
        "\n   Every function of a pose has a `_batch` over arrays; some have `_designs`, over arrays of parameters "
        "too. Loops\n"
        "   over arrays vectorise with `-O3 -march=native -fno-math-errno -fno-trapping-math`; never use -ffast-math.\n"
        "   In other source files: #define @_DECLARATIONS_ONLY before including this one.\n"
        "   With -D@_TEST the file is a program that tests itself against poses that yoke computed.\n");
    if (file->has_forces && m->stop_count > 0)
        yk_text_puts(out, "\n   Stops are not part of it: coordinates go on beyond them.\n");
    if (file->has_forces && file->forces.why_no_reactions)
        yk_text_format(out, "\n   Reactions are not part of it: %s.\n", file->forces.why_no_reactions);
    write_fixed(file);
    yk_text_puts(out, "*/\n");
}

// --- types
// ---------------------------------------------------------------------------------------------------------------

static void member(YkFile *file, const char *name, const char *comment)
{
    YkText line = {0};
    yk_text_format(&line, "    %s %s;", real_of(file), name);
    if (comment && *comment) {
        yk_text_repeat(&line, ' ', line.length < 34 ? 34 - line.length : 1);
        yk_text_format(&line, "/* %s */", comment);
    }
    yk_text_format(&file->text, "%s\n", yk_text_get(&line));
    yk_text_free(&line);
}

static const char *parameter_unit(const YkParameter *p)
{
    const struct {
        YkDimension dimension;
        const char *unit;
    } units[] = {{YK_DIM_LENGTH, "m"},         {YK_DIM_ANGLE, "rad"},          {YK_DIM_TIME, "s"},
                 {YK_DIM_MASS, "kg"},          {YK_DIM_INERTIA, "kg m^2"},     {YK_DIM_SPEED, "m/s"},
                 {YK_DIM_ANGLE_RATE, "rad/s"}, {YK_DIM_ACCELERATION, "m/s^2"}, {YK_DIM_ANGLE_ACCELERATION, "rad/s^2"},
                 {YK_DIM_FORCE, "N"},          {YK_DIM_TORQUE, "N m"}};
    for (size_t k = 0; k < sizeof units / sizeof *units; k++)
        if (yk_dimension_equal(units[k].dimension, p->dimension)) return units[k].unit;
    return "SI";
}

static bool is_own(const YkFile *file, size_t parameter)
{
    const YkValue *v = &file->program.graph.values[file->program.parameter[parameter]];
    return v->op == YK_VALUE_LEAF;
}

static size_t own_parameters(const YkFile *file)
{
    size_t count = 0;
    for (size_t k = 0; k < file->program.model->parameter_count; k++) count += is_own(file, k);
    return count;
}

static void write_parameters(YkFile *file)
{
    const YkModel *m = file->program.model;
    yk_file_template(file, "/* Parameters of the model file. Those that follow from others are computed from them. */\n"
                           "typedef struct @_parameters {\n");
    for (size_t k = 0; k < m->parameter_count; k++)
        if (is_own(file, k))
            member(file, yk_program_name(&file->program, m->parameters[k].name), parameter_unit(&m->parameters[k]));
    if (own_parameters(file) == 0) member(file, "none", "a struct cannot be empty");
    yk_file_template(file, "} @_parameters;\n\n");
}

static void write_machine_type(YkFile *file)
{
    YkPrinter *pr = &file->printer;
    yk_file_template(
        file, "/* Parameters, and what hangs on them alone. */\ntypedef struct @_machine {\n    @_parameters p;\n");
    for (size_t k = 0; k < pr->field_count; k++) member(file, pr->field[pr->fields[k]], NULL);
    yk_file_template(file, "} @_machine;\n\n");
}

static void write_notes(YkFile *file, const char *about, const char *type, const YkLeafNote *notes, size_t count)
{
    yk_text_format(&file->text, "/* %s */\ntypedef struct %s_%s {\n", about, file->prefix, type);
    for (size_t k = 0; k < count; k++) {
        const char *name = notes[k].name;
        if (notes[k].count > 0) name = yk_program_text(&file->program, "%s[%d]", name, (int)notes[k].count);
        member(file, name, notes[k].comment);
    }
    if (count == 0) member(file, "none", "a struct cannot be empty");
    yk_text_format(&file->text, "} %s_%s;\n\n", file->prefix, type);
}

static void pointers(YkFile *file, const char *type, const char *quality, const YkResult *results, size_t count,
                     const YkLeafNote *notes)
{
    yk_text_format(&file->text, "typedef struct %s_%s_arrays {\n", file->prefix, type);
    for (size_t k = 0; k < count; k++)
        yk_text_format(&file->text, "    %s%s *%s;\n", quality, real_of(file),
                       results ? results[k].name : notes[k].name);
    if (count == 0) yk_text_format(&file->text, "    %s *none;\n", real_of(file));
    yk_text_format(&file->text, "} %s_%s_arrays;\n\n", file->prefix, type);
}

static void write_parameter_arrays(YkFile *file)
{
    const YkModel *m = file->program.model;
    yk_file_template(file,
                     "/* For `_designs`: an array for each parameter. */\ntypedef struct @_parameters_arrays {\n");
    for (size_t k = 0; k < m->parameter_count; k++)
        if (is_own(file, k))
            yk_text_format(&file->text, "    const %s *%s;\n", real_of(file),
                           yk_program_name(&file->program, m->parameters[k].name));
    yk_file_template(file, "} @_parameters_arrays;\n\n");
}

static void prototype(YkFile *file, const YkRoutine *r, const char *ending)
{
    yk_text_format(&file->text,
                   "int %s_find_%s(const %s_machine *m, const %s_configuration *c, const %s_inputs *in, %s_%s *out)%s",
                   file->prefix, r->name, file->prefix, file->prefix, file->prefix, file->prefix, r->name, ending);
}

static void prototype_many(YkFile *file, const YkRoutine *r, bool designs, const char *ending)
{
    const char *p = file->prefix;
    yk_text_format(&file->text,
                   "void %s_find_%s_%s(size_t n, const %s_%s *%s, const %s_configuration *c,\n    const "
                   "%s_inputs_arrays *in, const %s_%s_arrays *out, signed char *status)%s",
                   p, r->name, designs ? "designs" : "batch", p, designs ? "parameters_arrays" : "machine",
                   designs ? "p" : "m", p, p, p, r->name, ending);
}

static void write_prototypes(YkFile *file)
{
    yk_file_template(file, "@_parameters @_defaults(void); /* the file's values */\n"
                           "@_machine @_prepare(const @_parameters *p);\n"
                           "@_configuration @_start(void); /* as `start:` has it */\n");
    if (file->drive_count > 0) yk_file_template(file, "void @_drives(const @_machine *m, $ t, @_inputs *in);\n");
    for (size_t k = 0; k < file->routine_count; k++) {
        const YkRoutine *r = &file->routines[k];
        yk_text_format(&file->text,
                       "\n/* %s\n   They return, or give for each pose, a status; n poses, arrays of n. */\n",
                       r->about);
        prototype(file, r, ";\n");
        prototype_many(file, r, false, ";\n");
        if (r->has_designs && own_parameters(file) > 0) prototype_many(file, r, true, ";\n");
    }
    yk_file_declare_residuals(file);
}

void yk_file_write_types(YkFile *file)
{
    yk_file_template(file, "#ifndef @_DECLARED\n#define @_DECLARED\n#include <stddef.h>\n\n");
    yk_file_template(file,
                     "/* What a call says of its outcome. Below 0 the results mean nothing and may be no numbers. */\n"
                     "enum {\n"
                     "    @_OK = 0,\n"
                     "    @_SINGULAR = 3,       /* a dead point, or a freedom without inertia: places stand, rates and "
                     "forces do not */\n"
                     "    @_LIMIT = -1,         /* past a limit position: this configuration does not close here */\n"
                     "    @_NO_ASSEMBLY = -2,   /* a loop that repeats others does not close */\n"
                     "    @_NOT_CONVERGED = -3, /* Newton's method did not reach its tolerance */\n"
                     "    @_BAD_INPUT = -5,     /* an input is no finite number, or an angle is beyond 1e5 rad */\n"
                     "    @_NOT_FINITE = -8     /* a load has no finite value here */\n"
                     "};\n\n");
    write_parameters(file);
    write_machine_type(file);
    write_notes(file, "How the machine is assembled.", "configuration", file->configuration, file->configuration_count);
    write_notes(file, "The independent coordinates of a pose.", "inputs", file->inputs, file->input_count);
    pointers(file, "inputs", "const ", NULL, file->input_count, file->inputs);
    if (own_parameters(file) > 0) write_parameter_arrays(file);
    for (size_t k = 0; k < file->routine_count; k++) {
        const YkRoutine *r = &file->routines[k];
        yk_text_format(&file->text, "/* %s */\ntypedef struct %s_%s {\n", r->about, file->prefix, r->name);
        for (size_t i = 0; i < r->count; i++) member(file, r->results[i].name, r->results[i].comment);
        yk_text_format(&file->text, "} %s_%s;\n\n", file->prefix, r->name);
        pointers(file, r->name, "", r->results, r->count, NULL);
    }
    write_prototypes(file);
    yk_file_template(file, "#endif\n\n");
}

// --- the machine
// ---------------------------------------------------------------------------------------------------------

static void write_defaults(YkFile *file)
{
    const YkModel *m = file->program.model;
    YkText *out = &file->text;
    yk_file_template(file, "@_parameters @_defaults(void)\n{\n    const @_parameters p = {\n");
    for (size_t k = 0; k < m->parameter_count; k++) {
        if (!is_own(file, k)) continue;
        yk_text_format(out, "        .%s = ", yk_program_name(&file->program, m->parameters[k].name));
        yk_printer_number(&file->printer, m->parameters[k].value);
        yk_text_puts(out, ",\n");
    }
    if (own_parameters(file) == 0) yk_text_puts(out, "        .none = 0,\n");
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

// --- routines
// ------------------------------------------------------------------------------------------------------------

static void line(YkFile *file, const char *before, YkRef value, const char *after)
{
    yk_text_puts(&file->text, before);
    yk_printer_value(&file->printer, value);
    yk_text_puts(&file->text, after);
}

static void write_checks(YkFile *file, const YkRoutine *r)
{
    YkProgram *p = &file->program;
    YkDag *g = &p->graph;
    const char *name = file->prefix;
    YkText *out = &file->text;
    bool has_gap = !yk_dag_is_number(g, p->gap, 0), has_groups = !yk_dag_is_number(g, p->missed, 0);
    yk_text_format(out, "\n    /* How it went. */\n    const %s margin = ", real_of(file));
    yk_printer_value(&file->printer, p->margin);
    yk_text_puts(out, ";\n");
    line(file, yk_program_text(p, "    const %s witness = ", real_of(file)), r->witness, ";\n");
    if (r->checks_results) {
        yk_text_format(out, "    const %s finite = 0", real_of(file));
        for (size_t k = 0; k < r->count; k++) yk_text_format(out, " + 0 * out->%s", r->results[k].name);
        yk_text_puts(out, ";\n");
    }
    yk_text_puts(out, "    return ");
    if (has_groups) {
        yk_text_format(out, "!(");
        yk_printer_value(&file->printer, p->missed);
        yk_text_format(out, " <= 1) ? %s_NOT_CONVERGED\n        : ", name);
    }
    yk_text_format(out, "!(margin >= %s) ? %s_LIMIT\n", file->single ? "-1e-6f" : "-1e-13", name);
    yk_text_format(out, "        : !(witness == 0) ? %s_BAD_INPUT\n", name);
    if (has_gap) {
        yk_text_puts(out, "        : !(");
        yk_printer_value(&file->printer, p->gap);
        yk_text_puts(out, " <= ");
        yk_printer_number(&file->printer, yk_program_size(p));
        yk_text_format(out, file->single ? " * (1e-5f + 1e-7f / sqrtf(margin > 1e-7f ? margin : 1e-7f))"
                                         : " * (1e-12 + 4e-16 / sqrt(margin > 1e-14 ? margin : 1e-14))");
        yk_text_format(out, ") ? %s_NO_ASSEMBLY\n", name);
    }
    yk_text_format(out, "        : !(margin > %s) ? %s_SINGULAR\n", file->single ? "1e-7f" : "1e-14", name);
    if (r->regular >= 0) {
        yk_text_puts(out, "        : !(");
        yk_printer_value(&file->printer, r->regular);
        yk_text_format(out, " > 0) ? %s_SINGULAR\n", name);
    }
    if (r->checks_results) yk_text_format(out, "        : !(finite == 0) ? %s_NOT_FINITE\n", name);
    yk_text_format(out, "        : %s_OK;\n}\n\n", name);
}

static size_t gather_roots(const YkFile *file, const YkRoutine *r, YkRef *roots)
{
    const YkProgram *p = &file->program;
    size_t count = 0;
    for (size_t k = 0; k < r->count; k++) roots[count++] = r->results[k].value;
    roots[count++] = p->margin;
    roots[count++] = r->witness;
    roots[count++] = p->gap;
    roots[count++] = p->missed;
    if (r->regular >= 0) roots[count++] = r->regular;
    return count;
}

size_t yk_file_roots(const YkFile *file, const YkRoutine *r, YkRef *roots)
{
    return gather_roots(file, r, roots);
}

static void write_kernel(YkFile *file, const YkRoutine *r)
{
    YkRef *roots = YK_NEW(file->program.arena, YkRef, r->count + 8);
    if (!roots) {
        file->program.failed = true;
        return;
    }
    size_t count = gather_roots(file, r, roots);
    yk_text_format(&file->text, "/* %s */\n", r->about);
    yk_text_format(&file->text,
                   "%s_INLINE int %s_%s_of(const %s_machine *m, const %s_configuration *c, const %s_inputs *in,\n    "
                   "%s_%s *out)\n{\n    (void)m;\n    (void)c;\n    (void)in;\n",
                   file->prefix, file->prefix, r->name, file->prefix, file->prefix, file->prefix, file->prefix,
                   r->name);
    yk_printer_body(&file->printer, roots, count);
    yk_text_puts(&file->text, "\n    /* Results. */\n");
    for (size_t k = 0; k < r->count; k++)
        line(file, yk_program_text(&file->program, "    out->%s = ", r->results[k].name), r->results[k].value, ";\n");
    write_checks(file, r);
}

// Does the routine use this input?
static bool uses_leaf(const YkFile *file, const char *name)
{
    const YkDag *g = &file->program.graph;
    for (size_t k = 0; k < g->count; k++)
        if (g->values[k].op == YK_VALUE_LEAF && strcmp(g->values[k].name, name) == 0) return file->printer.count[k] > 0;
    return false;
}

static void write_many(YkFile *file, const YkRoutine *r, const bool *used, bool designs)
{
    YkText *out = &file->text;
    YkProgram *p = &file->program;
    const char *real = real_of(file);
    prototype_many(file, r, designs, "\n{\n");
    for (size_t k = 0; k < file->input_count; k++)
        if (used[k])
            yk_text_format(out, "    const %s *restrict in_%s = in->%s;\n", real, file->inputs[k].name,
                           file->inputs[k].name);
    for (size_t k = 0; designs && k < p->model->parameter_count; k++)
        if (is_own(file, k)) {
            const char *name = yk_program_name(p, p->model->parameters[k].name);
            yk_text_format(out, "    const %s *restrict p_%s = p->%s;\n", real, name, name);
        }
    for (size_t k = 0; k < r->count; k++)
        yk_text_format(out, "    %s *restrict out_%s = out->%s;\n", real, r->results[k].name, r->results[k].name);
    if (!designs) yk_text_format(out, "    const %s_machine machine = *m;\n", file->prefix);
    yk_text_format(out,
                   "    const %s_configuration configuration = *c;\n    (void)in;\n    %s_EACH\n    for (size_t i = 0; "
                   "i < n; i++) {\n",
                   file->prefix, file->prefix);
    if (designs) {
        yk_text_format(out, "        const %s_parameters own = {", file->prefix);
        bool first = true;
        for (size_t k = 0; k < p->model->parameter_count; k++)
            if (is_own(file, k)) {
                const char *name = yk_program_name(p, p->model->parameters[k].name);
                yk_text_format(out, "%s.%s = p_%s[i]", first ? "" : ", ", name, name);
                first = false;
            }
        yk_text_format(out, "};\n        const %s_machine machine = %s_prepared(&own);\n", file->prefix, file->prefix);
    }
    yk_text_format(out, "        %s_inputs pose;\n        %s_%s found;\n", file->prefix, file->prefix, r->name);
    for (size_t k = 0; k < file->input_count; k++)
        if (used[k]) yk_text_format(out, "        pose.%s = in_%s[i];\n", file->inputs[k].name, file->inputs[k].name);
    yk_text_format(out, "        status[i] = (signed char)%s_%s_of(&machine, &configuration, &pose, &found);\n",
                   file->prefix, r->name);
    for (size_t k = 0; k < r->count; k++)
        yk_text_format(out, "        out_%s[i] = found.%s;\n", r->results[k].name, r->results[k].name);
    yk_text_puts(out, "    }\n}\n\n");
}

void yk_file_write_routine(YkFile *file, const YkRoutine *r)
{
    bool *used = YK_NEW(file->program.arena, bool, file->input_count + 1);
    write_kernel(file, r);
    if (!used) {
        file->program.failed = true;
        return;
    }
    for (size_t k = 0; k < file->input_count; k++)
        used[k] = uses_leaf(file, yk_program_text(&file->program, "in->%s", file->inputs[k].name));
    prototype(file, r, "\n{\n");
    yk_text_format(&file->text, "    return %s_%s_of(m, c, in, out);\n}\n\n", file->prefix, r->name);
    write_many(file, r, used, false);
    if (r->has_designs && own_parameters(file) > 0) write_many(file, r, used, true);
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
        line(file, yk_program_text(&file->program, "    in->%s = ", file->drives[k].name), roots[k], ";\n");
    yk_text_puts(&file->text, "}\n\n");
}
