// Finds the equilibria of a machine with one freedom: on each circuit of its map the effort of the loads changes sign there.
// The map comes as near to a limit of the free coordinate as one likes, where random poses hardly ever lie.
#include "base/problems.h"
#include "rest/rest.h"

enum { BLOCKS_MAX = 8 }; // a map follows every branch, and there are 2^8 of as many dyads

YkMap *yk_rest_map(YkRest *rest)
{
    if (rest->freedom != 1 || rest->mech->block_count > BLOCKS_MAX) return NULL;
    YkProblems *quiet = yk_problems_new(); // a machine that cannot be mapped is searched otherwise
    YkMap *map = quiet ? yk_map_new(rest->state, yk_rest_input(rest, 0), quiet) : NULL;
    rest->ran_out |= !quiet || yk_problems_ran_out(quiet);
    yk_problems_free(quiet);
    return map;
}

// Stands at a value of the free coordinate, in the configuration of a row near to it, and finds how the loads accelerate it.
// Returns false if the machine does not close there, or is singular.
static bool stand(YkRest *rest, const double *row, double at, double *accel)
{
    YkState *s = rest->state;
    for (size_t c = 0; c < rest->mech->coordinate_count; c++) {
        s->guess[c] = row[c];
        s->is_guessed[c] = true;
    }
    yk_state_set_input(s, (size_t)rest->input[0], (YkMotion){at, 0, 0});
    YkStatus status = yk_state_assemble(s);
    rest->ran_out |= status == YK_NO_MEMORY;
    return status >= 0 && yk_rest_accelerations(rest, &at, NULL, accel) && isfinite(*accel);
}

// Narrows an interval at whose ends the loads accelerate in different directions down to an equilibrium, and keeps it.
// accel: at `from`. Returns false when out of memory.
static bool bracket(YkRest *rest, const double *row, double from, double to, double accel)
{
    double now;
    for (int k = 0; k < 30; k++) {
        double middle = 0.5 * (from + to);
        if (!stand(rest, row, middle, &now)) return !rest->ran_out;
        if (now * accel > 0)
            from = middle;
        else
            to = middle;
    }
    rest->q[0] = 0.5 * (from + to);
    bool comes_there = stand(rest, row, rest->q[0], &now) && yk_rest_descend(rest);
    return comes_there ? yk_rest_keep(rest) : !rest->ran_out;
}

static bool search_branch(YkRest *rest, const YkMap *map, size_t circuit, size_t index)
{
    YkMapBranch branch = yk_map_branch(map, circuit, index);
    size_t c = yk_rest_input(rest, 0);
    double beside = 1e-10 * rest->scale[0], last = NAN, accel = NAN, now;
    for (size_t k = 0; k < branch.rows; k++) {
        const double *row = yk_map_row(map, circuit, index, k);
        double at = row[c];
        if (!branch.is_closed && k == 0) at += beside; // exactly at a limit no acceleration is determined
        if (!branch.is_closed && k + 1 == branch.rows) at -= beside;
        if (!yk_pace_spend(rest->pace, rest->mech->step_count + 1)) return false;
        bool stands = stand(rest, row, at, &now);
        if (rest->ran_out) return false;
        if (!stands) continue;
        if (now * accel < 0 && !bracket(rest, row, last, at, accel)) return false;
        last = at, accel = now;
    }
    return true;
}

// Returns whether the map ends somewhere only because it was not followed farther.
static bool has_ends(const YkMap *map, size_t circuit)
{
    size_t count = yk_map_circuit(map, circuit).events;
    for (size_t k = 0; k < count; k++)
        if (yk_map_event(map, circuit, k).kind == YK_MAP_END) return true;
    return false;
}

bool yk_rest_search_circuits(YkRest *rest, const YkMap *map)
{
    rest->is_complete = yk_map_is_complete(map);
    for (size_t circuit = 0; circuit < yk_map_circuit_count(map); circuit++) {
        rest->is_complete = rest->is_complete && !has_ends(map, circuit);
        for (size_t k = 0; k < yk_map_circuit(map, circuit).branches; k++)
            if (!search_branch(rest, map, circuit, k)) return false;
    }
    return true;
}
