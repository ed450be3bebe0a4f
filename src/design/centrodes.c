// Follows the instant centre of two bodies through a cycle.
//
// The fields v(p) = c + w i p of both bodies agree where (w1 - w2) i p = c2 - c1.
#include <yoke/centrodes.h>
#include <stdlib.h>
#include "base/problems.h"
#include "design/balancing.h"
#include "solve/state.h"

struct YkCentrodes {
    YkCentrodePoint *point; // [count]
    size_t count, body[2];
    bool is_closed;
};

// The body's axes: where a world point lies in them.
static YkVec on_body(const YkState *state, const YkBodyMotion *m, size_t body, YkVec at)
{
    return yk_add(yk_reference_point(state->mech->model, body), yk_mul(yk_conj(m->e), yk_sub(at, m->at)));
}

static YkCentrodePoint find_point(const YkState *state, const size_t body[2])
{
    static const double far_away = 1e9; // over the size of the machine
    YkCentrodePoint point = {.input = yk_state_input(state, 0).position};
    YkBodyMotion m[2];
    for (size_t k = 0; k < 2; k++) m[k] = yk_body_motion(state->mech, &state->space, body[k]);
    double w = m[1].w - m[0].w;
    // From the reference point of the second body, whose velocity against the first one is u.
    YkVec arm = yk_sub(m[1].at, m[0].at);
    YkVec u = yk_sub(m[1].velocity, yk_add(m[0].velocity, yk_scale(m[0].w, yk_quarter(arm))));
    point.exists = fabs(w) * far_away * state->mech->size > yk_norm(u);
    if (!point.exists) return point;
    YkVec at = yk_add(m[1].at, yk_scale(1 / w, yk_quarter(u)));
    point.at[0] = at.x;
    point.at[1] = at.y;
    for (size_t k = 0; k < 2; k++) {
        YkVec own = on_body(state, &m[k], body[k], at);
        point.on[k][0] = own.x;
        point.on[k][1] = own.y;
    }
    return point;
}

// Returns false when out of memory.
static bool follow(YkCentrodes *c, const YkCycle *cycle, YkState *moving)
{
    c->is_closed = cycle->turns;
    c->point = calloc(cycle->count + 1, sizeof *c->point);
    if (!c->point) return false;
    for (; c->count < cycle->count; c->count++) {
        YkStatus status = yk_cycle_pose(cycle, moving, c->count);
        if (status == YK_NO_MEMORY) return false;
        if (status >= 0) c->point[c->count] = find_point(moving, c->body);
        c->point[c->count].input = cycle->from + cycle->step * (double)c->count;
    }
    return true;
}

static bool has_points(const YkCentrodes *c)
{
    for (size_t k = 0; k < c->count; k++)
        if (c->point[k].exists) return true;
    return false;
}

YkCentrodes *yk_centrodes_new(const YkState *state, size_t first, size_t second, size_t steps, YkProblems *problems)
{
    if (!state || steps == 0 || !yk_state_has_pose(state)) return NULL;
    YkCycle cycle = {0};
    bool is_one = yk_input_count(state->mech) == 1;
    YkStatus status = is_one ? yk_cycle_find(state, steps, &cycle) : YK_OK;
    const char *why = first == second ? "a body has none with itself"
                      : !is_one       ? "the machine does not have exactly one freedom"
                      : status < 0    ? "the input cannot move from this pose"
                                      : NULL;
    YkCentrodes *c = !why ? calloc(1, sizeof *c) : NULL;
    YkState *moving = c ? yk_state_new(state->mech) : NULL;
    bool good = moving && yk_state_copy(moving, state) >= 0;
    if (good) c->body[0] = first, c->body[1] = second;
    good = good && follow(c, &cycle, moving);
    yk_state_free(moving);
    if (good && !has_points(c)) why = "these bodies only slide along each other, or move as one";
    if (good && !why) return c;
    bool ran_out = !why || status == YK_NO_MEMORY;
    yk_problem(problems, ran_out ? YK_CODE_OUT_OF_MEMORY : YK_CODE_NO_CENTERS, (YkPlace){0},
               ran_out ? "out of memory while following an instant centre%s" : "no centrodes can be drawn: %s",
               ran_out ? "" : why);
    yk_centrodes_free(c);
    return NULL;
}

void yk_centrodes_free(YkCentrodes *c)
{
    if (!c) return;
    free(c->point);
    free(c);
}

size_t yk_centrodes_body(const YkCentrodes *c, size_t side)
{
    return c && side < 2 ? c->body[side] : YK_NOT_FOUND;
}
bool yk_centrodes_are_closed(const YkCentrodes *c)
{
    return c && c->is_closed;
}
size_t yk_centrodes_count(const YkCentrodes *c)
{
    return c ? c->count : 0;
}
YkCentrodePoint yk_centrodes_point(const YkCentrodes *c, size_t index)
{
    return index < yk_centrodes_count(c) ? c->point[index] : (YkCentrodePoint){0};
}
