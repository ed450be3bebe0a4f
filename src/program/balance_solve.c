// Solves the balance in symbols. Entries that are plain numbers - the forces of pins, couples - are eliminated first:
// that takes few operations and no division by a quantity that may vanish. The rest falls apart into small blocks, one
// for every group of links, which are solved one after the other (Duff & Reid 1978, block triangular form).
#include <math.h>
#include "num/components.h"
#include "num/matching.h"
#include "program/balance.h"

typedef struct Pivot {
    size_t row, column;
} Pivot;

typedef struct Solver {
    YkBalanceSystem *w;
    YkGraph *g;
    YkArena *arena;
    size_t n, stride;
    bool *row_is_done, *column_is_done;
    size_t *row_count, *column_count; // entries among what is left
    Pivot *pivots;
    size_t pivot_count;
} Solver;

static YkRef *entry(const Solver *s, size_t row, size_t column)
{
    return &s->w->system[row * s->stride + column];
}

static bool is_zero(const Solver *s, size_t row, size_t column)
{
    return yk_graph_is_number(s->g, *entry(s, row, column), 0);
}

// --- pivots that are numbers

static void count_entries(Solver *s)
{
    for (size_t i = 0; i < s->n; i++) s->row_count[i] = s->column_count[i] = 0;
    for (size_t i = 0; i < s->n; i++)
        for (size_t j = 0; j < s->n && !s->row_is_done[i]; j++) {
            if (s->column_is_done[j] || is_zero(s, i, j)) continue;
            s->row_count[i]++;
            s->column_count[j]++;
        }
}

// A pivot must not be much smaller than what it is to eliminate: entries are about 1 or less.
static bool is_good_pivot(const Solver *s, size_t i, size_t j)
{
    const YkValue *v = &s->g->values[*entry(s, i, j)];
    return v->op == YK_VALUE_NUMBER && fabs(v->number) >= 0.25;
}

// Finds the number that fills in least (Markowitz 1957). Returns false if none is left.
static bool find_pivot(Solver *s, Pivot *best)
{
    size_t least = SIZE_MAX;
    count_entries(s);
    for (size_t i = 0; i < s->n; i++)
        for (size_t j = 0; j < s->n && !s->row_is_done[i]; j++) {
            size_t cost = (s->row_count[i] - 1) * (s->column_count[j] - 1);
            if (s->column_is_done[j] || cost >= least || !is_good_pivot(s, i, j)) continue;
            least = cost;
            *best = (Pivot){i, j};
        }
    return least < SIZE_MAX;
}

static void subtract_row(Solver *s, size_t row, Pivot p)
{
    YkRef factor = yk_graph_divide(s->g, *entry(s, row, p.column), *entry(s, p.row, p.column));
    for (size_t k = 0; k < s->stride; k++) {
        if ((k < s->n && s->column_is_done[k]) || is_zero(s, p.row, k)) continue;
        YkRef part = yk_graph_multiply(s->g, factor, *entry(s, p.row, k));
        *entry(s, row, k) = k == p.column ? yk_graph_number(s->g, 0) : yk_graph_subtract(s->g, *entry(s, row, k), part);
    }
}

static void eliminate(Solver *s, Pivot p)
{
    s->row_is_done[p.row] = true;
    for (size_t i = 0; i < s->n; i++)
        if (!s->row_is_done[i] && !is_zero(s, i, p.column)) subtract_row(s, i, p);
    s->column_is_done[p.column] = true;
    s->pivots[s->pivot_count++] = p;
}

// Returns the right side of a row less the part of the unknowns that are already solved.
static YkRef right_side(const Solver *s, size_t row, size_t side, const bool *is_known)
{
    YkRef sum = *entry(s, row, s->n + side);
    for (size_t k = 0; k < s->n; k++) {
        if (!is_known[k] || is_zero(s, row, k)) continue;
        YkRef part = yk_graph_multiply(s->g, *entry(s, row, k), s->w->solution[k * s->w->sides + side]);
        sum = yk_graph_subtract(s->g, sum, part);
    }
    return sum;
}

// --- blocks

typedef struct Blocks {
    size_t count;      // of what is left: rows, columns
    size_t *row;       // [k]: the row that belongs to column k of what is left,
    size_t *column;    // and that column of the system
    int32_t *block_of; // [k]
    size_t block_count;
} Blocks;

// Gives every column left a row of its own. Returns false if there is no such choice.
static bool match(const Solver *s, Blocks *b)
{
    YkMatching m;
    size_t left = 0, *rows = YK_NEW(s->arena, size_t, s->n + 1);
    int32_t *columns = YK_NEW(s->arena, int32_t, s->n + 1);
    if (yk_arena_failed(s->arena) || !yk_matching_start(&m, s->arena, b->count, b->count, b->count * b->count + 1))
        return false;
    for (size_t i = 0; i < s->n; i++) {
        size_t count = 0;
        if (s->row_is_done[i]) continue;
        for (size_t k = 0; k < b->count; k++)
            if (!is_zero(s, i, b->column[k])) columns[count++] = (int32_t)k;
        if (!yk_matching_add(&m, columns, count, true)) return false;
        rows[left++] = i;
    }
    for (size_t k = 0; k < b->count; k++) b->row[k] = rows[m.row_of[k]];
    return true;
}

static bool find_blocks(const Solver *s, Blocks *b)
{
    uint32_t *first = YK_NEW(s->arena, uint32_t, b->count + 1);
    int32_t *target = YK_NEW(s->arena, int32_t, b->count * b->count + 1);
    int32_t *work = YK_NEW(s->arena, int32_t, 5 * b->count + 1);
    if (yk_arena_failed(s->arena)) return false;
    uint32_t count = 0;
    for (size_t k = 0; k < b->count; k++) {
        first[k] = count;
        for (size_t j = 0; j < b->count; j++)
            if (j != k && !is_zero(s, b->row[k], b->column[j])) target[count++] = (int32_t)j;
    }
    first[b->count] = count;
    b->block_count = yk_components(b->count, first, target, b->block_of, work);
    return true;
}

// Notes how near a block is to having no solution: its determinant over the lengths of its columns.
static void note_determinant(const Solver *s, YkRef determinant)
{
    YkForces *f = s->w->f;
    determinant = yk_graph_unary(s->g, YK_VALUE_SIZE, determinant);
    f->determinant =
        f->determinant == 0 ? determinant : yk_graph_binary(s->g, YK_VALUE_LEAST, f->determinant, determinant);
}

// Solves [a b; c d] by Cramer's rule, for two unknowns as exact as elimination with pivots (Higham 2002, 1.10.1).
static void solve_two(const Solver *s, const size_t *rows, const size_t *columns, const YkRef *right)
{
    YkGraph *g = s->g;
    YkRefVec first = {*entry(s, rows[0], columns[0]), *entry(s, rows[1], columns[0])};
    YkRefVec second = {*entry(s, rows[0], columns[1]), *entry(s, rows[1], columns[1])};
    YkRef determinant = yk_graph_cross(g, first, second), per = yk_graph_inverse(g, determinant);
    YkRef first_length = yk_graph_vec_length(g, first),
          lengths = yk_graph_multiply(g, first_length, yk_graph_vec_length(g, second));
    for (size_t side = 0; side < s->w->sides; side++) {
        YkRefVec b = {right[2 * side], right[2 * side + 1]};
        YkRef *solution = s->w->solution + side;
        solution[columns[0] * s->w->sides] = yk_graph_multiply(g, yk_graph_cross(g, b, second), per);
        solution[columns[1] * s->w->sides] = yk_graph_multiply(g, yk_graph_cross(g, first, b), per);
    }
    note_determinant(s, yk_graph_divide(g, determinant, lengths));
}

static void solve_one(const Solver *s, size_t row, size_t column, const YkRef *right)
{
    YkRef a = *entry(s, row, column);
    for (size_t side = 0; side < s->w->sides; side++)
        s->w->solution[column * s->w->sides + side] = yk_graph_divide(s->g, right[side], a);
    note_determinant(s, a);
}

// Solves more unknowns by elimination with pivots, which are chosen pose by pose.
static bool solve_many(const Solver *s, size_t n, const size_t *rows, const size_t *columns, const YkRef *right)
{
    size_t sides = s->w->sides, stride = n + sides;
    YkRef *system = YK_NEW(s->w->f->program->arena, YkRef, n * stride + 1);
    if (!system) return false;
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < n; k++) system[i * stride + k] = *entry(s, rows[i], columns[k]);
        for (size_t side = 0; side < sides; side++) system[i * stride + n + side] = right[side * n + i];
    }
    int32_t call = yk_graph_call(s->g, (YkCall){.kind = YK_CALL_SOLVE,
                                                .n = (int32_t)n,
                                                .m = (int32_t)sides,
                                                .arguments = system,
                                                .argument_count = n * stride,
                                                .result_count = n * stride + 1,
                                                .name = "bodies"});
    for (size_t k = 0; k < n; k++)
        for (size_t side = 0; side < sides; side++)
            s->w->solution[columns[k] * sides + side] = yk_graph_result(s->g, call, k * stride + n + side);
    note_determinant(s, yk_graph_result(s->g, call, n * stride));
    return true;
}

static bool solve_block(const Solver *s, size_t n, const size_t *rows, const size_t *columns, const bool *is_known)
{
    size_t sides = s->w->sides;
    YkRef *right = YK_NEW(s->arena, YkRef, n * sides + 1);
    if (!right) return false;
    for (size_t side = 0; side < sides; side++)
        for (size_t i = 0; i < n; i++) right[side * n + i] = right_side(s, rows[i], side, is_known);
    if (n > 2) return solve_many(s, n, rows, columns, right);
    if (n == 2)
        solve_two(s, rows, columns, right);
    else
        solve_one(s, rows[0], columns[0], right);
    return true;
}

static bool solve_blocks(const Solver *s, bool *is_known)
{
    Blocks b = {.count = s->n - s->pivot_count};
    b.row = YK_NEW(s->arena, size_t, b.count + 1);
    b.column = YK_NEW(s->arena, size_t, b.count + 1);
    b.block_of = YK_NEW(s->arena, int32_t, b.count + 1);
    size_t *rows = YK_NEW(s->arena, size_t, b.count + 1), *columns = YK_NEW(s->arena, size_t, b.count + 1);
    if (yk_arena_failed(s->arena)) return false;
    for (size_t j = 0, k = 0; j < s->n; j++)
        if (!s->column_is_done[j]) b.column[k++] = j;
    if (!match(s, &b) || !find_blocks(s, &b)) return false;
    for (size_t block = 0; block < b.block_count; block++) {
        size_t n = 0;
        for (size_t k = 0; k < b.count; k++) {
            if (b.block_of[k] != (int32_t)block) continue;
            rows[n] = b.row[k];
            columns[n++] = b.column[k];
        }
        if (!solve_block(s, n, rows, columns, is_known)) return false;
        for (size_t k = 0; k < n; k++) is_known[columns[k]] = true;
    }
    return true;
}

// --- all of it

static void solve_pivots(const Solver *s, bool *is_known)
{
    for (size_t k = s->pivot_count; k-- > 0;) {
        Pivot p = s->pivots[k];
        for (size_t side = 0; side < s->w->sides; side++)
            s->w->solution[p.column * s->w->sides + side] =
                yk_graph_divide(s->g, right_side(s, p.row, side, is_known), *entry(s, p.row, p.column));
        is_known[p.column] = true;
    }
}

static bool run(Solver *s)
{
    Pivot p = {0, 0};
    s->row_is_done = YK_NEW(s->arena, bool, s->n + 1);
    s->column_is_done = YK_NEW(s->arena, bool, s->n + 1);
    s->row_count = YK_NEW(s->arena, size_t, s->n + 1);
    s->column_count = YK_NEW(s->arena, size_t, s->n + 1);
    s->pivots = YK_NEW(s->arena, Pivot, s->n + 1);
    bool *is_known = YK_NEW(s->arena, bool, s->n + 1);
    if (yk_arena_failed(s->arena)) return false;
    while (find_pivot(s, &p)) eliminate(s, p);
    if (!solve_blocks(s, is_known)) return false;
    solve_pivots(s, is_known);
    if (s->w->f->determinant == 0) s->w->f->determinant = yk_graph_number(s->g, 1); // nothing can vanish
    return !s->g->failed;
}

bool yk_balance_solve(YkBalanceSystem *w)
{
    YkArena *arena = yk_arena_new();
    w->ran_out = !arena;
    if (!arena) return false;
    w->f->determinant = 0;
    bool solved =
        run(&(Solver){.w = w, .g = &w->f->program->graph, .arena = arena, .n = w->n, .stride = w->n + w->sides});
    w->ran_out = yk_arena_failed(arena) || w->f->program->graph.failed || yk_arena_failed(w->f->program->arena);
    yk_arena_free(arena);
    return solved;
}
