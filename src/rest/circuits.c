// Finds the equilibria of a machine with one freedom: on each circuit of its map the effort of the loads changes sign
// there. The map comes as near to a limit of the free coordinate as one likes, where random poses hardly ever lie.
#include "base/problems.h"
#include "rest/rest.h"
#include "solve/gap.h"

enum { BLOCKS_MAX = 8 }; // a map follows every branch, and there are 2^8 of as many dyads

YkMap *yk_rest_map(YkRest *rest)
{
    if (rest->freedom != 1 || rest->mech->block_count > BLOCKS_MAX) return NULL;
    YkProblems *quiet = yk_problems_new(); // a machine that cannot be mapped is searched otherwise
    YkMap *map = quiet ? yk_map_new(rest->state, yk_rest_free_coordinate(rest, 0), quiet) : NULL;
    rest->ran_out |= !quiet || yk_problems_ran_out(quiet);
    yk_problems_free(quiet);
    return map;
}

// Puts the machine together at a value of the free coordinate, in the configuration of a row near to it.
static YkStatus put_together(YkRest *rest, const double *row, double at)
{
    YkState *s = rest->state;
    for (size_t c = 0; c < rest->mech->coordinate_count; c++) {
        s->guess[c] = row[c];
        s->is_guessed[c] = true;
    }
    yk_state_set_input(s, (size_t)rest->input[0], (YkMotion){at, 0, 0});
    YkStatus status = yk_state_assemble(s);
    rest->ran_out |= status == YK_NO_MEMORY;
    return status;
}

// Returns whether the machine stands in the configuration of a row. Beside a limit all goes with the root of the step.
static bool is_near(const YkRest *rest, const double *row)
{
    const double near = 0.03; // rad, or machine sizes
    for (size_t c = 0; c < rest->mech->coordinate_count; c++) {
        double off = yk_state_coordinate(rest->state, c).position - row[c];
        if (!(yk_gap(rest->mech, rest->mech->coordinates[c].is_distance, off) < near)) return false;
    }
    return true;
}

// Moves there from where the machine stands. Returns < 0 if it does not come to the configuration of the row.
static YkStatus move_near(YkRest *rest, const double *row, double at)
{
    yk_state_set_input(rest->state, (size_t)rest->input[0], (YkMotion){at, 0, 0});
    YkStatus status = yk_state_solve(rest->state);
    if (status >= 0) yk_state_refer(rest->state); // springs feel how often an angle has turned
    return status < 0 || rest->row == row || is_near(rest, row) ? status : YK_NO_ASSEMBLY;
}

// Stands at a value of the free coordinate, in the configuration of a row near to it, and finds how the loads
// accelerate it. Where a group is solved by iteration, the search for its assembly takes a hundred times as long as
// moving there from the last value beside the same row. Returns false if the machine does not close there, or is
// singular.
static bool stand(YkRest *rest, const double *row, double at, double *accel)
{
    YkStatus status = YK_NO_ASSEMBLY;
    if (rest->mech->has_groups && rest->row) status = move_near(rest, row, at);
    bool moved = status >= 0;
    if (!moved) status = put_together(rest, row, at); // just beyond a limit it may be another configuration
    bool stands = status >= 0 && yk_rest_accelerations(rest, &at, NULL, accel) && isfinite(*accel);
    rest->row = stands && (moved || is_near(rest, row)) ? row : NULL;
    return stands;
}

// Goes to the equilibrium near to where the machine stands, and keeps it. Returns false when out of memory.
static bool keep_near(YkRest *rest)
{
    rest->row = NULL;
    return !yk_rest_descend(rest) || yk_rest_keep(rest);
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
    return stand(rest, row, rest->q[0], &now) ? keep_near(rest) : !rest->ran_out;
}

// How the loads accelerate the free coordinate at one of its values, and how that changes along it.
typedef struct Probe {
    double at, accel, slope;
} Probe;

// inward: +1 or -1, a direction in which the coordinate may go. Returns false if the machine cannot stand there.
static bool probe(YkRest *rest, const double *row, double at, double inward, Probe *p)
{
    double h = inward * 1e-6 * rest->scale[0], beyond;
    bool has_slope = stand(rest, row, at + h, &beyond);
    *p = (Probe){.at = at};
    bool stands = stand(rest, row, at, &p->accel);
    p->slope = has_slope ? (beyond - p->accel) / h : (double)NAN;
    return stands;
}

// Returns whether the acceleration may come to zero between two places at which it has one sign: it may be as far from
// a straight line as a cubic that has its slopes there.
static bool may_vanish(const Probe *p, const Probe *q)
{
    double span = q->at - p->at, least = fmin(fabs(p->accel), fabs(q->accel)), most = 0;
    double bend = p->slope * span - (q->accel - p->accel), other = q->slope * span - (q->accel - p->accel);
    for (double t = 0.25; t < 1; t += 0.25) most = fmax(most, fabs(t * (1 - t) * ((1 - t) * bend - t * other)));
    return !(least > 2 * most) || isnan(bend) || isnan(other);
}

static bool is_straight(const Probe *p, const Probe *q)
{
    double secant = (q->accel - p->accel) / (q->at - p->at), one = p->slope / secant, other = q->slope / secant;
    return one > 0.7 && one < 1.5 && other > 0.7 && other < 1.5;
}

// Finds the equilibria between two places. Several may be close together, so intervals are halved until the
// acceleration is about a straight line in them. Returns false when out of memory.
static bool search_between(YkRest *rest, const double *row, Probe p, Probe q, int depth, int *left)
{
    const double NONE = 1e-12; // over the largest: what rounding leaves where the machine rests anywhere
    bool changes = p.accel * q.accel < 0, is_none = fmin(fabs(p.accel), fabs(q.accel)) <= NONE * rest->force_scale;
    Probe middle;
    if (!changes && (is_none || !may_vanish(&p, &q))) return true;
    if (--*left < 0) depth = 0;
    if (changes && (depth == 0 || is_straight(&p, &q))) return bracket(rest, row, p.at, q.at, p.accel);
    if (depth == 0) return true;
    if (!probe(rest, row, 0.5 * (p.at + q.at), q.at > p.at ? 1 : -1, &middle))
        return !rest->ran_out && (!changes || bracket(rest, row, p.at, q.at, p.accel));
    return search_between(rest, row, p, middle, depth - 1, left) &&
           search_between(rest, row, middle, q, depth - 1, left);
}

static bool search_branch(YkRest *rest, const YkMap *map, size_t circuit, size_t index)
{
    enum { DEPTH = 16, HALVINGS = 100 };
    const double DIFFERENT = 1e-9;
    YkMapBranch branch = yk_map_branch(map, circuit, index);
    size_t c = yk_rest_free_coordinate(rest, 0);
    double beside = 1e-10 * rest->scale[0];
    Probe first = {NAN, NAN, NAN}, last = first, now;
    if (branch.rows < 2) return true;
    // Begins at the second row: at a limit two branches meet, and moving on from the last branch would stay on it.
    const double *second = yk_map_row(map, circuit, index, 1);
    bool begins = rest->mech->has_groups && put_together(rest, second, second[c]) >= 0;
    rest->row = begins ? yk_map_row(map, circuit, index, 0) : NULL;
    for (size_t k = 0; k < branch.rows; k++) {
        const double *row = yk_map_row(map, circuit, index, k);
        double at = row[c];
        if (!branch.is_closed && k == 0) at += beside; // exactly at a limit no acceleration is determined
        if (!branch.is_closed && k + 1 == branch.rows) at -= beside;
        if (!yk_pace_spend(rest->pace, rest->mech->step_count + 1)) return false;
        const double *beyond = yk_map_row(map, circuit, index, k + 1 < branch.rows ? k + 1 : k - 1);
        bool stands = probe(rest, row, at, beyond[c] > row[c] ? 1 : -1, &now);
        if (rest->ran_out) return false;
        if (!stands) continue;
        rest->q[0] = at;
        bool is_there = now.accel == 0 && fabs(last.accel) > 0; // else it rests anywhere
        if (is_there && !keep_near(rest)) return false;
        int left = HALVINGS;
        if (isfinite(last.at) && !search_between(rest, row, last, now, DEPTH, &left)) return false;
        last = now;
        if (k == 0) first = now;
    }
    bool is_other = fabs(last.accel - first.accel) > DIFFERENT * rest->force_scale * rest->scale[0];
    rest->is_wound |= branch.is_closed && is_other; // in the same pose
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
    rest->is_complete = rest->is_complete && !rest->is_wound;
    return true;
}
