// Derivatives with respect to parameters: two ways that agree, and closed forms.
#include "study_check.h"
#include "compile/mechanism.h"

enum { MOST = 400 };
static double derivative[MOST], difference[MOST];

static void test_derivatives_of_a_slider_crank_are_the_closed_form(void **unused)
{
    (void)unused;
    Machine m = machine_parse("parameters: {r: 0.05 m, l: 0.18 m, e: 0 m}\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0], F: [0, e]}}\n"
                              "  crank: {points: {O: [0, 0], A: [r, 0]}}\n"
                              "  rod: {points: {A: [0, 0], B: [l, 0]}}\n"
                              "  piston: {points: {B: [0, 0]}}\n"
                              "joints:\n"
                              "  O: {pin: [ground, crank], angle: theta}\n"
                              "  A: {pin: [crank, rod], angle: phi}\n"
                              "  B: {pin: [rod, piston]}\n"
                              "  S: {slide: [ground, piston], from: F, to: B, along: x, distance: s}\n"
                              "drives: {theta: 60 deg + 1 rad/s * t}\n"
                              "start: {phi: -75 deg, s: 200 mm}\n",
                              true);
    const char *names[] = {"r", "l", "e"}, *of[] = {"s", "piston.B.x", "piston.B.y", "s.rate"};
    YkStudy *study = study_of(&m, names, 3, of, 4, 1);
    assert_int_equal(yk_study_sensitivities(study, NULL, derivative, difference), YK_OK);
    double r = 0.05, l = 0.18, sine = sin(YK_PI / 3), cosine = cos(YK_PI / 3), h = r * sine, root = sqrt(l * l - h * h);
    double exact[] = {cosine - h * sine / root, l / root, h / root};
    for (int p = 0; p < 3; p++) {
        CHECK_NEAR(derivative[p], exact[p], 1e-9);
        CHECK_NEAR(difference[p], exact[p], 1e-9);
        CHECK_NEAR(derivative[3 + p], exact[p], 1e-9);
        CHECK_NEAR(derivative[6 + p], p == 2 ? 1 : 0, 1e-10);
        assert_true(isnan(derivative[9 + p])); // a rate does not follow from the loops at the pose
        assert_true(isfinite(difference[9 + p]));
    }
    yk_study_free(study);
    machine_free(&m);
}

// A slider-crank that its slide drives: what closes it is the law of cosines, r^2 + s^2 - 2 r s cos(theta) = l^2. What
// a pose does not give, its place or its rate, is the file's own.
static void test_a_slide_that_drives_leaves_the_closed_form(void **unused)
{
    (void)unused;
    Machine m = machine_parse("parameters: {r: 0.05 m, l: 0.18 m}\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0]}}\n"
                              "  crank: {points: {O: [0, 0], A: [r, 0]}}\n"
                              "  rod: {points: {A: [0, 0], B: [l, 0]}}\n"
                              "  piston: {points: {B: [0, 0]}}\n"
                              "joints:\n"
                              "  O: {pin: [ground, crank], angle: theta}\n"
                              "  A: {pin: [crank, rod], angle: phi}\n"
                              "  B: {pin: [rod, piston]}\n"
                              "  S: {slide: [ground, piston], from: O, to: B, along: x, distance: s}\n"
                              "drives: {s: 0.2 m + 0.1 m/s * t}\n"
                              "start: {theta: 60 deg, phi: -75 deg}\n",
                              true);
    const char *names[] = {"r", "l"}, *of[] = {"theta", "s", "theta.rate"};
    YkStudy *study = study_of(&m, names, 2, of, 3, 1);
    double rate[] = {0.3, -0.2, 0.1}, place[] = {0.2, 0.19, 0.21}, zero = 0;
    for (int k = 0; k < 3; k++) {
        const double *const inputs[] = {k ? &place[k] : NULL, k < 2 ? &rate[k] : NULL, k < 2 ? &zero : NULL};
        assert_int_equal(yk_study_sensitivities(study, inputs, derivative, difference), YK_OK);
        double r = 0.05, l = 0.18, s = place[k], cosine = (r * r + s * s - l * l) / (2 * r * s),
               sine = sqrt(1 - cosine * cosine);
        double by_r = (s * cosine - r) / (r * s * sine), by_l = l / (r * s * sine);
        double by_s = (r * cosine - s) / (r * s * sine), off = 1e-6; // theta' = by_s s'
        CHECK_NEAR(derivative[0], by_r, 1e-8);
        CHECK_NEAR(derivative[1], by_l, 1e-8);
        CHECK_NEAR(difference[0], by_r, 1e-7);
        CHECK_NEAR(difference[1], by_l, 1e-7);
        for (int p = 0; p < 2; p++) CHECK_NEAR(derivative[2 + p], 0, 1e-12);
        double long_l = l + off, c = (r * r + s * s - long_l * long_l) / (2 * r * s);
        double other = (r * c - s) / (r * s * sqrt(1 - c * c));
        CHECK_NEAR(difference[5], (other - by_s) / off * rate[k], 1e-3 * fabs(difference[5]));
    }
    yk_study_free(study);
    machine_free(&m);
}

static void check_machine(const char *file, Machine m, size_t *checked)
{
    const char *names[NAMES_MAX], *of[NAMES_MAX];
    size_t parameters = 0, channels = 0;
    for (size_t p = 0; p < m.model->parameter_count && parameters < NAMES_MAX; p++) {
        YkVariant *v = yk_variant_new(m.mech, &m.model->parameters[p].name, 1, NULL);
        if (v) names[parameters++] = m.model->parameters[p].name;
        yk_variant_free(v);
    }
    for (size_t c = 0; c < yk_coordinate_count(m.mech) && channels < 4; c++)
        of[channels++] = yk_coordinate_info(m.mech, c).name;
    if (parameters == 0 || m.mech->relation_count > 0) {
        machine_free(&m);
        return;
    }
    YkStudy *study = study_of(&m, names, parameters, of, channels, 1);
    YkStatus status = yk_study_sensitivities(study, NULL, derivative, difference);
    for (size_t k = 0; status >= 0 && k < parameters * channels; k++) {
        double size = 1e-7 * (1 + fabs(difference[k]));
        if (!(fabs(derivative[k] - difference[k]) <= size))
            print_error("%s: %s by %s: %.12g, by difference %.12g\n", file, of[k / parameters], names[k % parameters],
                        derivative[k], difference[k]);
        CHECK_NEAR(derivative[k], difference[k], size);
        ++*checked;
    }
    yk_study_free(study);
    machine_free(&m);
}

static void test_both_ways_agree_on_the_examples(void **unused)
{
    (void)unused;
    static const char *const files[] = {
        "four-bar", "quick-return", "drag-link",          "stephenson-six-bar",    "watt-six-bar",
        "five-bar", "hoeken",       "chebyshev",          "inverted-slider-crank", "scotch-yoke",
        "jansen",   "klann",        "offset-slider-crank"};
    size_t checked = 0;
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) check_machine(files[k], machine_load(files[k]), &checked);
    check_machine("triad", machine_parse(TRIAD, true), &checked);
    assert_true(checked > 60);
}

// Of every kind of position: angles of bodies and joints, distances, points, and time, which nothing moves.
static void check_positions(const char *file)
{
    enum { CHANNELS = 40, PARAMETERS = 6 };
    YkChannel channels[CHANNELS] = {{.kind = YK_CHANNEL_TIME}};
    const char *names[PARAMETERS];
    double by[2][CHANNELS * PARAMETERS];
    size_t count = 1, parameters = 0, moved = 0;
    Machine m = machine_load(file);
    for (size_t p = 0; p < m.model->parameter_count && parameters < PARAMETERS; p++) {
        YkVariant *v = yk_variant_new(m.mech, &m.model->parameters[p].name, 1, NULL);
        if (v) names[parameters++] = m.model->parameters[p].name;
        yk_variant_free(v);
    }
    for (size_t b = 1; b < m.model->body_count && count < 12; b++)
        channels[count++] = (YkChannel){.kind = YK_CHANNEL_BODY, .index = (int)b};
    for (size_t j = 0; j < m.model->joint_count && count < 24; j++) {
        YkPartKind kind = m.model->joints[j].kind;
        if (kind == YK_PIN || kind == YK_PIN_SLOT)
            channels[count++] = (YkChannel){.kind = YK_CHANNEL_JOINT_ANGLE, .index = (int)j};
        if (m.mech->joint_distance[j] != YK_NONE)
            channels[count++] = (YkChannel){.kind = YK_CHANNEL_JOINT_DISTANCE, .index = (int)j};
    }
    for (size_t k = 0; k < m.model->point_count && count + 1 < CHANNELS; k++) {
        channels[count++] = (YkChannel){.kind = YK_CHANNEL_POINT_X, .index = (int)k};
        channels[count++] = (YkChannel){.kind = YK_CHANNEL_POINT_Y, .index = (int)k};
    }
    assert_true(parameters > 0);
    YkStudyOptions options = {
        .parameters = names, .parameter_count = parameters, .channels = channels, .channel_count = count};
    YkStudy *study = yk_study_new(m.state, &options, m.problems);
    assert_non_null(study);
    assert_true(yk_study_sensitivities(study, NULL, by[0], by[1]) >= 0);
    for (size_t k = 0; k < count * parameters; k++) {
        double size = fabs(by[1][k]), allowed = 1e-7 * (1 + size);
        if (!(fabs(by[0][k] - by[1][k]) <= allowed))
            print_error("%s: channel kind %d index %d by %s: %.12g, by difference %.12g\n", file,
                        channels[k / parameters].kind, channels[k / parameters].index, names[k % parameters], by[0][k],
                        by[1][k]);
        CHECK_NEAR(by[0][k], by[1][k], allowed);
        moved += size > 1e-3;
    }
    for (size_t p = 0; p < parameters; p++) assert_true(by[0][p] == 0);
    assert_true(moved > parameters);
    yk_study_free(study);
    machine_free(&m);
}

static void test_both_ways_agree_on_every_kind_of_position(void **unused)
{
    (void)unused;
    static const char *const files[] = {"four-bar",    "quick-return",        "inverted-slider-crank",
                                        "scotch-yoke", "offset-slider-crank", "five-bar"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) check_positions(files[k]);
}

// The rod just reaches the block's line; with a crank shorter by a hundredth it does not, which is told.
static void test_a_neighbour_that_does_not_close_is_told(void **unused)
{
    (void)unused;
    Machine m = machine_parse("parameters: {a: 1, b: 1.001}\n"
                              "bodies:\n"
                              "  ground: {points: {O: [0, 0], Q: [2, 0]}}\n"
                              "  crank: {points: {O: [0, 0], A: [a, 0]}}\n"
                              "  rod: {points: {A: [0, 0], B: [b, 0]}}\n"
                              "  block: {points: {B: [0, 0]}}\n"
                              "joints:\n"
                              "  O: {pin: [ground, crank], angle: q}\n"
                              "  A: {pin: [crank, rod], angle: p}\n"
                              "  B: {pin: [rod, block]}\n"
                              "  S: {slide: [ground, block], along: y, from: Q, to: B, distance: y}\n"
                              "drives: {q: 1 rad/s * t}\nstart: {p: 3 deg, y: 0.04}\n",
                              true);
    const char *name = "a", *of = "y";
    YkStudy *study = study_of(&m, &name, 1, &of, 1, 1);
    assert_int_equal(yk_study_sensitivities(study, NULL, derivative, difference), YK_NO_ASSEMBLY);
    yk_study_free(study);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_derivatives_of_a_slider_crank_are_the_closed_form),
        cmocka_unit_test(test_a_slide_that_drives_leaves_the_closed_form),
        cmocka_unit_test(test_both_ways_agree_on_the_examples),
        cmocka_unit_test(test_both_ways_agree_on_every_kind_of_position),
        cmocka_unit_test(test_a_neighbour_that_does_not_close_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
