// Finds efforts that hold a machine whose joints are at rest under dry friction.
//
// The unknowns are the frictions f of all joints with dry friction. Joint forces N(f), accelerations a(f) of the joints
// at rest and the efforts e(f) of the drives are affine in f; their columns come from solutions with one f at a time.
// With limits c = mu R,
//     |f_j| <= c_j |N_j(f)|       for a joint at rest, and
//     f_j = -s_j c_j |N_j(f)|     for one that slides in the sense s_j,
// and a(f) = 0 where free inputs would let a joint at rest move. Linear programs seek the lowest and highest effort
// over these f. With a unit vector u_j along N_j at the present f, u_j . N_j(f) <= |N_j(f)|, so |f_j| <= c_j u_j .
// N_j(f) allows nothing that friction does not allow. The best f gives the next u_j, until the effort rises no further
// (convex-concave procedure: Yuille & Rangarajan 2003). All f on the way are allowed, and so is every effort between
// the two ends. An end is accepted only if a solution with its frictions confirms it.
#include "dynamics/holding.h"
#include <stdlib.h>
#include <string.h>
#include "num/bounded.h"
#include "num/dense.h"
#include "num/linear_program.h"

enum { JOINTS_MAX = 200, ROUNDS_MAX = 60 };
static const double ROUNDING = 1e-11, BORNE_OUT = 1e-8;

typedef struct YkStanding {
    size_t item;        // of the loads
    bool stands;        // its rate is 0
    bool sticks;        // free inputs would move it, and friction holds it
    int sense;          // it slides, or begins to: +1, -1; otherwise 0
    double limit, unit; // limit: c; unit: scale of its friction
    double scale;       // of its motion: 1 rad, or the machine's size
    double u[2];
} YkStanding;

struct YkHolding {
    YkArena *arena;                     // of all arrays
    size_t count, rows, inputs, joints; // joints: followed by gears and cams
    bool is_too_large, is_open;
    double hardest; // the largest acceleration of the pose, rad/s^2 or sizes/s^2
    YkStanding *standing;
    double *base, *column; // [rows], [rows][count]: N_x, N_y of each, accelerations of each, efforts of each input
    double *f, *best, *trial, *row, *matrix, *bias, *A, *b, *c, *x, *work;
    YkBounds *bounds;
    size_t *order;
    YkEffortRange *range; // [input]
    YkReaction *before;   // [joint]
    bool *depends;        // [joint] on frictions of joints that stand
};

static bool lay_out(YkHolding *h)
{
    size_t n = h->count, r = h->rows, m = 4 * n;
    size_t work = YK_LINEAR_WORK(m, n) > YK_BOUNDED_WORK(n) ? YK_LINEAR_WORK(m, n) : YK_BOUNDED_WORK(n);
    YkArena *a = h->arena = yk_arena_new();
    h->standing = yk_arena_alloc(a, n + 1, sizeof *h->standing);
    h->bounds = yk_arena_alloc(a, n + 1, sizeof *h->bounds);
    h->order = yk_arena_alloc(a, YK_LINEAR_ORDER(m, n) + YK_BOUNDED_ORDER(n) + 1, sizeof *h->order);
    h->range = yk_arena_alloc(a, h->inputs + 1, sizeof *h->range);
    h->before = yk_arena_alloc(a, h->joints + 1, sizeof *h->before);
    h->depends = yk_arena_alloc(a, h->joints + 1, sizeof *h->depends);
    h->base = YK_NEW(a, double, r);
    h->row = YK_NEW(a, double, r);
    h->column = YK_NEW(a, double, r *n);
    h->f = YK_NEW(a, double, n);
    h->best = YK_NEW(a, double, n);
    h->trial = YK_NEW(a, double, n);
    h->bias = YK_NEW(a, double, n);
    h->c = YK_NEW(a, double, n);
    h->x = YK_NEW(a, double, n);
    h->matrix = YK_NEW(a, double, n *n);
    h->A = YK_NEW(a, double, m *n);
    h->b = YK_NEW(a, double, m);
    h->work = YK_NEW(a, double, work);
    return !yk_arena_failed(a);
}

YkHolding *yk_holding_new(const YkDynamics *d)
{
    YkHolding *h = calloc(1, sizeof *h);
    if (!h) return NULL;
    for (size_t k = 0; k < d->loads->item_count; k++) h->count += d->loads->items[k].kind == YK_LOAD_COULOMB;
    h->is_too_large = h->count > JOINTS_MAX;
    if (h->is_too_large) h->count = 0;
    h->inputs = d->mech->input_count;
    h->joints = d->mech->model->joint_count + d->mech->relation_count;
    h->rows = 3 * h->count + h->inputs;
    if (!lay_out(h)) {
        yk_holding_free(h);
        return NULL;
    }
    size_t j = 0;
    for (size_t k = 0; k < d->loads->item_count && h->count > 0; k++)
        if (d->loads->items[k].kind == YK_LOAD_COULOMB) h->standing[j++].item = k;
    yk_holding_clear(h);
    return h;
}

void yk_holding_free(YkHolding *h)
{
    if (!h) return;
    yk_arena_free(h->arena);
    free(h);
}

void yk_holding_clear(YkHolding *h)
{
    for (size_t i = 0; i < h->inputs; i++) h->range[i] = (YkEffortRange){.is_single = true, .is_known = true};
    h->is_open = false;
}

YkEffortRange yk_holding_range(const YkHolding *h, size_t input)
{
    return h->range[input];
}

bool yk_holding_is_open(const YkHolding *h)
{
    return h->is_open;
}

// --- the pose

static YkLoadItem *item_of(const YkHolding *h, const YkDynamics *d, size_t j)
{
    return &d->loads->items[h->standing[j].item];
}

static bool stands(const YkDynamics *d, const YkState *state, const YkLoadItem *item, double fastest, double *rate)
{
    *rate = yk_joint_rate(d->mech, &state->space, item->joint, item->is_distance);
    return fabs(*rate) <= ROUNDING * fastest * (item->is_distance ? d->mech->size : 1);
}

// Finds the largest rate and acceleration of the pose, of angles or in machine sizes.
static void find_scales(const YkDynamics *d, const YkState *state, double *fastest, double *hardest)
{
    *fastest = *hardest = 0;
    for (size_t c = 0; c < d->mech->coordinate_count; c++) {
        YkMotion m = yk_state_coordinate(state, c);
        double scale = d->mech->coordinates[c].is_distance ? d->mech->size : 1;
        *fastest = fmax(*fastest, fabs(m.velocity) / scale);
        *hardest = fmax(*hardest, fabs(m.acceleration) / scale);
    }
    *hardest = fmax(*hardest, *fastest * *fastest);
}

// Handles too many joints to examine: no effort is known if any of them is at rest.
static bool stand_unknown(YkHolding *h, const YkDynamics *d, const YkState *state)
{
    double fastest, hardest, rate;
    bool any = false;
    find_scales(d, state, &fastest, &hardest);
    for (size_t k = 0; k < d->loads->item_count; k++)
        any = any ||
              (d->loads->items[k].kind == YK_LOAD_COULOMB && stands(d, state, &d->loads->items[k], fastest, &rate));
    for (size_t i = 0; i < h->inputs && any; i++)
        if (!d->is_free[i]) h->range[i] = (YkEffortRange){.low = -(double)INFINITY, .high = (double)INFINITY};
    h->is_open = any;
    return false;
}

bool yk_holding_is_needed(YkHolding *h, const YkDynamics *d, const YkState *state)
{
    bool any = false;
    double fastest, rate;
    yk_holding_clear(h);
    if (h->is_too_large) return stand_unknown(h, d, state);
    find_scales(d, state, &fastest, &h->hardest);
    for (size_t j = 0; j < h->count; j++) {
        YkStanding *s = &h->standing[j];
        const YkLoadItem *item = item_of(h, d, j);
        s->stands = stands(d, state, item, fastest, &rate);
        s->sticks = false;
        s->sense = s->stands ? 0 : rate > 0 ? 1 : -1;
        s->limit = item->coulomb * item->radius;
        s->scale = item->is_distance ? d->mech->size : 1;
        any = any || s->stands;
    }
    return any;
}

// --- the affine model

static void set_frictions(const YkHolding *h, YkDynamics *d, const double *f)
{
    for (size_t j = 0; j < h->count; j++) item_of(h, d, j)->dry = f[j];
}

static void read_rows(const YkHolding *h, const YkDynamics *d, const YkState *state, double *row)
{
    for (size_t j = 0; j < h->count; j++) {
        const YkLoadItem *item = item_of(h, d, j);
        row[2 * j] = d->joint[item->joint].force[0];
        row[2 * j + 1] = d->joint[item->joint].force[1];
        row[2 * h->count + j] = yk_joint_motion(d->mech, &state->space, item->joint, item->is_distance).acceleration;
    }
    for (size_t i = 0; i < h->inputs; i++) row[3 * h->count + i] = d->drive[i];
}

static bool is_good(YkStatus status)
{
    return status == YK_OK || status == YK_REDUNDANT;
}

static YkStatus solve_with(const YkHolding *h, YkDynamics *d, YkState *state, YkMethod method, const double *f)
{
    set_frictions(h, d, f);
    return yk_dynamics_solve_once(d, state, method);
}

// Returns the reaction of a joint, or of the gears and cams after them.
static YkReaction *reaction_of(const YkDynamics *d, size_t k)
{
    size_t joints = d->mech->model->joint_count;
    return k < joints ? &d->joint[k] : &d->contact[k - joints];
}

static void copy_reactions(const YkHolding *h, const YkDynamics *d, YkReaction *to)
{
    for (size_t k = 0; k < h->joints; k++) to[k] = *reaction_of(d, k);
}

static bool differs(const YkReaction *a, const YkReaction *b, double near, double size)
{
    return fabs(a->force[0] - b->force[0]) > near || fabs(a->force[1] - b->force[1]) > near ||
           fabs(a->moment - b->moment) > near * size;
}

// Finds the rows without dry friction, h->f = 0, and how each changes with each friction.
static YkStatus find_columns(YkHolding *h, YkDynamics *d, YkState *state, YkMethod method)
{
    YkStatus status = solve_with(h, d, state, method, h->f);
    if (!is_good(status)) return status;
    read_rows(h, d, state, h->base);
    copy_reactions(h, d, h->before);
    memset(h->depends, 0, h->joints * sizeof *h->depends);
    double largest = d->largest_force, size = d->mech->size;
    for (size_t j = 0; j < h->count; j++) {
        YkStanding *s = &h->standing[j];
        double length = item_of(h, d, j)->is_distance ? 1 : size;
        s->unit = largest > 0 ? largest * fmin(s->limit, length) : fmin(s->limit, length);
        memset(h->trial, 0, h->count * sizeof *h->trial);
        h->trial[j] = s->unit;
        status = solve_with(h, d, state, method, h->trial);
        if (!is_good(status)) return status;
        read_rows(h, d, state, h->row);
        for (size_t r = 0; r < h->rows; r++) h->column[r * h->count + j] = (h->row[r] - h->base[r]) / s->unit;
        for (size_t k = 0; k < h->joints && s->stands; k++)
            if (differs(reaction_of(d, k), &h->before[k], 1e-9 * s->unit / length, size)) h->depends[k] = true;
    }
    return YK_OK;
}

static double row_at(const YkHolding *h, size_t row, const double *f)
{
    double sum = h->base[row];
    for (size_t j = 0; j < h->count; j++) sum += h->column[row * h->count + j] * f[j];
    return sum;
}

static double limit_at(const YkHolding *h, size_t j, const double *f)
{
    double x = row_at(h, 2 * j, f), y = row_at(h, 2 * j + 1, f);
    return h->standing[j].limit * sqrt(x * x + y * y);
}

// Sets the frictions of the joints that slide, with the others unchanged. Returns false if they do not settle.
static bool settle_sliding(const YkHolding *h, double *f)
{
    for (int round = 0; round < YK_DRY_ROUNDS; round++) {
        double share = round < YK_DRY_ROUNDS / 4 ? 1 : 0.5, off = 0;
        for (size_t j = 0; j < h->count; j++) {
            if (h->standing[j].sense == 0) continue;
            double next = -h->standing[j].sense * limit_at(h, j, f);
            if (!isfinite(next)) return false; // it grew beyond all numbers
            off = fmax(off, fabs(next - f[j]) / (fabs(next) + fabs(f[j]) + 1e-300));
            f[j] += share * (next - f[j]);
        }
        if (off <= yk_dynamics_dry_tolerance(round)) return true;
    }
    return false;
}

// --- joints that free inputs would move

// Finds which joints at rest free inputs could move, and which ones drives move: those begin to slip as they are
// driven.
static void ask_what_moves(YkHolding *h)
{
    size_t n = h->count;
    double most = h->hardest;
    for (size_t j = 0; j < n; j++)
        for (size_t k = 0; k < n; k++) h->matrix[j * n + k] = h->column[(2 * n + j) * n + k];
    for (size_t j = 0; j < n; j++)
        most = fmax(most, fabs(h->matrix[j * n + j] * h->standing[j].unit) / h->standing[j].scale);
    for (size_t j = 0; j < n; j++) { // an acceleration that no friction changes is that of a drive
        YkStanding *s = &h->standing[j];
        double none = ROUNDING * most * s->scale, a = h->base[2 * n + j];
        bool is_driven = fabs(h->matrix[j * n + j] * s->unit) <= none;
        s->sticks = s->stands && !is_driven;
        if (s->stands && is_driven && fabs(a) > none) s->sense = a > 0 ? 1 : -1;
        h->bounds[j] = s->sticks ? (YkBounds){-(double)INFINITY, (double)INFINITY} : (YkBounds){0, 0};
    }
    for (size_t j = 0; j < n; j++)
        for (size_t k = 0; k < n; k++)
            if (!h->standing[j].sticks || !h->standing[k].sticks) h->matrix[j * n + k] = 0;
}

// Finds the limits of what sticks at the frictions found; returns whether they have settled.
static bool find_limits(YkHolding *h, int round)
{
    bool stands = true;
    for (size_t j = 0; j < h->count; j++) {
        if (!h->standing[j].sticks) continue;
        double limit = limit_at(h, j, h->f), old = h->bounds[j].high;
        bool is_full = fabs(h->f[j]) >= fmin(limit, old) * (1 - 1e-12);
        stands = stands && limit < (double)INFINITY &&
                 (!is_full || fabs(limit - old) <= yk_dynamics_dry_tolerance(round) * limit);
        h->bounds[j] = (YkBounds){-limit, limit};
    }
    return stands;
}

static bool hold_within_limits(YkHolding *h)
{
    size_t n = h->count;
    for (int round = 0; round < YK_DRY_ROUNDS; round++) {
        bool stands = settle_sliding(h, h->f);
        for (size_t j = 0; j < n; j++) { // friction that does not stick enters as a load
            h->bias[j] = h->base[2 * n + j];
            for (size_t k = 0; k < n; k++)
                if (!h->standing[k].sticks) h->bias[j] += h->column[(2 * n + j) * n + k] * h->f[k];
            h->x[j] = h->standing[j].sticks ? h->f[j] : 0;
        }
        if (!yk_bounded_solve(n, h->matrix, h->bias, h->bounds, 5000, h->x, h->work, h->order)) return false;
        for (size_t j = 0; j < n; j++)
            if (h->standing[j].sticks) h->f[j] = h->x[j];
        if (find_limits(h, round) && stands) return true;
    }
    return false;
}

// Decides which joints stick and which begin to slip. Sets h->f, and the senses, of all joints at rest whose
// accelerations depend on free inputs; joints that drives move begin to slip as they are driven. Returns false if it
// does not settle.
static bool decide(YkHolding *h)
{
    size_t n = h->count;
    ask_what_moves(h);
    if (!hold_within_limits(h)) return false;
    for (size_t j = 0; j < n; j++) {
        YkStanding *s = &h->standing[j];
        double a = row_at(h, 2 * n + j, h->f), by_friction = fabs(h->matrix[j * n + j]);
        double size = fabs(h->base[2 * n + j]) + by_friction * fabs(h->f[j]);
        // Where nothing pulls, both are 0, and what other joints' frictions leave is rounding.
        if (!s->sticks || fabs(a) <= 1e-10 * size + ROUNDING * by_friction * s->unit) continue;
        s->sticks = false;
        s->sense = a > 0 ? 1 : -1;
    }
    return true;
}

// --- the ends of the intervals

// Points u_j along N_j(f); if a joint carries nothing there, along the force that it would carry if all frictions
// helped.
static void point_along(YkHolding *h, const double *f)
{
    for (size_t k = 0; k < h->count; k++)
        h->trial[k] = f[k] + (h->c[k] > 0 ? 1 : h->c[k] < 0 ? -1 : 0) * h->standing[k].unit;
    for (size_t j = 0; j < h->count; j++) {
        YkStanding *s = &h->standing[j];
        double x = row_at(h, 2 * j, f), y = row_at(h, 2 * j + 1, f), size = sqrt(x * x + y * y);
        if (size == 0) {
            x = row_at(h, 2 * j, h->trial);
            y = row_at(h, 2 * j + 1, h->trial);
            size = sqrt(x * x + y * y);
        }
        s->u[0] = size > 0 ? x / size : 0;
        s->u[1] = size > 0 ? y / size : 0;
    }
}

// Adds by_f f_j + by_n c_j u_j . N_j(f) <= 0, in frictions over their units, relative to f.
static void add_cone(YkHolding *h, size_t *m, size_t j, double by_f, double by_n, const double *f)
{
    const YkStanding *s = &h->standing[j];
    double *row = h->A + *m * h->count, most = 0, n = 0;
    for (size_t k = 0; k < h->count; k++) {
        double slope = s->u[0] * h->column[2 * j * h->count + k] + s->u[1] * h->column[(2 * j + 1) * h->count + k];
        row[k] = (by_n * s->limit * slope + (k == j ? by_f : 0)) * h->standing[k].unit;
        most = fmax(most, fabs(row[k]));
    }
    n = s->u[0] * row_at(h, 2 * j, f) + s->u[1] * row_at(h, 2 * j + 1, f);
    double right = -(by_f * f[j] + by_n * s->limit * n);
    if (!(most > 0)) return;
    for (size_t k = 0; k < h->count; k++) row[k] /= most;
    h->b[(*m)++] = fmax(right / most, 0);
}

static void add_rest(YkHolding *h, size_t *m, size_t j)
{
    double most = 0;
    for (int side = 1; side >= -1; side -= 2) {
        double *row = h->A + *m * h->count;
        for (size_t k = 0; k < h->count; k++) {
            row[k] = side * h->column[(2 * h->count + j) * h->count + k] * h->standing[k].unit;
            most = fmax(most, fabs(row[k]));
        }
        for (size_t k = 0; k < h->count && most > 0; k++) row[k] /= most;
        h->b[(*m)++] = 0;
    }
}

static size_t write_program(YkHolding *h, const double *f)
{
    size_t m = 0;
    point_along(h, f);
    for (size_t j = 0; j < h->count; j++) {
        const YkStanding *s = &h->standing[j];
        for (int side = 1; side >= -1; side -= 2) add_cone(h, &m, j, side, s->sense == 0 ? -1 : side * s->sense, f);
        if (s->sticks) add_rest(h, &m, j);
    }
    return m;
}

typedef enum End { END_FOUND, END_UNBOUNDED, END_LOST } End;

// Finds the largest `sense` * effort of an input that friction can balance; its frictions are in h->best.
static End find_end(YkHolding *h, size_t input, int sense, double *end)
{
    size_t n = h->count, row = 3 * n + input;
    double most = 0, old = row_at(h, row, h->f);
    memcpy(h->best, h->f, n * sizeof *h->best);
    for (size_t k = 0; k < n; k++) {
        h->c[k] = sense * h->column[row * n + k] * h->standing[k].unit;
        most = fmax(most, fabs(h->c[k]));
    }
    for (size_t k = 0; k < n; k++) h->c[k] /= most;
    for (int round = 0; round < ROUNDS_MAX; round++) {
        YkLinearStatus status =
            yk_linear_maximise(write_program(h, h->best), n, h->A, h->b, h->c, h->x, h->work, h->order);
        if (status == YK_LINEAR_UNBOUNDED) return END_UNBOUNDED;
        if (status == YK_LINEAR_EXHAUSTED) return END_LOST;
        for (size_t k = 0; k < n; k++) h->best[k] += h->x[k] * h->standing[k].unit;
        if (!settle_sliding(h, h->best)) return END_LOST;
        *end = row_at(h, row, h->best);
        if (fabs(*end - old) <= 1e-13 * (fabs(*end) + most)) return END_FOUND;
        old = *end;
    }
    return END_FOUND; // still rising slightly: an effort that holds
}

// Returns whether a solution with the frictions of h->best confirms that effort and those limits. *effort: its own
// value.
static bool is_borne_out(YkHolding *h, YkDynamics *d, YkState *state, YkMethod method, size_t input, double *effort)
{
    if (!is_good(solve_with(h, d, state, method, h->best))) return false;
    bool good = fabs(d->drive[input] - *effort) <= BORNE_OUT * (fabs(*effort) + fabs(d->drive[input]));
    for (size_t j = 0; j < h->count; j++) {
        double limit = yk_dynamics_dry_limit(d, item_of(h, d, j));
        good = good && fabs(h->best[j]) <= limit + BORNE_OUT * (limit + h->standing[j].unit);
    }
    *effort = d->drive[input];
    return good;
}

static void find_range(YkHolding *h, YkDynamics *d, YkState *state, YkMethod method, size_t input)
{
    YkEffortRange *range = &h->range[input];
    double ends[2], most = 0, bias = fabs(row_at(h, 3 * h->count + input, h->f));
    for (size_t k = 0; k < h->count; k++)
        if (h->standing[k].sense == 0)
            most = fmax(most, fabs(h->column[(3 * h->count + input) * h->count + k] * h->standing[k].unit));
    if (most <= ROUNDING * bias || most == 0) return; // no friction at rest affects it
    *range = (YkEffortRange){.is_known = true};
    for (int side = 0; side < 2; side++) {
        int sense = side ? 1 : -1;
        End end = find_end(h, input, sense, &ends[side]);
        if (end == END_UNBOUNDED) ends[side] = sense * (double)INFINITY;
        bool good = end == END_UNBOUNDED || (end == END_FOUND && is_borne_out(h, d, state, method, input, &ends[side]));
        range->is_known = range->is_known && good;
    }
    range->low = range->is_known ? ends[0] : -(double)INFINITY;
    range->high = range->is_known ? ends[1] : (double)INFINITY;
    double width = ends[1] - ends[0];
    range->is_single = range->is_known && isfinite(width) && width <= 1e-12 * (fabs(ends[0]) + fabs(ends[1]) + most);
}

// --- the whole

// Returns whether there is more than one set of frictions. There is not if only sticking joints are at rest, and their
// accelerations determine all their frictions.
static bool is_open(YkHolding *h)
{
    size_t n = h->count, sticking = 0, still = 0;
    for (size_t j = 0; j < n; j++) {
        sticking += h->standing[j].sticks;
        still += h->standing[j].stands && h->standing[j].sense == 0 && !h->standing[j].sticks;
    }
    if (still > 0 || sticking == 0) return still > 0;
    return yk_qr_factor(n, n, h->matrix, h->order, h->work, 1e-10) < sticking;
}

YkStatus yk_holding_find(YkHolding *h, YkDynamics *d, YkState *state, YkMethod method)
{
    memset(h->f, 0, h->count * sizeof *h->f);
    YkStatus status = find_columns(h, d, state, method);
    if (!is_good(status)) return status;
    if (!decide(h) || !settle_sliding(h, h->f)) return yk_dynamics_fail_at_dry(d);
    h->is_open = is_open(h);
    for (size_t i = 0; i < h->inputs && h->is_open; i++)
        if (!d->is_free[i]) find_range(h, d, state, method, i);
    status = solve_with(h, d, state, method, h->f);
    for (size_t k = 0; k < h->joints && h->is_open; k++)
        if (h->depends[k]) reaction_of(d, k)->is_determinate = false;
    return status;
}
