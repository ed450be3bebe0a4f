// Random linkages whose gears, belts, racks, cams and laws sit on the links of a loop, as text. A polygon of links with
// the world's axes at the start, all coordinates 0 there, so that loops close and teeth meet; each relation ties a link
// to another that the loop places too, so that both sides need each other.
#ifndef TESTS_DYNAMICS_RANDOM_GEARED_H
#define TESTS_DYNAMICS_RANDOM_GEARED_H
#include <stdbool.h>
#include "check.h"
#include "base/vec.h"

enum { GEARED_LINKS = 7, GEARED_TEXT = 12000 };

typedef struct Geared {
    uint64_t seed;
    int links;                                       // moving ones in the loop: a five-bar has 4
    double x[GEARED_LINKS + 1], y[GEARED_LINKS + 1]; // pin k joins link k (0: the ground) and k + 1
    int origin[GEARED_LINKS + 1];                    // which pin is a link's origin; -1: not settled
    bool meshes_on[GEARED_LINKS + 1];                // its neighbours are in mesh
    bool slides[GEARED_LINKS + 1];                   // link k is two bodies; the second slides on the first
    double radius[GEARED_LINKS + 1];                 // how far its line lies beside its first pin
    int relations, freedom;
    bool has_law;
    char bodies[GEARED_TEXT / 3], joints[GEARED_TEXT / 6], gears[4][GEARED_TEXT / 12], drives[GEARED_TEXT / 12];
    char text[GEARED_TEXT];
} Geared;

#define GEARED_ADD(buffer, ...) snprintf((buffer) + strlen(buffer), sizeof(buffer) - strlen(buffer), __VA_ARGS__)
enum { GEARED_GEARS, GEARED_BELTS, GEARED_RACKS, GEARED_CAMS };

static inline double geared_draw(Geared *g, double low, double high)
{
    return check_uniform(&g->seed, low, high);
}
static inline int geared_below(Geared *g, int n)
{
    return (int)(check_random(&g->seed) % (uint64_t)n);
}

// The body of link k that carries its first pin (end 0) or its last (end 1).
static inline const char *geared_body(const Geared *g, int k, int end)
{
    static char names[4][8];
    static int at;
    at = (at + 1) % 4;
    snprintf(names[at], sizeof names[at], k == 0 || k > g->links ? "ground" : g->slides[k] && end ? "c%d" : "b%d", k);
    return names[at];
}

// Link `carrier` holds both centres: the neighbour before it must have its origin at the carrier's first pin, the one
// behind it at its last.
static inline bool geared_settle(Geared *g, int before, int pin)
{
    if (before < 1 || before > g->links || g->slides[before]) return false;
    if (g->origin[before] >= 0 && g->origin[before] != pin) return false;
    g->origin[before] = pin;
    return true;
}

static inline bool geared_wheels(Geared *g, int carrier)
{
    if (g->slides[carrier] || g->meshes_on[carrier] || carrier < 2 || carrier >= g->links) return false;
    g->meshes_on[carrier] = true;
    int old = g->origin[carrier - 1];
    if (!geared_settle(g, carrier - 1, carrier - 1)) return false;
    if (!geared_settle(g, carrier + 1, carrier)) {
        g->origin[carrier - 1] = old;
        return false;
    }
    int kind = geared_below(g, 4), n = g->relations++;
    if (kind == 0) {
        bool is_crossed = geared_below(g, 2);
        double second = geared_draw(g, 0.02, 0.3), first = geared_draw(g, 0.02, 0.3);
        GEARED_ADD(g->gears[GEARED_BELTS],
                   "  m%d: {between: [b%d, b%d], radii: [%.3f, %.3f], crossed: %s, carrier: b%d}\n", n, carrier - 1,
                   carrier + 1, first, second, is_crossed ? "true" : "false", carrier);
    } else {
        int large = 40 + geared_below(g, 40), small = 12 + geared_below(g, 20);
        GEARED_ADD(g->gears[GEARED_GEARS], "  m%d: {mesh: [b%d, b%d], teeth: [%d, %d], carrier: b%d%s}\n", n,
                   carrier - 1, carrier + 1, small, large, carrier, kind == 1 ? ", internal: true" : "");
    }
    return true;
}

// Link k becomes a guide and a slider: the slider follows the link before by a rack, a cam or a law.
static inline bool geared_slider(Geared *g, int k)
{
    if (k < 2 || k > g->links || g->slides[k] || g->meshes_on[k] || g->origin[k] >= 0 ||
        !geared_settle(g, k - 1, k - 1))
        return false;
    g->slides[k] = true;
    g->origin[k] = k - 1;
    int kind = geared_below(g, 4), n = g->relations++;
    g->radius[k] = geared_draw(g, 0.03, 0.2);
    if (kind == 0) {
        GEARED_ADD(g->gears[GEARED_RACKS], "  m%d: {pinion: b%d, rack: c%d, radius: %.17g, carrier: b%d}\n", n, k - 1,
                   k, g->radius[k], k);
        return true;
    }
    g->has_law = true;
    if (kind == 1)
        GEARED_ADD(g->gears[GEARED_CAMS], "  m%d: {cam: b%d, follower: c%d, law: lift, base: 300 mm, roller: 10 mm}\n",
                   n, k - 1, k);
    else if (kind == 2)
        GEARED_ADD(g->drives, "%ss%d: {law: lift, of: q%d}", *g->drives ? ", " : "", k, k - 1);
    else // an angle after the distance
        GEARED_ADD(g->drives, "%sq%d: {law: bend, of: s%d}", *g->drives ? ", " : "", k - 1, k);
    return true;
}

static inline void geared_point(Geared *g, char *points, size_t size, int pin, int origin)
{
    size_t length = strlen(points);
    snprintf(points + length, size - length, "%sP%d: [%.17g, %.17g]", length ? ", " : "", pin, g->x[pin] - g->x[origin],
             g->y[pin] - g->y[origin]);
}

static inline void geared_add_body(Geared *g, const char *name, const char *points)
{
    double inertia = geared_draw(g, 0.05, 0.3), y = geared_draw(g, -0.3, 0.3), x = geared_draw(g, -0.3, 0.3);
    GEARED_ADD(g->bodies, "  %s: {points: {%s}, mass: %.3f, center: [%.3f, %.3f], inertia: %.3f}\n", name, points,
               geared_draw(g, 0.5, 2), x, y, inertia);
}

static inline void geared_link(Geared *g, int k)
{
    char points[400] = "";
    int origin = g->origin[k] < 0 ? k - geared_below(g, 2) : g->origin[k];
    geared_point(g, points, sizeof points, k - 1, origin);
    if (!g->slides[k]) {
        geared_point(g, points, sizeof points, k, origin);
        geared_add_body(g, geared_body(g, k, 0), points);
        return;
    }
    double turn = geared_draw(g, -3, 3), way = geared_draw(g, -0.5, 0.5), side = geared_below(g, 2) ? 1 : -1;
    double fx = way * cos(turn) - side * g->radius[k] * sin(turn),
           fy = way * sin(turn) + side * g->radius[k] * cos(turn);
    GEARED_ADD(points, ", F%d: [%.17g, %.17g]", k, fx, fy);
    geared_add_body(g, geared_body(g, k, 0), points);
    snprintf(points, sizeof points, "F%d: [%.17g, %.17g], P%d: [0, 0]", k, g->x[k - 1] + fx - g->x[k],
             g->y[k - 1] + fy - g->y[k], k);
    geared_add_body(g, geared_body(g, k, 1), points);
    GEARED_ADD(g->joints, "  S%d: {slide: [b%d, c%d], along: %.17g rad, from: F%d, to: F%d, distance: s%d}\n", k, k, k,
               turn, k, k, k);
}

static inline void geared_polygon(Geared *g)
{
    g->links = 4 + geared_below(g, 3);
    for (int k = 0; k <= g->links; k++) {
        double angle = 2 * YK_PI * (k + geared_draw(g, -0.3, 0.3)) / (g->links + 1), reach = geared_draw(g, 0.6, 1.4);
        g->x[k] = reach * cos(angle);
        g->y[k] = reach * sin(angle);
        g->origin[k] = -1;
    }
}

static inline void geared_machine(Geared *g, uint64_t number)
{
    *g = (Geared){.seed = 7919 * number + 17};
    geared_polygon(g);
    int wanted = 1 + geared_below(g, g->links - 3), sliders = 0;
    for (int tries = 0; tries < 40 && g->relations < wanted; tries++) {
        bool is_slider = geared_below(g, 2) == 0;
        int k = 1 + geared_below(g, g->links);
        if (!is_slider) geared_wheels(g, k);
        if (is_slider) sliders += geared_slider(g, k);
    }
    g->freedom = g->links - 2 + sliders - g->relations;
    GEARED_ADD(g->bodies, "  ground: {points: {P0: [%.17g, %.17g], P%d: [%.17g, %.17g]}}\n", g->x[0], g->y[0], g->links,
               g->x[g->links], g->y[g->links]);
    for (int k = 1; k <= g->links; k++) {
        GEARED_ADD(g->joints, "  J%d: {pin: [%s, %s], at: P%d, angle: q%d}\n", k - 1, geared_body(g, k - 1, 1),
                   geared_body(g, k, 0), k - 1, k - 1);
        geared_link(g, k);
    }
    GEARED_ADD(g->joints, "  J%d: {pin: [%s, ground], at: P%d}\n", g->links, geared_body(g, g->links, 1), g->links);
    static const char *const sections[] = {"gears", "belts", "racks", "cams"};
    GEARED_ADD(g->text, "gravity: [0, -9.81]\nbodies:\n%sjoints:\n%s", g->bodies, g->joints);
    for (int k = 0; k < 4; k++)
        if (*g->gears[k]) GEARED_ADD(g->text, "%s:\n%s", sections[k], g->gears[k]);
    if (*g->drives) GEARED_ADD(g->text, "drives: {%s}\n", g->drives);
    if (g->has_law)
        GEARED_ADD(
            g->text,
            "laws:\n  lift: {period: 2*pi, segments: [{rise: {to: 120 deg, by: 0.2 m, law: cycloidal}}, {fall: "
            "{to: 240 deg, by: 0.2 m, law: 3-4-5}}, {dwell: {to: 2*pi}}]}\n  bend: {table: [[-100 m, -0.9 rad], [-1 m, "
            "-0.8 rad], "
            "[-0.2 m, -0.3 rad], [0 m, 0 rad], [0.3 m, 0.5 rad], [1 m, 0.8 rad], [100 m, 0.9 rad]], between: cubic}\n");
    GEARED_ADD(g->text, "start: {q0: 0");
    for (int k = 1; k < g->links; k++) GEARED_ADD(g->text, ", q%d: 0", k);
    GEARED_ADD(g->text, "}\n");
}

#endif
