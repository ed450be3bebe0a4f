// Finds which equilibria a machine reaches from its start: it moves there in its own inputs and, with one freedom, also
// in every other coordinate, since a dead point of one is not a dead point of another. When a way ends at a limit of
// its coordinate, ways in other coordinates start.
#include <stdlib.h>
#include <yoke/move.h>
#include "rest/rest.h"
#include "solve/gap.h"

enum { WAYS_MAX = 16, PLACES_MAX = 48 };
static const double SAME = 1e-6; // rad, or machine sizes

typedef struct YkReach {
    YkRest *rest;
    YkPace pace;
    bool failed; // out of memory
    size_t way_count;
    YkMechanism *mech[WAYS_MAX]; // the machine with other inputs; [0]: those of the equilibria
    YkState *state[WAYS_MAX], *trial[WAYS_MAX];
    size_t free[WAYS_MAX]; // with one freedom: the free input
    size_t place_count;    // number of poses from which ways begin
    double *place;         // [place][coordinate]
    YkState *places[PLACES_MAX];
} YkReach;

static bool is_near(const YkMechanism *mech, const YkState *s, const double *coordinates, double near)
{
    for (size_t c = 0; c < mech->coordinate_count; c++) {
        double off = yk_state_coordinate(s, c).position - coordinates[c];
        if (!(yk_gap(mech, mech->coordinates[c].is_distance, off) <= near)) return false;
    }
    return true;
}

// Puts the state of a way, by its inputs, into the pose of a place. Returns false if it cannot take that pose.
static bool stand(YkReach *r, size_t way, size_t place)
{
    YkState *s = r->state[way];
    const YkState *from = r->places[place];
    YkStatus status = from->mech == s->mech ? yk_state_copy(s, from) : yk_state_adopt(s, from);
    r->failed |= status == YK_NO_MEMORY;
    return status >= 0;
}

static bool is_angle(const YkReach *r, size_t way)
{
    const YkMechanism *mech = r->mech[way];
    return !mech->coordinates[mech->inputs[r->free[way]]].is_distance;
}

// Moves the trial state of a way from the way's position; the places of its free inputs are in `goal`.
static bool move(YkReach *r, size_t way, const double *goal, double turns)
{
    YkState *s = r->trial[way];
    const YkMechanism *mech = r->mech[way];
    YkMotion *motion = calloc(mech->input_count + 1, sizeof *motion);
    YkMoveOptions options = yk_default_move_options();
    options.detours = r->rest->freedom > 1 && r->rest->freedom < 8 ? 8 : 0;
    bool ok = motion && yk_state_copy(s, r->state[way]) >= 0;
    r->failed |= !motion;
    for (size_t i = 0; i < mech->input_count && ok; i++) {
        const YkTreeCoordinate *c = &mech->coordinates[mech->inputs[i]];
        double here = s->input[3 * i];
        motion[i].position = here;
        if (c->drive != YK_NONE) continue;
        double there = goal[mech->inputs[i]];
        motion[i].position = c->is_distance ? there : yk_nearest_turn(there, here) + turns * 2 * YK_PI;
    }
    YkStatus status = ok ? yk_state_move_to(s, motion, &options, NULL) : YK_BAD_ARGUMENT;
    r->failed |= status == YK_NO_MEMORY;
    free(motion);
    return ok && status >= 0;
}

static bool reaches(YkReach *r, const double *goal)
{
    for (size_t place = 0; place < r->place_count; place++)
        for (size_t way = 0; way < r->way_count; way++) {
            if (!stand(r, way, place)) continue;
            bool goes_round = r->rest->freedom == 1 && is_angle(r, way);
            for (int turns = 0; turns < (goes_round ? 3 : 1); turns++) // 0, 1 and -1
                if (move(r, way, goal, turns == 2 ? -1 : turns) && is_near(r->mech[way], r->trial[way], goal, SAME))
                    return true;
        }
    return false;
}

static bool is_place(const YkReach *r, const YkState *s)
{
    size_t n = r->rest->mech->coordinate_count;
    for (size_t k = 0; k < r->place_count; k++)
        if (is_near(r->rest->mech, s, r->place + k * n, 1e-3)) return true;
    return false;
}

// Remembers a pose; returns false when out of memory.
static bool add_place(YkReach *r, const YkState *s)
{
    size_t n = r->rest->mech->coordinate_count;
    if (r->place_count == PLACES_MAX || is_place(r, s)) return true;
    YkState *kept = yk_state_new(s->mech);
    if (!kept) return false;
    yk_state_copy(kept, s);
    for (size_t c = 0; c < n; c++) r->place[r->place_count * n + c] = yk_state_coordinate(s, c).position;
    r->places[r->place_count++] = kept;
    return true;
}

// Finds, with one freedom, the ends of all ways, and of the ways that begin there.
static bool find_places(YkReach *r)
{
    size_t n = r->rest->mech->coordinate_count;
    double *goal = calloc(n + 1, sizeof *goal);
    bool ok = goal != NULL;
    for (size_t place = 0; place < r->place_count && ok; place++)
        for (size_t way = 0; way < r->way_count && ok; way++) {
            const YkMechanism *mech = r->mech[way];
            size_t c = (size_t)mech->inputs[r->free[way]];
            if (!stand(r, way, place)) continue;
            for (int sense = -1; sense <= 1 && ok; sense += 2) {
                double here = r->state[way]->input[3 * r->free[way]];
                goal[c] = mech->coordinates[c].is_distance ? here + sense * 4 * mech->size : here;
                if (!move(r, way, goal, sense)) ok = add_place(r, r->trial[way]);
            }
        }
    free(goal);
    return ok;
}

static bool make_states(YkReach *r, size_t way)
{
    r->state[way] = yk_state_new(r->mech[way]);
    r->trial[way] = yk_state_new(r->mech[way]);
    if (!r->state[way] || !r->trial[way]) return false;
    yk_state_lend(r->state[way], &r->pace);
    yk_state_lend(r->trial[way], &r->pace);
    return true;
}

// Adds machines with every other coordinate in place of the one free input.
static bool add_ways(YkReach *r)
{
    const YkMechanism *own = r->rest->mech;
    for (size_t c = 0; c < own->coordinate_count && r->way_count < WAYS_MAX; c++) {
        const YkTreeCoordinate *q = &own->coordinates[c];
        if (r->rest->freedom != 1 || own->block_count == 0 || q->input != YK_NONE) continue;
        YkProblems *quiet = yk_problems_new();
        if (!quiet) return false;
        const char *name = q->name;
        YkMechanism *mech =
            yk_mechanism_compile(own->model, &(YkCompileOptions){.inputs = &name, .input_count = 1}, quiet);
        bool is_told = yk_problems_error_count(quiet) > 0;
        for (size_t k = 0; is_told && k < yk_problems_count(quiet); k++)
            is_told = yk_problems_get(quiet, k)->code != YK_CODE_OUT_OF_MEMORY;
        yk_problems_free(quiet);
        if (!mech && !is_told) return false;
        if (!mech) continue; // it cannot be an input
        size_t way = r->way_count, input = 0;
        while (input < mech->input_count && (size_t)mech->inputs[input] != c) input++;
        bool fits = mech->input_count == own->input_count && mech->coordinate_count == own->coordinate_count &&
                    input < mech->input_count;
        if (!fits) {
            yk_mechanism_free(mech);
            continue;
        }
        r->way_count++;
        r->free[way] = input;
        r->mech[way] = mech;
        if (!make_states(r, way)) return false;
    }
    return true;
}

static bool prepare(YkReach *r)
{
    YkRest *rest = r->rest;
    r->way_count = 1;
    r->free[0] = rest->freedom > 0 ? (size_t)rest->input[0] : 0;
    r->mech[0] = rest->mech;
    bool has_states = make_states(r, 0);
    r->place = calloc(PLACES_MAX * rest->mech->coordinate_count + 1, sizeof *r->place);
    if (!has_states || !r->place || yk_state_set_time(r->state[0], rest->time, NULL) < 0) return false;
    for (size_t i = 0; i < rest->mech->input_count; i++)
        r->state[0]->input[3 * i + 1] = r->state[0]->input[3 * i + 2] = 0;
    YkStatus status = rest->pose ? yk_state_adopt(r->state[0], rest->pose) : yk_state_assemble(r->state[0]);
    if (status < 0) return status != YK_NO_MEMORY; // it has no start, so nothing is reached
    return add_place(r, r->state[0]) && add_ways(r) && (rest->freedom != 1 || find_places(r));
}

YkStatus yk_rest_reach(YkRest *rest)
{
    YkReach *r = calloc(1, sizeof *r);
    bool ok = r != NULL, is_stopped = false;
    if (ok) {
        r->rest = rest;
        yk_pace_begin(&r->pace, rest->progress);
        ok = prepare(r);
        for (size_t k = 0; k < rest->count && ok && !r->pace.is_stopped; k++) {
            yk_pace_reach(&r->pace, (double)k / (double)rest->count);
            rest->points[k].at.is_reachable = reaches(r, rest->points[k].coordinates);
        }
        ok = ok && !r->failed;
        is_stopped = r->pace.is_stopped;
        for (size_t k = 0; is_stopped && k < rest->count; k++) rest->points[k].at.is_reachable = false;
        for (size_t way = 0; way < r->way_count; way++) {
            yk_state_free(r->state[way]);
            yk_state_free(r->trial[way]);
            if (way > 0) yk_mechanism_free(r->mech[way]);
        }
        for (size_t k = 0; k < r->place_count; k++) yk_state_free(r->places[k]);
        free(r->place);
    }
    free(r);
    return !ok ? YK_NO_MEMORY : is_stopped ? YK_STOPPED : YK_OK;
}
