// Random trains as text, with their equations from the drawing, in absolute angles: wheels on one axis, planets on the
// ground and on arms, gears, belts and racks between them, some of which repeat each other, and laws by which angles
// follow others.
#ifndef TESTS_COMPILE_RANDOM_TRAIN_H
#define TESTS_COMPILE_RANDOM_TRAIN_H
#include <stdbool.h>
#include "check.h"

enum { BODIES = 18, TIES = 26, TEXT = 4000 };
typedef enum Kind { GEAR, RING, OPEN_BELT, CROSSED_BELT, RACK, LAW } Kind;

typedef struct Tie {
    Kind kind;
    int a, b, carrier; // a planet on the carrier; a wheel, or a rack
    double size[2];    // teeth or radii; a rack: 1 or -1, its side, and the pinion's radius; a law: its slope
    double row[BODIES], constant;
} Tie;

typedef struct Train {
    int bodies, central, ties, rank;
    int on[BODIES]; // what carries it; body 0 is the ground
    bool is_bar[BODIES];
    Tie tie[TIES];
    bool is_given[BODIES], is_driven[BODIES];
    double start[BODIES];
    char text[8 * TEXT];
} Train;

static inline int pick(uint64_t *seed, int low, int high)
{
    return low + (int)(check_random(seed) % (uint64_t)(high - low + 1));
}

// --- the drawing

static inline int new_body(Train *t, int on, bool is_bar)
{
    t->on[t->bodies] = on;
    t->is_bar[t->bodies] = is_bar;
    return t->bodies++;
}

static inline void add_tie(Train *t, uint64_t *seed, int a, int b)
{
    Tie *tie = &t->tie[t->ties++];
    *tie = (Tie){.kind = (Kind)pick(seed, GEAR, CROSSED_BELT), .a = a, .b = b, .carrier = t->on[a]};
    for (int k = 0; k < 2; k++) tie->size[k] = tie->kind <= RING ? pick(seed, 12, 60) : pick(seed, 1, 9) / 64.0;
    if (tie->kind == RING) tie->size[1] += 50;
    if (pick(seed, 0, 4) == 0) tie->size[1] = tie->size[0] + (tie->kind == RING); // equal pulleys leave the carrier out
}

// Another planet in mesh with the same wheels repeats what the first says.
static inline void add_copy(Train *t, int planet)
{
    int copy = new_body(t, t->on[planet], false), ties = t->ties;
    for (int k = 0; k < ties && t->ties < TIES; k++) {
        if (t->tie[k].kind == RACK || t->tie[k].a != planet) continue;
        t->tie[t->ties] = t->tie[k];
        t->tie[t->ties++].a = copy;
    }
}

static inline void add_rack(Train *t, uint64_t *seed, int pinion)
{
    int bar = new_body(t, t->on[pinion], true);
    t->tie[t->ties++] =
        (Tie){RACK, pinion, bar, t->on[pinion], {pick(seed, 0, 1) ? 1 : -1, check_uniform(seed, 0.1, 2)}, {0}, 0};
}

static inline void draw(Train *t, uint64_t *seed)
{
    memset(t, 0, sizeof *t);
    t->bodies = 1;
    int central = t->central = pick(seed, 1, 4), planets = pick(seed, 1, 5), wanted = pick(seed, 1, 8);
    for (int k = 0; k < central; k++) new_body(t, 0, false);
    for (int k = 0; k < planets; k++) new_body(t, pick(seed, 0, central), false);
    for (int tries = 0; t->ties < wanted && tries < 100; tries++) {
        int p = pick(seed, central + 1, central + planets), q = pick(seed, 1, central + planets), arm = t->on[p];
        if (q != p && q != arm && (q <= central || t->on[q] == arm)) add_tie(t, seed, p, q);
    }
    for (int k = pick(seed, 0, 2); k > 0; k--) add_copy(t, pick(seed, central + 1, central + planets));
    for (int k = pick(seed, 0, 2); k > 0; k--) add_rack(t, seed, pick(seed, central + 1, central + planets));
}

// --- its equations

// A coordinate: the angle to what carries it, or the distance.
static inline void add_coordinate(const Train *t, double *row, int body, double factor)
{
    row[body] += factor;
    if (!t->is_bar[body]) row[t->on[body]] -= factor;
    row[0] = 0;
}

static inline void write_row(const Train *t, Tie *tie)
{
    bool is_rack = tie->kind == RACK;
    double a = is_rack ? -tie->size[0] * tie->size[1] : tie->size[0], b = is_rack ? 1 : tie->size[1];
    if (tie->kind == RING || tie->kind == OPEN_BELT) b = -b;
    if (tie->kind == LAW) {
        add_coordinate(t, tie->row, tie->a, 1);
        add_coordinate(t, tie->row, tie->b, -tie->size[0]);
        return;
    }
    tie->row[tie->a] += a;
    tie->row[tie->b] += b;
    tie->row[tie->carrier] -= is_rack ? a : a + b;
    tie->row[0] = 0;
}

static inline void write_rows(Train *t)
{
    for (int k = 0; k < t->ties; k++) write_row(t, &t->tie[k]);
}

// A tie's factors on the angles between neighbours.
static inline void relative_row(const Train *t, const Tie *tie, double *share)
{
    memset(share, 0, BODIES * sizeof *share);
    for (int b = 1; b < t->bodies; b++) {
        share[b] += tie->row[b];
        if (!t->is_bar[b] && t->on[b] > 0) share[t->on[b]] += tie->row[b];
    }
}

// Its sum at the start where all that it ties is given, otherwise 0.
static inline void write_constants(Train *t)
{
    for (int k = 0; k < t->ties; k++) {
        double share[BODIES], sum = 0;
        bool all = true;
        relative_row(t, &t->tie[k], share);
        for (int b = 1; b < t->bodies; b++) {
            sum += share[b] * t->start[b];
            all = all && (fabs(share[b]) < 1e-9 || t->is_given[b]) && t->tie[k].kind != LAW;
        }
        t->tie[k].constant = all ? sum : 0;
    }
}

// Takes a row's part that does not depend on those taken; true where there is some.
static inline bool take(double basis[BODIES][BODIES], int *rank, const double *row)
{
    double v[BODIES], length = 0;
    memcpy(v, row, sizeof v);
    for (int k = 0; k < BODIES; k++) length += v[k] * v[k];
    for (int k = 0; k < BODIES; k++) v[k] /= sqrt(length);
    for (int i = 0; i < 2 * *rank; i++) { // twice
        double along = 0;
        for (int k = 0; k < BODIES; k++) along += v[k] * basis[i % *rank][k];
        for (int k = 0; k < BODIES; k++) v[k] -= along * basis[i % *rank][k];
    }
    length = 0;
    for (int k = 0; k < BODIES; k++) length += v[k] * v[k];
    if (length < 1e-18) return false;
    for (int k = 0; k < BODIES; k++) basis[*rank][k] = v[k] / sqrt(length);
    ++*rank;
    return true;
}

static inline bool follows(const Train *t, int body)
{
    bool is_led = false;
    for (int k = 0; k < t->ties; k++) is_led |= t->tie[k].kind == LAW && t->tie[k].a == body;
    return is_led;
}

// Makes angles follow others by laws, where no tie repeats another.
static inline void add_laws(Train *t, uint64_t *seed)
{
    double basis[BODIES][BODIES];
    int rank = 0;
    for (int k = 0; k < t->ties; k++) take(basis, &rank, t->tie[k].row);
    for (int k = pick(seed, 0, 2); k > 0 && rank == t->ties && t->ties < TIES; k--) {
        Tie tie = {.kind = LAW, .a = pick(seed, 1, t->bodies - 1), .b = pick(seed, 1, t->bodies - 1), .size = {3, 0}};
        if (tie.a == tie.b || t->is_bar[tie.a] || t->is_bar[tie.b] || follows(t, tie.a)) continue;
        write_row(t, &tie);
        if (take(basis, &rank, tie.row)) t->tie[t->ties++] = tie;
    }
}

// Drives some of what is free.
static inline void choose_drives(Train *t, uint64_t *seed)
{
    double basis[BODIES][BODIES];
    int rank = 0;
    for (int k = 0; k < t->ties; k++) take(basis, &rank, t->tie[k].row);
    t->rank = rank;
    for (int b = 1; b < t->bodies; b++) {
        double row[BODIES] = {0};
        add_coordinate(t, row, b, 1);
        t->is_driven[b] = !follows(t, b) && pick(seed, 0, 1) && take(basis, &rank, row);
    }
}

// --- its file

#define ADD(...) snprintf(t->text + strlen(t->text), sizeof t->text - strlen(t->text), __VA_ARGS__)

// Where a body's pin is on its carrier, and where a rack's line begins, beside its pinion.
static inline void write_point(Train *t, int body, int carrier)
{
    double x = 0, y = 0;
    if (carrier == t->on[body] && body > t->central && !t->is_bar[body]) x = body, y = 5;
    for (int k = 0; t->is_bar[body] && k < t->ties; k++)
        if (t->tie[k].kind == RACK && t->tie[k].b == body) y = 5 - 3 * t->tie[k].size[0];
    ADD("%sJ%d: [%g, %g]", t->text[strlen(t->text) - 1] == '{' ? "" : ", ", body, x, y);
}

// "ground", or "b3".
static inline const char *name_of(int body)
{
    static char name[8];
    snprintf(name, sizeof name, body ? "b%d" : "ground", body);
    return name;
}

static inline void write_structure(Train *t)
{
    ADD("bodies:\n");
    for (int b = 0; b < t->bodies; b++) {
        ADD("  %s: {points: {", name_of(b));
        for (int k = 1; k < t->bodies; k++)
            if (t->on[k] == b || k == b) write_point(t, k, b);
        ADD("}}\n");
    }
    ADD("joints:\n");
    for (int b = 1; b < t->bodies; b++)
        if (t->is_bar[b])
            ADD("  J%d: {slide: [%s, b%d], along: x, from: J%d, distance: q%d}\n", b, name_of(t->on[b]), b, b, b);
        else
            ADD("  J%d: {pin: [%s, b%d], angle: q%d}\n", b, name_of(t->on[b]), b, b);
}

static inline void write_ties(Train *t)
{
    static const char *const sections[] = {"gears", "belts", "racks"};
    for (int section = 0; section < 3; section++) {
        ADD("%s: {", sections[section]);
        for (int k = 0; k < t->ties; k++) {
            const Tie *tie = &t->tie[k];
            if (tie->kind == LAW || (int)tie->kind / 2 != section) continue;
            if (section == 0)
                ADD("m%d: {mesh: [b%d, b%d], teeth: [%g, %g], internal: %s", k, tie->a, tie->b, tie->size[0],
                    tie->size[1], tie->kind == RING ? "true" : "false");
            else if (section == 1)
                ADD("m%d: {between: [b%d, b%d], radii: [%.17g, %.17g], crossed: %s", k, tie->a, tie->b, tie->size[0],
                    tie->size[1], tie->kind == CROSSED_BELT ? "true" : "false");
            else
                ADD("m%d: {pinion: b%d, rack: b%d, radius: %.17g", k, tie->a, tie->b, tie->size[1]);
            ADD(", carrier: %s}, ", name_of(tie->carrier));
        }
        ADD("}\n");
    }
}

static inline void write_values(Train *t)
{
    ADD("laws: {triple: {table: [[-5000, -15000], [5000, 15000]], between: linear}}\ndrives: {");
    for (int k = 0; k < t->ties; k++)
        if (t->tie[k].kind == LAW) ADD("q%d: {law: triple, of: q%d}, ", t->tie[k].a, t->tie[k].b);
    for (int b = 1; b < t->bodies; b++)
        if (t->is_driven[b]) ADD("q%d: %.17g %s, ", b, t->start[b], t->is_bar[b] ? "m" : "rad");
    ADD("}\nstart: {");
    for (int b = 1; b < t->bodies; b++)
        if (t->is_given[b] && !t->is_driven[b]) ADD("q%d: %.17g, ", b, t->start[b]);
    ADD("}\n");
}

static inline void write_train(Train *t, uint64_t *seed)
{
    bool has_laws = t->ties > 0 && t->tie[t->ties - 1].kind == LAW;
    // None, all, or some, which must not contradict each other.
    int given = has_laws ? 0 : pick(seed, 0, t->rank == t->ties ? 2 : 1);
    for (int b = 1; b < t->bodies; b++) {
        t->start[b] = check_uniform(seed, -3, 3);
        t->is_given[b] = t->is_driven[b] || given == 1 || (given == 2 && pick(seed, 0, 1));
    }
    write_constants(t);
    write_structure(t);
    write_ties(t);
    write_values(t);
}

// Draws a train with its equations, drives, starts and file.
static inline void draw_train(Train *t, uint64_t *seed)
{
    draw(t, seed);
    write_rows(t);
    add_laws(t, seed);
    choose_drives(t, seed);
    write_train(t, seed);
}

#endif
