// One pose: rates against differences of positions, dead points at every distance, statuses, copies and inputs.
#include "machine.h"
#include "compile/mechanism.h"

// --- rates against differences
// --------------------------------------------------------------------------------------------

enum { CHANNELS_MAX = 512 };
typedef struct Channels {
    YkChannel of[CHANNELS_MAX];
    size_t count;
} Channels;

static void add(Channels *c, YkChannelKind kind, size_t index)
{
    if (c->count < CHANNELS_MAX) c->of[c->count++] = (YkChannel){.kind = kind, .index = (int)index};
}

// All that moves smoothly.
static Channels all_channels(const Machine *m)
{
    Channels c = {.count = 0};
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) add(&c, YK_CHANNEL_COORDINATE, k);
    for (size_t k = 0; k < yk_model_body_count(m->model); k++) add(&c, YK_CHANNEL_BODY, k);
    for (size_t k = 0; k < yk_model_joint_count(m->model); k++) {
        YkPartKind kind = m->model->joints[k].kind;
        if (kind == YK_PIN || kind == YK_PIN_SLOT) add(&c, YK_CHANNEL_JOINT_ANGLE, k);
        if (m->mech->joint_distance[k] != YK_NONE) add(&c, YK_CHANNEL_JOINT_DISTANCE, k);
    }
    for (size_t k = 0; k < yk_model_point_count(m->model); k++) {
        add(&c, YK_CHANNEL_POINT_X, k);
        add(&c, YK_CHANNEL_POINT_Y, k);
    }
    return c;
}

static double least_sine(const Machine *m)
{
    double least = 1;
    for (size_t b = 0; b < yk_block_count(m->mech); b++) {
        YkBlockKind kind = yk_block_info(m->mech, b).kind;
        if (kind <= YK_BLOCK_PP) least = fmin(least, sin(yk_state_transmission(m->state, b)));
    }
    return least;
}

// Every input on its own parabola in time, at time t.
static bool solve_at(const Machine *m, const YkMotion *start, double t)
{
    for (size_t i = 0; i < yk_input_count(m->mech); i++) {
        YkMotion s = start[i];
        yk_state_set_input(m->state, i,
                           (YkMotion){s.position + t * (s.velocity + 0.5 * t * s.acceleration),
                                      s.velocity + t * s.acceleration, s.acceleration});
    }
    return yk_state_solve(m->state) >= 0;
}

static const double h = 5e-4; // s: the inputs move about 1 rad/s

static void check_channel(const char *file, YkChannel c, const double v[5], double rate, double accel, double size)
{
    double slope = (v[0] - 8 * v[1] + 8 * v[3] - v[4]) / (12 * h);
    double bend = (-v[0] + 16 * v[1] - 30 * v[2] + 16 * v[3] - v[4]) / (12 * h * h);
    double most = fmax(size, fmax(fabs(rate), sqrt(fabs(accel) * size)));
    if (fabs(rate - slope) > 1e-7 * most ||
        fabs(accel - bend) > 1e-7 * fmax(most, fabs(accel)) + 1e-13 * size / (h * h))
        print_error("%s: channel kind %d index %d: %.12g for %.12g, %.12g for %.12g\n", file, c.kind, c.index, rate,
                    slope, accel, bend);
    CHECK_NEAR(rate, slope, 1e-7 * most);
    CHECK_NEAR(accel, bend, 1e-7 * fmax(most, fabs(accel)) + 1e-13 * size / (h * h));
}

static void check_differences(const char *file, const Machine *m, const YkMotion *start, const Channels *channels)
{
    static double values[5][CHANNELS_MAX], rate[CHANNELS_MAX], accel[CHANNELS_MAX];
    for (int k = 0; k < 5; k++) {
        if (!solve_at(m, start, (k - 2) * h)) return;
        for (size_t c = 0; c < channels->count; c++) values[k][c] = yk_state_channel(m->state, channels->of[c]);
    }
    assert_true(solve_at(m, start, 0));
    for (size_t c = 0; c < channels->count; c++) {
        YkChannel channel = channels->of[c];
        channel.order = 1;
        rate[c] = yk_state_channel(m->state, channel);
        channel.order = 2;
        accel[c] = yk_state_channel(m->state, channel);
    }
    double size = yk_mechanism_size(m->mech);
    for (size_t c = 0; c < channels->count; c++) // so bent that five points in 2 ms tell little
        if (fabs(accel[c]) > 20 * fmax(size, 1)) return;
    for (size_t c = 0; c < channels->count; c++) {
        YkChannel channel = channels->of[c];
        bool is_length = channel.kind == YK_CHANNEL_POINT_X || channel.kind == YK_CHANNEL_POINT_Y ||
                         channel.kind == YK_CHANNEL_JOINT_DISTANCE ||
                         (channel.kind == YK_CHANNEL_COORDINATE && m->mech->coordinates[channel.index].is_distance);
        double v[5] = {values[0][c], values[1][c], values[2][c], values[3][c], values[4][c]};
        check_channel(file, channel, v, rate[c], accel[c], is_length ? size : 1);
    }
}

static void check_example(const char *file)
{
    Machine m = machine_load(file);
    Channels channels = all_channels(&m);
    YkMotion start[8];
    size_t inputs = yk_input_count(m.mech), checked = 0;
    assert_true(inputs <= 8);
    double size = yk_mechanism_size(m.mech);
    for (size_t i = 0; i < inputs; i++) start[i] = yk_state_input(m.state, i);
    for (int k = 0; inputs > 0 && k < 24; k++) {
        for (size_t i = 0; i < inputs; i++) {
            double unit = yk_coordinate_info(m.mech, yk_input_coordinate(m.mech, i)).is_distance ? 0.1 * size : 1;
            start[i].velocity = unit * (0.7 + 0.2 * (double)i);
            start[i].acceleration = unit * (0.4 - 0.3 * (double)i);
        }
        if (!solve_at(&m, start, 0)) break;
        if (least_sine(&m) > 0.2) {
            check_differences(file, &m, start, &channels);
            checked++;
        }
        for (size_t i = 0; i < inputs; i++) start[i].position += 0.15 * start[i].velocity;
    }
    if (checked == 0) print_error("%s: nothing checked\n", file);
    assert_true(checked > 0 || inputs == 0);
    machine_free(&m);
}

static void test_rates_are_the_differences_of_positions_in_every_example(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < EXAMPLE_COUNT; k++) check_example(all_examples[k]);
}

// --- dead points
// ----------------------------------------------------------------------------------------------------------

// The rocker as input of a crank-rocker: it is dead where crank and coupler are in line.
static const char rocker_driven[] = "parameters: {a: 0.5, b: 1.2, c: 0.8, d: 1}\n"
                                    "bodies:\n"
                                    "  ground:  {points: {O2: [0, 0], O4: [d, 0]}}\n"
                                    "  crank:   {points: {O2: [0, 0], A: [a, 0]}}\n"
                                    "  coupler: {points: {A: [0, 0], B: [b, 0]}}\n"
                                    "  rocker:  {points: {O4: [0, 0], B: [c, 0]}}\n"
                                    "joints:\n"
                                    "  O2: {pin: [ground, crank], angle: theta2}\n"
                                    "  A:  {pin: [crank, coupler], angle: gamma}\n"
                                    "  O4: {pin: [ground, rocker], angle: theta4}\n"
                                    "  B:  {pin: [coupler, rocker]}\n"
                                    "start: {theta4: 110 deg, theta2: 50 deg, gamma: 0}\n";

static void test_nothing_is_nan_at_any_distance_from_a_dead_point(void **unused)
{
    (void)unused;
    // crank and coupler folded: |O2 B| = b - a = 0.7, so cos(theta4) = (0.7^2 - c^2 - d^2) / (2 c d) from O4 ... by
    // cosines
    double dead = acos((0.7 * 0.7 - 0.64 - 1) / (2 * 0.8));
    double stretched = acos((1.7 * 1.7 - 0.64 - 1) / (2 * 0.8));
    for (int side = 0; side < 2; side++)
        for (int inward = -1; inward <= 1; inward += 2)
            for (double off = 1e-1; off > 1e-17; off *= 0.1) {
                Machine m = machine_parse(rocker_driven, true);
                double at = (side ? stretched : dead) + inward * off, inside = side ? inward : -inward;
                YkStatus status = machine_solve(&m, at, 1, 0);
                const YkReport *report = yk_state_report(m.state);
                // the sine of the transmission angle grows as the root of the distance: 1e-7 about 1e-14 rad away
                if (inside > 0 && off >= 1e-12) assert_int_equal(status, YK_OK);
                if (inside < 0 && off >= 1e-12) assert_int_equal(status, YK_LIMIT);
                if (status == YK_OK) assert_true(yk_state_has_rates(m.state));
                if (status == YK_SINGULAR) {
                    assert_false(yk_state_has_rates(m.state));
                    assert_true(report->determinant >= 0 && report->determinant <= 1.01e-7);
                    assert_int_equal(report->block, 0);
                    assert_non_null(strstr(report->message, "`B`"));
                    CHECK_NEAR(machine_ask(&m, "theta2.rate"), 0, 0);
                }
                if (status == YK_LIMIT) assert_true(report->gap >= 0 && report->block == 0);
                static const char *const names[] = {"theta2",         "theta2.rate",        "theta2.accel",
                                                    "gamma",          "coupler.B.x",        "coupler.B.speed",
                                                    "B.transmission", "coupler.angle.accel"};
                for (size_t k = 0; k < sizeof names / sizeof names[0]; k++)
                    assert_true(isfinite(machine_ask(&m, names[k])));
                YkResiduals r = yk_state_residuals(m.state);
                assert_true(r.position <= 1e-12 && isfinite(r.velocity) && isfinite(r.acceleration));
                machine_free(&m);
            }
}

static void test_a_pose_beyond_a_limit_keeps_the_last_and_says_by_how_much(void **unused)
{
    (void)unused;
    Machine m = machine_parse(rocker_driven, true);
    assert_int_equal(machine_solve(&m, 1.6, 1, 0), YK_OK);
    double theta2 = machine_ask(&m, "theta2"), rate = machine_ask(&m, "theta2.rate");
    assert_int_equal(machine_solve(&m, 0.2, 3, 0), YK_LIMIT);
    CHECK_NEAR(machine_ask(&m, "theta2"), theta2, 0);
    CHECK_NEAR(machine_ask(&m, "theta2.rate"), rate, 0);
    CHECK_NEAR(machine_ask(&m, "theta4"), 1.6, 0); // the pose's own input, not the one that failed
    const YkReport *report = yk_state_report(m.state);
    double reach = hypot(1 + 0.8 * cos(0.2), 0.8 * sin(0.2));
    CHECK_NEAR(report->gap, reach - 1.7, 1e-12);
    assert_string_equal(yk_block_info(m.mech, (size_t)report->block).label, "B");
    assert_int_equal(machine_solve(&m, 1.6, 1, 0), YK_OK);
    CHECK_NEAR(machine_ask(&m, "theta2"), theta2, 1e-15);
    machine_free(&m);
}

static void test_inputs_that_are_no_numbers_are_refused_with_a_status(void **unused)
{
    (void)unused;
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e300, -1e308};
    static const char *const files[] = {
        "four-bar",         "slider-crank",       "excavator",        "oscillating-cylinder",
        "elliptic-trammel", "stephenson-awkward", "double-butterfly", "three-crank-parallelogram"};
    for (size_t f = 0; f < sizeof files / sizeof files[0]; f++)
        for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
            Machine m = machine_load(files[f]);
            double start = yk_state_input(m.state, 0).position;
            YkStatus status = machine_solve(&m, bad[k], 1, 0);
            if (!isfinite(bad[k]) && status >= 0)
                print_error("%s with %g: %s\n", files[f], bad[k], yk_status_name(status));
            if (!isfinite(bad[k])) assert_true(status < 0);
            YkResiduals r = yk_state_residuals(m.state);
            assert_true(isfinite(r.position) && isfinite(r.velocity) && isfinite(r.acceleration));
            if (status < 0) assert_true(machine_solve(&m, start, 1, 0) >= 0); // and it goes on
            machine_free(&m);
        }
}

// Nothing but the inputs decides about an open chain.
static void test_one_number_of_any_input_that_is_none_refuses_the_pose(void **unused)
{
    (void)unused;
    Machine m = machine_load("double-pendulum");
    assert_int_equal(yk_input_count(m.mech), 2);
    for (size_t k = 0; k < 6; k++) {
        YkMotion good = yk_state_input(m.state, k / 3), bad = good;
        double *const numbers[] = {&bad.position, &bad.velocity, &bad.acceleration};
        *numbers[k % 3] = NAN;
        yk_state_set_input(m.state, k / 3, bad);
        assert_true(yk_state_solve(m.state) < 0);
        yk_state_set_input(m.state, k / 3, good);
        assert_int_equal(yk_state_solve(m.state), YK_OK);
    }
    machine_free(&m);
}

// --- copies, inputs, reference
// --------------------------------------------------------------------------------------------

static void test_a_copy_answers_alike_and_goes_its_own_way(void **unused)
{
    (void)unused;
    static const char *const files[] = {"jansen", "double-butterfly"};
    for (size_t f = 0; f < 2; f++) {
        Machine m = machine_load(files[f]);
        YkState *copy = yk_state_new(m.mech);
        assert_int_equal(yk_state_copy(copy, m.state), YK_OK);
        for (size_t c = 0; c < yk_coordinate_count(m.mech); c++)
            CHECK_NEAR(yk_state_coordinate(copy, c).acceleration, yk_state_coordinate(m.state, c).acceleration, 0);
        double start = yk_state_input(m.state, 0).position, before = yk_state_coordinate(m.state, 1).position;
        yk_state_set_input(copy, 0, (YkMotion){start + 0.2, 1, 0});
        assert_true(yk_state_solve(copy) >= 0);
        CHECK_NEAR(yk_state_coordinate(m.state, 1).position, before, 0);
        assert_true(machine_solve(&m, start + 0.2, 1, 0) >= 0);
        for (size_t c = 0; c < yk_coordinate_count(m.mech); c++)
            CHECK_NEAR(yk_state_coordinate(copy, c).position, yk_state_coordinate(m.state, c).position, 1e-14);
        Machine other = machine_load("four-bar");
        assert_int_equal(yk_state_copy(copy, other.state), YK_BAD_ARGUMENT);
        yk_state_free(copy);
        machine_free(&other);
        machine_free(&m);
    }
}

static void test_time_sets_the_drives_with_their_derivatives(void **unused)
{
    (void)unused;
    Machine m = machine_load("five-bar");
    for (double t = 0; t < 3; t += 0.37) {
        assert_int_equal(yk_state_set_time(m.state, t, m.problems), YK_OK);
        YkMotion a = yk_state_input(m.state, 0), b = yk_state_input(m.state, 1);
        double w = 20 * YK_PI / 180;
        CHECK_NEAR(a.position, 120 * YK_PI / 180 + w * sin(2 * t), 1e-14);
        CHECK_NEAR(a.velocity, 2 * w * cos(2 * t), 1e-14);
        CHECK_NEAR(a.acceleration, -4 * w * sin(2 * t), 1e-14);
        CHECK_NEAR(b.velocity, 0.3 - 0.2 * t, 1e-14);
        CHECK_NEAR(b.acceleration, -0.2, 1e-14);
        CHECK_NEAR(yk_state_time(m.state), t, 0);
    }
    machine_free(&m);
}

static void test_held_coordinates_start_with_their_values_and_rates(void **unused)
{
    (void)unused;
    Machine m = machine_load("toggle"); // theta1 held at 70 deg, 3 rad/s
    CHECK_NEAR(yk_state_input(m.state, 0).position, 70 * YK_PI / 180, 1e-15);
    CHECK_NEAR(yk_state_input(m.state, 0).velocity, 3, 0);
    CHECK_NEAR(yk_state_input(m.state, 0).acceleration, 0, 0);
    machine_free(&m);
}

static void test_setting_the_other_branch_solves_the_other_assembly(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    int branch = yk_state_branch(m.state, 0);
    assert_true(branch == 1 || branch == -1);
    yk_state_set_branch(m.state, 0, -branch);
    assert_int_equal(yk_state_solve(m.state), YK_OK);
    CHECK_NEAR(machine_ask(&m, "theta4") * 180 / YK_PI, -98.00, 1e-2); // Norton, example 4-1, crossed
    char label[16];
    assert_int_equal(yk_state_label(m.state, label, sizeof label), 2);
    assert_string_equal(label, branch > 0 ? "B-" : "B+");
    machine_free(&m);
}

static void turn_crank(YkState *state, double by)
{
    YkMotion in = yk_state_input(state, 0);
    in.position += by;
    yk_state_set_input(state, 0, in);
    assert_int_equal(yk_state_solve(state), YK_OK);
}

static void test_poses_are_compared_up_to_whole_turns(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar"), slider = machine_load("slider-crank");
    YkState *other = yk_state_new(m.mech);
    assert_non_null(other);
    assert_false(yk_state_is_at(m.state, other)); // it has no pose
    assert_false(yk_state_is_at(NULL, m.state));
    assert_false(yk_state_is_at(m.state, slider.state));
    assert_int_equal(yk_state_copy(other, m.state), YK_OK);
    assert_true(yk_state_is_at(m.state, other));
    turn_crank(other, 2 * YK_PI);
    assert_true(yk_state_is_at(m.state, other));
    turn_crank(other, 1e-5);
    assert_false(yk_state_is_at(m.state, other));
    turn_crank(other, -1e-5);
    yk_state_set_branch(other, 0, -yk_state_branch(other, 0));
    assert_int_equal(yk_state_solve(other), YK_OK);
    assert_false(yk_state_is_at(m.state, other)); // the other assembly
    yk_state_free(other);
    machine_free(&slider);
    machine_free(&m);
}

// Of a branch only the sign counts, and 0 is none; there is none behind the last block.
static void a_branch_is_a_sign(void **unused)
{
    (void)unused;
    static const int branches[] = {1, -1, 0, 5, -3};
    Machine m = machine_load("four-bar");
    for (size_t k = 0; k < sizeof branches / sizeof *branches; k++) {
        yk_state_set_branch(m.state, 0, branches[k]);
        assert_int_equal(yk_state_branch(m.state, 0), (branches[k] > 0) - (branches[k] < 0));
    }
    assert_int_equal(yk_state_branch(m.state, yk_block_count(m.mech)), 0);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rates_are_the_differences_of_positions_in_every_example),
        cmocka_unit_test(test_nothing_is_nan_at_any_distance_from_a_dead_point),
        cmocka_unit_test(test_a_pose_beyond_a_limit_keeps_the_last_and_says_by_how_much),
        cmocka_unit_test(test_inputs_that_are_no_numbers_are_refused_with_a_status),
        cmocka_unit_test(test_one_number_of_any_input_that_is_none_refuses_the_pose),
        cmocka_unit_test(test_a_copy_answers_alike_and_goes_its_own_way),
        cmocka_unit_test(test_time_sets_the_drives_with_their_derivatives),
        cmocka_unit_test(test_held_coordinates_start_with_their_values_and_rates),
        cmocka_unit_test(test_setting_the_other_branch_solves_the_other_assembly),
        cmocka_unit_test(test_poses_are_compared_up_to_whole_turns),
        cmocka_unit_test(a_branch_is_a_sign),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
