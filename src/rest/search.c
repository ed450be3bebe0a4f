// Searches for equilibria: from the start, along the circuits of a machine with one freedom, and from random poses.
#include "rest/rest.h"

// Returns a seeded number in [0, 1): xorshift64* (Vigna 2016).
static double next_random(uint64_t *seed)
{
    *seed ^= *seed >> 12;
    *seed ^= *seed << 25;
    *seed ^= *seed >> 27;
    return (double)((*seed * 0x2545F4914F6CDD1Dull) >> 11) * 0x1p-53;
}

// Puts the machine together near random guesses. Returns YK_NO_MEMORY, or < 0 if they lead to no pose.
static YkStatus stand_anywhere(YkRest *rest, uint64_t *seed)
{
    YkState *s = rest->state;
    const YkMechanism *mech = rest->mech;
    for (size_t c = 0; c < mech->coordinate_count; c++) {
        double x = 2 * next_random(seed) - 1;
        s->guess[c] = x * (mech->coordinates[c].is_distance ? mech->size : YK_PI);
        s->is_guessed[c] = true;
    }
    for (size_t i = 0; i < rest->freedom; i++)
        yk_state_set_input(s, (size_t)rest->input[i], (YkMotion){s->guess[yk_rest_free_coordinate(rest, i)], 0, 0});
    return yk_state_assemble(s);
}

// Looks for an equilibrium from the pose in which the state stands. Where loads balance each other in every pose, as
// on an arm that a spring carries, the accelerations are rounding alone: the loads themselves say what is none.
static bool search_here(YkRest *rest)
{
    for (size_t i = 0; i < rest->freedom; i++) rest->q[i] = rest->state->input[3 * rest->input[i]];
    if (!yk_rest_weigh_loads(rest)) return false;
    rest->force_scale = fmax(rest->force_scale, 1e-2 * rest->loads);
    return !yk_rest_descend(rest) || yk_rest_keep(rest);
}

bool yk_rest_search(YkRest *rest, size_t starts)
{
    uint64_t seed = 0x9E3779B97F4A7C15ull;
    yk_pace_stage(rest->pace, YK_REST_STARTED, 1);
    YkMap *map = starts > 0 ? yk_rest_map(rest) : NULL; // from the start, which the search leaves
    bool ok = !rest->ran_out && search_here(rest);
    rest->of_start = rest->count;
    ok = ok && (!map || yk_rest_search_circuits(rest, map));
    yk_map_free(map);
    for (size_t k = 0; ok && k < starts; k++) {
        yk_pace_reach(rest->pace, (double)(k + 1) / (double)(starts + 1));
        if (yk_pace_is_stopped(rest->pace)) return false;
        YkStatus status = stand_anywhere(rest, &seed);
        if (status == YK_NO_MEMORY) return false;
        ok = status < 0 || search_here(rest);
    }
    return ok && !yk_pace_is_stopped(rest->pace);
}
