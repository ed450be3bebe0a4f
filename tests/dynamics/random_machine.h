// Random planar machines as text: at the start every body's axes are the world's, so that joints stand where they like
// and everything closes. Trees, dyads of every kind, class III groups, pin-slots, welds, parallelograms with a crank
// too many.
#ifndef TESTS_DYNAMICS_RANDOM_MACHINE_H
#define TESTS_DYNAMICS_RANDOM_MACHINE_H
#include <stdbool.h>
#include "check.h"

enum { RANDOM_BODIES = 40, RANDOM_POINTS = 200, RANDOM_TEXT = 60000 };

// For machines in symbols: points with three digits, or with parameters for coordinates. What cannot move any more then
// (parallelograms that are none) is refused.
typedef enum RandomNumbers { RANDOM_EXACT, RANDOM_SHORT, RANDOM_NAMED } RandomNumbers;
static RandomNumbers random_numbers = RANDOM_EXACT;

typedef struct RandomPoint {
    int body;
    char name[8];
    double x, y;
} RandomPoint;

typedef struct RandomMachine {
    uint64_t seed;
    int bodies, points, joints, loads, declared, open;
    RandomPoint point[RANDOM_POINTS];
    bool has_mass[RANDOM_BODIES];
    char joint_text[RANDOM_TEXT / 4], drive_text[RANDOM_TEXT / 8], load_text[RANDOM_TEXT / 4],
        start_text[RANDOM_TEXT / 8];
    char coordinate[RANDOM_BODIES * 3][8]; // declared ones
    bool is_distance[RANDOM_BODIES * 3], is_open[RANDOM_BODIES * 3], is_driven[RANDOM_BODIES * 3];
    double at[RANDOM_BODIES * 3];
    bool reversible; // no load that depends on time or rates, no drive
    bool dry;
    char text[RANDOM_TEXT];
} RandomMachine;

static inline double random_draw(RandomMachine *m, double low, double high)
{
    return check_uniform(&m->seed, low, high);
}
static inline bool random_chance(RandomMachine *m, double p)
{
    return random_draw(m, 0, 1) < p;
}
static inline int random_below(RandomMachine *m, int n)
{
    return (int)(check_random(&m->seed) % (uint64_t)n);
}
#define RANDOM_ADD(buffer, ...) snprintf((buffer) + strlen(buffer), sizeof(buffer) - strlen(buffer), __VA_ARGS__)

static inline int random_body(RandomMachine *m, double mass_chance)
{
    m->has_mass[m->bodies] = random_chance(m, mass_chance);
    return m->bodies++;
}
static inline const char *random_name(int body)
{
    static char names[4][8];
    static int at;
    at = (at + 1) % 4;
    snprintf(names[at], sizeof names[at], body == 0 ? "ground" : "b%d", body);
    return names[at];
}
static inline void random_point(RandomMachine *m, int body, const char *name, double x, double y)
{
    RandomPoint *p = &m->point[m->points++];
    *p = (RandomPoint){.body = body, .x = x, .y = y};
    snprintf(p->name, sizeof p->name, "%s", name);
}
static inline const char *random_declare(RandomMachine *m, bool is_distance, bool is_open, double at)
{
    int c = m->declared++;
    snprintf(m->coordinate[c], sizeof m->coordinate[c], "%s%d", is_distance ? "d" : "q", c);
    m->is_distance[c] = is_distance;
    m->is_open[c] = is_open;
    m->at[c] = at;
    return m->coordinate[c];
}
static inline void random_friction(RandomMachine *m, bool is_distance)
{
    if (random_chance(m, 0.1)) {
        RANDOM_ADD(m->joint_text, ", friction: {viscous: %.3g %s}", random_draw(m, 0.05, 0.5),
                   is_distance ? "N*s/m" : "N*m*s/rad");
        m->reversible = false;
    } else if (m->dry && random_chance(m, 0.2)) {
        RANDOM_ADD(m->joint_text, ", friction: {coulomb: %.3g%s}", random_draw(m, 0.02, 0.2),
                   is_distance ? "" : ", radius: 0.05 m");
        m->reversible = false;
    }
}

// A pin at (x, y), or a slide through (x, y); `named`: its coordinate is declared.
static inline void random_joint(RandomMachine *m, int a, int b, bool slides, bool named, bool is_open, double x,
                                double y)
{
    char name[8];
    snprintf(name, sizeof name, "J%d", m->joints++);
    random_point(m, a, name, x, y);
    if (!slides) {
        random_point(m, b, name, x, y);
        RANDOM_ADD(m->joint_text, "  %s: {pin: [%s, %s]", name, random_name(a), random_name(b));
        if (named) RANDOM_ADD(m->joint_text, ", angle: %s", random_declare(m, false, is_open, 0));
    } else {
        double along = random_draw(m, -3, 3), d = random_draw(m, -0.8, 0.8);
        char to[8];
        snprintf(to, sizeof to, "T%d", m->joints);
        random_point(m, b, to, x + d * cos(along), y + d * sin(along));
        RANDOM_ADD(m->joint_text, "  %s: {slide: [%s, %s], along: %.17g, from: %s, to: %s", name, random_name(a),
                   random_name(b), along, name, to);
        if (named) RANDOM_ADD(m->joint_text, ", distance: %s", random_declare(m, true, is_open, d));
    }
    random_friction(m, slides);
    RANDOM_ADD(m->joint_text, "}\n");
}

// The same at a place that is drawn. What is drawn is kept in variables before it is passed on, here and below, since
// the order in which arguments are evaluated is the compiler's choice.
static inline void random_joint_anywhere(RandomMachine *m, int a, int b, bool slides, bool named)
{
    double y = random_draw(m, -2, 2), x = random_draw(m, -2, 2);
    random_joint(m, a, b, slides, named, false, x, y);
}

static inline void random_open(RandomMachine *m, int parent, bool may_slide)
{
    int b = random_body(m, 1);
    m->open++;
    double y = random_draw(m, -2, 2), x = random_draw(m, -2, 2);
    bool slides = may_slide && random_chance(m, 0.25);
    random_joint(m, parent, b, slides, true, true, x, y);
}

static inline void random_dyad(RandomMachine *m, int i, int j)
{
    static const bool slides[6][3] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}};
    const bool *s = slides[random_chance(m, 0.4) ? 0 : random_below(m, 6)];
    int a = random_body(m, 0.8), b = random_body(m, 0.8), names = random_below(m, 3);
    random_joint_anywhere(m, i, a, s[0], names > 0);
    random_joint_anywhere(m, a, b, s[1], names > 1);
    random_joint_anywhere(m, j, b, s[2], names == 1);
}

static inline void random_triad(RandomMachine *m, int i, int j, int k)
{
    int body[3] = {i, j, k}, middle = random_body(m, 0.9);
    for (int s = 0; s < 3; s++) {
        int link = random_body(m, 0.7);
        random_joint_anywhere(m, body[s], link, false, s == 0);
        random_joint_anywhere(m, link, middle, false, false);
    }
}

static inline void random_pin_slot(RandomMachine *m, int i, int j)
{
    int b = random_body(m, 0.9);
    double along = random_draw(m, -3, 3), d = random_draw(m, -1, 1), x = random_draw(m, -2, 2),
           y = random_draw(m, -2, 2);
    double pin_y = random_draw(m, -2, 2), pin_x = random_draw(m, -2, 2);
    random_joint(m, i, b, false, random_chance(m, 0.5), false, pin_x, pin_y);
    char from[8], at[8];
    snprintf(from, sizeof from, "F%d", m->joints);
    snprintf(at, sizeof at, "A%d", m->joints);
    random_point(m, j, from, x, y);
    random_point(m, b, at, x + d * cos(along), y + d * sin(along));
    RANDOM_ADD(m->joint_text, "  J%d: {pin-slot: [%s, %s], at: %s, from: %s, along: %.17g", m->joints++, random_name(j),
               random_name(b), at, from, along);
    random_friction(m, true);
    RANDOM_ADD(m->joint_text, "}\n");
}

// A body carried by three equal parallel cranks: one constraint too many, and a freedom.
static inline void random_parallelogram(RandomMachine *m, int base)
{
    int plate = random_body(m, 1);
    double dx = random_draw(m, 0.5, 1.5), dy = random_draw(m, -1, 1);
    m->open++;
    for (int c = 0; c < 3; c++) {
        int crank = random_body(m, 0.9);
        double x = c == 0 ? 0.25 : c == 1 ? 1.25 : -0.75, y = c == 2 ? 0.5 : 0;
        random_joint(m, base, crank, false, c == 0, c == 0, x, y);
        random_joint(m, crank, plate, false, false, false, x + dx, y + dy);
    }
}

static inline void random_weld(RandomMachine *m, int i)
{
    int b = random_body(m, 1);
    RANDOM_ADD(m->joint_text, "  J%d: {weld: [%s, %s]}\n", m->joints++, random_name(i), random_name(b));
}

static inline void random_drives(RandomMachine *m)
{
    for (int c = 0; c < m->declared; c++) {
        if (!m->is_open[c]) continue;
        const char *u = m->is_distance[c] ? "m" : "rad";
        if (random_chance(m, 0.25)) {
            double faster = random_draw(m, 1, 3), swing = random_draw(m, -0.1, 0.1), rate = random_draw(m, -1, 1);
            RANDOM_ADD(m->drive_text, "  %s: %.17g %s + %.3g %s/s * t + %.3g %s * sin(%.3g rad/s * t)\n",
                       m->coordinate[c], m->at[c], u, rate, u, swing, u, faster);
            m->is_driven[c] = true;
            m->reversible = false;
        }
        RANDOM_ADD(m->start_text, "  %s: %.17g\n", m->coordinate[c], m->at[c]);
        if (!m->is_driven[c])
            RANDOM_ADD(m->start_text, "  %s.rate: %.3g\n", m->coordinate[c], random_draw(m, -1.5, 1.5));
    }
    for (int c = 0; c < m->declared; c++)
        if (!m->is_open[c]) RANDOM_ADD(m->start_text, "  %s: %.17g\n", m->coordinate[c], m->at[c]);
}

static inline const char *random_point_name(RandomMachine *m)
{
    static char names[2][24];
    static int at;
    const RandomPoint *p = &m->point[random_below(m, m->points)];
    at = 1 - at;
    snprintf(names[at], sizeof names[at], "%s.%s", random_name(p->body), p->name);
    return names[at];
}

static inline void random_springs(RandomMachine *m)
{
    RANDOM_ADD(m->load_text, "springs:\n");
    for (int k = random_below(m, 3); k >= 0; k--) {
        bool damped = random_chance(m, 0.3);
        m->reversible = m->reversible && !damped;
        if (random_chance(m, 0.5)) {
            char one[24];
            snprintf(one, sizeof one, "%s", random_point_name(m));
            const char *two = random_point_name(m);
            if (strcmp(one, two) == 0) continue;
            double length = random_chance(m, 0.2) ? 0 : random_draw(m, 0.5, 2);
            RANDOM_ADD(m->load_text, "  s%d: {between: [%s, %s], stiffness: %.3g N/m, length: %.3g m", k, one, two,
                       random_draw(m, 5, 60), length);
            if (damped) RANDOM_ADD(m->load_text, ", damping: %.3g N*s/m", random_draw(m, 0.1, 2));
        } else if (m->declared > 0) {
            int c = random_below(m, m->declared);
            RANDOM_ADD(m->load_text, "  s%d: {along: %s, stiffness: %.3g %s", k, m->coordinate[c],
                       random_draw(m, 5, 40), m->is_distance[c] ? "N/m" : "N*m/rad");
            if (damped)
                RANDOM_ADD(m->load_text, ", damping: %.3g %s", random_draw(m, 0.1, 2),
                           m->is_distance[c] ? "N*s/m" : "N*m*s/rad");
        } else {
            continue;
        }
        RANDOM_ADD(m->load_text, "}\n");
    }
}

static inline void random_forces(RandomMachine *m)
{
    RANDOM_ADD(m->load_text, "forces:\n");
    for (int k = random_below(m, 3); k >= 0; k--) {
        const RandomPoint *p = &m->point[random_below(m, m->points)];
        bool timed = random_chance(m, 0.4), body = random_chance(m, 0.5);
        m->reversible = m->reversible && !timed;
        double moment = random_draw(m, -4, 4), y = random_draw(m, -9, 9), x = random_draw(m, -9, 9);
        RANDOM_ADD(m->load_text, "  f%d: {body: %s, at: %s, value: [%.3g N%s, %.3g N], moment: %.3g N*m, axes: %s}\n",
                   k, random_name(p->body), p->name, x, timed ? " * cos(3 rad/s * t)" : "", y, moment,
                   body ? "body" : "world");
    }
}

static inline void random_efforts(RandomMachine *m)
{
    RANDOM_ADD(m->load_text, "efforts:\n");
    for (int c = 0; c < m->declared; c++) {
        if (m->is_driven[c] || !random_chance(m, 0.4)) continue;
        int of = random_below(m, m->declared);
        const char *u = m->is_distance[c] ? "N" : "N*m", *per = m->is_distance[of] ? "m" : "rad";
        double slope = random_draw(m, -5, 5), constant = random_draw(m, -5, 5);
        RANDOM_ADD(m->load_text, "  %s: %.3g %s + %.3g %s/%s * %s", m->coordinate[c], constant, u, slope, u, per,
                   m->coordinate[of]);
        if (random_chance(m, 0.4)) {
            RANDOM_ADD(m->load_text, " - %.3g %s*s/%s * %s.rate", random_draw(m, 0, 1), u, per, m->coordinate[of]);
            m->reversible = false;
        }
        RANDOM_ADD(m->load_text, "\n");
    }
}

// The first point with this coordinate: its number is the parameter's.
static inline int random_parameter(const RandomMachine *m, double value)
{
    int k = 0;
    while (fabs(k % 2 ? m->point[k / 2].y : m->point[k / 2].x) != fabs(value)) k++;
    return k;
}

static inline void random_parameters(RandomMachine *m)
{
    RANDOM_ADD(m->text, "parameters:\n");
    for (int k = 0; k < 2 * m->points; k++) {
        double value = k % 2 ? m->point[k / 2].y : m->point[k / 2].x;
        if (random_parameter(m, value) == k) RANDOM_ADD(m->text, "  a%d: %.3g m\n", k, fabs(value));
    }
}

static inline void random_coordinate(RandomMachine *m, double value)
{
    if (random_numbers == RANDOM_NAMED)
        RANDOM_ADD(m->text, "%sa%d", value < 0 ? "-" : "", random_parameter(m, value));
    else
        RANDOM_ADD(m->text, random_numbers == RANDOM_SHORT ? "%.3g" : "%.17g", value);
}

static inline void random_write(RandomMachine *m)
{
    if (random_numbers == RANDOM_NAMED && m->points > 0) random_parameters(m);
    if (random_chance(m, 0.8)) {
        double y = random_draw(m, -10, 0), x = random_draw(m, -2, 2);
        RANDOM_ADD(m->text, "gravity: [%.3g, %.3g]\n", x, y);
    }
    RANDOM_ADD(m->text, "bodies:\n");
    for (int b = 0; b < m->bodies; b++) {
        RANDOM_ADD(m->text, "  %s: {points: {Z: [0, 0]", random_name(b));
        for (int k = 0; k < m->points; k++)
            if (m->point[k].body == b) {
                RANDOM_ADD(m->text, ", %s: [", m->point[k].name);
                random_coordinate(m, m->point[k].x);
                RANDOM_ADD(m->text, ", ");
                random_coordinate(m, m->point[k].y);
                RANDOM_ADD(m->text, "]");
            }
        RANDOM_ADD(m->text, "}");
        if (b > 0 && m->has_mass[b]) {
            double inertia = random_draw(m, 0.05, 2), y = random_draw(m, -2, 2), x = random_draw(m, -2, 2);
            RANDOM_ADD(m->text, ", mass: %.4g, center: [%.4g, %.4g], inertia: %.4g", random_draw(m, 0.2, 4), x, y,
                       inertia);
        }
        RANDOM_ADD(m->text, "}\n");
    }
    RANDOM_ADD(m->text, "joints:\n%s", m->joint_text);
    if (m->drive_text[0]) RANDOM_ADD(m->text, "drives:\n%s", m->drive_text);
    RANDOM_ADD(m->text, "%s", m->load_text);
    if (m->start_text[0]) RANDOM_ADD(m->text, "start:\n%s", m->start_text);
}

static inline void random_machine(RandomMachine *m, uint64_t seed)
{
    memset(m, 0, sizeof *m);
    m->seed = seed;
    m->bodies = 1;
    m->reversible = true;
    m->dry = random_chance(m, 0.15);
    random_open(m, 0, true);
    for (int k = random_below(m, 6); k >= 0; k--) {
        int i = random_below(m, m->bodies), j = random_below(m, m->bodies), l = random_below(m, m->bodies);
        double what = random_draw(m, 0, 1);
        if (what < 0.25)
            random_open(m, i, true);
        else if (what < 0.65)
            random_dyad(m, i, j);
        else if (what < 0.75)
            random_triad(m, i, j, l);
        else if (what < 0.85)
            random_pin_slot(m, i, j);
        else if (what < 0.92)
            random_weld(m, i);
        else
            random_parallelogram(m, i);
    }
    random_drives(m);
    if (random_chance(m, 0.6)) random_springs(m);
    if (random_chance(m, 0.6)) random_forces(m);
    if (random_chance(m, 0.6)) random_efforts(m);
    random_write(m);
}

#endif
