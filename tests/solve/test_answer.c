// Answers from a pose: bodies' angles one by one, all at once and in a batch, along trees deeper than one piece of a
// way.
#include "compile/ladder.h"
#include "machine.h"

enum { LINKS = 1300, EVERY = 50 };

static double expected[LINKS + 1];

// A chain whose every joint is an input: a body's angle is the sum of those before it.
static void turn_all(Machine *m)
{
    uint64_t seed = 99;
    for (size_t i = 0; i < LINKS; i++) {
        yk_state_set_input(m->state, i, (YkMotion){check_uniform(&seed, -9, 9), check_uniform(&seed, -1, 1), 0});
        expected[i + 1] = expected[i] + yk_state_input(m->state, i).position;
    }
    assert_true(yk_state_solve(m->state) >= 0);
}

static void check_batch(const Machine *m, size_t body)
{
    YkChannel channel = {.kind = YK_CHANNEL_BODY, .index = (int)body};
    YkBatch *batch = yk_batch_new(m->state, &channel, 1);
    double value = NAN, *outputs[] = {&value};
    assert_non_null(batch);
    const double *inputs[3 * LINKS] = {NULL};
    signed char status = 0;
    yk_batch_run(batch, inputs, outputs, &status, 1);
    assert_true(value == yk_state_body(m->state, body).position);
    yk_batch_free(batch);
}

static void angles_of_bodies_have_the_same_bits_however_they_are_asked_for(void **unused)
{
    (void)unused;
    static YkMotion all[LINKS + 1];
    Story story = chain(LINKS);
    Machine m = machine_parse(story.text, true);
    turn_all(&m);
    yk_state_bodies(m.state, all);
    for (size_t b = 0; b <= LINKS; b++) {
        YkMotion one = yk_state_body(m.state, b);
        assert_true(one.position == all[b].position);
        assert_true(one.velocity == all[b].velocity);
        CHECK_NEAR(all[b].position, expected[b], 1e-10);
    }
    for (size_t b = 0; b <= LINKS; b += EVERY) check_batch(&m, b);
    machine_free(&m);
    free(story.text);
}

// The angle between the directions in which a dyad's end can leave: across both arms; across the arm and along the
// line; along a line that turns, and across the way from its pivot. However short an arm is.
static void transmission_angles_have_closed_forms(void **unused)
{
    (void)unused;
    static const char *const lengths[][2] = {
        {"2.5 m", "1.8 m"}, {"1.7e-3 m", "2.2 m"}, {"2.1 m", "1.5e-3 m"}, {"2.1 m", "0.4 m"}};
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
        YkOverride arms[] = {{.name = "b", .value = lengths[k][0]}, {.name = "c", .value = lengths[k][1]}};
        double b = atof(lengths[k][0]), c = atof(lengths[k][1]), d = 2, a = 0.3;
        Machine m = machine_parse_with(
            "parameters: {b: 1 m, c: 1 m}\nbodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n"
            "  crank: {points: {O: [0, 0], A: [0.3, 0]}}\n  coupler: {points: {A: [0, 0], B: [b, 0]}}\n"
            "  rocker: {points: {Q: [0, 0], B: [c, 0]}}\njoints:\n  O: {pin: [ground, crank], angle: th}\n"
            "  A: {pin: [crank, coupler], angle: u}\n  Q: {pin: [ground, rocker], angle: v}\n"
            "  B: {pin: [coupler, rocker]}\ndrives: {th: 1}\nstart: {u: -1, v: 1}\n",
            arms, 2);
        size_t closed = 0;
        for (double th = -3; th < 3; th += 0.004) {
            double l2 = a * a + d * d - 2 * a * d * cos(th), cosine = (b * b + c * c - l2) / (2 * b * c);
            yk_state_set_input(m.state, 0, (YkMotion){th, 1, 0});
            if (!(fabs(cosine) < 0.999)) continue;
            assert_true(yk_state_assemble(m.state) >= 0);
            CHECK_NEAR(sin(yk_state_transmission(m.state, 0)), sqrt(1 - cosine * cosine), 1e-9);
            closed++;
        }
        if (closed == 0) print_error("%s\n", lengths[k][0]);
        assert_true(closed > 0);
        machine_free(&m);
    }
    Machine m = machine_parse(
        "bodies:\n  ground: {points: {O: [0, 0], C: [2, 0]}}\n  crank: {points: {O: [0, 0], A: [0.9, 0]}}\n"
        "  lever: {points: {C: [0, 0], F: [0, 0.2]}}\njoints:\n  O: {pin: [ground, crank], angle: th}\n"
        "  C: {pin: [ground, lever], angle: u}\n"
        "  A: {pin-slot: [lever, crank], along: x, from: F, at: A}\ndrives: {th: 1}\nstart: {u: 2}\n",
        true);
    for (double th = 0; th < 6; th += 0.1) { // the pin on its line, which passes the pivot at 0.2
        double K = hypot(2 - 0.9 * cos(th), 0.9 * sin(th));
        assert_int_equal(machine_solve(&m, th, 1, 0), YK_OK);
        CHECK_NEAR(yk_state_transmission(m.state, 0), asin(sqrt(1 - pow(0.2 / K, 2))), 1e-9);
    }
    machine_free(&m);
    m = machine_load("offset-slider-crank");
    for (double th = 0; th < 6; th += 0.1) {
        assert_int_equal(machine_solve(&m, th, 1, 0), YK_OK);
        double rod = fmod(machine_ask(&m, "rod.angle"), YK_PI);
        CHECK_NEAR(sin(yk_state_transmission(m.state, 0)), fabs(cos(rod)), 1e-9); // the guide is along x
    }
    machine_free(&m);
}

// Whatever room there is, a label is cut to fit and ends, and its whole length is told.
static void labels_fit_their_room(void **unused)
{
    (void)unused;
    Machine m = machine_load("jansen");
    char whole[200], text[200];
    size_t length = yk_state_label(m.state, whole, sizeof whole);
    assert_int_equal(length, strlen(whole));
    for (size_t room = 0; room <= length + 2; room++) {
        memset(text, '#', sizeof text);
        assert_int_equal(yk_state_label(m.state, text, room), length);
        if (room > 0) assert_int_equal(strlen(text), room <= length ? room - 1 : length);
        if (room > 0) assert_memory_equal(text, whole, strlen(text));
        for (size_t k = room; k < sizeof text; k++) assert_true(text[k] == '#');
    }
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles_of_bodies_have_the_same_bits_however_they_are_asked_for),
        cmocka_unit_test(transmission_angles_have_closed_forms),
        cmocka_unit_test(labels_fit_their_room),
    };
    return cmocka_run_group_tests_name("solve/answer", tests, NULL, NULL);
}
