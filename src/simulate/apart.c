// Singular positions that a machine only comes close to, such as that of a parallelogram one of whose links is a little
// too long: two branches approach each other there, and the motion turns from the one's direction to the other's within
// a short way without leaving its own. The signs of the blocks must then stay, though their angles seem to go through
// 0.
#include "elementary/elementary.h"
#include "simulate/crossing.h"

#define MEETS 1e-11 // sin^2 up to which branches meet

// A line through poses: over time within the last step, or over the only free input.
typedef struct Line {
    YkSimulation *sim;
    bool is_time;
    double low, high; // where it ends
    double nearest;   // rad: how far from the singular position a block is in the last samples
} Line;

// Stands at a place of the line, with the signs predicted there for near blocks. Returns false if it has none.
static bool stand(const Line *line, double x)
{
    YkSimulation *sim = line->sim;
    if (line->is_time)
        return yk_ode_dense(sim->ode, x, sim->looked) == YK_ODE_OK && yk_simulation_set(sim, x, sim->looked);
    for (size_t k = 0; k < sim->near_count; k++) {
        double angle = sim->near[k].angle + sim->near[k].rate / sim->y[1] * (x - sim->y[0]);
        sim->state->branch[sim->near[k].block] = yk_sin(angle) < 0 ? -1 : 1;
    }
    sim->state->input[3 * sim->free_input[0]] = x;
    return true;
}

// Returns a block's margin in the present pose; negative if the block does not close, NaN if it cannot be found,
// because another one does not.
static double margin_of(const YkState *s, size_t block, bool stands)
{
    if (stands) return s->space.block_margin[block];
    return s->report.block == (int)block ? -1 : (double)NAN;
}

// Adds the search for a near block's least margin around `at`. slope: of the block's angle.
static void begin_search(const Line *line, size_t block, double at, double slope, size_t *count)
{
    const double LONGEST = 0.1; // rad: the block's angle goes as far in the first samples
    double h = fmin(LONGEST / fabs(slope), 0.25 * (line->high - line->low));
    at = fmin(fmax(at, line->low + h), line->high - h);
    line->sim->searches[(*count)++] = (YkSearch){.block = block, .at = at, .h = h, .is_open = true};
}

static void decide(YkSearch *search, bool is_touched)
{
    search->is_open = false;
    search->is_touched = is_touched;
}

// Notes the margin in sample j of a round of four.
static void note(YkSearch *search, int j, double margin)
{
    search->f[j] = margin;
    if (isnan(margin))
        decide(search, true);
    else if (margin < -MEETS)
        decide(search, false);
}

// Judges a round of samples: the margin is a parabola near the singular position. The next samples are nearer to its
// vertex but never in it, where other blocks may be singular.
static void end_round(const Line *line, YkSearch *search)
{
    enum { ROUNDS_MAX = 24 };
    const double *f = search->f, h = search->h;
    double bend = (f[0] + f[3] - f[1] - f[2]) / (1.5 * h * h);
    double ahead = bend > 0 ? (f[0] - f[3]) / (4 * bend * h) : f[0] < f[3] ? -h : h;
    double least = bend > 0 ? 0.5 * (f[1] + f[2]) - bend * (0.25 * h * h + ahead * ahead) : fmin(f[0], f[3]);
    if (fabs(least) <= MEETS) {
        decide(search, true);
        return;
    }
    double at = search->at, next = fmin(fmax(at + fmin(fmax(ahead, -h), h), line->low + 0.3 * h), line->high - 0.3 * h);
    if (fabs(ahead) < 0.5 * h || fabs(next - at) < 0.5 * h) search->h *= 0.3; // it is near, or the line ends
    search->at = next;
    bool goes_on = ++search->rounds < ROUNDS_MAX && fmax(f[0], f[3]) > line->nearest * line->nearest;
    if (!goes_on) decide(search, false);
}

// Lets a search take samples at the places of another one, if its own are hardly elsewhere.
static bool joins(YkSearch *search, const YkSearch *leader)
{
    bool is_same = fabs(search->at - leader->at) <= 0.1 * leader->h && fabs(search->h - leader->h) <= 0.1 * leader->h;
    if (!search->is_open || !is_same) return false;
    search->at = leader->at;
    search->h = leader->h;
    return true;
}

// Makes a round of samples for the first open search, and for all that follow it to the same places: loops that are
// equal, or nearly so, are judged in the same poses.
static void sample_round(const Line *line, YkSearch *searches, size_t count)
{
    static const double places[] = {-1, -0.5, 0.5, 1};
    YkSimulation *sim = line->sim;
    for (size_t k = 1; k < count; k++) searches[k].is_with = joins(&searches[k], searches);
    searches->is_with = true;
    double at = searches->at, h = searches->h;
    for (int j = 0; j < 4 && searches->is_open; j++) {
        bool is_told = stand(line, at + places[j] * h), stands = is_told && yk_state_solve(sim->state) >= 0;
        for (size_t k = 0; k < count; k++) {
            YkSearch *search = &searches[k];
            if (!search->is_with || !search->is_open) continue;
            note(search, j, is_told ? margin_of(sim->state, search->block, stands) : (double)NAN);
        }
    }
    for (size_t k = 0; k < count; k++)
        if (searches[k].is_with && searches[k].is_open) end_round(line, &searches[k]);
}

// Returns whether the margin of every block searched may touch zero.
static bool are_touched(const Line *line, size_t count)
{
    YkSearch *searches = line->sim->searches;
    for (size_t first = 0; first < count;) {
        if (searches[first].is_open)
            sample_round(line, searches + first, count - first);
        else if (!searches[first].is_touched)
            return false;
        else
            first++;
    }
    return true;
}

// Returns when a near block's angle, as predicted, goes through 0 or half a turn.
static double predicted_passage(const YkNear *near, double from, double to)
{
    double before = yk_sin(near->angle), low = 0, high = to - from;
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        *(yk_sin(yk_near_angle(near, middle)) * before > 0 ? &low : &high) = middle;
    }
    return from + low;
}

bool yk_simulation_must_keep_apart(YkSimulation *sim)
{
    bool is_fixed = sim->options.integrator == YK_INTEGRATOR_RK4; // its steps cannot be repeated
    if (sim->keeps_apart || yk_begins_flat(sim) || sim->free_count == 0 || is_fixed) return false;
    double end = yk_ode_time(sim->ode), dt = end - sim->near_time;
    Line line = {sim, true, yk_ode_previous(sim->ode), end, 3e-5};
    size_t count = 0;
    for (size_t k = 0; k < sim->near_count; k++) {
        const YkNear *near = &sim->near[k];
        if (!(yk_sin(near->angle) * yk_sin(yk_near_angle(near, dt)) < 0)) continue;
        begin_search(&line, near->block, predicted_passage(near, sim->near_time, end), near->rate, &count);
    }
    if (count == 0) return false;
    sim->is_elsewhere = true;
    return sim->keeps_apart = !are_touched(&line, count);
}

bool yk_simulation_look_whether_apart(YkSimulation *sim)
{
    bool is_line = sim->free_count == 1 && !sim->has_drives && sim->options.integrator != YK_INTEGRATOR_RK4;
    if (sim->keeps_apart || !is_line || sim->is_flat) return true;
    const double BLIND = 1e-3; // sine below which the way to there is not known well enough
    double at = sim->y[0], rate = sim->y[1], most = 0.5 * yk_simulation_input_scale(sim, 0);
    Line line = {sim, false, at - most, at + most, 3e-4}; // nearer, signs are guesses
    size_t count = 0;
    for (size_t k = 0; k < sim->near_count; k++) {
        double angle = sim->near[k].angle, gap = yk_asin(yk_sin(angle)) * (yk_cos(angle) < 0 ? -1 : 1);
        double slope = sim->near[k].rate / rate, way = -gap / slope;
        if (fabs(yk_sin(angle)) < BLIND || !isfinite(way) || !isfinite(1 / slope) || fabs(way) > most) continue;
        begin_search(&line, sim->near[k].block, at + way, slope, &count);
    }
    if (count == 0) return true;
    sim->keeps_apart = !are_touched(&line, count);
    return yk_simulation_pose(sim, sim->time, sim->y);
}

double yk_simulation_reach_apart(const YkSimulation *sim)
{
    const double PART = 0.3, SMALL = 1e-6; // of the angle that is left, rad
    double reach = HUGE_VAL;
    for (size_t k = 0; k < sim->near_count && sim->keeps_apart; k++) {
        const YkNear *near = &sim->near[k];
        double left = fmax(fabs(yk_sin(near->angle)), SMALL);
        reach = fmin(reach, PART * left / (fabs(near->rate) + sqrt(fabs(near->acceleration) * left)));
    }
    return reach;
}
