// Solves a group by Newton's method: position, velocity and acceleration, and the search for all its solutions.
#include "solve/group.h"
#include <stdlib.h>
#include <string.h>
#include "num/dense.h"
#include "solve/gap.h"
#include "solve/relations.h"
#include "solve/run.h"

bool yk_group_start(YkGroupWork *w, const YkMechanism *mech)
{
    size_t n = mech->largest_group, all = mech->column_count;
    *w = (YkGroupWork){0};
    if (n == 0) return true;
    size_t total = all + 2 * n * n + 6 * n + YK_GROUP_SOLUTIONS_MAX * n;
    w->memory = calloc(total * sizeof(double) + n * (sizeof(int) + sizeof(size_t)) + 16, 1);
    if (!w->memory) return false;
    w->x = w->memory;
    w->residual = w->x + all;
    w->scale = w->residual + n;
    w->step = w->scale + n;
    w->trial = w->step + n;
    w->tau = w->trial + n;
    w->J = w->tau + 2 * n;
    w->A = w->J + n * n;
    w->solutions = w->A + n * n;
    w->order = (size_t *)(w->solutions + YK_GROUP_SOLUTIONS_MAX * n);
    w->pivot = (int *)(w->order + n);
    return true;
}

void yk_group_end(YkGroupWork *w)
{
    free(w->memory);
    *w = (YkGroupWork){0};
}

// One group in one pose.
typedef struct Group {
    const YkMechanism *mech;
    const YkSpace *space;
    const YkBlock *block;
    const YkColumn *columns;
    size_t m, n;
    double *x;
    const YkRun *run;
} Group;

static Group group_of(const YkRun *run, size_t index)
{
    const YkBlock *b = &run->mech->blocks[index];
    return (Group){.mech = run->mech,
                   .space = run->space,
                   .block = b,
                   .columns = run->mech->group_columns + b->first_column,
                   .m = yk_block_rows(b),
                   .n = b->column_count,
                   .x = run->groups->x + b->first_column,
                   .run = run};
}

static int32_t relation_of(const Group *g, size_t k)
{
    return g->mech->group_relations[g->block->first_relation + k];
}

static int find_column(const Group *g, bool is_distance, int32_t index)
{
    for (size_t k = 0; k < g->n; k++)
        if (g->columns[k].is_distance == is_distance && g->columns[k].index == index) return (int)k;
    return -1;
}

// The unit vector of an orientation: known, or its group's unknown root turned by the relative orientation.
typedef struct Arrow {
    YkVec e;
    double w, a;
    int column;
} Arrow;

static Arrow arrow_of(const Group *g, int32_t slot, const double *x)
{
    const YkMechanism *mech = g->mech;
    if (slot == 0) return (Arrow){{1, 0}, 0, 0, -1};
    int column = find_column(g, false, mech->group_root[slot]);
    int32_t from = column < 0 ? slot : mech->relative_slot[slot];
    Arrow arrow = {{1, 0}, 0, 0, column};
    if (from != 0) {
        YkTurn t = yk_space_turn(g->space, from);
        arrow = (Arrow){{t.c[0], t.s[0]}, t.w[0], t.a[0], column};
    }
    if (column >= 0) arrow.e = yk_mul(arrow.e, yk_unit(x[column]));
    return arrow;
}

static void add_node(const Group *g, int32_t node, double sign, YkVec out[3])
{
    if (node == YK_NONE) return;
    YkPlane p = yk_space_plane(g->space, node);
    out[0] = yk_add(out[0], yk_scale(sign, yk_vec(p.x[0], p.y[0])));
    out[1] = yk_add(out[1], yk_scale(sign, yk_vec(p.vx[0], p.vy[0])));
    out[2] = yk_add(out[2], yk_scale(sign, yk_vec(p.ax[0], p.ay[0])));
}

static void add_to_column(double *J, size_t n, size_t row, int column, YkVec v)
{
    if (column < 0) return;
    J[row * n + (size_t)column] += v.x;
    J[(row + 1) * n + (size_t)column] += v.y;
}

// Evaluates the residuals of the relations, m, with the same weight as a loop's.
static void evaluate_relations(const Group *g, const double *x, double *residual, double *J)
{
    for (size_t k = 0; k < g->block->relation_count; k++) {
        size_t row = 2 * g->block->loop_count + k;
        YkRelationPose pose = yk_relation_pose(g->run, (size_t)relation_of(g, k), x, NULL);
        residual[row] = pose.value.position;
        if (J) yk_relation_gradient(g->mech, (size_t)relation_of(g, k), pose.slope, J + row * g->n);
    }
}

// Evaluates residual[m] and J[m][n], or NULL.
static void evaluate(const Group *g, const double *x, double *residual, double *J)
{
    if (J) memset(J, 0, g->m * g->n * sizeof *J);
    evaluate_relations(g, x, residual, J);
    for (size_t l = 0; l < g->block->loop_count; l++) {
        const YkSum *sum = &g->mech->group_loops[g->block->first_loop + l];
        YkVec total[3] = {sum->constant, {0, 0}, {0, 0}};
        add_node(g, sum->plus, 1, total);
        add_node(g, sum->minus, -1, total);
        for (uint32_t k = 0; k < sum->count; k++) {
            YkTerm t = g->mech->terms[sum->first + k];
            Arrow arrow = arrow_of(g, t.slot, x);
            YkVec v = yk_mul(arrow.e, t.v);
            double d = 1;
            if (t.distance != YK_NONE) {
                int column = find_column(g, true, t.distance);
                d = column >= 0 ? x[column] : yk_space_slide(g->space, t.distance).d[0];
                if (J) add_to_column(J, g->n, 2 * l, column, v);
            }
            total[0] = yk_add(total[0], yk_scale(d, v));
            if (J) add_to_column(J, g->n, 2 * l, arrow.column, yk_scale(d, yk_quarter(v)));
        }
        residual[2 * l] = total[0].x;
        residual[2 * l + 1] = total[0].y;
    }
}

static double norm(const double *v, size_t n)
{
    double sum = 0;
    for (size_t k = 0; k < n; k++) sum += v[k] * v[k];
    return sqrt(sum);
}

// Returns the least sine of the angle between a column and those pivoted before it. The factors are in w->A, the
// columns themselves in w->J.
static double least_sine(const YkGroupWork *w, const Group *g)
{
    double least = 1;
    for (size_t k = 0; k < g->n; k++) {
        double sum = 0;
        for (size_t i = 0; i < g->m; i++) {
            double entry = w->J[i * g->n + w->order[k]];
            sum += entry * entry;
        }
        least = fmin(least, fabs(w->A[k * g->n + k]) / sqrt(sum));
    }
    return least;
}

// Takes the Newton (or least-squares) step from J and residual. Returns the normalised determinant; if loops repeat
// others, the least sine between columns, which is equally small at a dead point (rank deficiency: 0).
static double newton_step(YkGroupWork *w, const Group *g)
{
    memcpy(w->A, w->J, g->m * g->n * sizeof *w->A);
    for (size_t k = 0; k < g->m; k++) w->step[k] = -w->residual[k];
    if (g->m == g->n) {
        double det = yk_lu_factor(g->n, w->A, w->pivot, w->scale);
        if (det != 0) yk_lu_solve(g->n, w->A, w->pivot, w->step);
        return det;
    }
    double *b = w->scale;
    memcpy(b, w->step, g->m * sizeof *b);
    size_t rank = yk_qr_factor(g->m, g->n, w->A, w->order, w->tau, 1e-10);
    yk_qr_solve(g->m, g->n, w->A, w->order, w->tau, rank, b, w->step);
    return rank == g->n ? least_sine(w, g) : 0;
}

// Returns how far the group is from a dead point: its determinant, but at least the least sine, since the determinant
// of many columns is small even if none of them is near the span of the others.
static double distance_from_dead_point(YkGroupWork *w, const Group *g, double det)
{
    const double small = 1e-3;
    if (fabs(det) >= small || det == 0 || g->m != g->n) return det;
    memcpy(w->A, w->J, g->m * g->n * sizeof *w->A);
    if (yk_qr_factor(g->m, g->n, w->A, w->order, w->tau, 1e-14) < g->n) return det;
    return copysign(fmax(fabs(det), fmin(least_sine(w, g), small)), det);
}

static double column_size(const Group *g, size_t k)
{
    return g->columns[k].is_distance ? g->mech->size : 1;
}

// Returns the step length: a step that would turn an angle by more than a quarter turn, or change a distance by more
// than the size, is shortened.
static double step_length(const YkGroupWork *w, const Group *g)
{
    double largest = 0;
    for (size_t k = 0; k < g->n; k++) largest = fmax(largest, fabs(w->step[k]) / column_size(g, k));
    return largest > 0.7 ? 0.7 / largest : 1;
}

// Returns the residual of a relation that rounding causes, m: angles of many turns are known to fewer digits.
static double rounding_of(const Group *g)
{
    double most = 0;
    for (size_t k = 0; k < g->block->relation_count; k++)
        most = fmax(most, yk_relation_pose(g->run, (size_t)relation_of(g, k), g->x, NULL).scale);
    return 1e-15 * most;
}

static bool iterate(YkGroupWork *w, const Group *g)
{
    double size = g->mech->size, tolerance = 1e-14 * size, now;
    int limit = w->global ? 60 : 8;
    evaluate(g, g->x, w->residual, w->J);
    now = norm(w->residual, g->m);
    for (int k = 0; k < limit && now > tolerance; k++) {
        if (!yk_pace_spend(w->pace, g->m * g->n * (g->n + 20)) || newton_step(w, g) == 0) return false;
        double s = w->global ? step_length(w, g) : 1, then = now;
        for (int halving = 0; halving < 12; halving++, s *= 0.5) {
            for (size_t j = 0; j < g->n; j++) w->trial[j] = g->x[j] + s * w->step[j];
            evaluate(g, w->trial, w->residual, w->J);
            then = norm(w->residual, g->m);
            if (then < now || !w->global) break;
        }
        if (!(then < now)) break; // rounding reached, or no progress
        memcpy(g->x, w->trial, g->n * sizeof *g->x);
        now = then;
    }
    evaluate(g, g->x, w->residual, w->J);
    return now <= 1e-12 * size + rounding_of(g);
}

// Computes the known parts of velocity (order 1) or acceleration (order 2) of all loops, given the unknowns' own rates
// in `rate`.
static void known_rates(const Group *g, int order, const double *rate, double *out)
{
    for (size_t k = 0; k < g->block->relation_count; k++) {
        YkMotion value = yk_relation_pose(g->run, (size_t)relation_of(g, k), g->x, rate).value;
        out[2 * g->block->loop_count + k] = order == 1 ? value.velocity : value.acceleration;
    }
    for (size_t l = 0; l < g->block->loop_count; l++) {
        const YkSum *sum = &g->mech->group_loops[g->block->first_loop + l];
        YkVec total[3] = {{0, 0}, {0, 0}, {0, 0}};
        add_node(g, sum->plus, 1, total);
        add_node(g, sum->minus, -1, total);
        for (uint32_t k = 0; k < sum->count; k++) {
            YkTerm t = g->mech->terms[sum->first + k];
            Arrow arrow = arrow_of(g, t.slot, g->x);
            double w = arrow.w, a = arrow.a, d = 1, dv = 0, da = 0;
            if (arrow.column >= 0 && rate) w += rate[arrow.column];
            if (t.distance != YK_NONE) {
                int column = find_column(g, true, t.distance);
                YkSlide slide = yk_space_slide(g->space, t.distance);
                d = column >= 0 ? g->x[column] : slide.d[0];
                dv = column >= 0 ? (rate ? rate[column] : 0) : slide.v[0];
                da = column >= 0 ? 0 : slide.a[0];
            }
            YkVec v = yk_mul(arrow.e, t.v), iv = yk_quarter(v);
            total[1] = yk_add(total[1], yk_add(yk_scale(dv, v), yk_scale(d * w, iv)));
            total[2] = yk_add(total[2], yk_add(yk_scale(da - d * w * w, v), yk_scale(d * a + 2 * dv * w, iv)));
        }
        out[2 * l] = total[order].x;
        out[2 * l + 1] = total[order].y;
    }
}

static void write_solution(const Group *g, const double *rate, const double *accel)
{
    for (size_t k = 0; k < g->block->relation_count; k++) {
        size_t relation = (size_t)relation_of(g, k);
        g->space->gain[relation * g->space->stride] = yk_relation_pose(g->run, relation, g->x, NULL).slope;
    }
    for (size_t k = 0; k < g->n; k++) {
        if (g->columns[k].is_distance) {
            YkSlide d = yk_space_slide(g->space, g->columns[k].index);
            d.d[0] = g->x[k];
            d.v[0] = rate[k];
            d.a[0] = accel[k];
        } else {
            YkTurn t = yk_space_turn(g->space, g->columns[k].index);
            YkVec e = yk_unit(g->x[k]);
            t.c[0] = e.x;
            t.s[0] = e.y;
            t.w[0] = rate[k];
            t.a[0] = accel[k];
        }
    }
}

// Returns the least sine of the angle between a column and the span of all others, from the factors in w->A:
// the length of each row of the inverse is 1 over the distance of a column from that span. A determinant is a product
// of such sines, and in a large group it is small even if none of them is.
static double least_sine_square(YkGroupWork *w, const Group *g)
{
    double *row = w->scale, *b = w->tau, largest = 0;
    memset(row, 0, g->n * sizeof *row);
    for (size_t k = 0; k < g->n; k++) {
        memset(b, 0, g->n * sizeof *b);
        b[k] = 1;
        yk_lu_solve(g->n, w->A, w->pivot, b);
        for (size_t j = 0; j < g->n; j++) row[j] += b[j] * b[j];
    }
    for (size_t j = 0; j < g->n; j++) {
        double column = 0;
        for (size_t i = 0; i < g->m; i++) column += w->J[i * g->n + j] * w->J[i * g->n + j];
        largest = fmax(largest, row[j] * column);
    }
    return 1 / sqrt(largest);
}

// Returns the normalised determinant with its sign; if it is small in a large group, its size is the least sine.
static double determinant_of(YkGroupWork *w, const Group *g, double det)
{
    enum { SMALL_GROUP = 4 };
    if (g->m != g->n || g->n <= SMALL_GROUP || det == 0 || fabs(det) > 1e-2) return det;
    double sine = least_sine_square(w, g);
    return sine > fabs(det) ? copysign(sine, det) : det;
}

static double solve_rates(YkGroupWork *w, const Group *g)
{
    double *rate = w->trial, *accel = w->step;
    known_rates(g, 1, NULL, w->residual);
    double det = newton_step(w, g);
    memcpy(rate, w->step, g->n * sizeof *rate);
    known_rates(g, 2, rate, w->residual);
    if (det != 0) newton_step(w, g);
    det = determinant_of(w, g, det);
    if (det == 0)
        for (size_t k = 0; k < g->n; k++) rate[k] = accel[k] = 0;
    write_solution(g, rate, accel);
    return det;
}

void yk_group_solve(const YkRun *run, size_t index, int branch)
{
    YkGroupWork *w = run->groups;
    const YkSpace *space = run->space;
    Group g = group_of(run, index);
    double *guess = w->tau + g.n; // tau has twice the length
    memcpy(guess, g.x, g.n * sizeof *guess);
    bool ok = iterate(w, &g);
    for (size_t k = 0; k < g.n; k++) w->moved = fmax(w->moved, fabs(g.x[k] - guess[k]) / column_size(&g, k));
    double det = distance_from_dead_point(w, &g, solve_rates(w, &g)), m = det * det;
    if (!ok || (branch != 0 && det * branch < 0)) m = -1;
    if (space->block_margin) space->block_margin[index * space->stride] = m;
    if (!(space->margin[0] <= m)) space->margin[0] = m;
}

double yk_group_miss(const YkRun *run, size_t index)
{
    YkGroupWork *w = run->groups;
    Group g = group_of(run, index);
    evaluate(&g, g.x, w->residual, NULL);
    return norm(w->residual, g.m);
}

int yk_group_sign(const YkRun *run, size_t index)
{
    YkGroupWork *w = run->groups;
    Group g = group_of(run, index);
    evaluate(&g, g.x, w->residual, w->J);
    double det = newton_step(w, &g);
    return det > 0 ? 1 : det < 0 ? -1 : 0;
}

static bool is_new(const YkGroupWork *w, const Group *g, size_t count)
{
    for (size_t s = 0; s < count; s++)
        if (yk_group_gap(g->mech, g->block, g->x, w->solutions + s * g->n) < 1e-7) return false;
    return true;
}

static void random_start(const Group *g, const double *guess, uint64_t *seed)
{
    for (size_t k = 0; k < g->n; k++) {
        *seed = *seed * 6364136223846793005u + 1442695040888963407u;
        double r = (double)(int64_t)*seed * 0x1p-63;
        double middle = g->columns[k].is_distance || g->block->relation_count > 0 ? guess[k] : 0;
        g->x[k] = middle + r * (g->columns[k].is_distance ? 2 * g->mech->size : YK_PI);
    }
}

// Returns the number of starts; each takes at most some sixty factorisations.
static size_t starts_max(const Group *g)
{
    const double work_max = 1e9, work = 60.0 * (double)g->m * (double)g->n * (double)g->n;
    return (size_t)fmax(4, fmin(40.0 * (double)g->n, work_max / work));
}

// Returns whether the first start found the guess itself.
static bool stands_at_guess(const Group *g, const double *guess)
{
    for (size_t k = 0; k < g->n; k++)
        if (!(fabs(g->x[k] - guess[k]) <= 1e-9 * column_size(g, k))) return false;
    return true;
}

size_t yk_group_search(const YkRun *run, size_t index)
{
    YkGroupWork *w = run->groups;
    Group g = group_of(run, index);
    size_t count = 0, tries = starts_max(&g);
    uint64_t seed = 1;
    double *guess = w->tau + g.n; // memory of its own: tau has twice the length
    bool global = w->global;
    memcpy(guess, g.x, g.n * sizeof *guess);
    w->global = true;
    for (size_t t = 0; t <= tries && count < YK_GROUP_SOLUTIONS_MAX && !yk_pace_is_stopped(w->pace); t++) {
        if (t > 0) random_start(&g, guess, &seed);
        if (!iterate(w, &g)) continue;
        for (size_t k = 0; k < g.n && g.block->relation_count == 0; k++) // gears that count turns keep them
            if (!g.columns[k].is_distance) g.x[k] = yk_nearest_turn(g.x[k], guess[k]);
        if (!is_new(w, &g, count)) continue;
        memcpy(w->solutions + count++ * g.n, g.x, g.n * sizeof *g.x);
        if (w->at_guess && t == 0 && stands_at_guess(&g, guess)) break;
    }
    memcpy(g.x, guess, g.n * sizeof *guess);
    w->global = global;
    return count;
}
