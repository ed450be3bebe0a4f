// Writes the head of the printed file: what it is, how to use it, what it leaves out.
#include "code/file.h"

static void write_fixed(YkFile *file)
{
    const YkModel *m = file->program.model;
    bool any = false;
    for (size_t k = 0; k < m->parameter_count; k++) {
        if (!file->program.is_fixed[k]) continue;
        yk_text_format(&file->text, "%s%s = %g",
                       any ? ", " : "\n   Fixed, since laws or gears depend on them: ", m->parameters[k].name,
                       m->parameters[k].value);
        any = true;
    }
    if (any) yk_text_puts(&file->text, ".\n");
}

void yk_file_write_head(YkFile *file)
{
    const YkModel *m = file->program.model;
    YkText *out = &file->text;
    char *name = yk_graph_text(&file->program.graph, "%s", m->name); // must neither end the comment nor begin another
    for (char *c = name; *c; c++)
        if ((*c == '*' && c[1] == '/') || (*c == '/' && c[1] == '*')) *c = ' ';
    yk_text_format(out, "/* %s\n\n", name);
    yk_file_template(
        file,
        "   C11 for this machine, printed by `yoke code`. SI units and radians throughout. Needs the C library's "
        "<math.h>\n"
        "   alone; allocates nothing, has no variables outside functions.\n\n"
        "       @_parameters p = @_defaults();         dimensions, masses ...: change what you like\n"
        "       @_machine m = @_prepare(&p);           what depends only on them, computed once\n"
        "       @_configuration c = @_start();         how it is assembled\n"
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
        "   In other source files, of C or C++: #define @_DECLARATIONS_ONLY before including this one.\n"
        "   With -D@_TEST the file is a program that tests itself against poses that yoke computed.\n");
    if (m->engaged) yk_text_format(out, "\n   Its lock %s is engaged.\n", m->engaged);
    if (file->has_forces && m->stop_count > 0)
        yk_text_puts(out, "\n   Stops are not part of it: coordinates go on beyond them.\n");
    if (file->has_forces && file->forces.why_no_reactions)
        yk_text_format(out, "\n   Reactions are not part of it: %s.\n", file->forces.why_no_reactions);
    if (file->has_forces && file->forces.is_least)
        yk_text_puts(out, "\n   Constraints repeat others: of all reactions that balance the machine, those of least "
                          "norm are found,\n"
                          "   with couples over the machine's size.\n");
    if (file->has_forces && file->forces.is_least && m->follow_count > 0)
        yk_text_puts(out, "   The efforts of drives that follow laws are not part of it: they may be any.\n");
    if (file->is_of_file)
        yk_text_puts(out, "\n   The parameters' values are special: near them the machine has other "
                          "constraints. What is 0 or\n"
                          "   cancels at these values is assumed to stay so.\n");
    write_fixed(file);
    yk_text_puts(out, "*/\n");
}
