// Writes the types of the printed file, and the prototypes of its functions.
#include "code/file.h"
#include "model/load.h"

bool yk_file_is_own(const YkFile *file, size_t parameter)
{
    const YkValue *v = &file->program.graph.values[file->program.parameter[parameter]];
    return v->op == YK_VALUE_LEAF;
}

size_t yk_file_own_parameters(const YkFile *file)
{
    size_t count = 0;
    for (size_t k = 0; k < file->program.model->parameter_count; k++) count += yk_file_is_own(file, k);
    return count;
}

// --- types

static void member(YkFile *file, const char *name, const char *comment)
{
    YkText line = {0};
    yk_text_format(&line, "    %s %s;", yk_file_real(file), name);
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

static void write_parameters(YkFile *file)
{
    const YkModel *m = file->program.model;
    yk_file_template(file, "/* Parameters of the model file. Those that follow from others are computed from them. */\n"
                           "typedef struct @_parameters {\n");
    for (size_t k = 0; k < m->parameter_count; k++)
        if (yk_file_is_own(file, k)) member(file, file->program.names.parameter[k], parameter_unit(&m->parameters[k]));
    if (yk_file_own_parameters(file) == 0) member(file, "none", "a struct cannot be empty");
    yk_file_template(file, "} @_parameters;\n\n");
}

static void write_machine_type(YkFile *file)
{
    YkPrinter *pr = &file->printer;
    yk_file_template(
        file, "/* Parameters, and what depends only on them. */\ntypedef struct @_machine {\n    @_parameters p;\n");
    for (size_t k = 0; k < pr->field_count; k++) member(file, pr->field[pr->fields[k]], NULL);
    yk_file_template(file, "} @_machine;\n\n");
}

static void write_notes(YkFile *file, const char *about, const char *type, const YkLeafNote *notes, size_t count)
{
    yk_text_format(&file->text, "/* %s */\ntypedef struct %s_%s {\n", about, file->prefix, type);
    for (size_t k = 0; k < count; k++) {
        const char *name = notes[k].name;
        if (notes[k].count > 0) name = yk_graph_text(&file->program.graph, "%s[%d]", name, (int)notes[k].count);
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
        yk_text_format(&file->text, "    %s%s *%s;\n", quality, yk_file_real(file),
                       results ? results[k].name : notes[k].name);
    if (count == 0) yk_text_format(&file->text, "    %s *none;\n", yk_file_real(file));
    yk_text_format(&file->text, "} %s_%s_arrays;\n\n", file->prefix, type);
}

static void write_parameter_arrays(YkFile *file)
{
    const YkModel *m = file->program.model;
    yk_file_template(file,
                     "/* For `_designs`: an array for each parameter. */\ntypedef struct @_parameters_arrays {\n");
    for (size_t k = 0; k < m->parameter_count; k++)
        if (yk_file_is_own(file, k))
            yk_text_format(&file->text, "    const %s *%s;\n", yk_file_real(file), file->program.names.parameter[k]);
    yk_file_template(file, "} @_parameters_arrays;\n\n");
}

// --- prototypes

void yk_file_prototype(YkFile *file, const YkRoutine *r, const char *ending)
{
    yk_text_format(&file->text,
                   "int %s_find_%s(const %s_machine *m, const %s_configuration *c, const %s_inputs *in, %s_%s *out)%s",
                   file->prefix, r->name, file->prefix, file->prefix, file->prefix, file->prefix, r->name, ending);
}

void yk_file_prototype_many(YkFile *file, const YkRoutine *r, bool designs, const char *ending)
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
                           "@_configuration @_start(void); /* as `start:` says */\n");
    if (file->drive_count > 0) yk_file_template(file, "void @_drives(const @_machine *m, $ t, @_inputs *in);\n");
    for (size_t k = 0; k < file->routine_count; k++) {
        const YkRoutine *r = &file->routines[k];
        yk_text_format(&file->text,
                       "\n/* %s\n   They return, or give for each pose, a status; n poses, arrays of n. */\n",
                       r->about);
        yk_file_prototype(file, r, ";\n");
        yk_file_prototype_many(file, r, false, ";\n");
        if (r->has_designs && yk_file_own_parameters(file) > 0) yk_file_prototype_many(file, r, true, ";\n");
    }
    yk_file_declare_residuals(file);
}

static void write_statuses(YkFile *file)
{
    bool is_dry = file->forces.dry_count > 0;
    yk_file_template(
        file, "/* The status of a call. Below 0 the results are meaningless and may be NaN. */\n"
              "enum {\n"
              "    @_OK = 0,\n"
              "    @_SINGULAR = 3,       /* a dead point or so close to one that rounding decides, two pins of a\n"
              "                             loop that coincide, or a freedom without inertia: positions are\n"
              "                             valid, rates and forces are not */\n");
    if (is_dry)
        yk_file_template(
            file,
            "    @_AT_REST = 4,        /* a joint with dry friction is at rest, so that its friction is any in an\n"
            "                             interval: the results are those without it */\n");
    yk_file_template(file,
                     "    @_LIMIT = -1,         /* past a limit position: this configuration does not close here */\n"
                     "    @_NO_ASSEMBLY = -2,   /* a loop that repeats others does not close */\n");
    yk_file_template(
        file, is_dry
                  ? "    @_NOT_CONVERGED = -3, /* dry friction does not settle: the joints jam; or Newton's method did "
                    "not\n                             reach its tolerance */\n"
                  : "    @_NOT_CONVERGED = -3, /* Newton's method did not reach its tolerance */\n");
    if (file->rack_side >= 0)
        yk_file_template(file,
                         "    @_BAD_DESIGN = -4,    /* the parameters move a rack's line to the other side of its "
                         "pinion, whose\n                             teeth it would meet turned: print that machine's "
                         "own file */\n");
    yk_file_template(file, "    @_BAD_INPUT = -5,     /* an input is not a finite number");
    yk_text_puts(&file->text, file->single ? " */\n" : ", or an angle is beyond 1e5 rad */\n");
    yk_file_template(file, "    @_NOT_FINITE = -8     /* a load, or what it does, has no finite value here */\n"
                           "};\n\n");
}

void yk_file_write_types(YkFile *file)
{
    yk_file_template(file, "#ifndef @_DECLARED\n#define @_DECLARED\n#include <stddef.h>\n\n"
                           "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    write_statuses(file);
    write_parameters(file);
    write_machine_type(file);
    write_notes(file, "How the machine is assembled.", "configuration", file->configuration, file->configuration_count);
    write_notes(file, "The independent coordinates of a pose.", "inputs", file->inputs, file->input_count);
    pointers(file, "inputs", "const ", NULL, file->input_count, file->inputs);
    if (yk_file_own_parameters(file) > 0) write_parameter_arrays(file);
    for (size_t k = 0; k < file->routine_count; k++) {
        const YkRoutine *r = &file->routines[k];
        yk_text_format(&file->text, "/* %s */\ntypedef struct %s_%s {\n", r->about, file->prefix, r->name);
        for (size_t i = 0; i < r->count; i++) member(file, r->results[i].name, r->results[i].comment);
        yk_text_format(&file->text, "} %s_%s;\n\n", file->prefix, r->name);
        pointers(file, r->name, "", r->results, r->count, NULL);
    }
    write_prototypes(file);
    yk_file_template(file, "\n#ifdef __cplusplus\n}\n#endif\n#endif\n\n");
}
