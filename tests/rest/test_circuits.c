// All equilibria of random four-bars with a spring, also those close to a limit of the crank: on each circuit the
// potential energy is a smooth function of one angle, and its extremes are counted from the law of cosines.
#include "check.h"
#include <yoke/yoke.h>
#include "free_bodies/inside.h"

typedef struct Bars {
    double ground, crank, coupler, rocker;
    double mass, x, y; // of the coupler, and its centre
    double px, py;     // the coupler's point that a spring holds
    double gx, gy, stiffness, length;
} Bars;

// The crank's angles on a circuit are middle + half cos(u) with the branch's side that of sin(u), or, if it turns
// fully, u.
typedef struct Circuit {
    double middle, half, side; // side 0: both branches
} Circuit;

static size_t circuits_of(const Bars *b, Circuit circuits[2])
{
    double sum = b->coupler + b->rocker, gap = b->coupler - b->rocker, two = 2 * b->ground * b->crank;
    double squares = b->ground * b->ground + b->crank * b->crank;
    double outer = (squares - sum * sum) / two, inner = (squares - gap * gap) / two;
    if (outer <= -1 && inner >= 1) {
        circuits[0] = (Circuit){0, YK_PI, 1};
        circuits[1] = (Circuit){0, YK_PI, -1};
        return 2;
    }
    if (outer <= -1 || inner >= 1) {
        circuits[0] = outer <= -1 ? (Circuit){YK_PI, YK_PI - acos(inner), 0} : (Circuit){0, acos(outer), 0};
        return 1;
    }
    double from = acos(inner), to = acos(outer);
    circuits[0] = (Circuit){0.5 * (from + to), 0.5 * (to - from), 0};
    circuits[1] = (Circuit){-0.5 * (from + to), 0.5 * (to - from), 0};
    return 2;
}

static double crank_at(const Circuit *c, double u)
{
    return c->side == 0 ? c->middle + c->half * cos(u) : u;
}

static double potential_at(const Bars *b, const Circuit *c, double u)
{
    double theta = crank_at(c, u), ax = b->crank * cos(theta), ay = b->crank * sin(theta);
    double dx = b->ground - ax, dy = -ay, d2 = dx * dx + dy * dy, d = sqrt(d2);
    double along = (b->coupler * b->coupler - b->rocker * b->rocker + d2) / (2 * d);
    double up = sqrt(fmax(0, b->coupler * b->coupler - along * along)), side = c->side != 0 ? c->side : sin(u);
    up = side < 0 ? -up : up;
    double cx = (along * dx - up * dy) / (d * b->coupler), cy = (along * dy + up * dx) / (d * b->coupler);
    double height = ay + b->x * cy + b->y * cx;
    double px = ax + b->px * cx - b->py * cy - b->gx, py = ay + b->px * cy + b->py * cx - b->gy;
    double stretch = sqrt(px * px + py * py) - b->length;
    return 9.81 * b->mass * height + 0.5 * b->stiffness * stretch * stretch;
}

static Bars random_bars(uint64_t *seed)
{
    static const double low[] = {0.2, 0.2, 0.2, 0.2, 0.5, -0.2, -0.2, -0.3, -0.3, -1, -1, 0, 0.1};
    static const double high[] = {1, 1, 1, 1, 3, 0.4, 0.2, 0.6, 0.5, 1, 1, 60, 0.6};
    double v[sizeof low / sizeof *low];
    for (size_t k = 0; k < sizeof low / sizeof *low; k++) v[k] = check_uniform(seed, low[k], high[k]);
    return (Bars){v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10], v[11], v[12]};
}

static bool closes(const Bars *b)
{
    double longest = fmax(fmax(b->ground, b->crank), fmax(b->coupler, b->rocker));
    return 2 * longest < 0.98 * (b->ground + b->crank + b->coupler + b->rocker);
}

static YkRest *rest_of(const Bars *b, const Circuit *c, YkModel **model)
{
    char text[1500];
    double theta = crank_at(c, 1), d = hypot(b->ground - b->crank * cos(theta), b->crank * sin(theta));
    double base = atan2(-b->crank * sin(theta), b->ground - b->crank * cos(theta));
    double at_a = acos((b->coupler * b->coupler + d * d - b->rocker * b->rocker) / (2 * b->coupler * d));
    snprintf(text, sizeof text,
             "gravity: [0, -9.81]\nbodies:\n"
             "  ground: {points: {O: [0, 0], C: [%.17g, 0], G: [%.17g, %.17g]}}\n"
             "  crank: {points: {O: [0, 0], A: [%.17g, 0]}}\n"
             "  coupler: {points: {A: [0, 0], B: [%.17g, 0], P: [%.17g, %.17g]}, mass: %.17g, center: [%.17g, %.17g], "
             "inertia: 0.05}\n"
             "  rocker: {points: {C: [0, 0], B: [%.17g, 0]}}\n"
             "joints:\n"
             "  O: {pin: [ground, crank], angle: theta}\n"
             "  A: {pin: [crank, coupler], angle: phi}\n"
             "  C: {pin: [ground, rocker]}\n"
             "  B: {pin: [coupler, rocker]}\n"
             "springs: {k: {between: [ground.G, coupler.P], stiffness: %.17g, length: %.17g}}\n"
             "start: {theta: %.17g, phi: %.17g}\n",
             b->ground, b->gx, b->gy, b->crank, b->coupler, b->px, b->py, b->mass, b->x, b->y, b->rocker, b->stiffness,
             b->length, theta, base + (c->side < 0 ? -at_a : at_a) - theta);
    YkProblems *problems = yk_problems_new();
    *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
    YkRest *rest = *model ? yk_rest_find(*model, NULL, problems) : NULL;
    if (!rest) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(rest);
    yk_problems_free(problems);
    return rest;
}

// Returns the extreme between two angles, by golden section.
static double extreme_between(const Bars *b, const Circuit *c, double from, double to, double sign)
{
    const double ratio = 0.6180339887498949;
    for (int k = 0; k < 60; k++) {
        double low = to - ratio * (to - from), high = from + ratio * (to - from);
        if (sign * potential_at(b, c, low) < sign * potential_at(b, c, high))
            to = high;
        else
            from = low;
    }
    return 0.5 * (from + to);
}

static bool has_equilibrium(const YkRest *rest, double potential, double theta, bool is_minimum)
{
    for (size_t k = 0; k < yk_rest_count(rest); k++) {
        YkEquilibrium e = yk_rest_equilibrium(rest, k);
        YkMotion at = yk_state_coordinate(yk_rest_state((YkRest *)rest, k), yk_rest_input(rest, 0));
        if (fabs(e.potential - potential) < 1e-9 * (1 + fabs(potential)) &&
            fabs(remainder(at.position - theta, 2 * YK_PI)) < 1e-5)
            return (e.stability == YK_STABILITY_STABLE) == is_minimum;
    }
    return false;
}

// Returns how many extremes a circuit has, each of which must be among the equilibria.
static size_t check_circuit(const YkRest *rest, const Bars *b, const Circuit *c)
{
    enum { SAMPLES = 3000 };
    const double step = 2 * YK_PI / SAMPLES;
    size_t count = 0;
    for (int k = 0; k < SAMPLES; k++) {
        double u = (k + 0.37) * step, here = potential_at(b, c, u);
        double before = potential_at(b, c, u - step) - here, after = potential_at(b, c, u + step) - here;
        if (!(before * after > 0)) continue;
        double at = extreme_between(b, c, u - step, u + step, before > 0 ? 1 : -1);
        bool is_there = has_equilibrium(rest, potential_at(b, c, at), crank_at(c, at), before > 0);
        if (!is_there)
            print_error("no equilibrium at theta = %.17g, %.17g J\n", crank_at(c, at), potential_at(b, c, at));
        assert_true(is_there);
        count++;
    }
    return count;
}

static void all_equilibria_are_found(void **unused)
{
    (void)unused;
    uint64_t seed = 7;
    for (uint64_t tried = 0; tried < check_cases(60);) {
        Bars b = random_bars(&seed);
        if (!closes(&b)) continue;
        Circuit circuits[2];
        YkModel *model;
        size_t count = circuits_of(&b, circuits), extremes = 0;
        YkRest *rest = rest_of(&b, &circuits[0], &model);
        for (size_t k = 0; k < count; k++) extremes += check_circuit(rest, &b, &circuits[k]);
        assert_true(yk_rest_is_complete(rest));
        assert_int_equal(yk_rest_count(rest), extremes);
        yk_rest_free(rest);
        yk_model_free(model);
        tried++;
    }
}

// A pendulum without weight that a torque drives, zero at given angles and half a turn on from each: two, or three, are
// closer together than the map's rows.
static void equilibria_close_together_are_found(void **unused)
{
    (void)unused;
    uint64_t seed = 11;
    for (uint64_t tried = 0; tried < check_cases(40); tried++) {
        double root[4], first = check_uniform(&seed, -1, 1), apart = pow(10, check_uniform(&seed, -3.5, -1.3));
        root[0] = first, root[1] = first + apart;
        root[2] = tried % 2 ? first + 2.1 * apart : first + 0.7, root[3] = first + 1.4;
        char text[800];
        snprintf(
            text, sizeof text,
            "bodies:\n  ground: {points: {O: [0, 0]}}\n"
            "  arm: {points: {O: [0, 0]}, mass: 1, center: [0.1, 0], inertia: 0.01}\n"
            "joints:\n  O: {pin: [ground, arm], angle: theta}\n"
            "springs: {k: {along: theta, torque: '1 N*m * sin(angle - %.17g rad)*sin(angle - %.17g rad)*sin(angle - "
            "%.17g rad)*sin(angle - %.17g rad)'}}\n"
            "start: {theta: 2.2 rad}\n",
            root[0], root[1], root[2], root[3]);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
        YkRestOptions options = yk_default_rest_options();
        options.starts = 1;
        YkRest *rest = model ? yk_rest_find(model, &options, problems) : NULL;
        if (!rest) print_error("%s%s", text, yk_problems_text(problems, 0));
        assert_non_null(rest);
        if (yk_rest_count(rest) != 8)
            print_error("%zu equilibria, %g apart from %.17g\n", yk_rest_count(rest), apart, first);
        assert_int_equal(yk_rest_count(rest), 8);
        for (size_t k = 0; k < 8; k++) {
            YkMotion at = yk_state_coordinate(yk_rest_state(rest, k), yk_rest_input(rest, 0));
            double off = 1;
            for (size_t i = 0; i < 4; i++) off = fmin(off, fabs(remainder(at.position - root[i], YK_PI)));
            CHECK_NEAR(off, 0, 1e-8);
        }
        yk_rest_free(rest);
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

// Potential energy of the machine with three slots at a row of its map, by hand; coordinates q, w, d.
static double energy_by_hand(const double *row, double free_angle)
{
    double q = row[0], w = row[1];
    double crank = 0.5 * sin(q) + 0.2 * cos(q), plate = 1.1 * sin(w) + 0.3 * cos(w);
    return 9.81 * (crank + 1.2 * plate) + 0.5 * 4 * (w - free_angle) * (w - free_angle);
}

// Finds an equilibrium for each extreme of the energy between rows of a circuit. Returns how many there are.
static size_t check_extremes(YkRest *rest, const YkMap *map, size_t circuit, double free_angle)
{
    size_t extremes = 0;
    assert_int_equal(yk_map_circuit(map, circuit).branches, 1);
    for (size_t i = 2; i < yk_map_branch(map, circuit, 0).rows; i++) {
        const double *row[3];
        double energy[3];
        for (size_t k = 0; k < 3; k++) {
            row[k] = yk_map_row(map, circuit, 0, i - 2 + k);
            energy[k] = energy_by_hand(row[k], free_angle);
        }
        if ((energy[1] - energy[0]) * (energy[2] - energy[1]) >= 0) continue;
        size_t found = 0;
        for (size_t e = 0; e < yk_rest_count(rest); e++) {
            double q = yk_state_coordinate(yk_rest_state(rest, e), 0).position;
            double w = yk_state_coordinate(yk_rest_state(rest, e), 1).position;
            found += (w - row[0][1]) * (w - row[2][1]) < 0 && fabs(remainder(q - row[1][0], 2 * YK_PI)) < 0.5;
        }
        assert_int_equal(found, 1);
        extremes++;
    }
    return extremes;
}

// A plate in three slots, a group, turns fully, and a spring is wound up by its turning. Along each circuit of the map
// the energy has extremes, which are equilibria: the search must count turns as the map does.
static void springs_of_groups_are_wound_up(void **unused)
{
    (void)unused;
    for (int k = 0; k < 4; k++) {
        double free_angle = (double)(100 + 100 * k) * YK_PI / 180;
        char text[1000];
        snprintf(
            text, sizeof text,
            "gravity: [0, -9.81]\nbodies:\n  ground: {points: {O: [0, 0], S: [0.05, 0.02]}}\n"
            "  crank: {points: {O: [0, 0], C: [0.02, 0.03]}, mass: 1, center: [0.5, 0.2], inertia: 0.1}\n"
            "  plate: {points: {A: [0, 0], B: [1, 0], E: [1.7, 0.1]}, mass: 1.2, center: [1.1, 0.3], inertia: 0.2}\n"
            "joints:\n  O: {pin: [ground, crank], angle: q}\n"
            "  A: {pin-slot: [ground, plate], at: A, from: O, along: x, angle: w, distance: d}\n"
            "  B: {pin-slot: [ground, plate], at: B, from: S, along: 80 deg}\n"
            "  E: {pin-slot: [crank, plate], at: E, from: C, along: 3 deg}\n"
            "springs: {k: {along: w, stiffness: 4 N*m/rad, angle: %.17g rad}}\n"
            "start: {q: 60 deg, w: 120 deg, d: 0.5}\n",
            free_angle);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
        YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
        YkState *state = mech ? yk_state_new(mech) : NULL;
        if (!state) print_error("%s%s", text, yk_problems_text(problems, 0));
        assert_non_null(state);
        assert_true(yk_state_assemble(state) >= 0);
        YkMap *map = yk_map_new(state, 0, problems);
        assert_non_null(map);
        YkRestOptions options = yk_default_rest_options();
        options.starts = 1;
        YkRest *rest = yk_rest_find(model, &options, problems);
        assert_non_null(rest);
        size_t extremes = 0;
        for (size_t c = 0; c < yk_map_circuit_count(map); c++) extremes += check_extremes(rest, map, c, free_angle);
        assert_true(extremes > 2);
        yk_rest_free(rest);
        yk_map_free(map);
        yk_state_free(state);
        yk_mechanism_free(mech);
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

// On the one closed circuit of a six-bar minima and maxima of the energy take turns; one is 2e-4 rad from a limit.
static void minima_and_maxima_take_turns(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    static const char text[] =
        "gravity: [0, -9.81]\n"
        "bodies:\n"
        "  ground: {points: {O: [0.279, -0.95], G2: [0.473, 0.353], G3: [0.784, -0.826], S: [-0.559, "
        "0.179], P2: [-0.563, 0.011], P3: [-0.947, -0.602]}}\n"
        "  crank: {points: {O: [0.279, -0.95], A: [-0.45, -0.554]}, mass: 1.657, center: [-0.987, "
        "0.612], inertia: 0.212}\n"
        "  l1: {points: {A: [-0.45, -0.554], P1: [-0.156, -0.94]}, mass: 0.812, center: [-0.689, "
        "0.914], inertia: 0.108}\n"
        "  tern: {points: {P1: [-0.156, -0.94], P2: [-0.563, 0.011], P3: [-0.947, -0.602], E: [0.3, "
        "0.09]}, mass: 0.367, center: [-0.807, 0.695], inertia: 0.185}\n"
        "joints:\n"
        "  JO: {pin: [ground, crank], at: O, angle: aO}\n"
        "  JA: {pin: [crank, l1], at: A, angle: aA}\n"
        "  JP1: {pin: [l1, tern], at: P1, angle: aP1}\n"
        "  JP2: {pin-slot: [ground, tern], at: P2, from: P2, along: 145.3 deg}\n"
        "  JP3: {pin-slot: [ground, tern], at: P3, from: P3, along: 131.4 deg}\n"
        "springs: {s: {between: [ground.S, tern.E], stiffness: 55.94, length: 0.98, damping: 1.14}}\n"
        "start: {aO: 0, aA: 0, aP1: 0}\n";
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_parse(text, strlen(text), "t.yaml", NULL, problems);
    YkRestOptions options = yk_default_rest_options();
    options.starts = 1;
    YkRest *rest = model ? yk_rest_find(model, &options, problems) : NULL;
    if (!rest) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(rest);
    size_t stable = 0;
    for (size_t k = 0; k < yk_rest_count(rest); k++)
        stable += yk_rest_equilibrium(rest, k).stability == YK_STABILITY_STABLE;
    assert_true(stable > 0);
    assert_int_equal(yk_rest_count(rest), 2 * stable);
    yk_rest_free(rest);
    yk_model_free(model);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_equilibria_are_found), cmocka_unit_test(equilibria_close_together_are_found),
        cmocka_unit_test(springs_of_groups_are_wound_up), cmocka_unit_test(minima_and_maxima_take_turns)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
