// Another choice of independent coordinates near a dead point: those that the pivots of all rates choose, for each part
// of the machine that moves by itself.
#include <stdlib.h>
#include <string.h>
#include "base/sets.h"
#include "num/dense.h"
#include "simulate/simulation.h"

// The bodies that joints and relations connect, other than by the ground, form a part. Lists are ordered by part: that
// of part p has the members first[p] .. first[p + 1] - 1.
typedef struct List {
    size_t *first, *member;
} List;
typedef struct Parts {
    int32_t *parent;          // [body]: of its set (base/sets.h), which is a part
    size_t *number;           // [body]: of the part of which it is the root
    int32_t *distance_body;   // [distance]
    size_t count, most;       // parts with free inputs; of these in one part
    List inputs, coordinates; // members: index in free_input; coordinate
    double *rates, *tau;      // of one part after the other: [free input][coordinate]
    size_t *order;
    void *memory;
} Parts;

// --- parts

static void unite(Parts *parts, int32_t a, int32_t b)
{
    if (a != 0 && b != 0) yk_sets_join(parts->parent, a, b);
}

static int32_t body_of_joint(const YkSimulation *sim, size_t joint)
{
    const int32_t *body = sim->model->joints[joint].body;
    return body[0] != 0 ? body[0] : body[1];
}

// Returns where the number of a coordinate's part is kept.
static size_t *number_of(const YkSimulation *sim, const Parts *parts, size_t coordinate)
{
    int32_t body = body_of_joint(sim, (size_t)sim->mech->coordinates[coordinate].joint);
    return &parts->number[yk_root_of(parts->parent, body)];
}

static size_t coordinate_of(const YkSimulation *sim, size_t k)
{
    return (size_t)sim->mech->inputs[sim->free_input[k]];
}

// Returns a body among those of the terms that is not the ground, or `body`; unites all of them with it.
static int32_t unite_terms(const YkMechanism *mech, Parts *parts, uint32_t from, uint32_t count, int32_t body)
{
    for (uint32_t k = from; k < from + count; k++) {
        YkRelationTerm term = mech->relation_terms[k];
        int32_t other = term.is_distance ? parts->distance_body[term.index] : mech->orientation_body[term.index];
        unite(parts, body, other);
        if (other != 0) body = other;
    }
    return body;
}

static void unite_all(const YkSimulation *sim, Parts *parts)
{
    const YkMechanism *mech = sim->mech;
    yk_sets_begin(parts->parent, sim->model->body_count);
    for (size_t j = 0; j < sim->model->joint_count; j++) {
        const int32_t *body = sim->model->joints[j].body;
        unite(parts, body[0], body[1]);
        if (mech->joint_distance[j] != YK_NONE) parts->distance_body[mech->joint_distance[j]] = body_of_joint(sim, j);
    }
    for (size_t r = 0; r < mech->relation_count; r++) {
        const YkRelation *relation = &mech->relations[r];
        int32_t body = unite_terms(mech, parts, relation->first_term, relation->term_count, 0);
        unite_terms(mech, parts, relation->first_argument, relation->argument_count, body);
    }
}

// Lists members by part. part_of_member[k] >= count: in none.
static void list_by_part(List *list, size_t parts, const size_t *part_of_member, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (part_of_member[k] < parts) list->first[part_of_member[k] + 1]++;
    for (size_t p = 0; p < parts; p++) list->first[p + 1] += list->first[p];
    for (size_t k = count; k-- > 0;) // backwards, each list from its end
        if (part_of_member[k] < parts) list->member[--list->first[part_of_member[k] + 1]] = k;
    for (size_t p = 0; p < parts; p++) list->first[p] = list->first[p + 1];
    list->first[parts] = 0;
    for (size_t k = 0; k < count; k++) list->first[parts] += part_of_member[k] < parts;
}

static void find_parts(const YkSimulation *sim, Parts *parts)
{
    size_t f = sim->free_count, n = sim->mech->coordinate_count, *of = parts->order; // scratch
    unite_all(sim, parts);
    for (size_t b = 0; b < sim->model->body_count; b++) parts->number[b] = SIZE_MAX;
    for (size_t k = 0; k < f; k++) { // by their first free inputs
        size_t *number = number_of(sim, parts, coordinate_of(sim, k));
        if (*number == SIZE_MAX) *number = parts->count++;
        of[k] = *number;
    }
    list_by_part(&parts->inputs, parts->count, of, f);
    for (size_t c = 0; c < n; c++) of[c] = *number_of(sim, parts, c);
    list_by_part(&parts->coordinates, parts->count, of, n);
    for (size_t p = 0; p < parts->count; p++) {
        size_t own = parts->inputs.first[p + 1] - parts->inputs.first[p];
        if (own > parts->most) parts->most = own;
    }
}

static bool make_parts(const YkSimulation *sim, Parts *parts)
{
    const double ENTRIES_MAX = 4e6;
    size_t bodies = sim->model->body_count, f = sim->free_count, n = sim->mech->coordinate_count, entries = 0;
    size_t distances = sim->mech->distance_count, *p;
    *parts = (Parts){.memory = calloc(2 * bodies + distances + 3 * f + 2 * n + 8, sizeof *p)};
    if (!parts->memory) return false;
    p = parts->memory;
    parts->number = p, p += bodies;
    parts->inputs = (List){p, p + f + 2}, p += 2 * f + 2;
    parts->coordinates = (List){p, p + f + 2}, p += f + 2 + n;
    parts->order = p, p += n + 1;
    parts->parent = (int32_t *)p, parts->distance_body = parts->parent + bodies;
    find_parts(sim, parts);
    for (size_t k = 0; k < parts->count; k++)
        entries += (parts->inputs.first[k + 1] - parts->inputs.first[k]) *
                   (parts->coordinates.first[k + 1] - parts->coordinates.first[k]);
    if (parts->count == 0 || (double)entries > ENTRIES_MAX) return true; // without rates
    parts->rates = calloc(entries + 2 * n + f, sizeof *parts->rates);
    parts->tau = parts->rates ? parts->rates + entries : NULL;
    return parts->rates != NULL;
}

// --- choosing

// Finds the rates of all coordinates for a unit rate of each free input, of one input of every part at a time;
// distances over the machine's size.
static bool find_rates(YkSimulation *sim, const Parts *parts)
{
    YkState *s = sim->state;
    const YkMechanism *mech = sim->mech;
    const size_t *inputs = parts->inputs.first, *coordinates = parts->coordinates.first;
    for (size_t round = 0; round < parts->most; round++) {
        for (size_t i = 0; i < mech->input_count; i++) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
        for (size_t p = 0; p < parts->count; p++)
            if (inputs[p] + round < inputs[p + 1])
                s->input[3 * sim->free_input[parts->inputs.member[inputs[p] + round]] + 1] = 1;
        if (yk_state_solve(s) < 0 || !s->has_rates) return false;
        double *rates = parts->rates;
        for (size_t p = 0; p < parts->count; p++) {
            size_t n = coordinates[p + 1] - coordinates[p], f = inputs[p + 1] - inputs[p];
            for (size_t k = 0; round < f && k < n; k++) {
                size_t c = parts->coordinates.member[coordinates[p] + k];
                const YkTreeCoordinate *q = &mech->coordinates[c];
                bool is_driven = q->input != YK_NONE && !sim->dynamics->is_free[q->input];
                double rate = is_driven ? 0 : yk_state_coordinate(s, c).velocity;
                rates[round * n + k] = q->is_distance ? rate / mech->size : rate;
                if (!isfinite(rate)) return false;
            }
            rates += f * n;
        }
    }
    return true;
}

// Finds the coordinates of a part that the pivots of its rates choose; returns how much larger their determinant is
// than that of the present ones.
static double choose(const YkSimulation *sim, const Parts *parts, size_t p, double *rates)
{
    size_t from = parts->inputs.first[p], f = parts->inputs.first[p + 1] - from;
    size_t n = parts->coordinates.first[p + 1] - parts->coordinates.first[p];
    double gain = 1;
    for (size_t j = 0; j < f; j++) // the present coordinates have the unit matrix, up to their size
        if (sim->mech->coordinates[coordinate_of(sim, parts->inputs.member[from + j])].is_distance)
            gain *= sim->mech->size;
    yk_qr_factor(f, n, rates, parts->order, parts->tau, 1e-12);
    for (size_t j = 0; j < f; j++) gain *= fabs(rates[j * n + j]);
    return gain;
}

// Chooses for every part; returns whether one gets others. Parts that gain little keep theirs.
static bool choose_all(const YkSimulation *sim, const Parts *parts, size_t *chosen)
{
    const double GAIN =
        2.5; // equal links fold by half: their relative angle, twice as fast, is no better at a change point
    double *rates = parts->rates;
    bool changes = false;
    for (size_t p = 0; p < parts->count; p++) {
        size_t from = parts->inputs.first[p], f = parts->inputs.first[p + 1] - from;
        size_t at = parts->coordinates.first[p], n = parts->coordinates.first[p + 1] - at;
        bool gains = choose(sim, parts, p, rates) > GAIN;
        for (size_t j = 0; j < f; j++) {
            size_t k = parts->inputs.member[from + j];
            chosen[k] = gains ? parts->coordinates.member[at + parts->order[j]] : coordinate_of(sim, k);
        }
        changes |= gains;
        rates += f * n;
    }
    return changes;
}

bool yk_simulation_recoordinate(YkSimulation *sim, bool *changed)
{
    size_t inputs = sim->mech->input_count;
    *changed = false;
    if (sim->free_count == 0) return true;
    Parts parts;
    double *kept = calloc(3 * inputs + 1, sizeof *kept);
    size_t *chosen = calloc(sim->free_count, sizeof *chosen);
    bool ok = make_parts(sim, &parts) && kept && chosen;
    if (ok && parts.rates) {
        memcpy(kept, sim->state->input, 3 * inputs * sizeof *kept);
        bool found = find_rates(sim, &parts) && choose_all(sim, &parts, chosen);
        memcpy(sim->state->input, kept, 3 * inputs * sizeof *kept);
        yk_state_solve(sim->state);
        if (found) ok = yk_simulation_take(sim, chosen, changed);
    }
    free(parts.rates);
    free(parts.memory);
    free(kept);
    free(chosen);
    if (!ok) yk_arena_fail(sim->arena);
    return ok;
}
