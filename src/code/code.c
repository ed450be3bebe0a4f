// Turns a model into the text of a C file.
#include <stdlib.h>
#include <string.h>
#include <yoke/move.h>
#include "base/letters.h"
#include "base/problems.h"
#include "code/file.h"
#include "compile/variant.h"

struct YkCSource {
    YkText text;
    char *prefix;
};

YkCSourceOptions yk_default_c_source_options(void)
{
    return (YkCSourceOptions){0};
}

// Makes a C name from the name of the model's file: lower case, words joined by underscores.
static const char *prefix_of(YkProgram *p, const char *name)
{
    const char *slash = strrchr(name, '/');
    char *copy = yk_graph_text(&p->graph, "%s", slash ? slash + 1 : name), *to = copy, *dot = strrchr(copy, '.');
    if (dot && dot > copy) *dot = 0;
    for (const char *c = copy; *c && to - copy < 40; c++) {
        if (yk_is_letter(*c) || yk_is_digit(*c))
            *to++ = *c >= 'A' && *c <= 'Z' ? (char)(*c - 'A' + 'a') : *c;
        else if (*c != '\'' && to > copy && to[-1] != '_')
            *to++ = '_';
    }
    while (to > copy && to[-1] == '_') to--;
    *to = 0;
    if (to == copy) return "machine";
    return yk_is_digit(copy[0]) ? yk_graph_text(&p->graph, "machine_%s", copy) : copy;
}

static bool assemble(YkFile *file, const YkState *pose, YkProblems *problems)
{
    YkStatus status = pose ? yk_state_adopt(file->state, pose) : yk_state_assemble(file->state);
    if (status >= 0) return true;
    yk_problem(problems, YK_CODE_POSE_NO_ASSEMBLY, (YkPlace){0}, "%s: %s", yk_status_name(status),
               yk_state_report(file->state)->message);
    return false;
}

static bool need_fields(YkFile *file)
{
    YkProgram *p = &file->program;
    for (size_t k = 0; k < file->routine_count; k++) {
        size_t count;
        const YkRef *roots = yk_file_roots(file, &file->routines[k], &count);
        if (!roots) return false;
        yk_printer_need(&file->printer, roots, count);
    }
    for (size_t k = 0; k < file->drive_count; k++) yk_printer_need(&file->printer, &file->drives[k].value, 1);
    yk_printer_need(&file->printer, file->residuals, file->residual_count);
    for (size_t b = 0; b < p->mech->block_count; b++) {
        size_t n = p->mech->blocks[b].column_count;
        if (p->mech->blocks[b].kind != YK_BLOCK_GROUP) continue;
        yk_printer_need(&file->printer, p->placed[b].residual, n);
        yk_printer_need(&file->printer, p->placed[b].jacobian, n * n);
    }
    yk_program_name_fields(&file->program, &file->printer);
    return !p->failed;
}

// Compilers work on as many poses side by side as fit the narrowest type of a loop. Loops of the machine make a long
// chain of operations, each waiting for the last: there four vectors at once pay off, in trees two.
static void write_lanes(YkFile *file)
{
    bool has_blocks = file->program.mech->block_count > 0;
    yk_file_template(
        file, "/* A status in loops over arrays: a narrow type makes compilers work at more poses side by side. */\n");
    yk_file_template(file, has_blocks ? "typedef short @_status;\n\n" : "typedef int @_status;\n\n");
}

static const double COMPILED = 0.05, ROUTINES = 0.5, TESTS = 0.7; // shares of the whole up to there

// Writes the body aside first, since the helpers that it uses are printed before it.
static bool write_body(YkFile *file)
{
    YkProgram *p = &file->program;
    YkText head = file->text, body;
    file->text = (YkText){0};
    yk_file_write_machine(file);
    for (size_t b = 0; b < p->mech->block_count; b++)
        if (p->mech->blocks[b].kind == YK_BLOCK_GROUP) yk_file_write_group(file, b);
    yk_file_write_drives(file);
    yk_file_write_residuals(file);
    yk_file_write_before(file);
    yk_pace_stage(file->pace, ROUTINES, TESTS);
    for (size_t k = 0; k < file->routine_count && yk_file_goes_on(file, 0); k++) {
        yk_pace_reach(file->pace, (double)k / (double)file->routine_count);
        yk_file_write_routine(file, &file->routines[k]);
    }
    yk_pace_stage(file->pace, TESTS, 1);
    body = file->text;
    file->text = head;
    yk_file_template(file,
                     "#ifndef @_DECLARATIONS_ONLY\n#include <math.h>\n#include <stdint.h>\n#include <string.h>\n\n"
                     "/* Functions to inline into loops, and loops in which poses do not depend on each other. */\n"
                     "#if defined(__GNUC__)\n#define @_INLINE static inline __attribute__((always_inline))\n#else\n"
                     "#define @_INLINE static inline\n#endif\n"
                     "#if defined(__clang__)\n#pragma clang diagnostic ignored \"-Wpass-failed\" /* a loop that stays "
                     "scalar is slower, not wrong */\n"
                     "#define @_EACH _Pragma(\"clang loop vectorize(assume_safety)\")\n#elif defined(__GNUC__)\n"
                     "#define @_EACH _Pragma(\"GCC ivdep\")\n#else\n#define @_EACH\n#endif\n"
                     "enum { @_BLOCK = 256 }; /* poses whose status is held at a time */\n");
    write_lanes(file);
    yk_file_write_helpers(file, yk_text_get(&body));
    yk_text_puts(&file->text, yk_text_get(&body));
    bool failed = body.failed;
    yk_text_free(&body);
    yk_file_write_test(file);
    yk_file_template(file, "#endif\n");
    return !failed;
}

// Returns whether nothing ran out of memory: every part records its failure.
static bool is_whole(const YkFile *file)
{
    const YkProgram *p = &file->program;
    return !file->text.failed && !file->printer.failed && !p->failed && !p->graph.failed && !yk_arena_failed(p->arena);
}

static const char *name_of(void *program, const char *wish)
{
    return yk_file_name(program, wish);
}

static bool write_all(YkFile *file)
{
    if (!yk_file_members(file) || !yk_file_routines(file)) return false;
    if (file->program.graph.failed) return false;
    file->naming = (YkPrinterFile){&file->program, "m->p.", "p->", "machine.", name_of, yk_call_print, yk_call_known};
    if (!yk_printer_start(&file->printer, &file->program.graph, &file->naming, file->prefix, file->single, &file->text))
        return false;
    if (!need_fields(file)) return false;
    yk_file_write_head(file);
    yk_file_write_types(file);
    return write_body(file) && is_whole(file);
}

// Finds the parameters that may vary in the printed program: given by the file alone, and not fixed.
static size_t own_parameters(YkProgram *p, const char **names)
{
    const YkModel *m = p->model;
    size_t count = 0;
    for (size_t k = 0; k < m->parameter_count; k++) {
        bool follows = false;
        for (size_t i = 0; i < m->parameter_count && m->parameters[k].expr; i++)
            follows = follows || yk_expr_mentions(m->parameters[k].expr, m->parameters[i].name);
        if (!follows && !p->is_fixed[k]) names[count++] = m->parameters[k].name;
    }
    return count;
}

// Compiles the mechanism with the recipe of its vectors, so that no coincidence of the file's numbers shapes it.
static YkVariant *vary(const YkMechanism *mech, YkArena *arena, YkProblems *problems)
{
    const YkModel *m = mech->model;
    YkProgram fixing = {.model = m, .is_fixed = YK_NEW(arena, bool, m->parameter_count + 1)};
    const char **names = YK_NEW(arena, const char *, m->parameter_count + 1);
    if (yk_arena_failed(arena)) return NULL;
    yk_program_fix(&fixing);
    size_t count = own_parameters(&fixing, names);
    return yk_variant_new(mech, names, count, problems);
}

static bool print_varying(YkFile *file, YkVariant *variant, const YkCSourceOptions *options, YkArena *arena,
                          YkProblems *problems)
{
    const YkMechanism *mech = variant->mech;
    if (!yk_program_start(&file->program, mech, &variant->recipe, arena, problems)) return false;
    file->program.graph.joins_terms = true;
    file->program.graph.pace = arena->pace = file->pace;
    file->prefix = options->prefix ? options->prefix : prefix_of(&file->program, mech->model->source_name);
    file->program.prefix = file->prefix;
    if (!yk_file_choose_names(&file->program)) return false;
    file->single = file->program.is_single = options->single;
    file->is_of_file = variant->is_of_file;
    file->has_forces = !options->kinematics && yk_model_has_forces(mech->model);
    yk_program_fix(&file->program);
    yk_program_constants(&file->program);
    file->state = yk_state_new(mech);
    return file->state && assemble(file, options->pose, problems) && write_all(file);
}

static bool print(YkFile *file, const YkModel *model, const YkCSourceOptions *options, YkArena *arena,
                  YkProblems *problems)
{
    YkCompileOptions compile = {.inputs = options->inputs, .input_count = options->input_count};
    compile.progress = yk_pace_within(file->pace);
    YkMechanism *mech = yk_mechanism_compile(model, &compile, NULL);
    yk_pace_stage(file->pace, COMPILED, ROUTINES);
    if (!mech) mech = yk_mechanism_compile(model, &compile, problems); // to say why; its notes are for `yoke check`
    YkVariant *variant = mech ? vary(mech, arena, problems) : NULL;
    bool ok = variant && print_varying(file, variant, options, arena, problems);
    yk_printer_end(&file->printer);
    if (variant) yk_program_end(&file->program);
    yk_state_free(file->state);
    yk_variant_free(variant);
    yk_mechanism_free(mech);
    return ok;
}

YkCSource *yk_c_source_new(const YkModel *model, const YkCSourceOptions *options, YkProblems *problems)
{
    YkCSourceOptions defaults = yk_default_c_source_options();
    YkFile file = {0};
    YkArena *arena = yk_arena_new();
    YkCSource *code = calloc(1, sizeof *code);
    size_t errors = yk_problems_error_count(problems);
    YkPace pace;
    file.pace = &pace;
    yk_pace_begin(&pace, options ? options->progress : defaults.progress);
    yk_pace_stage(&pace, 0, COMPILED);
    bool ok = arena && code && print(&file, model, options ? options : &defaults, arena, problems);
    if (ok && !pace.is_stopped) {
        code->text = file.text;
        code->prefix = malloc(strlen(file.prefix) + 1);
        if (code->prefix) memcpy(code->prefix, file.prefix, strlen(file.prefix) + 1);
        ok = code->prefix != NULL;
    } else {
        yk_text_free(&file.text);
        ok = false;
    }
    yk_arena_free(arena);
    if (ok) return code;
    if (pace.is_stopped)
        yk_problem_stopped(problems);
    else if (problems && yk_problems_error_count(problems) == errors)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while printing the code");
    yk_c_source_free(code);
    return NULL;
}

const char *yk_c_source_text(const YkCSource *code)
{
    return yk_text_get(&code->text);
}

const char *yk_c_source_prefix(const YkCSource *code)
{
    return code->prefix;
}

void yk_c_source_free(YkCSource *code)
{
    if (!code) return;
    yk_text_free(&code->text);
    free(code->prefix);
    free(code);
}
