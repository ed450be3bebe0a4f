// Derivatives of positions by parameters: against complex steps through closed forms that share nothing with the
// engine, and on the whole gallery against machines solved anew.
#include "compile/gradient.h"
#include "base/vec.h"
#include "machine.h"
#include <yoke/move.h>
#include <yoke/study.h>

enum { NAMES = 64 };

typedef struct Varied {
    Machine m;
    YkVariant *variant;
    YkState *state;
    YkGradient *gradient;
    const char *name[NAMES];
    double own[NAMES];
    size_t count;
} Varied;

// Varies those of the first `most` parameters that can. A parameter that follows others, if it is among them, does not
// then.
static Varied vary(const char *source, size_t most)
{
    Varied v = {.m = machine(source)};
    const YkModel *model = v.m.model;
    for (size_t k = 0; k < model->parameter_count && k < most && v.count < NAMES; k++) {
        YkProblems *unheard = yk_problems_new();
        const char *name = model->parameters[k].name;
        YkVariant *one = yk_variant_new(v.m.mech, &name, 1, unheard);
        if (one && yk_problems_count(unheard) == 0) {
            v.own[v.count] = yk_model_parameter(model, name);
            v.name[v.count++] = name;
        }
        yk_variant_free(one);
        yk_problems_free(unheard);
    }
    v.variant = yk_variant_new(v.m.mech, v.name, v.count, v.m.problems);
    assert_non_null(v.variant);
    v.state = yk_state_new(yk_variant_mechanism(v.variant));
    v.gradient = yk_gradient_new(v.variant);
    assert_true(v.state && v.gradient);
    return v;
}

static void vary_free(Varied *v)
{
    yk_gradient_free(v->gradient);
    yk_state_free(v->state);
    yk_variant_free(v->variant);
    machine_free(&v->m);
}

// The pose of the state as the variables of the loops, with their rates and accelerations.
static void variables_of(const YkState *s, const YkMechanism *mech, double *x)
{
    size_t o = mech->orientation_count - 1, n = yk_variable_count(mech);
    for (int order = 0; order < 3; order++, x += n) {
        for (size_t k = 1; k <= o; k++)
            x[k - 1] =
                yk_state_channel(s, (YkChannel){YK_CHANNEL_BODY, mech->orientation_body[k], order, YK_QUANTITY_ANGLE});
        for (size_t j = 0; j < mech->model->joint_count; j++)
            if (mech->joint_distance[j] >= 0)
                x[o + (size_t)mech->joint_distance[j]] =
                    yk_state_channel(s, (YkChannel){YK_CHANNEL_JOINT_DISTANCE, (int)j, order, YK_QUANTITY_LENGTH});
    }
}

// Linearises at the state's pose. Returns false at a dead point.
static bool linearise(const Varied *v)
{
    const YkMechanism *mech = yk_variant_mechanism(v->variant);
    double *x = calloc(3 * yk_variable_count(mech) + 1, sizeof *x);
    assert_non_null(x);
    variables_of(v->state, mech, x);
    bool good = yk_gradient_design(v->gradient) &&
                yk_gradient_pose(v->gradient, x, x + yk_variable_count(mech), x + 2 * yk_variable_count(mech));
    free(x);
    return good;
}

static void add_slope(YkGradient *gradient, YkWeighted part, double *slope)
{
    yk_gradient_start(gradient);
    yk_gradient_take(gradient, part);
    yk_gradient_finish(gradient, slope);
}

static void by_parameters(const Varied *v, const char *channel, double *slope)
{
    YkWeighted one = {.weight = 1};
    assert_int_equal(yk_channel_parse(v->m.mech, channel, &one.channel, NULL), YK_OK);
    assert_true(yk_gradient_covers(v->m.mech, one.channel));
    for (size_t k = 0; k < v->count; k++) slope[k] = 0;
    add_slope(v->gradient, one, slope);
}

static void turn_to(const Varied *v, double angle)
{
    YkMotion goal = {.position = angle};
    assert_int_equal(yk_state_set_time(v->state, 0, NULL), YK_OK);
    assert_true(yk_state_assemble(v->state) >= 0);
    assert_true(yk_state_move_to(v->state, &goal, NULL, NULL) >= 0);
    assert_true(linearise(v));
}

// --- by complex step

// The corner of a triangle over a and b, at the distances p and q, on the left of the way from a to b (sign 1).
static Vector corner(Vector a, Vector b, double complex p, double complex q, double sign)
{
    Vector d = sum(b, a, -1);
    double complex dd = d.x * d.x + d.y * d.y, along = (p * p - q * q + dd) / (2 * dd),
                   across = sign * csqrt(p * p / dd - along * along);
    return (Vector){a.x + along * d.x - across * d.y, a.y + along * d.y + across * d.x};
}

// The foot of Jansen's leg at a crank angle, from its eleven lengths a, b, ..., k, l, m.
static Vector jansen(const double complex *p, double theta)
{
    enum { A, B, C, D, E, F, G, H, J_I, J, K, L, M };
    Vector hip = {-p[A], -p[L]}, crank = {p[M] * cos(theta), p[M] * sin(theta)};
    Vector above = corner(crank, hip, p[J], p[B], -1), below = corner(crank, hip, p[K], p[C], 1);
    Vector out = corner(hip, above, p[D], p[E], 1), knee = corner(out, below, p[F], p[G], -1);
    return corner(below, knee, p[J_I], p[H], 1);
}

static void jansens_foot_follows_its_lengths(void **state)
{
    (void)state;
    enum { LENGTHS = 13, POSES = 24 };
    static const char *const names[LENGTHS] = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m"};
    Varied v = vary("jansen", LENGTHS);
    double slope[2][NAMES];
    for (int pose = 0; pose < POSES; pose++) {
        double theta = 2 * YK_PI * pose / POSES;
        double complex value[LENGTHS];
        turn_to(&v, theta);
        by_parameters(&v, "leg.foot.x", slope[0]);
        by_parameters(&v, "leg.foot.y", slope[1]);
        for (size_t k = 0; k < LENGTHS; k++) value[k] = yk_model_parameter(v.m.model, names[k]);
        Vector foot = jansen(value, theta);
        YkChannel at;
        assert_int_equal(yk_channel_parse(v.m.mech, "leg.foot.x", &at, NULL), YK_OK);
        YkPointMotion is = yk_state_point(v.state, (size_t)at.index);
        CHECK_NEAR(creal(foot.x), is.position[0], 1e-14);
        CHECK_NEAR(creal(foot.y), is.position[1], 1e-14);
        for (size_t k = 0; k < LENGTHS; k++) {
            size_t own = 0;
            while (own < v.count && strcmp(v.name[own], names[k]) != 0) own++;
            assert_true(own < v.count);
            value[k] += 1e-30 * I;
            foot = jansen(value, theta);
            value[k] = creal(value[k]);
            CHECK_NEAR(slope[0][own], cimag(foot.x) * 1e30, 1e-11);
            CHECK_NEAR(slope[1][own], cimag(foot.y) * 1e30, 1e-11);
        }
    }
    vary_free(&v);
}

// A slotted lever: its line's direction follows a parameter, and so do a place on the line and the crank, by functions.
static void directions_and_functions_have_slopes(void **state)
{
    (void)state;
    static const char source[] =
        "parameters: {u: 1.2, lift: 20 deg, far: 3 m}\n"
        "bodies:\n  ground: {points: {O: [0, 0], L: [far*cos(lift), 1 m * log(u)]}}\n"
        "  crank: {points: {O: [0, 0], A: [1 m * sqrt(u), 0]}}\n"
        "  rod: {points: {A: [0, 0], B: [4 m * u, 0], P: [2, \"1 m * sin(atan2(u, far/1 m))\"]}}\n"
        "  slider: {points: {B: [0, 0]}}\n"
        "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
        "  B: {pin: [rod, slider]}\n"
        "  S: {slide: [ground, slider], along: lift*u + 10 deg, from: L, to: B, distance: s}\n"
        "drives: {theta: 40 deg + 1 rad/s * t}\nstart: {phi: -10 deg, s: 2}\n";
    static const char *const names[] = {"u", "lift", "far"};
    Varied v = vary(source, NAMES);
    assert_int_equal(v.count, 3);
    double s[NAMES], x[NAMES], theta = 0.9;
    turn_to(&v, theta);
    by_parameters(&v, "s", s);
    by_parameters(&v, "rod.P.x", x);
    double complex p[3] = {1.2, YK_PI / 9, 3};
    for (int k = 0; k < 3; k++) {
        assert_string_equal(v.name[k], names[k]);
        p[k] += 1e-30 * I;
        double complex u = p[0], line = p[1] * u + YK_PI / 18, c = ccos(line), si = csin(line);
        Vector l = {p[2] * ccos(p[1]), clog(u)}, a = {csqrt(u) * cos(theta), csqrt(u) * sin(theta)}, d = sum(a, l, -1);
        double complex along = d.x * c + d.y * si, off = -d.x * si + d.y * c, reach = csqrt(16 * u * u - off * off);
        double sign =
            yk_state_channel(v.state, (YkChannel){YK_CHANNEL_COORDINATE, (int)yk_coordinate_find(v.m.mech, "s"), 0,
                                                  YK_QUANTITY_LENGTH}) > creal(along)
                ? 1
                : -1;
        double complex slide = along + sign * reach;
        Vector b = {l.x + slide * c, l.y + slide * si}, e = sum(b, a, -1);
        double complex height = csin(catan(u / p[2])), P = a.x + (2 * e.x - height * e.y) / (4 * u);
        p[k] = creal(p[k]);
        CHECK_NEAR(s[k], cimag(slide) * 1e30, 1e-12);
        CHECK_NEAR(x[k], cimag(P) * 1e30, 1e-12);
    }
    vary_free(&v);
}

static double complex square(double complex z)
{
    return z * z;
}

// A crank r, a rod l with a point P beside it, and a guide at the height h, turning with the rate w and the
// acceleration a. Answers by name, each an expression of the lengths alone.
typedef struct Crank {
    double complex value[18];
} Crank;
static const char *const crank_names[18] = {
    "s",           "s.rate",         "s.accel",       "rod.angle", "rod.rate",     "rod.accel",
    "rod.P.x",     "rod.P.x.rate",   "rod.P.x.accel", "rod.P.y",   "rod.P.y.rate", "rod.P.y.accel",
    "rod.P.speed", "B.transmission", "phi",           "phi.rate",  "B.angle",      "slider.B.speed"};

static Crank crank_of(const double complex *p, double theta, double w, double a)
{
    double complex r = p[0], l = p[1], h = p[2], px = p[3], py = p[4], c = cos(theta), si = sin(theta);
    double complex sine = (h - r * si) / l, cosine = csqrt(1 - square(sine)), phi = casin(sine);
    double complex rate = -r * c * w / (l * cosine);
    double complex accel = (r * si * w * w - r * c * a + l * sine * square(rate)) / (l * cosine);
    double complex s = r * c + l * cosine, v = -r * si * w - l * sine * rate;
    double complex acc = -r * c * w * w - r * si * a - l * cosine * square(rate) - l * sine * accel;
    double complex x = px * cosine - py * sine, y = px * sine + py * cosine; // P's arm from the crank's end, turned
    double complex vx = -r * si * w - y * rate, vy = r * c * w + x * rate;
    double complex ax = -r * c * w * w - r * si * a - y * accel - x * square(rate);
    double complex ay = -r * si * w * w + r * c * a + x * accel - y * square(rate);
    // The rod's end can leave the rod's circle across the rod, and the guide along x: these two are at this angle.
    double complex transmission = casin(creal(cosine) < 0 ? -cosine : cosine);
    return (Crank){{s, v, acc, phi, rate, accel, r * c + x, vx, ax, r * si + y, vy, ay, csqrt(square(vx) + square(vy)),
                    transmission, phi - theta, rate - w, -phi, creal(v) < 0 ? -v : v}};
}

static void rates_speeds_and_transmissions_have_slopes(void **state)
{
    (void)state;
    static const char source[] =
        "parameters: {r: 1 m, l: 3 m, h: 0.4 m, px: 1.2 m, py: 0.7 m}\n"
        "bodies:\n  ground: {points: {O: [0, 0], G: [0, h]}}\n  crank: {points: {O: [0, 0], A: [r, 0]}}\n"
        "  rod: {points: {A: [0, 0], B: [l, 0], P: [px, py]}}\n  slider: {points: {B: [0, 0]}}\n"
        "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
        "  B: {pin: [rod, slider]}\n  S: {slide: [ground, slider], along: x, from: G, to: B, distance: s}\n"
        "drives: {theta: 0.5}\nstart: {phi: -0.5, s: 4}\n";
    enum { LENGTHS = 5, ANSWERS = sizeof crank_names / sizeof *crank_names };
    const double own[LENGTHS] = {1, 3, 0.4, 1.2, 0.7};
    Varied v = vary(source, NAMES);
    assert_int_equal(v.count, LENGTHS);
    for (int pose = 0; pose < 20; pose++) {
        double theta = 0.1 + 0.3 * pose, w = 1.7, a = -0.6, slope[NAMES];
        turn_to(&v, theta);
        yk_state_set_input(v.state, 0, (YkMotion){theta, w, a});
        assert_true(yk_state_solve(v.state) >= 0);
        assert_true(linearise(&v));
        for (int n = 0; n < ANSWERS; n++) {
            YkChannel channel;
            double complex p[LENGTHS] = {own[0], own[1], own[2], own[3], own[4]};
            assert_int_equal(yk_channel_parse(v.m.mech, crank_names[n], &channel, NULL), YK_OK);
            double off = yk_state_channel(v.state, channel) - creal(crank_of(p, theta, w, a).value[n]);
            if (channel.quantity == YK_QUANTITY_ANGLE) off = remainder(off, 2 * YK_PI);
            if (!(fabs(off) < 1e-12)) print_error("%s at %g\n", crank_names[n], theta);
            CHECK_NEAR(off, 0, 1e-12);
            by_parameters(&v, crank_names[n], slope);
            for (int k = 0; k < LENGTHS; k++) {
                p[k] += 1e-30 * I;
                double truth = cimag(crank_of(p, theta, w, a).value[n]) * 1e30;
                p[k] = own[k];
                if (!(fabs(slope[k] - truth) < 1e-11 * (1 + fabs(truth))))
                    print_error("%s by %s at %g\n", crank_names[n], v.name[k], theta);
                CHECK_NEAR(slope[k], truth, 1e-11 * (1 + fabs(truth)));
            }
        }
        YkWeighted time = {.channel = {.kind = YK_CHANNEL_TIME}, .weight = 1};
        for (int k = 0; k < LENGTHS; k++) slope[k] = 0;
        add_slope(v.gradient, time, slope);
        for (int k = 0; k < LENGTHS; k++) CHECK_NEAR(slope[k], 0, 0);
    }
    vary_free(&v);
}

// --- by differences

// All positions, rates, accelerations, speeds and transmission angles that have slopes.
static size_t list_channels(const Varied *v, YkChannel *channels, size_t capacity)
{
    size_t count = 0;
    for (int order = 0; order < 3; order++) {
        for (size_t k = 0; k < v->m.model->point_count; k++)
            for (int axis = 0; axis < 2 && count < capacity; axis++)
                channels[count++] = (YkChannel){YK_CHANNEL_POINT_X + axis, (int)k, order, YK_QUANTITY_LENGTH};
        for (size_t k = 0; k < v->m.model->joint_count && count < capacity; k++) {
            bool turns = yk_part(v->m.model->joints[k].kind)->turns;
            YkChannelKind kind = turns ? YK_CHANNEL_JOINT_ANGLE : YK_CHANNEL_JOINT_DISTANCE;
            channels[count++] = (YkChannel){kind, (int)k, order, YK_QUANTITY_NUMBER};
        }
    }
    for (size_t k = 0; k < v->m.model->point_count && count < capacity; k++)
        channels[count++] = (YkChannel){YK_CHANNEL_POINT_SPEED, (int)k, 0, YK_QUANTITY_SPEED};
    for (size_t k = 0; k < v->m.mech->block_count && count < capacity; k++) {
        YkChannel c = {YK_CHANNEL_TRANSMISSION, (int)k, 0, YK_QUANTITY_ANGLE};
        if (yk_gradient_covers(v->m.mech, c)) channels[count++] = c;
    }
    return count;
}

static void read_all(const Varied *v, const YkChannel *channels, size_t count, double *values)
{
    for (size_t i = 0; i < yk_input_count(v->m.mech); i++) {
        YkMotion in = yk_state_input(v->state, i);
        yk_state_set_input(v->state, i, (YkMotion){in.position, 1.1 - 0.4 * (double)i, 0.6});
    }
    assert_true(yk_state_solve(v->state) >= 0);
    for (size_t c = 0; c < count; c++) values[c] = yk_state_channel(v->state, channels[c]);
}

// Central differences of the fourth order, of a state that follows.
static void check_differences(const char *source)
{
    enum { CHANNELS = 400 };
    static const double place[4] = {-2, -1, 1, 2}, weight[4] = {1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12};
    static YkChannel channels[CHANNELS];
    static double values[4][CHANNELS], here[CHANNELS], slope[CHANNELS][NAMES];
    Varied v = vary(source, NAMES);
    size_t count = list_channels(&v, channels, CHANNELS);
    assert_true(v.count > 0 && count > 0);
    assert_int_equal(yk_state_set_time(v.state, 0.05, NULL), YK_OK);
    assert_true(yk_state_assemble(v.state) >= 0);
    read_all(&v, channels, count, here);
    assert_true(linearise(&v));
    memset(slope, 0, sizeof slope);
    for (size_t c = 0; c < count; c++) add_slope(v.gradient, (YkWeighted){channels[c], 1}, slope[c]);
    for (size_t k = 0; k < v.count; k++) {
        double own = v.own[k], h = 1e-3 * fmax(fabs(own), 0.1 * v.m.mech->size);
        for (int e = 0; e < 4; e++) {
            v.own[k] = own + h * place[e];
            assert_int_equal(yk_variant_set(v.variant, v.own), YK_OK);
            read_all(&v, channels, count, values[e]);
        }
        v.own[k] = own;
        for (size_t c = 0; c < count; c++) {
            double by = 0, most = fabs(here[c]) / h;
            for (int e = 0; e < 4; e++)
                by += weight[e] *
                      (channels[c].kind == YK_CHANNEL_JOINT_ANGLE && channels[c].order == 0
                           ? remainder(values[e][c] - here[c], 2 * YK_PI)
                           : values[e][c] - here[c]) /
                      h;
            double allowed = 1e-7 * (1 + fabs(by)) + 1e-9 * most;
            if (!(fabs(slope[c][k] - by) <= allowed)) {
                char name[200];
                yk_channel_name(v.m.mech, channels[c], name, sizeof name);
                print_error("%.40s: %s by %s: %.12g, differences %.12g\n", source, name, v.name[k], slope[c][k], by);
            }
            CHECK_NEAR(slope[c][k], by, allowed);
        }
    }
    vary_free(&v);
}

static void rates_and_accelerations_have_the_slopes_of_differences(void **state)
{
    (void)state;
    static const char *const names[] = {"four-bar",           "crank-slotted-lever",  "inverted-slider-crank",
                                        "quick-return",       "oscillating-cylinder", "whitworth-kg",
                                        "offset-slider-crank"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) check_differences(names[k]);
    check_differences( // a guide whose direction is a parameter, and a slot on a body that turns
        "parameters: {r: 1 m, l: 3 m, lift: 20 deg, tilt: 12 deg}\n"
        "bodies:\n  ground: {points: {O: [0, 0], G: [0, 0.3]}}\n  crank: {points: {O: [0, 0], A: [r, 0]}}\n"
        "  rod: {points: {A: [0, 0], B: [l, 0], E: [1, 0.2]}}\n  slider: {points: {B: [0, 0]}}\n"
        "  block: {points: {F: [0, 0], H: [0.3, 0.1]}}\n"
        "joints:\n  O: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
        "  B: {pin: [rod, slider]}\n  S: {slide: [ground, slider], along: lift, from: G, to: B, distance: s}\n"
        "  E: {slide: [rod, block], along: tilt, from: E, to: F, distance: e}\n"
        "drives: {theta: 0.9, e: 0.4}\nstart: {phi: -0.5, s: 4}\n");
}

// --- the gallery

// Compares all positions of a machine as its file gives it with those of machines solved anew.
static size_t compare(const char *source)
{
    enum { CHANNELS = 200 };
    Varied v = vary(source, NAMES);
    YkChannel channels[CHANNELS];
    size_t count = 0, compared = 0;
    for (size_t k = 0; k < v.m.model->point_count && count + 2 < CHANNELS; k++)
        for (int axis = 0; axis < 2; axis++)
            channels[count++] = (YkChannel){YK_CHANNEL_POINT_X + axis, (int)k, 0, YK_QUANTITY_LENGTH};
    for (size_t k = 0; k < v.m.mech->coordinate_count && count < CHANNELS; k++)
        channels[count++] = (YkChannel){YK_CHANNEL_COORDINATE, (int)k, 0, YK_QUANTITY_NUMBER};
    YkState *state = yk_state_new(v.m.mech);
    assert_true(state && yk_state_set_time(v.state, 0, NULL) == YK_OK && yk_state_set_time(state, 0, NULL) == YK_OK);
    YkStudyOptions options = {v.name, v.count, channels, count, 1, NULL};
    double *ways[2] = {calloc(count * v.count + 1, sizeof(double)), calloc(count * v.count + 1, sizeof(double))};
    bool stands = yk_state_assemble(v.state) == YK_OK && yk_state_assemble(state) == YK_OK;
    YkStudy *study = stands && v.count > 0 ? yk_study_new(state, &options, v.m.problems) : NULL;
    if (study && yk_study_sensitivities(study, NULL, ways[0], ways[1]) == YK_OK && linearise(&v)) {
        for (size_t c = 0; c < count; c++) {
            double slope[NAMES] = {0};
            add_slope(v.gradient, (YkWeighted){channels[c], 1}, slope);
            for (size_t k = 0; k < v.count; k++) {
                double by = ways[1][c * v.count + k];
                if (!(fabs(slope[k] - by) <= 1e-6 * (fabs(by) + v.m.mech->size / (fabs(v.own[k]) + v.m.mech->size))))
                    print_error("%s, channel %zu, %s: %.12g is not %.12g\n", source, c, v.name[k], slope[k], by);
                CHECK_NEAR(slope[k], by, 1e-6 * (fabs(by) + v.m.mech->size / (fabs(v.own[k]) + v.m.mech->size)));
                compared++;
            }
        }
    }
    free(ways[0]);
    free(ways[1]);
    yk_study_free(study);
    yk_state_free(state);
    vary_free(&v);
    return compared;
}

static void the_gallery_has_the_slopes_of_machines_solved_anew(void **state)
{
    (void)state;
    static const char *const names[] = {
        "crank-press",
        "crank-slotted-lever",
        "elliptic-trammel",
        "five-bar-motors",
        "five-bar",
        "four-bar",
        "hoeken",
        "jansen",
        "inverted-slider-crank",
        "marghitu",
        "andrews",
        "oscillating-cylinder",
        "peaucellier",
        "quick-return",
        "offset-slider-crank",
        "scotch-yoke",
        "slider-crank",
        "steam-engine",
        "toggle",
        "whitworth-kg",
        "chain",
        "rocking-four-bar",
        "planetary-gear",
    };
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) assert_true(compare(names[k]) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jansens_foot_follows_its_lengths),
        cmocka_unit_test(directions_and_functions_have_slopes),
        cmocka_unit_test(rates_speeds_and_transmissions_have_slopes),
        cmocka_unit_test(rates_and_accelerations_have_the_slopes_of_differences),
        cmocka_unit_test(the_gallery_has_the_slopes_of_machines_solved_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
