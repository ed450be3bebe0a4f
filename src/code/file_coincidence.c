// Poses at which two pins of a dyad coincide, so that any angle closes it. The engine keeps the angle with which the
// machine arrives. A printed function has no memory: it takes the pose just before, going back along the rates.
#include "code/file.h"

bool yk_file_may_coincide(const YkFile *file)
{
    const YkMechanism *mech = file->program.mech;
    bool may = false;
    for (size_t k = 0; k < mech->block_count; k++) {
        const YkBlock *b = &mech->blocks[k];
        bool has_arm = b->kind == YK_BLOCK_RRP && b->arm_is_constant[0];
        may = may || (b->kind <= YK_BLOCK_RPR && b->kind != YK_BLOCK_PP && !has_arm);
    }
    return may && mech->input_count > 0;
}

// Writes what an input's hair is measured by, if that is not 1 rad: the machine's size.
static void write_unit(YkFile *file, size_t input, const char *before)
{
    const YkMechanism *mech = file->program.mech;
    if (!mech->coordinates[mech->inputs[input]].is_distance) return;
    yk_text_puts(&file->text, before);
    yk_printer_number(&file->printer, yk_program_size(&file->program));
}

static const char *input_name(const YkFile *file, size_t input)
{
    return file->program.names.coordinate[file->program.mech->inputs[input]];
}

void yk_file_write_before(YkFile *file)
{
    YkText *out = &file->text;
    size_t inputs = file->program.mech->input_count;
    if (!yk_file_may_coincide(file)) return;
    yk_file_template(
        file, "/* Where two pins of a loop coincide, any angle closes it. These are the inputs a hair before: the "
              "machine\n   comes with the angle that it has there. */\n"
              "enum { @_OPEN = 16, @_LOST = 32 }; /* while that is not settled: bits of the status */\n"
              "static @_inputs @_before(const @_inputs *in)\n{\n    @_inputs before = *in;\n    $ fastest = 0;\n");
    for (size_t i = 0; i < inputs; i++) {
        yk_text_format(out, "    fastest = fmax%s(fastest, fabs%s(in->%s_rate)", file->single ? "f" : "",
                       file->single ? "f" : "", input_name(file, i));
        write_unit(file, i, " / ");
        yk_text_puts(out, ");\n");
    }
    yk_file_template(file, file->single ? "    const $ hair = 1e-4f, share = fastest > 0 ? hair / fastest : 0;\n"
                                        : "    const $ hair = 1e-8, share = fastest > 0 ? hair / fastest : 0;\n");
    for (size_t i = 0; i < inputs; i++) {
        const char *name = input_name(file, i);
        yk_text_format(out, "    before.%s -= fastest > 0 ? share * in->%s_rate : hair", name, name);
        write_unit(file, i, " * ");
        yk_text_puts(out, ";\n");
    }
    yk_text_puts(out, "    return before;\n}\n\n");
}

// Bits, since a chain of more than four results is not turned into vector instructions; of a negative status both are
// set already.
void yk_file_mark_open(YkFile *file)
{
    yk_file_template(
        file, file->single ? "    return how | (margin >= 1e-12f ? 0 : @_OPEN) | (margin == margin ? 0 : @_LOST);\n"
                           : "    return how | (margin >= 1e-23 ? 0 : @_OPEN) | (margin == margin ? 0 : @_LOST);\n");
}

// At a dead point the margin grows with the way, at a coincidence with its square: there alone the pose beside is
// singular too.
void yk_file_write_beside(YkFile *file, const YkRoutine *r)
{
    const char *p = file->prefix;
    if (!yk_file_may_coincide(file)) return;
    yk_text_format(&file->text,
                   "static int %s_%s_beside(const %s_machine *m, const %s_configuration *c, const %s_inputs *in,\n    "
                   "%s_%s *out)\n{\n    int how = %s_LIMIT;\n"
                   "    for (int k = 0; k < 2 && how != %s_SINGULAR; k++) {\n"
                   "        const %s_inputs pose = k == 0 ? %s_before(in) : *in;\n"
                   "        how = %s_%s_of(m, c, &pose, out);\n    }\n"
                   "    return how < 0 || how & %s_LOST ? %s_LIMIT : %s_SINGULAR;\n}\n\n",
                   p, r->name, p, p, p, p, r->name, p, p, p, p, p, r->name, p, p, p);
}
