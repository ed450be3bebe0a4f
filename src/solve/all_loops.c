// Where constraints repeat each other, some equations are kept and solved, and the others are only checked. At a pose
// where the kept ones are singular the others may still determine the motion, as the third crank of a parallelogram
// does in line.
#include "solve/all_loops.h"
#include <stdlib.h>
#include <string.h>
#include "compile/closure.h"
#include "elementary/elementary.h"
#include "num/dense.h"

// All equations of the pose: two for each loop, one for each gear, one for each input. Lengths count over the machine's
// size.
typedef struct Equations {
    const YkState *s;
    YkRun run;
    size_t rows, columns, rank;
    double *x, *A, *tau, *b, *step;
    size_t *order;
} Equations;

static size_t gear_count(const YkMechanism *mech)
{
    return mech->relation_count; // sums of several stand behind them
}

// Only where equations repeat each other and gears are linear: a law's argument counts turns.
static bool applies(const YkMechanism *mech)
{
    if (mech->redundant_count == 0 || yk_variable_count(mech) > YK_CLOSURE_MAX) return false;
    for (size_t k = 0; k < gear_count(mech); k++)
        if (mech->relations[k].law) return false;
    return true;
}

static size_t row_count(const YkMechanism *mech)
{
    return 2 * mech->loop_count + gear_count(mech) + mech->input_count;
}

bool yk_all_loops_start(YkState *s)
{
    size_t m = row_count(s->mech), n = yk_variable_count(s->mech);
    if (!applies(s->mech) || m < n) return true;
    s->all_loops = malloc((m * n + 2 * m + 4 * n + 1) * sizeof(double) + (n + 1) * sizeof(size_t));
    return s->all_loops != NULL;
}

static void share_room(Equations *e)
{
    size_t m = e->rows, n = e->columns;
    e->x = e->s->all_loops;
    e->step = e->x + n;
    e->tau = e->step + n;
    e->b = e->tau + 2 * n;
    e->A = e->b + m;
    e->order = (size_t *)(void *)(e->A + m * n);
}

static void read_pose(Equations *e)
{
    size_t o = e->s->mech->orientation_count - 1;
    for (size_t k = 0; k < o; k++) {
        YkTurn t = yk_space_turn(e->run.space, (int32_t)k + 1);
        e->x[k] = yk_atan2(*t.s, *t.c);
    }
    for (size_t k = o; k < e->columns; k++) e->x[k] = *yk_space_slide(e->run.space, (int32_t)(k - o)).d;
}

// Writes the row of an input: the difference of two orientations, or a distance.
static void add_input_row(const Equations *e, size_t input, double *row)
{
    const YkMechanism *mech = e->s->mech;
    const YkTreeCoordinate *c = &mech->coordinates[mech->inputs[input]];
    if (c->is_distance) {
        row[mech->orientation_count - 1 + (size_t)c->distance] = 1;
        return;
    }
    if (c->angle.b > 0) row[c->angle.b - 1] += mech->size;
    if (c->angle.a > 0) row[c->angle.a - 1] -= mech->size;
}

// Factors the Jacobian of all equations; b keeps how far the loops miss. Returns whether it has full rank.
static bool factor(Equations *e)
{
    const YkMechanism *mech = e->s->mech;
    size_t loops = mech->loop_count, gears = gear_count(mech), n = e->columns;
    memset(e->A, 0, e->rows * n * sizeof *e->A);
    memset(e->b, 0, e->rows * sizeof *e->b);
    yk_closure(mech, e->x, e->b, e->A);
    for (size_t k = 0; k < gears; k++) {
        yk_closure_relation(mech, k, e->x, &e->b[2 * loops + k], e->A + (2 * loops + k) * n, NULL);
        e->b[2 * loops + k] = 0; // the pose has it exactly, with its turns
    }
    for (size_t k = 0; k < mech->input_count; k++) add_input_row(e, k, e->A + (2 * loops + gears + k) * n);
    for (size_t row = 0; row < e->rows; row++) // distances over the size: all columns are lengths
        for (size_t c = mech->orientation_count - 1; c < n; c++) e->A[row * n + c] *= mech->size;
    const double least = 1e-5; // of the largest: half the digits of the rates remain
    e->rank = yk_qr_factor(e->rows, n, e->A, e->order, e->tau, least);
    return e->rank == n;
}

// Solves for a step of all variables from the right-hand side in b.
static void solve(Equations *e)
{
    const YkMechanism *mech = e->s->mech;
    yk_qr_solve(e->rows, e->columns, e->A, e->order, e->tau, e->rank, e->b, e->step);
    for (size_t c = mech->orientation_count - 1; c < e->columns; c++) e->step[c] *= mech->size;
}

static bool closes(const Equations *e)
{
    double miss = 0;
    for (size_t row = 0; row < 2 * e->s->mech->loop_count; row++) miss = fmax(miss, fabs(e->b[row]));
    return miss <= e->s->mech->size * YK_CLOSING_TOLERANCE;
}

// Moves the pose to where all loops close best: a singular block knows its angles to half the digits. Returns whether
// the way is short and they close.
static bool polish(Equations *e)
{
    enum { STEPS_MAX = 4 };
    const double way_most = 1e-4; // of a step, rad or sizes: a pose farther away may be another one
    const YkMechanism *mech = e->s->mech;
    double miss = INFINITY;
    for (int k = 0; k < STEPS_MAX; k++) {
        if (!factor(e)) return false;
        double now = 0;
        for (size_t row = 0; row < 2 * mech->loop_count; row++) now = fmax(now, fabs(e->b[row]));
        if (!(now < miss)) break;
        miss = now;
        for (size_t row = 0; row < e->rows; row++) e->b[row] = -e->b[row];
        solve(e);
        for (size_t c = 0; c < e->columns; c++) {
            double unit = c < mech->orientation_count - 1 ? 1 : mech->size;
            if (!(fabs(e->step[c]) < way_most * unit)) return false;
            e->x[c] += e->step[c];
        }
    }
    return miss <= mech->size * YK_CLOSING_TOLERANCE;
}

// Writes angles and distances, and their rates from `step`: velocities, or accelerations beside them.
static void write_pose(const Equations *e, int order)
{
    size_t o = e->s->mech->orientation_count - 1;
    for (size_t k = 0; k < o; k++) {
        YkTurn t = yk_space_turn(e->run.space, (int32_t)k + 1);
        YkVec unit = yk_unit(e->x[k]);
        *t.c = unit.x, *t.s = unit.y;
        if (order == 1) *t.w = e->step[k], *t.a = 0;
        if (order == 2) *t.a = e->step[k];
    }
    for (size_t k = o; k < e->columns; k++) {
        YkSlide d = yk_space_slide(e->run.space, (int32_t)(k - o));
        *d.d = e->x[k];
        if (order == 1) *d.v = e->step[k], *d.a = 0;
        if (order == 2) *d.a = e->step[k];
    }
}

// Solves for the rates of an order from those of the inputs; of order 2 with what the velocities add to the loops.
static void solve_rates(Equations *e, int order)
{
    const YkMechanism *mech = e->s->mech;
    YkPlane known = yk_space_scratch(e->run.space, YK_SCRATCH_KNOWN);
    memset(e->b, 0, e->rows * sizeof *e->b);
    for (size_t l = 0; order == 2 && l < mech->loop_count; l++) {
        yk_run_sum(&e->run, &mech->loops[l].sum, known);
        e->b[2 * l] = -*known.ax;
        e->b[2 * l + 1] = -*known.ay;
    }
    for (size_t k = 0; k < mech->input_count; k++) {
        bool is_distance = mech->coordinates[mech->inputs[k]].is_distance;
        e->b[e->rows - mech->input_count + k] = e->s->input[3 * k + (size_t)order] * (is_distance ? 1 : mech->size);
    }
    solve(e);
    write_pose(e, order);
}

static Equations equations_of(YkState *s, YkSpace *space)
{
    Equations e = {
        .s = s, .run = yk_state_run(s, space), .rows = row_count(s->mech), .columns = yk_variable_count(s->mech)};
    share_room(&e);
    read_pose(&e);
    return e;
}

const double *yk_all_loops_ahead(YkState *s, YkSpace *space, double h)
{
    if (!s->all_loops) return NULL;
    Equations e = equations_of(s, space);
    if (!polish(&e) || !factor(&e)) return NULL;
    solve_rates(&e, 1);
    for (size_t c = 0; c < e.columns; c++) e.x[c] += h * e.step[c];
    return polish(&e) ? e.x : NULL;
}

YkStatus yk_state_by_all_loops(YkState *s, YkSpace *space, YkStatus status)
{
    const YkMechanism *mech = s->mech;
    s->is_regular = false;
    if (status < 0 || !(space->margin[0] <= YK_NEAR_MARGIN) || !s->all_loops) return status;
    Equations e = equations_of(s, space);
    if (polish(&e) && factor(&e) && closes(&e)) {
        solve_rates(&e, 1);
        solve_rates(&e, 2);
        for (size_t k = 0; k < mech->step_count; k++)
            if (mech->steps[k].kind != YK_STEP_BLOCK) yk_run_steps(&e.run, k, k + 1);
        s->is_regular = true;
        s->is_kept = false;
    }
    return s->is_regular ? YK_REDUNDANT : status;
}
