// Ratios as formulas in tooth numbers: Cramer's rule over polynomials, on no more equations than the ratio needs.
//
// Bodies that stand still or turn together are one unknown. Random tooth numbers modulo a prime show which of the
// remaining equations take part, so that no coincidence of the real ones decides. The determinants are expanded row by
// row; states that used the same columns are added up, and since a row has at most three entries there are few.
#include <stdlib.h>
#include <string.h>
#include "base/mix.h"
#include "design/trains/train.h"

enum { ROWS_MAX = 24, COLUMNS_MAX = 30, SYMBOLS_MAX = 40, TERMS_MAX = 2000, STATES_MAX = 4000 };
#define PRIME UINT64_C(2147483647) // 2^31 - 1

typedef struct Work {
    const YkTrainCase *one;
    YkRing *ring;
    int32_t *class_of;           // per column of the net: 0 stands still, otherwise 1 + its number; -1 not numbered yet
    int32_t rows, columns;       // of the small system
    int32_t row[ROWS_MAX];       // of the case
    uint64_t value[SYMBOLS_MAX]; // random
    uint64_t cell[ROWS_MAX][COLUMNS_MAX], trace[ROWS_MAX][ROWS_MAX];
    int32_t pivot[ROWS_MAX]; // column that the row solves, or -1
    const YkPoisson *symbol[SYMBOLS_MAX];
} Work;

static uint64_t power(uint64_t base, uint64_t exponent)
{
    uint64_t result = 1;
    for (; exponent > 0; exponent >>= 1, base = base * base % PRIME)
        if (exponent & 1) result = result * base % PRIME;
    return result;
}

// A plain congruential sequence would be geometric, and its products would coincide.
static uint64_t random_value(uint64_t *seed)
{
    return 1 + yk_mix_next(seed) % (PRIME - 1);
}

// --- The small system

static int32_t root(const int32_t *parent, int32_t column)
{
    while (parent[column] != column) column = parent[column];
    return column;
}

static bool is_tie(const YkTrainRow *row)
{
    return row->kind == YK_ROW_GROUND || row->kind == YK_ROW_KEPT || row->kind == YK_ROW_HOLD ||
           row->kind == YK_ROW_JOIN;
}

// Puts the columns that turn together in one class; the ground's root is always column 0.
static void tie(const YkTrainCase *one, int32_t *parent)
{
    for (int32_t c = 0; c < one->net->columns; c++) parent[c] = c;
    for (int32_t r = 0; r < one->row_count; r++) {
        const YkTrainRow *row = &one->rows[r];
        if (!is_tie(row) || row->count == 0) continue;
        int32_t a = root(parent, row->terms[0].column), b = row->count > 1 ? root(parent, row->terms[1].column) : 0;
        if (a < b) parent[b] = a;
        if (b < a) parent[a] = b;
    }
}

static bool number_classes(Work *work)
{
    const YkTrainNet *net = work->one->net;
    int32_t *parent = calloc((size_t)net->columns + 1, sizeof *parent);
    if (!parent) yk_ring_fail(work->ring, YK_RING_MEMORY);
    if (!parent) return false;
    tie(work->one, parent);
    for (int32_t c = 0; c < net->columns; c++) {
        int32_t top = root(parent, c);
        work->class_of[c] = top == 0 ? 0 : top == c ? ++work->columns : work->class_of[top];
    }
    free(parent);
    for (int32_t r = 0; r < work->one->row_count; r++) {
        if (is_tie(&work->one->rows[r])) continue;
        if (work->rows == ROWS_MAX) return false;
        work->row[work->rows++] = r;
    }
    return work->columns <= COLUMNS_MAX;
}

static void fill(Work *work)
{
    uint64_t seed = 12345;
    for (int32_t s = 0; s < work->one->net->symbol_count; s++) work->value[s] = random_value(&seed);
    for (int32_t r = 0; r < work->rows; r++) {
        const YkTrainRow *row = &work->one->rows[work->row[r]];
        work->pivot[r] = -1;
        work->trace[r][r] = 1;
        for (int32_t t = 0; t < row->count; t++) {
            int32_t column = work->class_of[row->terms[t].column] - 1;
            if (column < 0) continue;
            uint64_t by = row->terms[t].symbol < 0 ? 1 : work->value[row->terms[t].symbol];
            work->cell[r][column] = (work->cell[r][column] + (row->terms[t].sign < 0 ? PRIME - by : by)) % PRIME;
        }
    }
}

static void subtract(Work *work, int32_t row, int32_t pivot, int32_t column)
{
    uint64_t by = PRIME - work->cell[row][column];
    for (int32_t c = 0; c < work->columns; c++)
        work->cell[row][c] = (work->cell[row][c] + by * work->cell[pivot][c]) % PRIME;
    for (int32_t r = 0; r < work->rows; r++)
        work->trace[row][r] = (work->trace[row][r] + by * work->trace[pivot][r]) % PRIME;
}

static void reduce(Work *work)
{
    for (int32_t r = 0; r < work->rows; r++) {
        int32_t column = 0;
        while (column < work->columns && work->cell[r][column] == 0) column++;
        if (column == work->columns) continue;
        work->pivot[r] = column;
        uint64_t by = power(work->cell[r][column], PRIME - 2);
        for (int32_t c = 0; c < work->columns; c++) work->cell[r][c] = work->cell[r][c] * by % PRIME;
        for (int32_t k = 0; k < work->rows; k++) work->trace[r][k] = work->trace[r][k] * by % PRIME;
        for (int32_t k = 0; k < work->rows; k++)
            if (k != r && work->cell[k][column] != 0) subtract(work, k, r, column);
    }
}

// --- Determinants

// Rows and columns that take part, numbered as in the small system.
typedef struct Square {
    int32_t size;
    int32_t row[ROWS_MAX], column[ROWS_MAX];
} Square;

static const YkPoisson *entry(Work *work, int32_t row, int32_t column)
{
    const YkTrainRow *source = &work->one->rows[work->row[row]];
    const YkPoisson *sum = NULL;
    for (int32_t t = 0; t < source->count; t++) {
        const YkTrainTerm *term = &source->terms[t];
        if (work->class_of[term->column] - 1 != column) continue;
        const YkPoisson *part = term->symbol < 0 ? yk_ring_rational(work->ring, 1, 1) : work->symbol[term->symbol];
        if (term->sign < 0) part = yk_ring_negate(work->ring, part);
        sum = sum ? yk_ring_add(work->ring, sum, part) : part;
    }
    return sum && yk_ring_terms(sum) > 0 ? sum : NULL;
}

typedef struct State {
    uint32_t used; // columns
    const YkPoisson *sum;
} State;

static void gather(Work *work, State *states, size_t *count, uint32_t used, const YkPoisson *part)
{
    for (size_t i = 0; i < *count; i++) {
        if (states[i].used != used) continue;
        states[i].sum = yk_ring_add(work->ring, states[i].sum, part);
        return;
    }
    if (*count < STATES_MAX) states[(*count)++] = (State){used, part};
}

static bool is_odd(uint32_t bits)
{
    bool odd = false;
    for (; bits; bits &= bits - 1) odd = !odd;
    return odd;
}

// Adds one row: every state continues with every entry of the row in a column that is still free.
static size_t expand(Work *work, const Square *square, int32_t row, const State *from, size_t count, State *to)
{
    size_t reached = 0;
    for (int32_t c = 0; c < square->size; c++) {
        const YkPoisson *by = entry(work, row, square->column[c]);
        for (size_t i = 0; by && i < count; i++) {
            uint32_t bit = UINT32_C(1) << c;
            if (from[i].used & bit) continue;
            const YkPoisson *part = yk_ring_multiply(work->ring, from[i].sum, by);
            if (is_odd(from[i].used >> (c + 1))) part = yk_ring_negate(work->ring, part);
            gather(work, to, &reached, from[i].used | bit, part);
        }
    }
    return reached;
}

// Returns the determinant without one row and one column (-1: with all); NULL if it is zero or too large.
static const YkPoisson *determinant(Work *work, const Square *all, int32_t without_row, int32_t without_column)
{
    Square square = {0};
    State *states = calloc(2 * (size_t)STATES_MAX, sizeof *states);
    size_t count = 1;
    if (!states) return yk_ring_fail(work->ring, YK_RING_MEMORY);
    for (int32_t k = 0; k < all->size; k++)
        if (all->column[k] != without_column) square.column[square.size++] = all->column[k];
    State *from = states, *to = states + STATES_MAX;
    from[0] = (State){0, yk_ring_rational(work->ring, 1, 1)};
    for (int32_t k = 0; k < all->size && count > 0 && count < STATES_MAX; k++) {
        if (all->row[k] == without_row) continue;
        count = expand(work, &square, all->row[k], from, count, to);
        State *swap = from;
        from = to;
        to = swap;
    }
    const YkPoisson *result = count == 1 ? from[0].sum : NULL;
    free(states);
    return yk_ring_terms(result) > 0 ? result : NULL;
}

// --- Cramer

static bool is_independent(Work *work, Square *square, int32_t column, uint64_t basis[ROWS_MAX][ROWS_MAX],
                           int32_t lead[ROWS_MAX], Work *original)
{
    uint64_t vector[ROWS_MAX];
    int32_t rows = 0;
    for (int32_t r = 0; r < work->rows; r++) vector[r] = 0;
    for (int32_t k = 0; k < ROWS_MAX && square->row[k] >= 0; k++)
        vector[rows++] = original->cell[square->row[k]][column];
    for (int32_t b = 0; b < square->size; b++) {
        uint64_t by = PRIME - vector[lead[b]];
        for (int32_t r = 0; r < rows; r++) vector[r] = (vector[r] + by * basis[b][r]) % PRIME;
    }
    int32_t first = 0;
    while (first < rows && vector[first] == 0) first++;
    if (first == rows) return false;
    uint64_t by = power(vector[first], PRIME - 2);
    for (int32_t r = 0; r < rows; r++) basis[square->size][r] = vector[r] * by % PRIME;
    lead[square->size] = first;
    square->column[square->size++] = column;
    return true;
}

// Chooses the equations whose combination gives this unknown, and as many unknowns in them, this one first.
static bool choose(Work *work, int32_t target, Square *square)
{
    uint64_t basis[ROWS_MAX][ROWS_MAX];
    int32_t lead[ROWS_MAX], solving = -1, count = 0;
    Work *original = calloc(1, sizeof *original);
    if (!original) yk_ring_fail(work->ring, YK_RING_MEMORY);
    if (!original) return false;
    memcpy(original, work, sizeof *original);
    reduce(work);
    for (int32_t r = 0; r < work->rows; r++)
        if (work->pivot[r] == target) solving = r;
    bool good = solving >= 0;
    for (int32_t c = 0; good && c < work->columns; c++) good = c == target || work->cell[solving][c] == 0;
    for (int32_t r = 0; r < ROWS_MAX; r++) square->row[r] = -1;
    for (int32_t r = 0; good && r < work->rows; r++)
        if (work->trace[solving][r] != 0) square->row[count++] = r;
    square->size = 0;
    if (good) good = is_independent(work, square, target, basis, lead, original);
    for (int32_t c = 0; good && c < work->columns && square->size < count; c++)
        if (c != target) is_independent(work, square, c, basis, lead, original);
    free(original);
    return good && square->size == count;
}

// Finds over / under of the share; over is 0 if the column stands still or the input has no part in it. Returns false
// if there is no formula.
static bool share(Work *work, int32_t target, int32_t input, const YkPoisson **over, const YkPoisson **under)
{
    Square square;
    int32_t at = -1;
    *over = yk_ring_rational(work->ring, 0, 1);
    *under = yk_ring_rational(work->ring, 1, 1);
    if (target < 0) return true; // it stands still
    if (!choose(work, target, &square)) return false;
    for (int32_t k = 0; k < square.size; k++)
        if (work->one->rows[work->row[square.row[k]]].input == input) at = k;
    if (at < 0) return true;
    *under = determinant(work, &square, -1, -1);
    *over = square.size > 1 ? determinant(work, &square, square.row[at], target) : yk_ring_rational(work->ring, 1, 1);
    if (at % 2 == 1) *over = yk_ring_negate(work->ring, *over); // the target's column comes first
    return *over && *under;
}

bool yk_train_share_in(const YkTrainCase *one, int32_t column, int32_t input, YkRing *ring,
                       const YkPoisson *const *symbols, const YkPoisson **over, const YkPoisson **under)
{
    const YkTrainNet *net = one->net;
    if (net->symbol_count > SYMBOLS_MAX || net->mesh_count > ROWS_MAX) return false;
    Work *work = calloc(1, sizeof *work);
    bool good = false;
    if (!work) yk_ring_fail(ring, YK_RING_MEMORY);
    if (!work) return false;
    work->one = one;
    work->ring = ring;
    work->class_of = calloc((size_t)net->columns + 1, sizeof *work->class_of);
    if (!work->class_of) {
        yk_ring_fail(ring, YK_RING_MEMORY);
    } else if (number_classes(work)) {
        fill(work);
        yk_ring_set_limit(ring, TERMS_MAX);
        for (int32_t s = 0; s < net->symbol_count; s++) work->symbol[s] = symbols[s];
        good = share(work, work->class_of[column] - 1, input, over, under);
        yk_ring_set_limit(ring, YK_RING_TERMS_MAX);
    }
    free(work->class_of);
    free(work);
    return good && yk_ring_status(ring) == YK_RING_OK;
}

static const char *write(YkRing *ring, const YkPoisson *over, const YkPoisson *under, bool is_inverse, YkArena *arena)
{
    YkText text = {0};
    YkTrainQuotient quotient;
    bool is_zero = yk_ring_is_zero(over);
    if (is_zero && is_inverse) return NULL;
    if (is_zero) return "0";
    if (yk_train_quotient(ring, is_inverse ? under : over, is_inverse ? over : under, &quotient) &&
        yk_train_write_quotient(&quotient, &text))
        return yk_train_keep(arena, &text);
    if (text.failed) yk_arena_fail(arena);
    yk_text_free(&text);
    return NULL;
}

const char *yk_train_formula(const YkTrainCase *one, int32_t column, int32_t input, bool is_inverse, YkArena *arena)
{
    const YkTrainNet *net = one->net;
    const YkPoisson *symbols[SYMBOLS_MAX], *over, *under;
    const char *text = NULL;
    if (net->symbol_count > SYMBOLS_MAX) return NULL;
    YkRing *ring = yk_ring_new();
    for (int32_t s = 0; ring && s < net->symbol_count; s++)
        symbols[s] = yk_ring_of(ring, yk_ring_symbol(ring, net->symbols[s].name, YK_RING_CONSTANT));
    if (ring && yk_train_share_in(one, column, input, ring, symbols, &over, &under))
        text = write(ring, over, under, is_inverse, arena);
    if (!ring || yk_ring_status(ring) == YK_RING_MEMORY) yk_arena_fail(arena);
    yk_ring_free(ring);
    return text;
}
