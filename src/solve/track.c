// Follows a pose along a path of the inputs by prediction and Newton's method.
#include "solve/track.h"
#include <string.h>
#include "solve/passing.h"
#include "solve/relations.h"

#define DEAD_MARGIN 1e-11  // sin^2: below this rounding moves the unknowns by more than a correction may
#define DEPARTURE 1e-8     // rad, or lengths over the size: the first step from a dead point
#define STEP_FLOOR 0x1p-46 // rad, or lengths over the size: if not even such a step succeeds, there is a limit
#define STRIDE 0.05        // rad, or lengths over the size: the longest step of an input
#define TRIALS_SPARE 512 // in addition to those of a smooth path: 46 halvings to the floor and back, a few trials each
#define WORK_MAX 2e9     // multiplications on one path: some seconds

YkStatus yk_state_run_here(YkState *s)
{
    YkRun run = yk_state_run(s, &s->spare);
    if (!yk_state_spend(s, s->mech->step_count)) return YK_STOPPED;
    s->groups.global = false;
    s->groups.moved = 0;
    yk_run_begin(&run);
    yk_run_steps(&run, 0, s->mech->step_count);
    return yk_state_judge(s, &s->spare);
}

typedef struct Path { // of one input: position from + at * way; its true rates at the end
    double from, way, rate, accel;
} Path;

static Path path_of(const YkState *s, size_t i)
{
    return (Path){s->valid_input[3 * i], s->input[3 * i] - s->valid_input[3 * i], s->input[3 * i + 1],
                  s->input[3 * i + 2]};
}

// Returns the largest change of an input along the path: radians, or lengths over the size.
static double path_length(const YkState *s)
{
    double longest = 0;
    for (size_t i = 0; i < s->mech->input_count; i++)
        longest = fmax(longest, fabs(path_of(s, i).way) / yk_input_unit(s->mech, i));
    return longest;
}

// Returns velocity and acceleration (along the path) of a group's unknown.
static YkMotion rates_of(const YkState *s, YkColumn c)
{
    if (c.is_distance) {
        YkSlide d = yk_space_slide(&s->space, c.index);
        return (YkMotion){0, d.v[0], d.a[0]};
    }
    YkTurn t = yk_space_turn(&s->space, c.index);
    return (YkMotion){0, t.w[0], t.a[0]};
}

static double column_size(const YkState *s, YkColumn c)
{
    return c.is_distance ? s->mech->size : 1;
}
static bool at_dead_point(const YkState *s)
{
    return !(s->space.margin[0] > DEAD_MARGIN);
}

// Puts the group's unknowns where velocity and acceleration predict them; leaves them at a dead point. Returns the
// largest change: radians, or lengths over the size.
static double predict(YkState *s, double h)
{
    double largest = 0;
    for (size_t k = 0; k < s->mech->column_count; k++) {
        YkColumn c = s->mech->group_columns[k];
        YkMotion m = at_dead_point(s) ? (YkMotion){0, 0, 0} : rates_of(s, c);
        double change = h * (m.velocity + 0.5 * h * m.acceleration);
        s->groups.x[k] = s->valid_x[k] + change;
        largest = fmax(largest, fabs(change) / column_size(s, c));
    }
    return largest;
}

// Moves the unknowns by `way` along their velocity: next to a dead point this is the direction in which two solutions
// separate.
static bool kick(YkState *s, double way)
{
    double largest = 0;
    for (size_t k = 0; k < s->mech->column_count; k++) {
        YkColumn c = s->mech->group_columns[k];
        largest = fmax(largest, fabs(rates_of(s, c).velocity) / column_size(s, c));
    }
    if (!(largest > 0 && isfinite(largest))) return false;
    for (size_t k = 0; k < s->mech->column_count; k++)
        s->groups.x[k] = s->valid_x[k] + way / largest * rates_of(s, s->mech->group_columns[k]).velocity;
    return true;
}

void yk_set_path(YkState *s, const double *ends, double at)
{
    for (size_t i = 0; i < s->mech->input_count; i++) {
        double from = ends[2 * i], way = ends[2 * i + 1];
        s->input[3 * i] = from + at * way;
        s->input[3 * i + 1] = way;
        s->input[3 * i + 2] = 0;
    }
}

typedef struct Tracker {
    double at, h, longest;
    size_t trials_left; // 0: the path is given up
} Tracker;

// Returns roughly the multiplications of one trial: a sum for each step, a few factorisations for each group.
static double trial_cost(const YkState *s)
{
    double cost = 30 * (double)(s->mech->step_count + 1);
    for (size_t b = 0; b < s->mech->block_count; b++) {
        const YkBlock *block = &s->mech->blocks[b];
        if (block->kind != YK_BLOCK_GROUP) continue;
        double n = block->column_count, m = (double)yk_block_rows(block);
        cost += 4 * (m * n * n + 20 * m);
    }
    return cost;
}

// Returns how many steps may be tried on the path: 0 if even the longest steps would be more work than allowed.
static size_t trials_max(const YkState *s, double longest)
{
    double strides = longest / STRIDE, most = WORK_MAX / trial_cost(s);
    if (!(strides <= most)) return 0;
    return TRIALS_SPARE + (size_t)fmin(8 * strides, most);
}

static const char *const way_too_long =
    "the way to these inputs is too long to be followed step by step: ask for inputs nearer to the last pose";
static const char *const way_too_hard =
    "the way to these inputs was given up: near the last pose that closes, steps become too small";

static void accept_along(YkState *s)
{
    YkSpace space = s->space;
    s->space = s->spare;
    s->spare = space;
    memcpy(s->valid_x, s->groups.x, s->mech->column_count * sizeof *s->valid_x);
    yk_relations_refer(s, &s->space);
}

// Returns how far Newton's method may correct a prediction. From a dead point, which predicts nothing, the unknowns
// move as the square root of the step, and the determinant's sign gives the direction.
static double correction_max(const YkState *s, double way)
{
    return at_dead_point(s) ? 0.01 : 0.25 * way + 1e-9;
}

// Takes one step of the path; returns false when even the smallest fails, or no trial is left. Newton's correction must
// be small compared with the predicted change: the result is then the continuation and not another solution. Towards a
// limit the steps shrink with the remaining distance.
static bool advance(YkState *s, Tracker *t, const double *ends)
{
    while (t->at + t->h > t->at && t->h > STEP_FLOOR) {
        if (t->trials_left == 0) return false;
        t->trials_left--;
        double h = fmin(t->h, 1 - t->at), way = predict(s, h);
        yk_set_path(s, ends, t->at + h);
        if (way < 0.5 && yk_state_run_here(s) >= 0 && s->groups.moved <= correction_max(s, way)) {
            accept_along(s);
            t->at += h;
            t->h = fmin(2 * t->h, STRIDE / fmax(t->longest, 1e-300));
            return true;
        }
        t->h = 0.5 * h;
    }
    return false;
}

// Departs from a dead point, where the unknowns move as the square root of the input's path, at an unknown rate. Tries
// amplitudes in both directions: Newton's method and the determinant's sign show which one the solution has.
static void depart(YkState *s, Tracker *t, const double *ends)
{
    double h = fmin(1, DEPARTURE / t->longest), base = sqrt(h * t->longest);
    for (int k = -14; k < 16; k++) {
        double way = ldexp(k % 2 ? -base : base, k / 2);
        if (!kick(s, way)) return;
        yk_set_path(s, ends, h);
        if (yk_state_run_here(s) < 0 || !(s->groups.moved <= 0.4 * fabs(way))) continue;
        accept_along(s);
        t->at = h;
        return;
    }
}

// Goes past a pose at which only the kept equations of a machine with redundant constraints are singular.
static bool pass(YkState *s, Tracker *t, const double *ends)
{
    double h = yk_state_pass(s, ends, t->at, 1 - t->at);
    if (h == 0) return false;
    accept_along(s);
    t->at = h < 1 - t->at ? t->at + h : 1;
    t->h = h;
    return true;
}

static void find_ends(const YkState *s, double *ends)
{
    for (size_t i = 0; i < s->mech->input_count; i++) {
        Path p = path_of(s, i);
        ends[2 * i] = p.from;
        ends[2 * i + 1] = p.way;
    }
}

static void keep_references(YkState *s)
{
    memcpy(s->search->kept_reference, s->slot_reference, s->mech->reference_count * sizeof *s->slot_reference);
}

void yk_state_walk_back(YkState *s)
{
    memcpy(s->slot_reference, s->search->kept_reference, s->mech->reference_count * sizeof *s->slot_reference);
}

YkStatus yk_state_track(YkState *s)
{
    size_t n = s->mech->input_count;
    double *ends = s->search->path, *wanted = s->search->wanted;
    if (!s->has_pose) return YK_BAD_ARGUMENT;
    memcpy(wanted, s->input, 3 * n * sizeof *wanted);
    find_ends(s, ends);
    keep_references(s);
    Tracker t = {.h = 1, .longest = path_length(s)};
    t.trials_left = trials_max(s, t.longest);
    if (t.trials_left == 0) return yk_state_refuse(s, YK_NOT_CONVERGED, way_too_long);
    if (t.longest > STRIDE) t.h = STRIDE / t.longest;
    memcpy(s->groups.x, s->valid_x, s->mech->column_count * sizeof *s->valid_x);
    yk_space_copy(&s->search->kept, &s->space); // to return to on failure
    memcpy(s->search->kept_x, s->valid_x, s->mech->column_count * sizeof *s->valid_x);
    signed char *kept_branch = s->search->kept_branch + s->mech->block_count;
    memcpy(kept_branch, s->branch, s->mech->block_count);
    yk_set_path(s, ends, 0);
    YkStatus status = yk_state_run_here(
        s); // rates along the path at its start; at a dead point rounding may give the other sign there
    bool ok = status >= 0 || at_dead_point(s);
    if (ok) accept_along(s);
    if (ok && at_dead_point(s) && t.longest > STEP_FLOOR && !pass(s, &t, ends)) depart(s, &t, ends);
    while (ok && t.at < 1) ok = advance(s, &t, ends) || pass(s, &t, ends);
    memcpy(s->input, wanted, 3 * n * sizeof *wanted);
    if (ok) {
        memcpy(s->groups.x, s->valid_x, s->mech->column_count * sizeof *s->valid_x);
        status = yk_state_stand_here(s);
        yk_state_tell(s, &s->spare, status);
        if (status >= 0) yk_state_accept(s);
    }
    if (!ok || status < 0) {
        status = t.trials_left > 0 ? YK_LIMIT : YK_NOT_CONVERGED;
        if (status == YK_LIMIT)
            yk_state_tell(s, &s->spare, status);
        else
            yk_state_refuse(s, status, way_too_hard);
        yk_space_copy(&s->space, &s->search->kept);
        memcpy(s->valid_x, s->search->kept_x, s->mech->column_count * sizeof *s->valid_x);
        memcpy(s->branch, kept_branch, s->mech->block_count);
        yk_state_walk_back(s);
    }
    return status;
}

void yk_state_walk(YkState *s)
{
    enum { STEPS_MAX = 100000 };
    const double stride = 0.1; // rad, or over the size: no angle makes half a turn in it
    double *ends = s->search->path, *wanted = s->search->wanted, length = path_length(s);
    keep_references(s);
    if (!s->has_pose || !(length > stride) || !(length < stride * STEPS_MAX)) return;
    memcpy(wanted, s->input, 3 * s->mech->input_count * sizeof *wanted);
    find_ends(s, ends);
    int steps = (int)ceil(length / stride);
    for (int k = 1; k < steps; k++) {
        yk_set_path(s, ends, (double)k / steps);
        if (yk_state_run_here(s) >= 0) yk_relations_refer(s, &s->spare);
    }
    memcpy(s->input, wanted, 3 * s->mech->input_count * sizeof *wanted);
}

YkStatus yk_state_settle(YkState *s, double most)
{
    size_t bytes = s->mech->column_count * sizeof *s->valid_x;
    if (bytes > 0) memcpy(s->groups.x, s->valid_x, bytes);
    YkStatus status = yk_state_run_here(s);
    if (status >= 0 && s->groups.moved > most) status = YK_LIMIT;
    yk_state_tell(s, &s->spare, status);
    if (status >= 0) yk_state_accept(s);
    return status;
}
