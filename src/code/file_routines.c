// Writes the routines of the printed file: one pose, and loops over arrays of poses and of parameters.
#include <string.h>
#include "code/file.h"

// --- the status

// Sets the status if the condition does not hold (for NaN none does); the first failure counts.
static void check(YkFile *file, YkRef value, const char *condition, const char *status)
{
    yk_text_puts(&file->text, "!(");
    yk_printer_value(&file->printer, value);
    yk_text_format(&file->text, "%s) ? %s_%s\n        : ", condition, file->prefix, status);
}

static void check_local(YkFile *file, const char *condition, const char *status)
{
    yk_text_format(&file->text, "!(%s) ? %s_%s\n        : ", condition, file->prefix, status);
}

static void check_gap(YkFile *file)
{
    YkText *out = &file->text;
    yk_text_puts(out, "!(");
    yk_printer_value(&file->printer, file->program.gap);
    yk_text_puts(out, " <= ");
    yk_printer_number(&file->printer, yk_program_size(&file->program));
    yk_text_puts(out, file->single ? " * (1e-5f + 1e-7f / sqrtf(margin > 1e-7f ? margin : 1e-7f))"
                                   : " * (1e-12 + 4e-16 / sqrt(margin > 1e-14 ? margin : 1e-14))");
    yk_text_format(out, ") ? %s_NO_ASSEMBLY\n        : ", file->prefix);
}

// Writes the values in the conditions.
static void write_witnesses(YkFile *file, const YkRoutine *r, bool has_margin, bool has_witness)
{
    const char *real = yk_file_real(file);
    YkText *out = &file->text;
    yk_text_puts(out, "\n    /* How it went. */\n");
    if (has_margin)
        yk_file_line(file, yk_graph_text(&file->program.graph, "    const %s margin = ", real), file->program.margin,
                     ";\n");
    if (has_witness)
        yk_file_line(file, yk_graph_text(&file->program.graph, "    const %s witness = ", real), r->witness, ";\n");
    if (!r->checks_results) return;
    size_t from = out->length;
    yk_text_format(out, "    const %s finite = ", real);
    for (size_t k = 0; k < r->count; k++) yk_text_format(out, "%s0 * out->%s", k == 0 ? "" : " + ", r->results[k].name);
    yk_text_puts(out, ";");
    yk_printer_wrap(&file->printer, from);
    yk_text_puts(out, "\n");
}

static void write_status(YkFile *file, const YkRoutine *r)
{
    const YkProgram *p = &file->program;
    const YkGraph *g = &p->graph;
    bool has_gap = !yk_graph_is_number(g, p->gap, 0), has_margin = has_gap || !yk_graph_is_number(g, p->margin, 1),
         has_witness = !yk_graph_is_number(g, r->witness, 0), has_angles = !yk_graph_is_number(g, p->angles, 0);
    write_witnesses(file, r, has_margin, has_witness);
    bool is_open = yk_file_may_coincide(file);
    yk_text_puts(&file->text, is_open ? "    const int how = " : "    return ");
    if (has_witness) check_local(file, "witness == 0", "BAD_INPUT");
    if (file->rack_side >= 0) check(file, file->rack_side, " > 0", "BAD_DESIGN");
    if (!yk_graph_is_number(g, p->missed, 0)) check(file, p->missed, " <= 1", "NOT_CONVERGED");
    if (is_open)
        yk_text_format(&file->text,
                       file->single ? "margin < -1e-6f ? %s_LIMIT\n        : "
                                    : "margin < -1e-13 ? %s_LIMIT\n        : ",
                       file->prefix);
    else if (has_margin)
        check_local(file, file->single ? "margin >= -1e-6f" : "margin >= -1e-13", "LIMIT");
    if (is_open && (has_angles || has_gap)) check_local(file, "margin == margin", "SINGULAR");
    if (has_angles) check(file, p->angles, " == 0", "BAD_INPUT");
    if (has_gap) check_gap(file);
    const char *clear =
        r->kind == YK_ROUTINE_INVERSE ? "margin > 1e-7" : "margin > 5e-10"; // as the engine, for all rates
    if (has_margin) check_local(file, file->single ? "margin > 1e-7f" : clear, "SINGULAR");
    if (r->regular >= 0) check(file, r->regular, " > 0", "SINGULAR");
    if (r->settled >= 0) check(file, r->settled, " > 0", "NOT_CONVERGED");
    if (r->checks_results) check_local(file, "finite == 0", "NOT_FINITE");
    if (r->moves >= 0) check(file, r->moves, " > 0", "AT_REST");
    yk_text_format(&file->text, "%s_OK;\n", file->prefix);
    if (is_open) yk_file_mark_open(file);
    yk_text_puts(&file->text, "}\n\n");
}

// --- the kernel

const YkRef *yk_file_roots(YkFile *file, const YkRoutine *r, size_t *root_count)
{
    YkProgram *p = &file->program;
    enum { STATUS_MOST = 9 };
    YkRef *roots = YK_NEW(p->arena, YkRef, r->count + STATUS_MOST);
    size_t count = 0;
    p->failed |= !roots;
    if (!roots) return NULL;
    for (size_t k = 0; k < r->count; k++) roots[count++] = r->results[k].value;
    roots[count++] = p->margin;
    roots[count++] = r->witness;
    roots[count++] = p->angles;
    roots[count++] = p->gap;
    roots[count++] = p->missed;
    if (r->regular >= 0) roots[count++] = r->regular;
    if (r->settled >= 0) roots[count++] = r->settled;
    if (r->moves >= 0) roots[count++] = r->moves;
    if (file->rack_side >= 0) roots[count++] = file->rack_side;
    *root_count = count;
    return roots;
}

static void write_kernel(YkFile *file, const YkRoutine *r)
{
    size_t count;
    const YkRef *roots = yk_file_roots(file, r, &count);
    if (!roots) return;
    yk_text_format(&file->text, "/* %s */\n", r->about);
    yk_text_format(&file->text,
                   "%s_INLINE int %s_%s_of(const %s_machine *m, const %s_configuration *c, const %s_inputs *in,\n    "
                   "%s_%s *out)\n{\n    (void)m;\n    (void)c;\n    (void)in;\n",
                   file->prefix, file->prefix, r->name, file->prefix, file->prefix, file->prefix, file->prefix,
                   r->name);
    yk_printer_body(&file->printer, roots, count);
    yk_text_puts(&file->text, "\n    /* Results. */\n");
    for (size_t k = 0; k < r->count; k++)
        yk_file_line(file, yk_graph_text(&file->program.graph, "    out->%s = ", r->results[k].name),
                     r->results[k].value, ";\n");
    write_status(file, r);
}

// --- inputs

typedef struct Uses { // which inputs the routine's kernel takes; those of them that its witness has not seen: loads'
    bool *taken, *unseen;
    bool any_unseen;
} Uses;

// Returns the input that a value is, or input_count.
static size_t input_of(const YkFile *file, const YkValue *v)
{
    size_t k = 0;
    if (v->op != YK_VALUE_LEAF || strncmp(v->name, "in->", 4) != 0) return file->input_count;
    while (k < file->input_count && strcmp(v->name + 4, file->inputs[k].name) != 0) k++;
    return k;
}

static void mark_operands(const YkGraph *g, const YkValue *v, bool *is_marked)
{
    const YkRef operands[] = {v->a, v->b, v->c}, *of = operands;
    size_t count = v->op == YK_VALUE_SINE || v->op == YK_VALUE_COSINE ? 1 : 3; // behind the angle is the other of them
    if (v->op == YK_VALUE_LEAF) return;
    if (v->op == YK_VALUE_RESULT) {
        of = g->calls[v->a].arguments;
        count = g->calls[v->a].argument_count;
    }
    for (size_t k = 0; k < count; k++)
        if (of[k] >= 0) is_marked[of[k]] = true;
}

// Marks a value and all that it depends on: operands come before their value.
static void mark_under(const YkGraph *g, YkRef value, bool *is_marked)
{
    is_marked[value] = true;
    for (size_t k = (size_t)value + 1; k-- > 0;)
        if (is_marked[k]) mark_operands(g, &g->values[k], is_marked);
}

static bool find_uses(YkFile *file, const YkRoutine *r, Uses *uses)
{
    const YkGraph *g = &file->program.graph;
    bool *is_seen = YK_NEW(file->program.arena, bool, g->count + 1);
    uses->taken = YK_NEW(file->program.arena, bool, file->input_count + 1);
    uses->unseen = YK_NEW(file->program.arena, bool, file->input_count + 1);
    if (!uses->taken || !uses->unseen || !is_seen) return false;
    mark_under(g, r->witness, is_seen);
    for (size_t v = 0; v < g->count; v++) {
        size_t k = input_of(file, &g->values[v]);
        if (k == file->input_count) continue;
        uses->taken[k] = file->printer.count[v] > 0;
        uses->unseen[k] = uses->taken[k] && !is_seen[v];
        uses->any_unseen = uses->any_unseen || uses->unseen[k];
    }
    return true;
}

// Checks inputs that the witness has not seen; only after a failure, so that it costs nothing otherwise.
static void write_fault(YkFile *file, const Uses *uses, const char *before, const char *after)
{
    YkText *out = &file->text;
    size_t from = out->length;
    yk_text_puts(out, "            !(");
    for (size_t k = 0, written = 0; k < file->input_count; k++)
        if (uses->unseen[k])
            yk_text_format(out, "%s0 * %s%s%s", written++ > 0 ? " + " : "", before, file->inputs[k].name, after);
    yk_text_puts(out, " == 0))");
    yk_printer_wrap(&file->printer, from);
    yk_text_puts(out, "\n");
}

static void write_one(YkFile *file, const YkRoutine *r, const Uses *uses)
{
    YkText *out = &file->text;
    const char *p = file->prefix;
    bool is_open = yk_file_may_coincide(file);
    yk_file_prototype(file, r, "\n{\n");
    if (!is_open && !uses->any_unseen) {
        yk_text_format(out, "    return %s_%s_of(m, c, in, out);\n}\n\n", p, r->name);
        return;
    }
    yk_text_format(out, "    %sint how = %s_%s_of(m, c, in, out);\n", is_open ? "" : "const ", p, r->name);
    if (is_open) yk_text_format(out, "    if (how >= %s_OPEN) how = %s_%s_beside(m, c, in, out);\n", p, p, r->name);
    if (uses->any_unseen) {
        yk_file_template(file, "    if (how != @_OK &&\n");
        write_fault(file, uses, "in->", "");
        yk_file_template(file, "        return @_BAD_INPUT;\n");
    }
    yk_text_puts(out, "    return how;\n}\n\n");
}

// --- loops

// Writes the arrays under names of their own, so that none overlaps another.
static void write_arrays(YkFile *file, const YkRoutine *r, const Uses *uses, bool designs)
{
    YkText *out = &file->text;
    YkProgram *p = &file->program;
    const char *real = yk_file_real(file);
    for (size_t k = 0; k < file->input_count; k++)
        if (uses->taken[k])
            yk_text_format(out, "    const %s *restrict in_%s = in->%s;\n", real, file->inputs[k].name,
                           file->inputs[k].name);
    for (size_t k = 0; designs && k < p->model->parameter_count; k++)
        if (yk_file_is_own(file, k)) {
            const char *name = p->names.parameter[k];
            yk_text_format(out, "    const %s *restrict p_%s = p->%s;\n", real, name, name);
        }
    for (size_t k = 0; k < r->count; k++)
        yk_text_format(out, "    %s *restrict out_%s = out->%s;\n", real, r->results[k].name, r->results[k].name);
    if (!designs) yk_text_format(out, "    const %s_machine machine = *m;\n", file->prefix);
    yk_file_template(file, "    const @_configuration configuration = *c;\n    (void)in;\n");
}

static void write_own_machine(YkFile *file)
{
    YkText *out = &file->text;
    YkProgram *p = &file->program;
    yk_file_template(file, "            @_parameters own;\n");
    for (size_t k = 0; k < p->model->parameter_count; k++) {
        if (!yk_file_is_own(file, k)) continue;
        const char *name = p->names.parameter[k];
        yk_text_format(out, "            own.%s = p_%s[i];\n", name, name);
    }
    yk_file_template(file, "            const @_machine machine = @_prepared(&own);\n");
}

// Writes the inputs of pose i.
static void write_pose(YkFile *file, const Uses *uses)
{
    for (size_t k = 0; k < file->input_count; k++)
        if (uses->taken[k])
            yk_text_format(&file->text, "            pose.%s = in_%s[i];\n", file->inputs[k].name,
                           file->inputs[k].name);
}

static void write_results(YkFile *file, const YkRoutine *r)
{
    for (size_t k = 0; k < r->count; k++)
        yk_text_format(&file->text, "            out_%s[i] = found.%s;\n", r->results[k].name, r->results[k].name);
}

// Writes the loop that settles poses at which any angle closes a dyad.
static void write_open(YkFile *file, const YkRoutine *r, const Uses *uses, bool designs)
{
    const char *p = file->prefix;
    yk_file_template(file, "        for (size_t i = first; i < first + count && any != @_OK; i++) {\n"
                           "            if (status[i] < @_OPEN) continue;\n");
    if (designs) write_own_machine(file);
    yk_text_format(&file->text, "            %s_inputs pose = {0};\n            %s_%s found;\n", p, p, r->name);
    write_pose(file, uses);
    yk_text_format(&file->text,
                   "            status[i] = (signed char)%s_%s_beside(&machine, &configuration, &pose, &found);\n", p,
                   r->name);
    write_results(file, r);
    yk_text_puts(&file->text, "        }\n");
}

static void write_statuses(YkFile *file, const YkRoutine *r, const Uses *uses, bool designs)
{
    bool is_open = yk_file_may_coincide(file);
    if (!uses->any_unseen && !is_open) {
        yk_file_template(file, "        for (size_t k = 0; k < count; k++) status[first + k] = (signed char)how[k];\n");
        return;
    }
    yk_file_template(file, "        @_status any = @_OK;\n"
                           "        for (size_t k = 0; k < count; k++) {\n"
                           "            status[first + k] = (signed char)how[k];\n"
                           "            any |= how[k];\n"
                           "        }\n");
    if (is_open) write_open(file, r, uses, designs);
    if (!uses->any_unseen) return;
    yk_file_template(file, "        for (size_t i = first; i < first + count && any != @_OK; i++)\n"
                           "            if (status[i] != @_OK &&\n");
    write_fault(file, uses, "in_", "[i]");
    yk_file_template(file, "                status[i] = @_BAD_INPUT;\n");
}

// Writes blocks of poses: the status of each as a number beside the results, then all of them as bytes.
static void write_many(YkFile *file, const YkRoutine *r, const Uses *uses, bool designs)
{
    YkText *out = &file->text;
    yk_file_prototype_many(file, r, designs, "\n{\n");
    write_arrays(file, r, uses, designs);
    yk_file_template(file, "    for (size_t first = 0; first < n; first += @_BLOCK) {\n"
                           "        const size_t count = n - first < @_BLOCK ? n - first : @_BLOCK;\n"
                           "        @_status how[@_BLOCK];\n"
                           "        @_EACH\n"
                           "        for (size_t k = 0; k < count; k++) {\n"
                           "            const size_t i = first + k;\n");
    if (designs) write_own_machine(file);
    yk_text_format(out, "            %s_inputs pose;\n            %s_%s found;\n", file->prefix, file->prefix, r->name);
    write_pose(file, uses);
    yk_text_format(out, "            how[k] = (%s_status)%s_%s_of(&machine, &configuration, &pose, &found);\n",
                   file->prefix, file->prefix, r->name);
    write_results(file, r);
    yk_text_puts(out, "        }\n");
    write_statuses(file, r, uses, designs);
    yk_text_puts(out, "    }\n}\n\n");
}

void yk_file_write_routine(YkFile *file, const YkRoutine *r)
{
    Uses uses = {0};
    write_kernel(file, r);
    if (!find_uses(file, r, &uses)) {
        file->program.failed = true;
        return;
    }
    yk_file_write_beside(file, r);
    write_one(file, r, &uses);
    write_many(file, r, &uses, false);
    if (r->has_designs && yk_file_own_parameters(file) > 0) write_many(file, r, &uses, true);
}
