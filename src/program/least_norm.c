// Reactions of redundant constraints: of all f with A f = b the one of least norm, as in free_bodies/balance.
//
// It is f = A^T y, so y joins the unknowns and f - A^T y = 0 the equations. That is done for parts of the machine in
// which more columns than equations meet; the others have one solution.
#include "program/balance.h"

typedef struct Parts {
    YkBalanceSystem *w;
    size_t rows, stride;
    size_t *above;   // [row]: union of the rows that columns join
    size_t *columns; // [root of rows]: columns
    size_t *size;    // [root of rows]: rows
    size_t *place;   // [row]: its unknown y, or SIZE_MAX
} Parts;

static size_t root_of(const Parts *s, size_t row)
{
    while (s->above[row] != row) row = s->above[row] = s->above[s->above[row]];
    return row;
}

static YkRef entry(const Parts *s, size_t row, size_t column)
{
    return s->w->system[row * s->stride + column];
}

static bool is_zero(const Parts *s, size_t row, size_t column)
{
    return yk_graph_is_number(&s->w->f->program->graph, entry(s, row, column), 0);
}

// Returns the first row that a column enters; `rows` if there is none.
static size_t first_row(const Parts *s, size_t column)
{
    size_t row = 0;
    while (row < s->rows && is_zero(s, row, column)) row++;
    return row;
}

static bool is_redundant(const Parts *s, size_t row)
{
    size_t root = root_of(s, row);
    return s->columns[root] > s->size[root];
}

static void find_parts(Parts *s)
{
    for (size_t i = 0; i < s->rows; i++) s->above[i] = i;
    for (size_t c = 0; c < s->w->count; c++) {
        size_t first = first_row(s, c);
        for (size_t i = first; i < s->rows; i++)
            if (!is_zero(s, i, c)) s->above[root_of(s, i)] = root_of(s, first);
    }
    for (size_t i = 0; i < s->rows; i++) s->size[root_of(s, i)]++;
    for (size_t c = 0; c < s->w->count; c++) {
        size_t first = first_row(s, c);
        if (first < s->rows) s->columns[root_of(s, first)]++;
    }
}

// Returns whether a column's own equation is f = A^T y: in redundant parts, and where nothing asks for it.
static bool is_least(const Parts *s, size_t column)
{
    size_t first = first_row(s, column);
    return first == s->rows || is_redundant(s, first);
}

static void fill(const Parts *s, YkRef *system, size_t n)
{
    YkBalanceSystem *w = s->w;
    YkGraph *g = &w->f->program->graph;
    YkRef zero = yk_graph_number(g, 0);
    size_t stride = n + w->sides, at = s->rows;
    for (size_t k = 0; k < n * stride; k++) system[k] = zero;
    for (size_t i = 0; i < s->rows; i++) {
        for (size_t c = 0; c < w->count; c++) system[i * stride + c] = entry(s, i, c);
        for (size_t side = 0; side < w->sides; side++) system[i * stride + n + side] = entry(s, i, w->count + side);
    }
    for (size_t c = 0; c < w->count; c++) {
        if (!is_least(s, c)) continue;
        YkRef *row = system + at++ * stride;
        row[c] = yk_graph_number(g, 1);
        for (size_t i = 0; i < s->rows; i++)
            if (s->place[i] != SIZE_MAX && !is_zero(s, i, c)) row[s->place[i]] = yk_graph_minus(g, entry(s, i, c));
    }
}

bool yk_balance_widen(YkBalanceSystem *w)
{
    YkProgram *p = w->f->program;
    size_t rows = 3 * (p->model->body_count - 1), n = w->count, equations = rows;
    Parts s = {.w = w, .rows = rows, .stride = w->count + w->sides};
    s.above = YK_NEW(p->arena, size_t, rows + 1);
    s.columns = YK_NEW(p->arena, size_t, rows + 1);
    s.size = YK_NEW(p->arena, size_t, rows + 1);
    s.place = YK_NEW(p->arena, size_t, rows + 1);
    if (yk_arena_failed(p->arena)) return false;
    find_parts(&s);
    for (size_t i = 0; i < rows; i++) s.place[i] = is_redundant(&s, i) ? n++ : SIZE_MAX;
    for (size_t c = 0; c < w->count; c++) equations += is_least(&s, c);
    if (equations != n) {
        w->f->why_no_reactions = "some part of the machine lacks an input that holds it";
        return false;
    }
    YkRef *system = YK_NEW(p->arena, YkRef, n * (n + w->sides) + 1);
    if (!system) return false;
    fill(&s, system, n);
    w->system = system;
    w->n = n;
    return true;
}
