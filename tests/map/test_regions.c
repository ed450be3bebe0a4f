// Maps over two freedoms: five-bars in closed form, counts of `solve --all` at random poses, and curves on which the
// Jacobian's determinant vanishes.
#include <yoke/configurations.h>
#include <yoke/regions.h>
#include "configurations/truss.h"
#include "map/workspace/box.h"

// A five-bar: motors at (-w, 0) and (w, 0), cranks, couplers.
typedef struct FiveBar {
    double w, crank[2], coupler[2];
} FiveBar;

static Machine five_bar(const FiveBar *f, double first, double second)
{
    char text[2000];
    snprintf(
        text, sizeof text,
        "bodies:\n  ground: {points: {L: [%.17g, 0], R: [%.17g, 0]}}\n  left: {points: {L: [0, 0], A: [%.17g, 0]}}\n"
        "  right: {points: {R: [0, 0], B: [%.17g, 0]}}\n  reachL: {points: {A: [0, 0], P: [%.17g, 0]}}\n"
        "  reachR: {points: {B: [0, 0], P: [%.17g, 0]}}\njoints:\n  L: {pin: [ground, left], angle: u}\n"
        "  R: {pin: [ground, right], angle: v}\n  A: {pin: [left, reachL]}\n  B: {pin: [right, reachR]}\n"
        "  P: {pin: [reachL, reachR]}\ndrives: {u: %.17g, v: %.17g}\n",
        -f->w, f->w, f->crank[0], f->crank[1], f->coupler[0], f->coupler[1], first, second);
    return machine_parse_with(text, NULL, 0);
}

static bool stand(Machine *m)
{
    return yk_state_set_time(m->state, 0, m->problems) >= 0 && yk_state_assemble(m->state) >= 0;
}

static YkRegions *regions_of(Machine *m, double tolerance)
{
    const YkRegionsOptions options = {.tolerance = tolerance};
    YkRegions *r = yk_regions_new(m->state, yk_input_coordinate(m->mech, 0), yk_input_coordinate(m->mech, 1), &options,
                                  m->problems);
    if (!r) print_error("%s", yk_problems_text(m->problems, 0));
    assert_non_null(r);
    return r;
}

static double total_area(const YkRegions *r, int configurations)
{
    double area = 0;
    for (size_t k = 0; k < yk_regions_count(r); k++)
        if (yk_regions_region(r, k).configurations == configurations) area += yk_regions_region(r, k).area;
    return area;
}

static YkRange annulus(const FiveBar *f, int side) // of radii that a dyad reaches
{
    return (YkRange){fabs(f->crank[side] - f->coupler[side]), f->crank[side] + f->coupler[side]};
}

// --- over the point

// Returns the area that two discs share.
static double lens(double a, double b, double apart)
{
    if (apart >= a + b) return 0;
    if (apart <= fabs(a - b)) return YK_PI * fmin(a, b) * fmin(a, b);
    double x = (apart * apart + a * a - b * b) / (2 * apart), y = apart - x;
    return a * a * acos(x / a) - x * sqrt(a * a - x * x) + b * b * acos(y / b) - y * sqrt(b * b - y * y);
}

static double workspace_area(const FiveBar *f)
{
    YkRange p = annulus(f, 0), q = annulus(f, 1);
    double d = 2 * f->w;
    return lens(p.to, q.to, d) - lens(p.from, q.to, d) - lens(p.to, q.from, d) + lens(p.from, q.from, d);
}

static int workspace_count(const FiveBar *f, double x, double y)
{
    YkRange p = annulus(f, 0), q = annulus(f, 1);
    double l = hypot(x + f->w, y), r = hypot(x - f->w, y);
    return l > p.from && l < p.to && r > q.from && r < q.to ? 4 : 0;
}

// Returns how far a pose is from the circles that bound the workspace.
static double off_circles(const FiveBar *f, double x, double y)
{
    YkRange p = annulus(f, 0), q = annulus(f, 1);
    double l = hypot(x + f->w, y), r = hypot(x - f->w, y);
    return fmin(fmin(fabs(l - p.from), fabs(l - p.to)), fmin(fabs(r - q.from), fabs(r - q.to)));
}

static void check_workspace(const FiveBar *f, uint64_t *seed)
{
    Machine m = five_bar(f, 2, 1);
    if (!stand(&m)) {
        machine_free(&m);
        return;
    }
    size_t point = yk_model_find_point(m.model, "reachL.P");
    YkPointMotion at = yk_state_point(m.state, point);
    Machine c = {.problems = yk_problems_new()};
    c.model = yk_model_carry_point(m.model, point, "over_", at.position, NULL, c.problems);
    const char *inputs[] = {"over_x", "over_y"};
    YkCompileOptions options = yk_default_compile_options();
    options.inputs = inputs;
    options.input_count = 2;
    c.mech = c.model ? yk_mechanism_compile(c.model, &options, c.problems) : NULL;
    if (!c.mech) print_error("%s", yk_problems_text(c.problems, 0));
    assert_non_null(c.mech);
    c.state = yk_state_new(c.mech);
    assert_true(stand(&c));
    YkRegions *r = regions_of(&c, 2e-3);
    double expected = workspace_area(f), size = annulus(f, 0).to;
    if (!yk_regions_are_complete(r))
        print_error("%.17g %.17g %.17g %.17g %.17g: %s\n", f->w, f->crank[0], f->coupler[0], f->crank[1], f->coupler[1],
                    yk_regions_message(r));
    assert_true(yk_regions_are_complete(r));
    assert_true(yk_regions_region(r, 0).contains_start);
    CHECK_NEAR(total_area(r, 4) / expected, 1, 2e-4);
    for (int k = 0; k < 2000; k++) {
        bool proved;
        double x = check_uniform(seed, yk_regions_domain(r, 0).from, yk_regions_domain(r, 0).to);
        double y = check_uniform(seed, yk_regions_domain(r, 1).from, yk_regions_domain(r, 1).to);
        int count = yk_regions_at(r, x, y, &proved);
        if (proved || off_circles(f, x, y) > 2 * yk_regions_tolerance(r, 0))
            assert_int_equal(count, workspace_count(f, x, y));
    }
    // Corners lie on the circles, but for the few where curves meet.
    size_t corners = 0, off = 0;
    for (size_t k = 0; k < yk_regions_count(r); k++)
        for (size_t o = 0; o < yk_regions_region(r, k).outlines; o++) {
            size_t count;
            const double *points = yk_regions_outline(r, k, o, &count);
            for (size_t p = 0; p < count; p++, corners++)
                off += off_circles(f, points[2 * p], points[2 * p + 1]) > 1e-6 * size;
        }
    assert_true(corners > 500 && off <= 16);
    yk_regions_free(r);
    machine_free(&c);
    machine_free(&m);
}

static void test_workspaces_are_annuli(void **unused)
{
    (void)unused;
    uint64_t seed = 5;
    const FiveBar usual = {0.06, {0.2, 0.2}, {0.26, 0.26}};
    check_workspace(&usual, &seed);
    const FiveBar equal = {0.6, {1.5, 1.2}, {1.5, 1.2}}; // the dyads fold where the point is at a motor
    check_workspace(&equal, &seed);
    for (uint64_t k = 0; k < check_cases(8); k++) {
        FiveBar f;
        f.w = check_uniform(&seed, 0.1, 0.5);
        for (int side = 0; side < 2; side++) {
            f.crank[side] = check_uniform(&seed, 0.5, 1.5);
            f.coupler[side] = check_uniform(&seed, 0.5, 1.5);
        }
        check_workspace(&f, &seed);
    }
}

// --- over the cranks

// Returns the distance of the cranks' ends.
static double span(const FiveBar *f, double u, double v)
{
    return hypot(2 * f->w + f->crank[1] * cos(v) - f->crank[0] * cos(u), f->crank[1] * sin(v) - f->crank[0] * sin(u));
}

// Returns for how many angles v, rad, the couplers reach, at one u: the arcs of a circle about R within an annulus
// about the left crank's end.
static double reach_at(const FiveBar *f, double u)
{
    double x = f->crank[0] * cos(u) - 2 * f->w, y = f->crank[0] * sin(u), d = hypot(x, y), a = f->crank[1], part[2];
    double radius[2] = {fabs(f->coupler[0] - f->coupler[1]), f->coupler[0] + f->coupler[1]};
    for (int k = 0; k < 2; k++) {
        double c = (d * d + a * a - radius[k] * radius[k]) / (2 * d * a);
        part[k] = c >= 1 ? 0 : c <= -1 ? YK_PI : acos(c);
    }
    return 2 * (part[1] - part[0]);
}

static void check_cranks(const FiveBar *f, uint64_t *seed)
{
    double area = 0, u = 0, v = 0;
    enum { SLICES = 20000 };
    for (int k = 0; k < SLICES; k++) area += reach_at(f, 2 * YK_PI * (k + 0.5) / SLICES) * 2 * YK_PI / SLICES;
    double least = fabs(f->coupler[0] - f->coupler[1]), most = f->coupler[0] + f->coupler[1];
    for (int k = 0; k < 1000 && !(span(f, u, v) > 1.05 * least && span(f, u, v) < 0.95 * most); k++) {
        u = check_uniform(seed, -3, 3);
        v = check_uniform(seed, -3, 3);
    }
    Machine m = five_bar(f, u, v);
    if (!stand(&m)) {
        machine_free(&m);
        return;
    }
    YkRegions *r = regions_of(&m, 2e-3);
    assert_true(yk_regions_are_complete(r));
    CHECK_NEAR(total_area(r, 2), area, 1e-3);
    assert_true(yk_regions_region(r, 0).contains_start);
    for (int k = 0; k < 2000; k++) {
        bool proved;
        u = check_uniform(seed, -3, 3);
        v = check_uniform(seed, -3, 3);
        double d = span(f, u, v);
        int count = yk_regions_at(r, u, v, &proved);
        if (proved) assert_int_equal(count, d > least && d < most ? 2 : 0);
    }
    assert_true(yk_regions_proved(r) > 0.95);
    yk_regions_free(r);
    machine_free(&m);
}

static void test_cranks_reach_what_the_couplers_span(void **unused)
{
    (void)unused;
    uint64_t seed = 7;
    for (uint64_t k = 0; k < check_cases(8); k++) {
        FiveBar f;
        f.w = check_uniform(&seed, 0.2, 1);
        for (int side = 0; side < 2; side++) {
            f.crank[side] = check_uniform(&seed, 0.3, 1.5);
            f.coupler[side] = check_uniform(&seed, 0.3, 1.5);
        }
        check_cranks(&f, &seed);
    }
}

// Where both couplers are equally long and the cranks' ends meet, the couplers turn freely. There cos u = w / crank,
// above and below the motors; all about these places there are two configurations.
static void test_places_where_a_dyad_turns_freely_are_told(void **unused)
{
    (void)unused;
    const FiveBar f = {0.06, {0.2, 0.2}, {0.3, 0.3}};
    Machine m = five_bar(&f, 2, 1);
    assert_true(stand(&m));
    YkRegions *r = regions_of(&m, 5e-3);
    double u = acos(0.3);
    assert_true(yk_regions_are_complete(r));
    assert_int_equal(yk_regions_count(r), 1);
    assert_int_equal(yk_regions_region(r, 0).configurations, 2);
    const char *places = strstr(yk_regions_message(r), "turns freely: joint `P` at ");
    assert_non_null(places);
    for (int k = 0; k < 2; k++) { // the place below comes first
        char *end;
        bool proved = true;
        double sign = k == 0 ? -1 : 1, first = strtod(strstr(places, " at ") + 4, &end);
        double second = strtod(strstr(end, ", ") + 2, &end);
        CHECK_NEAR(first, sign * u, 1e-5);
        CHECK_NEAR(second, sign * (YK_PI - u), 1e-5);
        assert_int_equal(yk_regions_at(r, sign * u, sign * (YK_PI - u), &proved), 2);
        assert_false(proved);
        places = end;
    }
    assert_null(strstr(places, " at "));
    yk_regions_free(r);
    machine_free(&m);
}

// Where the couplers are just long enough for the cranks stretched apart, at u = pi and v = 0, two configurations meet
// at one pose. All about it is proved, as it is where the couplers are a little longer and nothing meets.
static void test_places_at_which_configurations_touch_are_told(void **unused)
{
    (void)unused;
    for (int k = 0; k < 2; k++) {
        double longer = k == 0 ? 0 : 1e-6;
        const FiveBar f = {0.06, {0.2, 0.2}, {0.26 + longer, 0.26 + longer}};
        Machine m = five_bar(&f, 2, 1);
        assert_true(stand(&m));
        YkRegions *r = regions_of(&m, 5e-3);
        if (!yk_regions_are_complete(r)) print_error("%s\n", yk_regions_message(r));
        assert_true(yk_regions_are_complete(r));
        assert_int_equal(yk_regions_count(r), 1);
        assert_int_equal(yk_regions_region(r, 0).configurations, 2);
        const char *place = strstr(yk_regions_message(r), "two configurations meet: joint `P` at ");
        assert_int_equal(place != NULL, k == 0);
        if (place) {
            char *end;
            double u = strtod(strstr(place, " at ") + 4, &end), v = strtod(strstr(end, ", ") + 2, &end);
            CHECK_NEAR(u, YK_PI, 1e-5);
            assert_memory_equal(strstr(place, ", "), ", 0 rad", 7); // and not rounding noise
            CHECK_NEAR(v, 0, 1e-8);
            assert_null(strstr(end, " at "));
        }
        yk_regions_free(r);
        machine_free(&m);
    }
}

// Couplers that are a little too short do not close within a small circle; those that differ by more than rounding do
// not turn freely, but do not close within one either. It is narrower than the tolerance, and only said not to be
// proved.
static void test_small_gaps_are_not_proved(void **unused)
{
    (void)unused;
    const FiveBar apart = {0.06, {0.2, 0.2}, {0.26, 0.26 - 1e-6}}, unequal = {0.06, {0.2, 0.2}, {0.3, 0.3 + 1e-9}};
    for (int k = 0; k < 2; k++) {
        Machine m = five_bar(k == 0 ? &apart : &unequal, 2, 1);
        assert_true(stand(&m));
        YkRegions *r = regions_of(&m, 5e-3);
        assert_false(yk_regions_are_complete(r));
        assert_non_null(strstr(yk_regions_message(r), "may meet"));
        yk_regions_free(r);
        machine_free(&m);
    }
}

// --- groups

// A triad whose inputs are two cranks: a platform on three legs, two of which are carried by the cranks. If asked, the
// platform also carries a dyad.
static Machine two_cranks(uint64_t seed, bool has_dyad)
{
    double x[6], leg[3];
    char text[2400];
    const char *bodies =
        has_dyad ? "  l4: {points: {F: [0, 0], G: [0.8, 0]}}\n  l5: {points: {H: [0, 0], G: [0.7, 0]}}\n" : "";
    const char *joints =
        has_dyad ? "  F4: {pin: [plate, l4], at: F}\n  H: {pin: [ground, l5]}\n  G: {pin: [l4, l5]}\n" : "";
    for (int k = 0; k < 6; k++) x[k] = check_uniform(&seed, -0.7, 0.7);
    for (int k = 0; k < 3; k++) leg[k] = check_uniform(&seed, 1.2, 2);
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {O: [0, 0], Q: [3, 0.2], S: [1.4, 2.6], H: [1, 0.7]}}\n"
             "  c1: {points: {O: [0, 0], A: [0.6, 0]}}\n  c2: {points: {Q: [0, 0], B: [0.5, 0]}}\n"
             "  l1: {points: {A: [0, 0], D: [%.17g, 0]}}\n  l2: {points: {B: [0, 0], E: [%.17g, 0]}}\n"
             "  l3: {points: {S: [0, 0], F: [%.17g, 0]}}\n"
             "  plate: {points: {D: [%.17g, %.17g], E: [%.17g, %.17g], F: [%.17g, %.17g]}}\n%s"
             "joints:\n  O: {pin: [ground, c1], angle: u}\n  Q: {pin: [ground, c2], angle: v}\n  A: {pin: [c1, l1]}\n"
             "  B: {pin: [c2, l2]}\n  S: {pin: [ground, l3]}\n  D: {pin: [l1, plate]}\n  E: {pin: [l2, plate]}\n"
             "  F: {pin: [l3, plate]}\n%sdrives: {u: 0.3, v: 0.4}\n",
             leg[0], leg[1], leg[2], x[0], x[1], x[2], x[3], x[4], x[5], bodies, joints);
    return machine_parse_with(text, NULL, 0);
}

// Returns the number of configurations at the inputs; -1 if that is not proved.
static int count_all(Machine *m, YkConfigurations *all, double u, double v)
{
    YkConfigurationsReport report;
    yk_state_set_input(m->state, 0, (YkMotion){u, 0, 0});
    yk_state_set_input(m->state, 1, (YkMotion){v, 0, 0});
    yk_configurations_each(all, m->state, NULL, NULL, NULL, &report);
    return report.complete ? (int)report.count : -1;
}

// Returns the centre of a square, where the number of configurations is found even if it is not proved all over it.
static double center(const YkRegions *r, int axis, double part)
{
    YkRange domain = yk_regions_domain(r, axis);
    double step = yk_regions_tolerance(r, axis);
    return domain.from + (floor(part * (domain.to - domain.from) / step) + 0.5) * step;
}

static void test_counts_are_those_of_solve_all(void **unused)
{
    (void)unused;
    uint64_t seed = 11;
    size_t compared = 0, seen[16] = {0};
    for (uint64_t k = 0; k < check_cases(3); k++) {
        Machine m = two_cranks(k + 1, k % 2 == 0);
        if (!stand(&m)) {
            machine_free(&m);
            continue;
        }
        YkConfigurations *all = yk_configurations_new(m.mech);
        YkRegions *r = regions_of(&m, 2e-2);
        for (int p = 0; p < 400; p++) {
            double u = center(r, 0, check_uniform(&seed, 0, 1)), v = center(r, 1, check_uniform(&seed, 0, 1));
            int count = yk_regions_at(r, u, v, NULL), expected = count_all(&m, all, u, v);
            if (expected < 0) continue;
            assert_int_equal(count, expected);
            seen[count < 16 ? count : 15]++;
            compared++;
        }
        yk_regions_free(r);
        yk_configurations_free(all);
        machine_free(&m);
    }
    assert_true(compared > 300);
    assert_true((seen[0] > 0) + (seen[2] > 0) + (seen[4] > 0) + (seen[6] > 0) >= 2);
}

// A platform of three legs whose lengths l1 and l2 are the inputs, l3 is 0.9: |l1| is at most AC + DF + l3, |l2| at
// most BC + EF + l3.
static Machine three_legs(void)
{
    static const char text[] =
        "bodies:\n  ground: {points: {A: [0, 0], B: [2, 0], C: [1, 1.7]}}\n  t1: {points: {A: [0, 0]}}\n"
        "  t2: {points: {B: [0, 0]}}\n  r1: {points: {D: [0, 0]}}\n  r2: {points: {E: [0, 0]}}\n"
        "  leg: {points: {C: [0, 0], F: [0.9, 0]}}\n"
        "  plate: {points: {D: [0, 0], E: [0.6, 0], F: [0.35, 0.5]}}\njoints:\n  A: {pin: [ground, t1], angle: a}\n"
        "  B: {pin: [ground, t2]}\n  C: {pin: [ground, leg]}\n"
        "  P1: {slide: [t1, r1], along: x, from: A, distance: l1}\n"
        "  P2: {slide: [t2, r2], along: x, from: B, distance: l2}\n"
        "  D: {pin: [r1, plate]}\n  E: {pin: [r2, plate]}\n  F: {pin: [leg, plate]}\n"
        "drives: {l1: 1, l2: 1.1}\nstart: {a: 50 deg}\n";
    return machine_parse_with(text, NULL, 0);
}

static void test_loops_of_a_group_that_cannot_close_empty_a_square(void **unused)
{
    (void)unused;
    enum { CASES = 60 };
    Machine m = three_legs();
    assert_true(stand(&m));
    YkConfigurations *all = yk_configurations_new(m.mech);
    YkTracer t = {0};
    const double most[2] = {hypot(1, 1.7) + hypot(0.35, 0.5) + 0.9, hypot(1, 1.7) + hypot(0.25, 0.5) + 0.9}, half = 0.2;
    double inputs[2] = {0};
    uint64_t seed = 13;
    size_t empty = 0, filled = 0;
    assert_true(yk_tracer_begin(&t, m.mech) && yk_tracer_read(&t, m.problems));
    t.discs.mapped = 0;
    t.discs.second = 1;
    t.discs.others = inputs;
    for (int p = 0; p < CASES; p++) {
        double low[2], high[2], at[2];
        bool is_out = false;
        for (int k = 0; k < 2; k++) {
            at[k] = check_uniform(&seed, -6, 6);
            low[k] = at[k] - half;
            high[k] = at[k] + half;
            is_out |= fabs(at[k]) > most[k] + 2 * half;
        }
        int count = yk_box_count(&t, low, high, NULL);
        if (is_out) assert_int_equal(count, 0);
        int expected = count_all(&m, all, at[0], at[1]);
        if (count >= 0 && expected >= 0) assert_int_equal(count, expected);
        empty += count == 0;
        filled += expected > 0;
    }
    assert_true(empty > CASES / 4 && filled > CASES / 20);
    yk_tracer_end(&t);
    yk_configurations_free(all);
    machine_free(&m);
}

// --- what is refused

static void test_what_cannot_be_mapped_is_refused(void **unused)
{
    (void)unused;
    const FiveBar f = {0.06, {0.2, 0.2}, {0.26, 0.26}};
    Machine m = five_bar(&f, 2, 1);
    const YkRegionsOptions narrow = {.tolerance = 1e-6}, wide = {.tolerance = 0.5}, none = {.tolerance = NAN};
    size_t u = yk_coordinate_find(m.mech, "u"), v = yk_coordinate_find(m.mech, "v");
    assert_null(yk_regions_new(m.state, u, v, NULL, m.problems)); // not assembled
    assert_true(stand(&m));
    assert_null(yk_regions_new(NULL, u, v, NULL, m.problems));
    assert_null(yk_regions_new(m.state, u, u, NULL, m.problems));
    assert_null(yk_regions_new(m.state, u, 99, NULL, m.problems));
    assert_null(yk_regions_new(m.state, u, v, &narrow, m.problems));
    assert_null(yk_regions_new(m.state, u, v, &wide, m.problems));
    assert_null(yk_regions_new(m.state, u, v, &none, m.problems));
    assert_int_equal(yk_problems_error_count(m.problems), 6);
    assert_null(yk_model_carry_point(m.model, 99, "p_", (double[2]){0, 0}, NULL, m.problems));
    assert_null(yk_model_carry_point(NULL, 0, "p_", (double[2]){0, 0}, NULL, m.problems));
    machine_free(&m);
}

static void test_wrong_indices_get_nothing(void **unused)
{
    (void)unused;
    const FiveBar f = {0.06, {0.2, 0.2}, {0.26, 0.26}};
    Machine m = five_bar(&f, 2, 1);
    size_t count = 5;
    assert_true(stand(&m));
    YkRegions *r = regions_of(&m, 2e-2);
    assert_null(yk_regions_outline(r, 99, 0, &count));
    assert_int_equal(count, 0);
    assert_null(yk_regions_outline(r, 0, 99, NULL));
    assert_int_equal(yk_regions_region(r, 99).configurations, 0);
    assert_int_equal(yk_regions_bound(r, 0, 99).block, -1);
    assert_int_equal(yk_regions_at(r, 99, 0, NULL), -1);
    assert_int_equal(yk_regions_at(r, NAN, 0, NULL), -1);
    assert_true(isnan(yk_regions_domain(r, 2).from) && isnan(yk_regions_tolerance(r, -1)));
    assert_null(yk_regions_picture(r, NULL));
    assert_null(yk_regions_picture(NULL, NULL));
    assert_int_equal(yk_regions_count(NULL), 0);
    assert_int_equal(yk_regions_at(NULL, 0, 0, NULL), -1);
    assert_false(yk_regions_are_complete(NULL));
    assert_true(yk_regions_proved(NULL) == 0);
    yk_regions_free(r);
    yk_regions_free(NULL);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_workspaces_are_annuli),
        cmocka_unit_test(test_cranks_reach_what_the_couplers_span),
        cmocka_unit_test(test_places_where_a_dyad_turns_freely_are_told),
        cmocka_unit_test(test_places_at_which_configurations_touch_are_told),
        cmocka_unit_test(test_small_gaps_are_not_proved),
        cmocka_unit_test(test_counts_are_those_of_solve_all),
        cmocka_unit_test(test_loops_of_a_group_that_cannot_close_empty_a_square),
        cmocka_unit_test(test_what_cannot_be_mapped_is_refused),
        cmocka_unit_test(test_wrong_indices_get_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
