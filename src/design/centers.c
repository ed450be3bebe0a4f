// Instant centres by Kennedy's theorem, checked against the velocities and completed from them.
//
// In homogeneous coordinates (x, y, w) a centre at infinity is a point like any other: the line through two points and
// the point where two lines meet are cross products. The centres of three bodies lie on one line (Aronhold 1872,
// Kennedy 1886), so that of i and j lies on the lines through the centres ik and kj, for every k whose two are known.
#include <yoke/centers.h>
#include <math.h>
#include <stdlib.h>
#include "base/problems.h"
#include "compile/mechanism.h"
#include "solve/run.h"
#include "solve/state.h"

enum { BODIES_MAX = 200 };

static const double alike = 1e-9, coincident = 1e-6; // beside what is compared; sine between lines

typedef struct Place { // homogeneous, in units of the machine's size
    double x, y, w;
} Place;

// A body's velocity field: v(p) = c + w i p, in units of the machine's size and of the fastest body.
typedef struct Field {
    YkVec c;
    double w;
} Field;

struct YkCenters {
    YkCenter *items;
    size_t count, stalled;
};

typedef struct Search {
    YkArena *arena; // of its arrays
    const YkState *state;
    const YkModel *model;
    YkCenters *centers;
    size_t bodies;
    Field *field;             // [bodies]
    Place *place;             // [bodies * bodies], both ways round
    bool *is_done, *is_known; // likewise: has its answer; has a place that lines can go through
    double size;
} Search;

static Place cross(Place a, Place b)
{
    return (Place){a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
}

static double length(Place a)
{
    return sqrt(a.x * a.x + a.y * a.y + a.w * a.w);
}

static Place unit(Place a)
{
    double l = length(a);
    return l > 0 ? (Place){a.x / l, a.y / l, a.w / l} : a;
}

// Returns the sine of the angle between two homogeneous vectors of length 1: 0 if they are the same point or line.
static double apart(Place a, Place b)
{
    return length(cross(a, b));
}

static size_t pair_of(const Search *s, size_t i, size_t j)
{
    return i * s->bodies + j;
}

// The centre by velocities: Delta c + Delta w i p = 0. False if the bodies move as one.
static bool by_velocities(const Search *s, size_t i, size_t j, Place *place)
{
    const Field *a = &s->field[i], *b = &s->field[j];
    YkVec c = yk_sub(a->c, b->c);
    double w = a->w - b->w, size = fabs(a->w) + fabs(b->w) + yk_norm(a->c) + yk_norm(b->c);
    *place = unit((Place){-c.y, c.x, w});
    return sqrt(yk_dot(c, c) + w * w) > alike * size;
}

static void keep(Search *s, size_t i, size_t j, Place place, YkCenter center)
{
    static const double far_away = 1e-12;
    size_t low = i < j ? i : j, high = i < j ? j : i;
    center.body[0] = low;
    center.body[1] = high;
    if (center.kind != YK_CENTER_UNDEFINED) {
        center.kind = fabs(place.w) > far_away * length(place) ? YK_CENTER_POINT : YK_CENTER_AT_INFINITY;
        s->is_known[pair_of(s, i, j)] = s->is_known[pair_of(s, j, i)] = true;
        s->place[pair_of(s, i, j)] = s->place[pair_of(s, j, i)] = unit(place);
    }
    if (center.kind == YK_CENTER_POINT) {
        center.at[0] = s->size * place.x / place.w;
        center.at[1] = s->size * place.y / place.w;
    } else if (center.kind == YK_CENTER_AT_INFINITY) {
        double angle = yk_atan2(place.y, place.x);
        center.direction = angle > YK_PI / 2 ? angle - YK_PI : angle <= -YK_PI / 2 ? angle + YK_PI : angle;
    }
    s->is_done[pair_of(s, i, j)] = s->is_done[pair_of(s, j, i)] = true;
    s->centers->items[s->centers->count++] = center;
}

// --- velocities

static void find_fields(Search *s, const YkState *state)
{
    double fastest = 0;
    for (size_t b = 0; b < s->bodies; b++) {
        double x[6];
        YkRun run = {.mech = state->mech, .space = &state->space, .lanes = 1};
        yk_run_sum(&run, &state->mech->bodies[b].origin, (YkPlane){x, x + 1, x + 2, x + 3, x + 4, x + 5});
        double w = yk_state_body(state, b).velocity;
        YkVec at = yk_scale(1 / s->size, yk_vec(x[0], x[1])), v = yk_scale(1 / s->size, yk_vec(x[2], x[3]));
        s->field[b] = (Field){yk_sub(v, yk_scale(w, yk_quarter(at))), w};
        fastest = fmax(fastest, fabs(w) + yk_norm(v));
    }
    for (size_t b = 0; b < s->bodies && fastest > 0; b++) {
        s->field[b].c = yk_scale(1 / fastest, s->field[b].c);
        s->field[b].w /= fastest;
    }
}

// --- joints

// The world direction and place of a joint on its first body.
static YkVec joint_place(const Search *s, const YkJoint *joint, YkVec *turn)
{
    double x[6];
    YkRun run = {.mech = s->state->mech, .space = &s->state->space, .lanes = 1};
    const YkPlacing *placing = &s->state->mech->bodies[joint->body[0]];
    yk_run_sum(&run, &placing->origin, (YkPlane){x, x + 1, x + 2, x + 3, x + 4, x + 5});
    *turn = placing->turn_unit;
    if (placing->orientation != 0) {
        YkTurn t = yk_space_turn(&s->state->space, placing->orientation);
        *turn = yk_mul(yk_vec(t.c[0], t.s[0]), placing->turn_unit);
    }
    return yk_scale(1 / s->size, yk_add(yk_vec(x[0], x[1]), yk_mul(*turn, joint->at[0])));
}

static void take_joints(Search *s)
{
    for (size_t k = 0; k < s->model->shown_joints; k++) {
        const YkJoint *joint = &s->model->joints[k];
        size_t i = (size_t)joint->body[0], j = (size_t)joint->body[1];
        YkVec turn, at;
        Place by_rates;
        if ((joint->kind != YK_PIN && joint->kind != YK_SLIDE) || joint->is_free || s->is_done[pair_of(s, i, j)])
            continue;
        at = joint_place(s, joint, &turn);
        YkVec across = yk_quarter(yk_mul(turn, joint->along));
        Place place = joint->kind == YK_PIN ? (Place){at.x, at.y, 1} : (Place){across.x, across.y, 0};
        YkCenter center = {.source = YK_CENTER_JOINT, .joint = k};
        if (!by_velocities(s, i, j, &by_rates)) center.kind = YK_CENTER_UNDEFINED; // the joint does not move
        keep(s, i, j, place, center);
    }
}

// --- Kennedy

// Finds the two lines that meet best. Returns false if no two lines meet, or they do so elsewhere than the velocities
// have it: then they coincide, up to rounding.
static bool by_kennedy(const Search *s, size_t i, size_t j, Place *place, size_t by[2])
{
    double best = coincident;
    Place known;
    bool found = false;
    if (!by_velocities(s, i, j, &known)) return false;
    for (size_t k = 0; k < s->bodies; k++) {
        if (!s->is_known[pair_of(s, i, k)] || !s->is_known[pair_of(s, k, j)]) continue;
        Place p = s->place[pair_of(s, i, k)], q = s->place[pair_of(s, k, j)];
        if (apart(p, q) < coincident) continue;
        Place line = unit(cross(p, q));
        for (size_t m = k + 1; m < s->bodies; m++) {
            if (!s->is_known[pair_of(s, i, m)] || !s->is_known[pair_of(s, m, j)]) continue;
            Place r = s->place[pair_of(s, i, m)], t = s->place[pair_of(s, m, j)];
            if (apart(r, t) < coincident) continue;
            Place other = unit(cross(r, t));
            double sine = apart(line, other);
            if (sine <= best) continue;
            best = sine;
            by[0] = k;
            by[1] = m;
            *place = cross(line, other);
            found = true;
        }
    }
    return found && apart(unit(*place), known) < alike / best;
}

// Takes the first pair that two lines determine; false if there is none.
static bool take_next(Search *s)
{
    for (size_t i = 0; i < s->bodies; i++)
        for (size_t j = i + 1; j < s->bodies; j++) {
            YkCenter center = {.source = YK_CENTER_KENNEDY};
            Place place;
            if (s->is_done[pair_of(s, i, j)] || !by_kennedy(s, i, j, &place, center.by)) continue;
            keep(s, i, j, place, center);
            return true;
        }
    return false;
}

// Takes the first pair that is left from the velocities; false if all are done.
static bool take_stalled(Search *s)
{
    for (size_t i = 0; i < s->bodies; i++)
        for (size_t j = i + 1; j < s->bodies; j++) {
            YkCenter center = {.source = YK_CENTER_VELOCITIES};
            Place place = {0};
            if (s->is_done[pair_of(s, i, j)]) continue;
            if (!by_velocities(s, i, j, &place)) center.kind = YK_CENTER_UNDEFINED;
            s->centers->stalled += center.kind != YK_CENTER_UNDEFINED;
            keep(s, i, j, place, center);
            return true;
        }
    return false;
}

static bool allocate(Search *s)
{
    size_t n = s->bodies, pairs = n * n;
    YkArena *a = s->arena = yk_arena_new();
    s->field = yk_arena_alloc(a, n, sizeof *s->field);
    s->place = yk_arena_alloc(a, pairs, sizeof *s->place);
    s->is_done = yk_arena_alloc(a, pairs, sizeof *s->is_done);
    s->is_known = yk_arena_alloc(a, pairs, sizeof *s->is_known);
    s->centers = calloc(1, sizeof *s->centers);
    if (s->centers) s->centers->items = calloc(pairs, sizeof *s->centers->items);
    return !yk_arena_failed(a) && s->centers && s->centers->items;
}

// A copy of the state whose input moves at unit rate; NULL when out of memory or at a dead point.
static YkState *moving_copy(const YkState *state, YkStatus *status)
{
    YkState *moving = yk_state_new(state->mech);
    *status = moving ? yk_state_copy(moving, state) : YK_NO_MEMORY;
    if (*status < 0) return moving;
    bool is_distance = yk_coordinate_info(state->mech, yk_input_coordinate(state->mech, 0)).is_distance;
    YkMotion input = {yk_state_input(state, 0).position, is_distance ? state->mech->size : 1, 0};
    yk_state_set_input(moving, 0, input);
    *status = yk_state_solve(moving);
    return moving;
}

static bool is_fit(const YkState *state, YkProblems *problems)
{
    const char *why = yk_input_count(state->mech) != 1              ? "the machine does not have exactly one freedom"
                      : state->mech->model->body_count > BODIES_MAX ? "the machine has more than 200 bodies"
                                                                    : NULL;
    if (why) yk_problem(problems, YK_CODE_NO_CENTERS, (YkPlace){0}, "there are no instant centres: %s", why);
    return !why;
}

YkCenters *yk_centers_new(const YkState *state, YkProblems *problems)
{
    if (!state || !yk_state_has_pose(state) || !is_fit(state, problems)) return NULL;
    const YkModel *model = state->mech->model;
    Search s = {.model = model, .bodies = model->body_count - model->carriage_count, .size = state->mech->size};
    YkStatus status = YK_OK;
    YkState *moving = moving_copy(state, &status);
    bool good = moving && status != YK_NO_MEMORY && allocate(&s);
    bool has_rates = good && status >= 0 && yk_state_has_rates(moving);
    s.state = moving;
    if (has_rates) {
        find_fields(&s, moving);
        take_joints(&s);
        while (take_next(&s) || take_stalled(&s)) {}
    } else {
        yk_problem(problems, good ? YK_CODE_NO_CENTERS : YK_CODE_OUT_OF_MEMORY, (YkPlace){0},
                   good ? "there are no instant centres here: the velocities are not determined at this pose"
                        : "out of memory while finding instant centres");
        yk_centers_free(s.centers);
        s.centers = NULL;
    }
    yk_state_free(moving);
    yk_arena_free(s.arena);
    return s.centers;
}

void yk_centers_free(YkCenters *centers)
{
    if (!centers) return;
    free(centers->items);
    free(centers);
}

size_t yk_centers_count(const YkCenters *centers)
{
    return centers ? centers->count : 0;
}

YkCenter yk_centers_at(const YkCenters *centers, size_t index)
{
    return index < yk_centers_count(centers) ? centers->items[index] : (YkCenter){.kind = YK_CENTER_UNDEFINED};
}

size_t yk_centers_stalled(const YkCenters *centers)
{
    return centers ? centers->stalled : 0;
}
