// Finds what binds the tree's angles at all poses seen of this machine and of others like it: whole multiples of some
// add up to a constant, as the opposite sides of a parallelogram stay parallel. Found in the rates.
#include <math.h>
#include <stdlib.h>
#include "num/dense.h"
#include "prove/check_inside.h"

enum { ANGLES_MAX = 64, FACTOR_MAX = 6, TURNS_IN_PI = 12 };
static const double EQUAL = 1e-6;

typedef struct Search {
    YkCheck *check;
    int32_t *angle; // coordinates that are angles: [angles]; first the independent ones
    size_t angles, independent;
    double *size, *A, *b, *x, *tau;
    size_t *order;
} Search;

static double position(const Search *s, size_t pose, int32_t coordinate)
{
    return s->check->seen->motion[2 * s->check->d->tree_count * pose + (size_t)coordinate];
}

static double rate(const Search *s, size_t pose, int32_t coordinate)
{
    return position(s, pose, (int32_t)s->check->d->tree_count + coordinate);
}

// Expresses a coordinate's rate by those of the independent ones, in x; returns the remainder over its size.
static double express(Search *s, int32_t coordinate)
{
    size_t rows = s->check->seen->count, n = s->independent;
    double left = 0;
    for (size_t r = 0; r < rows; r++) {
        s->b[r] = rate(s, r, coordinate);
        for (size_t k = 0; k < n; k++) s->A[r * n + k] = rate(s, r, s->angle[k]);
    }
    size_t rank = n > 0 ? yk_qr_factor(rows, n, s->A, s->order, s->tau, 1e-12) : 0;
    if (n > 0) yk_qr_solve(rows, n, s->A, s->order, s->tau, rank, s->b, s->x);
    for (size_t r = 0; r < rows; r++) {
        double rest = rate(s, r, coordinate);
        for (size_t k = 0; k < n; k++) rest -= s->x[k] * rate(s, r, s->angle[k]);
        left = fmax(left, fabs(rest));
    }
    return left;
}

// Sorts slow angles first: one that turns twice as fast is then a whole multiple.
static void sort_by_size(Search *s)
{
    const YkCheckSeen *seen = s->check->seen;
    for (size_t k = 0; k < s->angles; k++) {
        s->size[k] = 0;
        for (size_t r = 0; r < seen->count; r++) s->size[k] = fmax(s->size[k], fabs(rate(s, r, s->angle[k])));
        for (size_t i = k; i > 0 && s->size[i] < s->size[i - 1]; i--) {
            double size = s->size[i];
            int32_t angle = s->angle[i];
            s->size[i] = s->size[i - 1], s->angle[i] = s->angle[i - 1];
            s->size[i - 1] = size, s->angle[i - 1] = angle;
        }
    }
}

// Adds to the independent angles those that they do not give.
static void choose_independent(Search *s)
{
    double most = s->angles > 0 ? s->size[s->angles - 1] : 0;
    for (size_t k = 0; k < s->angles; k++) {
        int32_t own = s->angle[k];
        if (express(s, own) <= EQUAL * most) continue;
        for (size_t i = k; i > s->independent; i--) s->angle[i] = s->angle[i - 1];
        s->angle[s->independent++] = own;
    }
}

static bool make_bond(Search *s, int32_t pivot, YkLoopBond *bond)
{
    YkDerivation *d = s->check->d;
    double first = 0;
    express(s, pivot);
    *bond = (YkLoopBond){.pivot = pivot, .factor = YK_NEW(d->arena, int32_t, d->tree_count + 1)};
    if (!bond->factor) return false;
    for (size_t k = 0; k < s->independent; k++) {
        double whole = round(s->x[k]);
        if (fabs(whole) > FACTOR_MAX || fabs(s->x[k] - whole) > EQUAL) return false;
        bond->factor[s->angle[k]] = -(int32_t)whole;
    }
    bond->factor[pivot] = 1;
    for (size_t r = 0; r < s->check->seen->count; r++) {
        double sum = 0;
        for (size_t k = 0; k < d->tree_count; k++) sum += bond->factor[k] * position(s, r, (int32_t)k);
        if (r == 0) first = sum;
        if (fabs(sum - first) > EQUAL) return false;
    }
    double turns = round(first * TURNS_IN_PI / YK_PI);
    bond->turns = (int32_t)turns;
    return fabs(turns) < 1e6 && fabs(first - turns * YK_PI / TURNS_IN_PI) < EQUAL;
}

static const YkLoopBonds *list_bonds(Search *s)
{
    YkLoopBonds *bonds = YK_NEW(s->check->d->arena, YkLoopBonds, 1);
    if (bonds) bonds->bond = YK_NEW(s->check->d->arena, YkLoopBond, s->angles + 1);
    if (!bonds || !bonds->bond) return NULL;
    sort_by_size(s);
    choose_independent(s);
    for (size_t k = s->independent; k < s->angles; k++)
        bonds->count += make_bond(s, s->angle[k], &bonds->bond[bonds->count]);
    return bonds->count > 0 ? bonds : NULL;
}

const YkLoopBonds *yk_check_find_bonds(YkCheck *check)
{
    const YkDerivation *d = check->d;
    Search s = {.check = check};
    const YkLoopBonds *bonds = NULL;
    s.angle = yk_derive_scratch(check->d, d->tree_count + 1, sizeof *s.angle);
    for (size_t k = 0; s.angle && k < d->tree_count; k++)
        if (!d->coordinates[k].is_distance) s.angle[s.angles++] = (int32_t)k;
    // gears bind angles by numbers of teeth, and too few poses prove nothing
    if (d->tie_count > 0 || s.angles == 0 || s.angles > ANGLES_MAX || check->seen->count < d->mech->input_count + 4) {
        free(s.angle);
        return NULL;
    }
    size_t rows = check->seen->count;
    s.size = yk_derive_scratch(check->d, 3 * s.angles + rows * (s.angles + 1), sizeof *s.size);
    s.order = yk_derive_scratch(check->d, s.angles, sizeof *s.order);
    if (s.size && s.order) {
        s.x = s.size + s.angles, s.tau = s.x + s.angles, s.b = s.tau + s.angles, s.A = s.b + rows;
        bonds = list_bonds(&s);
    }
    free(s.angle);
    free(s.size);
    free(s.order);
    return bonds;
}
