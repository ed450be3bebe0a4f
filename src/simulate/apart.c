// Singular positions that a machine only comes close to, such as that of a parallelogram one of whose links is a little too
// long: two branches approach each other there, and the motion turns from the one's direction to the other's within a short way
// without leaving its own. The signs of the blocks must then stay, though their angles seem to go through 0.
#include "elementary/elementary.h"
#include "simulate/crossing.h"

#define MEETS 1e-11 // sin^2 up to which branches meet

// A block's margin along a line through poses: over time within the last step, or over the only free input.
typedef struct Line {
    YkSimulation *sim;
    size_t block;
    bool is_time;
    double low, high; // where the line ends
    double nearest;   // rad: how far from the singular position the block is in the last samples
} Line;

// Stands at a place of the line, with the signs that near blocks are predicted to have there. Returns false if it has none.
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

// Returns the margin; negative where the block does not close, NaN if it cannot be told, because another one does not.
static double margin_at(const Line *line, double x)
{
    const YkState *s = line->sim->state;
    if (!stand(line, x)) return NAN;
    if (yk_state_solve(line->sim->state) >= 0) return s->space.block_margin[line->block];
    return s->report.block == (int)line->block ? -1 : (double)NAN;
}

// Returns whether the margin may touch zero near `at`, where it is a parabola: from four samples, ever nearer to its vertex but
// never in it, where other blocks may be singular. slope: of the block's angle.
static bool is_touched(const Line *line, double at, double slope)
{
    const double LONGEST = 0.1; // rad: the block's angle goes as far in the first samples
    double h = fmin(LONGEST / fabs(slope), 0.25 * (line->high - line->low)), f[4] = {1};
    at = fmin(fmax(at, line->low + h), line->high - h);
    for (int k = 0; k < 24 && fmax(f[0], f[3]) > line->nearest * line->nearest; k++) {
        for (int j = 0; j < 4; j++) {
            static const double places[] = {-1, -0.5, 0.5, 1};
            f[j] = margin_at(line, at + places[j] * h);
            if (isnan(f[j])) return true;
            if (f[j] < -MEETS) return false;
        }
        double bend = (f[0] + f[3] - f[1] - f[2]) / (1.5 * h * h);
        double ahead = bend > 0 ? (f[0] - f[3]) / (4 * bend * h) : f[0] < f[3] ? -h : h;
        double least = bend > 0 ? 0.5 * (f[1] + f[2]) - bend * (0.25 * h * h + ahead * ahead) : fmin(f[0], f[3]);
        if (fabs(least) <= MEETS) return true;
        double next = fmin(fmax(at + fmin(fmax(ahead, -h), h), line->low + 0.3 * h), line->high - 0.3 * h);
        if (fabs(ahead) < 0.5 * h || fabs(next - at) < 0.5 * h) h *= 0.3; // it is near, or the line ends
        at = next;
    }
    return false;
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
    for (size_t k = 0; k < sim->near_count; k++) {
        const YkNear *near = &sim->near[k];
        if (!(yk_sin(near->angle) * yk_sin(yk_near_angle(near, dt)) < 0)) continue;
        sim->is_elsewhere = true;
        Line line = {sim, near->block, true, yk_ode_previous(sim->ode), end, 3e-5};
        if (!is_touched(&line, predicted_passage(near, sim->near_time, end), near->rate))
            return sim->keeps_apart = true;
    }
    return false;
}

bool yk_simulation_look_whether_apart(YkSimulation *sim)
{
    bool is_line = sim->free_count == 1 && !sim->has_drives && sim->options.integrator != YK_INTEGRATOR_RK4;
    if (sim->keeps_apart || !is_line || sim->is_flat) return true;
    const double BLIND = 1e-3; // sine below which the way to there is not known well enough
    double at = sim->y[0], rate = sim->y[1], most = 0.5 * yk_simulation_input_scale(sim, 0);
    bool has_left = false;
    for (size_t k = 0; k < sim->near_count && !sim->keeps_apart; k++) {
        double angle = sim->near[k].angle, gap = yk_asin(yk_sin(angle)) * (yk_cos(angle) < 0 ? -1 : 1);
        double slope = sim->near[k].rate / rate, way = -gap / slope;
        if (fabs(yk_sin(angle)) < BLIND || !isfinite(way) || !isfinite(1 / slope) || fabs(way) > most) continue;
        Line line = {sim, sim->near[k].block, false, at - most, at + most, 3e-4}; // nearer, signs are guesses
        sim->keeps_apart = !is_touched(&line, at + way, slope);
        has_left = true;
    }
    return !has_left || yk_simulation_pose(sim, sim->time, sim->y);
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
