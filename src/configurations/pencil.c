// Combines the equations of a group such that few monomials are left.
#include "configurations/pencil.h"
#include <stdlib.h>
#include "base/mix.h"
#include "num/complex.h"

enum { MOST = YK_ELIMINATION_MOST, SET_MAX = 4096 };

typedef struct Set {
    YkMonomial of[SET_MAX];
    size_t count;
} Set;

// A multiplier is a monomial times one loop (monomials of `first`), or times one conjugate (of `second`).
typedef struct Multipliers {
    const YkHidden *hidden;
    Set first, second;
    Set all; // the monomials of all products; those that are kept come first
    size_t kept, count;
    YkVec *rest;   // [all][count]: the coefficients of the products without h
    YkVec *with_h; // [kept][count]: those of h
    YkVec *kernel; // [count][combinations]
    size_t *order; // [count]
    size_t combinations;
} Multipliers;

static YkMonomial with_distance(YkMonomial m, size_t slide)
{
    return m + ((YkMonomial)(slide + 1) << 28);
}

// Returns the place of a monomial, and adds it if it is new.
static size_t put(Set *set, YkMonomial m)
{
    for (size_t k = 0; k < set->count; k++)
        if (set->of[k] == m) return k;
    set->of[set->count] = m;
    return set->count++;
}

// Lists the multipliers. In Dixon's determinant every unknown has a column. The columns are divided into those of which
// the loops' half is taken and those of which the conjugates' half is; the product of what they contribute multiplies
// the loops if L - 1 are of the first kind, and the conjugates if L are.
static void list_monomials(Multipliers *w)
{
    const YkHidden *h = w->hidden;
    YkMonomial one = 0;
    size_t columns = h->angles + h->slides;
    for (int k = 0; k < 7; k++) one = yk_times_angle(one, k, 8);
    for (size_t up = 0; up < (size_t)1 << columns; up++) {
        YkMonomial m = one;
        size_t taken = 0;
        for (size_t k = 0; k < columns; k++) {
            bool is_up = up >> k & 1;
            taken += is_up;
            m = k < h->angles ? yk_times_angle(m, (int)k, is_up)
                              : yk_times_angle(m, h->turning[k - h->angles], is_up ? 1 : -1);
        }
        if (taken + 1 == h->loops) put(&w->first, m);
        if (taken == h->loops) put(&w->second, m);
    }
    for (size_t k = 0; k < w->first.count; k++) put(&w->all, w->first.of[k]);
    for (size_t k = 0; k < w->second.count; k++) put(&w->all, w->second.of[k]);
    w->kept = w->all.count;
    w->count = h->loops * (w->first.count + w->second.count);
}

// Multiplies an equation by a monomial: lists the product's monomials, and writes its coefficients if there is room.
static void expand(Multipliers *w, YkMonomial m, size_t row, size_t column)
{
    const YkHidden *h = w->hidden;
    size_t width = h->angles + h->slides + 1;
    int sign = row < h->loops ? 1 : -1;
    for (size_t k = 0; k < width; k++) {
        YkVec a = h->coefficients[row * width + k];
        YkMonomial product = m;
        if (a.x == 0 && a.y == 0) continue;
        if (k < h->angles) product = yk_times_angle(m, (int)k, sign);
        if (k >= h->angles && k + 1 < width)
            product = with_distance(yk_times_angle(m, h->turning[k - h->angles], sign), k - h->angles);
        size_t place = put(&w->all, product);
        if (w->rest) w->rest[place * w->count + column] = a;
    }
    if (w->rest) w->with_h[put(&w->all, m) * w->count + column] = h->times[row];
}

static void expand_all(Multipliers *w)
{
    size_t column = 0, loops = w->hidden->loops;
    for (size_t k = 0; k < w->first.count; k++)
        for (size_t l = 0; l < loops; l++) expand(w, w->first.of[k], l, column++);
    for (size_t k = 0; k < w->second.count; k++)
        for (size_t l = 0; l < loops; l++) expand(w, w->second.of[k], loops + l, column++);
}

static bool make_room(Multipliers *w)
{
    size_t n = w->count;
    w->rest = calloc(w->all.count * n, sizeof *w->rest);
    w->with_h = calloc(w->kept * n, sizeof *w->with_h);
    w->kernel = calloc(n * n, sizeof *w->kernel);
    w->order = calloc(n, sizeof *w->order);
    return w->rest && w->with_h && w->kernel && w->order;
}

// Writes the kept coefficients of a combination: those without h, and those of h. Conjugates with a hidden angle have
// 1 / h, and are multiplied by h.
static void write_row(const Multipliers *w, size_t combination, YkVec row[2][MOST])
{
    for (size_t e = 0; e < w->kept; e++) row[0][e] = row[1][e] = yk_vec(0, 0);
    for (size_t m = 0; m < w->count; m++) {
        YkVec factor = w->kernel[m * w->combinations + combination];
        if (factor.x == 0 && factor.y == 0) continue;
        bool is_turned = w->hidden->is_angle && m >= w->hidden->loops * w->first.count;
        for (size_t e = 0; e < w->kept; e++) {
            row[is_turned][e] = yk_add_product(row[is_turned][e], factor, w->rest[e * w->count + m]);
            row[!is_turned][e] = yk_add_product(row[!is_turned][e], factor, w->with_h[e * w->count + m]);
        }
    }
}

// Adds random multiples of a combination to all rows.
static void add_to_rows(YkPencil *p, YkVec row[2][MOST], uint64_t *seed)
{
    size_t n = p->count;
    for (size_t r = 0; r < n; r++) {
        YkVec share = yk_unit(2 * YK_PI * yk_mix_unit(seed));
        for (size_t e = 0; e < n; e++) {
            p->M[0][r * n + e] = yk_add_product(p->M[0][r * n + e], share, row[0][e]);
            p->M[1][r * n + e] = yk_add_product(p->M[1][r * n + e], share, row[1][e]);
        }
    }
}

// Finds the combinations in which kept monomials alone are left, and mixes them. Returns false if they are too few.
static bool combine(Multipliers *w, YkPencil *p)
{
    const double zero = 1e-10;
    uint64_t seed = 1;
    YkVec row[2][MOST];
    size_t n = p->count = w->kept;
    size_t rank = yk_complex_kernel(w->all.count - n, w->count, w->rest + n * w->count, w->order, zero, w->kernel);
    w->combinations = w->count - rank;
    if (w->combinations < n) return false;
    for (size_t e = 0; e < n; e++) p->monomials[e] = w->all.of[e];
    for (size_t k = 0; k < n * n; k++) p->M[0][k] = p->M[1][k] = yk_vec(0, 0);
    for (size_t c = 0; c < w->combinations; c++) {
        write_row(w, c, row);
        add_to_rows(p, row, &seed);
    }
    return true;
}

YkPencilStatus yk_pencil_make(YkPencil *pencil, const YkHidden *hidden)
{
    Multipliers *w = calloc(1, sizeof *w);
    YkPencilStatus status = YK_PENCIL_NO_MEMORY;
    if (!w) return status;
    w->hidden = hidden;
    pencil->hidden = hidden;
    list_monomials(w);
    if (w->kept > MOST) {
        status = YK_PENCIL_NONE;
    } else {
        expand_all(w); // lists the monomials
        if (make_room(w)) {
            expand_all(w);
            status = combine(w, pencil) ? YK_PENCIL_MADE : YK_PENCIL_NONE;
        }
    }
    free(w->rest);
    free(w->with_h);
    free(w->kernel);
    free(w->order);
    free(w);
    return status;
}

int yk_pencil_column(const YkPencil *pencil, YkMonomial monomial)
{
    for (size_t k = 0; k < pencil->count; k++)
        if (pencil->monomials[k] == monomial) return (int)k;
    return -1;
}
