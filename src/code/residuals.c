// Residuals of the loops and relations at any values of the coordinates, and their Jacobian by exact derivatives: the
// equations that the steps solve, for other solvers.
#include "code/file.h"

typedef struct Work {
    YkFile *file;
    YkRef *coordinate; // per coordinate of the tree, then distances outside the tree: leaves q[k]
    int32_t *distance; // per distance: its leaf's place
    size_t count;
    YkRef *angle; // per orientation
    YkRef *rows;
    size_t row_count;
} Work;

static YkRef leaf(Work *w, size_t k)
{
    YkProgram *p = &w->file->program;
    return yk_graph_leaf(&p->graph, YK_LEAF_POSE, yk_graph_text(&p->graph, "q[%d]", (int)k));
}

static void make_leaves(Work *w)
{
    const YkMechanism *mech = w->file->program.mech;
    for (size_t d = 0; d < mech->distance_count; d++) w->distance[d] = YK_NONE;
    for (size_t k = 0; k < mech->coordinate_count; k++) {
        if (mech->coordinates[k].is_distance) w->distance[mech->coordinates[k].distance] = (int32_t)w->count;
        w->coordinate[w->count] = leaf(w, w->count);
        w->count++;
    }
    for (size_t d = 0; d < mech->distance_count; d++) {
        if (w->distance[d] != YK_NONE) continue;
        w->distance[d] = (int32_t)w->count;
        w->coordinate[w->count] = leaf(w, w->count);
        w->count++;
    }
}

// Adds angles along the tree, from body to body; the body of an orientation has no turn of its own.
static void make_angles(Work *w)
{
    YkProgram *p = &w->file->program;
    YkGraph *g = &p->graph;
    const YkMechanism *mech = p->mech;
    for (size_t o = 0; o < mech->orientation_count; o++) {
        YkRef sum = yk_graph_number(g, 0);
        for (int32_t b = mech->orientation_body[o]; mech->tree.parent[b] != YK_NONE; b = mech->tree.parent[b]) {
            const YkJoint *joint = &p->model->joints[mech->tree.joint[b]];
            int32_t c = yk_tree_coordinate(mech, mech->tree.joint[b], false);
            YkRef part = c != YK_NONE         ? w->coordinate[c]
                         : joint->turned_expr ? yk_program_expr(p, joint->turned_expr)
                                              : yk_graph_number(g, joint->turned);
            sum = joint->body[1] == b ? yk_graph_add(g, sum, part) : yk_graph_subtract(g, sum, part);
        }
        w->angle[o] = sum;
    }
}

static void add_loop(Work *w, const YkSum *sum)
{
    YkProgram *p = &w->file->program;
    YkGraph *g = &p->graph;
    YkRefVec total = yk_program_constant(p, sum);
    for (uint32_t k = 0; k < sum->count; k++) {
        const YkTerm *term = &p->mech->terms[sum->first + k];
        YkRefVec e = yk_graph_unit(g, w->angle[term->slot]);
        YkRefVec v = yk_graph_vec_multiply(g, e, yk_program_term(p, sum->first + k));
        if (term->distance != YK_NONE) v = yk_graph_vec_scale(g, w->coordinate[w->distance[term->distance]], v);
        total = yk_graph_vec_add(g, total, v);
    }
    w->rows[w->row_count++] = total.x;
    w->rows[w->row_count++] = total.y;
}

static YkRef relation_sum(Work *w, uint32_t first, uint32_t count)
{
    YkProgram *p = &w->file->program;
    YkGraph *g = &p->graph;
    YkRef sum = yk_graph_number(g, 0);
    for (uint32_t k = first; k < first + count; k++) {
        const YkRelationTerm *t = &p->mech->relation_terms[k];
        YkRef x = t->is_distance ? w->coordinate[w->distance[t->index]] : w->angle[t->index];
        sum = yk_graph_add(g, sum, yk_graph_multiply(g, yk_graph_number(g, t->factor), x));
    }
    return sum;
}

static void add_relation(Work *w, const YkRelation *r)
{
    YkProgram *p = &w->file->program;
    YkGraph *g = &p->graph;
    YkRef sum = relation_sum(w, r->first_term, r->term_count);
    YkRef row = yk_graph_subtract(g, sum, yk_graph_number(g, r->constant));
    if (r->law) {
        YkRef argument = relation_sum(w, r->first_argument, r->argument_count);
        argument = yk_graph_add(g, argument, yk_graph_number(g, r->argument_constant));
        row = yk_graph_subtract(g, row,
                                yk_graph_result(g, yk_program_call_law(p, yk_program_law(p, r->law), argument), 0));
    }
    w->rows[w->row_count++] = row;
}

bool yk_file_residuals(YkFile *file)
{
    YkProgram *p = &file->program;
    const YkMechanism *mech = p->mech;
    size_t most = mech->coordinate_count + mech->distance_count, rows = 2 * mech->loop_count + mech->relation_count;
    Work w = {.file = file};
    w.coordinate = YK_NEW(p->arena, YkRef, most + 1);
    w.distance = YK_NEW(p->arena, int32_t, mech->distance_count + 1);
    w.angle = YK_NEW(p->arena, YkRef, mech->orientation_count);
    w.rows = YK_NEW(p->arena, YkRef, rows + 1);
    if (yk_arena_failed(p->arena)) return false;
    yk_graph_section(&p->graph, NULL);
    make_leaves(&w);
    make_angles(&w);
    for (size_t l = 0; l < mech->loop_count; l++) add_loop(&w, &mech->loops[l].sum);
    for (size_t k = 0; k < mech->relation_count; k++) add_relation(&w, &mech->relations[k]);
    file->coordinate_count = w.count;
    file->row_count = w.row_count;
    file->residuals = YK_NEW(p->arena, YkRef, w.row_count * (w.count + 1) + 1);
    if (!file->residuals) return false;
    for (size_t i = 0; i < w.row_count; i++) file->residuals[file->residual_count++] = w.rows[i];
    for (size_t i = 0; i < w.row_count; i++)
        for (size_t k = 0; k < w.count; k++)
            file->residuals[file->residual_count++] = yk_graph_derivative(&p->graph, w.rows[i], w.coordinate[k]);
    return !p->failed;
}

// --- printing

static void write_about(YkFile *file)
{
    YkProgram *p = &file->program;
    YkText *out = &file->text;
    const YkMechanism *mech = p->mech;
    yk_text_format(
        out,
        "\n/* Residuals of the %d equations that tie the coordinates, and their Jacobian, [%d][%d] row by row.\n   q: ",
        (int)file->row_count, (int)file->row_count, (int)file->coordinate_count);
    size_t k = 0;
    for (; k < mech->coordinate_count; k++)
        yk_text_format(out, "%s%d %s", k == 0 ? "" : ", ", (int)k, p->names.coordinate[k]);
    for (size_t d = 0; d < mech->distance_count && k < file->coordinate_count; d++) {
        bool in_tree = false;
        for (size_t c = 0; c < mech->coordinate_count; c++)
            if (mech->coordinates[c].is_distance && mech->coordinates[c].distance == (int32_t)d) in_tree = true;
        if (!in_tree) yk_text_format(out, ", %d %s", (int)k++, yk_program_distance_name(p, (int32_t)d));
    }
    yk_text_puts(out, ".\n   Rows: ");
    for (size_t l = 0; l < mech->loop_count; l++)
        yk_text_format(out, "%s%d and %d the loop of %s (x and y, m)", l == 0 ? "" : ", ", 2 * (int)l, 2 * (int)l + 1,
                       p->model->joints[mech->loops[l].joint].name);
    for (size_t r = 0; r < mech->relation_count; r++)
        yk_text_format(out, "%s%d %s", r + mech->loop_count == 0 ? "" : ", ", (int)(2 * mech->loop_count + r),
                       mech->relations[r].name);
    yk_text_puts(out, ". */\n");
}

void yk_file_declare_residuals(YkFile *file)
{
    if (file->row_count == 0) return;
    write_about(file);
    yk_file_template(file, "void @_residuals(const @_machine *m, const $ *q, $ *residual, $ *jacobian);\n");
}

void yk_file_write_residuals(YkFile *file)
{
    if (file->row_count == 0) return;
    yk_file_template(file,
                     "void @_residuals(const @_machine *m, const $ *q, $ *residual, $ *jacobian)\n{\n    (void)m;\n");
    yk_printer_body(&file->printer, file->residuals, file->residual_count);
    for (size_t k = 0; k < file->residual_count; k++) {
        bool is_row = k < file->row_count;
        yk_text_format(&file->text, "    %s[%d] = ", is_row ? "residual" : "jacobian",
                       (int)(is_row ? k : k - file->row_count));
        yk_printer_value(&file->printer, file->residuals[k]);
        yk_text_puts(&file->text, ";\n");
    }
    yk_text_puts(&file->text, "}\n\n");
}
