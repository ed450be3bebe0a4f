// Batches: bit for bit one pose a call, over every channel; lanes that do not close, blocks that are not full.
#include "solve/machine.h"
#include "compile/mechanism.h"

enum { POSES = 777, CHANNELS_MAX = 400, INPUTS_MAX = 12 };
static double inputs[INPUTS_MAX][POSES], outputs[CHANNELS_MAX][POSES];
static signed char status[POSES];
static YkChannel channels[CHANNELS_MAX];
static size_t channel_count;

static void add(YkChannelKind kind, size_t index, int orders)
{
    for (int order = 0; order < orders && channel_count < CHANNELS_MAX; order++)
        channels[channel_count++] = (YkChannel){.kind = kind, .index = (int)index, .order = order};
}

static void list_channels(const Machine *m, bool transmission)
{
    channel_count = 0;
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) add(YK_CHANNEL_COORDINATE, k, 3);
    for (size_t k = 0; k < yk_model_body_count(m->model); k++) add(YK_CHANNEL_BODY, k, 3);
    for (size_t k = 0; k < yk_model_joint_count(m->model); k++) {
        YkPartKind kind = m->model->joints[k].kind;
        if (kind == YK_PIN || kind == YK_PIN_SLOT) add(YK_CHANNEL_JOINT_ANGLE, k, 3);
        if (m->mech->joint_distance[k] != YK_NONE) add(YK_CHANNEL_JOINT_DISTANCE, k, 3);
    }
    for (size_t k = 0; k < yk_model_point_count(m->model); k++) {
        add(YK_CHANNEL_POINT_X, k, 3);
        add(YK_CHANNEL_POINT_Y, k, 3);
        add(YK_CHANNEL_POINT_SPEED, k, 1);
    }
    for (size_t k = 0; transmission && k < yk_block_count(m->mech); k++)
        if (yk_block_info(m->mech, k).kind <= YK_BLOCK_RPR) add(YK_CHANNEL_TRANSMISSION, k, 1);
    add(YK_CHANNEL_TIME, 0, 1); // last: the first channel is one that a pose changes
}

// Random inputs about the state's own: `spread` radians, or that part of a length.
static void draw_inputs(const Machine *m, double spread, uint64_t *seed)
{
    for (size_t i = 0; i < yk_input_count(m->mech); i++) {
        YkMotion at = yk_state_input(m->state, i);
        bool is_distance = yk_coordinate_info(m->mech, yk_input_coordinate(m->mech, i)).is_distance;
        double reach = is_distance ? spread * 0.2 * at.position : spread;
        for (size_t k = 0; k < POSES; k++) {
            inputs[3 * i][k] = at.position + check_uniform(seed, -reach, reach);
            inputs[3 * i + 1][k] = check_uniform(seed, -3, 3);
            inputs[3 * i + 2][k] = check_uniform(seed, -3, 3);
        }
    }
}

static YkStatus run(YkBatch *batch, const Machine *m, bool with_status, size_t count)
{
    const double *in[INPUTS_MAX];
    double *out[CHANNELS_MAX];
    for (size_t i = 0; i < 3 * yk_input_count(m->mech); i++) in[i] = inputs[i];
    for (size_t c = 0; c < channel_count; c++) out[c] = outputs[c];
    return yk_batch_run(batch, in, out, with_status ? status : NULL, count);
}

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a == 0 && b == 0);
}

// A pose of the batch against a state that solves it.
static void check_pose(const char *file, const Machine *m, size_t k)
{
    for (size_t i = 0; i < yk_input_count(m->mech); i++)
        yk_state_set_input(m->state, i, (YkMotion){inputs[3 * i][k], inputs[3 * i + 1][k], inputs[3 * i + 2][k]});
    YkStatus one = yk_state_solve(m->state);
    YkStatus due = one == YK_REDUNDANT ? YK_OK : one < 0 ? YK_LIMIT : one;
    assert_int_equal(status[k], due);
    for (size_t c = 0; c < channel_count; c++) {
        double value = due < 0 ? 0 : yk_state_channel(m->state, channels[c]);
        assert_true(isfinite(outputs[c][k]));
        if (!same_bits(outputs[c][k], value))
            print_error("%s pose %zu (status %d): channel kind %d index %d order %d is %.17g, alone %.17g\n", file, k,
                        status[k], channels[c].kind, channels[c].index, channels[c].order, outputs[c][k], value);
        assert_true(same_bits(outputs[c][k], value));
    }
}

// The same, one pose a call: channels then come from a space of their own.
static void check_call(const char *file, YkBatch *batch, const Machine *m, size_t k)
{
    const double *in[INPUTS_MAX];
    double *out[CHANNELS_MAX];
    for (size_t i = 0; i < 3 * yk_input_count(m->mech); i++) in[i] = inputs[i] + k;
    for (size_t c = 0; c < channel_count; c++) *(out[c] = outputs[c] + k) = 12345;
    YkStatus worst = yk_batch_run(batch, in, out, status + k, 1);
    assert_int_equal(worst, status[k]);
    check_pose(file, m, k);
}

static void check_machine(const char *file, double spread, bool transmission)
{
    Machine m = machine_load(file);
    uint64_t seed = 99;
    assert_true(3 * yk_input_count(m.mech) <= INPUTS_MAX);
    list_channels(&m, transmission);
    draw_inputs(&m, spread, &seed);
    inputs[0][POSES / 2] = NAN; // one lane is nonsense: the others do not care
    inputs[0][POSES / 3] = INFINITY;
    YkBatch *batch = yk_batch_new(m.state, channels, channel_count);
    assert_non_null(batch);
    YkStatus worst = run(batch, &m, true, POSES);
    assert_int_equal(worst, YK_LIMIT);
    for (size_t k = 0; k < POSES; k++) check_pose(file, &m, k);
    for (size_t k = 0; k < POSES; k += 37) check_call(file, batch, &m, k);
    yk_batch_free(batch);
    machine_free(&m);
}

static void test_a_batch_gives_the_bits_of_single_poses(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < EXAMPLE_COUNT; k++) {
        if (!strcmp(all_examples[k], "double-butterfly") || !strcmp(all_examples[k], "stephenson-awkward")) continue;
        check_machine(all_examples[k], 0.3, false);
        check_machine(all_examples[k], 3, false); // past limits, and over turns
    }
}

static void test_a_batch_with_transmission_angles_gives_the_same_bits(void **unused)
{
    (void)unused;
    check_machine("quick-return", 2, true);
    check_machine("jansen", 2, true);
}

static void test_a_batch_of_a_group_solves_each_pose_from_the_first(void **unused)
{
    (void)unused;
    Machine m = machine_load("stephenson-awkward");
    uint64_t seed = 5;
    list_channels(&m, false);
    draw_inputs(&m, 0.4, &seed);
    YkBatch *batch = yk_batch_new(m.state, channels, channel_count);
    run(batch, &m, true, 60);
    YkState *home = yk_state_new(m.mech);
    yk_state_copy(home, m.state);
    for (size_t k = 0; k < 60; k++) {
        yk_state_copy(m.state, home);
        check_pose("stephenson-awkward", &m, k);
    }
    yk_state_free(home);
    yk_batch_free(batch);
    machine_free(&m);
}

static void test_any_count_of_poses_is_the_same_poses(void **unused)
{
    (void)unused;
    static const size_t counts[] = {0, 1, 2, 7, 8, 9, 63, 64, 65, 127, 128, 129, 255, 256, 257, 500, POSES};
    static double whole[CHANNELS_MAX][POSES];
    Machine m = machine_load("quick-return");
    uint64_t seed = 7;
    list_channels(&m, false);
    draw_inputs(&m, 1, &seed);
    YkBatch *batch = yk_batch_new(m.state, channels, channel_count);
    run(batch, &m, true, POSES);
    memcpy(whole, outputs, sizeof whole);
    for (size_t n = 0; n < sizeof counts / sizeof counts[0]; n++) {
        for (size_t c = 0; c < channel_count; c++)
            for (size_t k = 0; k < POSES; k++) outputs[c][k] = 12345;
        run(batch, &m, n % 2 == 0, counts[n]);
        for (size_t c = 0; c < channel_count; c++)
            for (size_t k = 0; k < POSES; k++) // and nothing is written past the end
                assert_true(same_bits(outputs[c][k], k < counts[n] ? whole[c][k] : 12345));
    }
    yk_batch_free(batch);
    machine_free(&m);
}

static void test_a_missing_input_stands_for_the_states_own(void **unused)
{
    (void)unused;
    Machine m = machine_load("five-bar");
    uint64_t seed = 11;
    list_channels(&m, false);
    draw_inputs(&m, 0.2, &seed);
    yk_state_set_input(m.state, 1, (YkMotion){yk_state_input(m.state, 1).position, 0.25, -0.5});
    assert_true(yk_state_solve(m.state) >= 0);
    YkMotion own[2] = {yk_state_input(m.state, 0), yk_state_input(m.state, 1)};
    YkBatch *batch = yk_batch_new(m.state, channels, channel_count);
    const double *in[6] = {inputs[0], NULL, inputs[2], NULL, inputs[4], NULL};
    double *out[CHANNELS_MAX];
    for (size_t c = 0; c < channel_count; c++) out[c] = outputs[c];
    yk_batch_run(batch, in, out, status, POSES);
    for (size_t k = 0; k < POSES; k++) {
        inputs[1][k] = own[0].velocity;
        inputs[3][k] = own[1].position;
        inputs[5][k] = own[1].acceleration;
    }
    for (size_t k = 0; k < POSES; k += 5) check_pose("five-bar", &m, k);
    yk_batch_free(batch);
    machine_free(&m);
}

// Wherever the rows begin in their cache lines, and however many poses there are, each is computed, and nothing beside
// them.
static void test_rows_may_begin_anywhere(void **unused)
{
    (void)unused;
    enum { ROOM = POSES + 31 }; // a multiple of 8, so that all rows begin alike
    static _Alignas(64) double rows[CHANNELS_MAX][ROOM];
    Machine m = machine_load("quick-return");
    uint64_t seed = 17;
    list_channels(&m, false);
    draw_inputs(&m, 3, &seed);
    YkBatch *batch = yk_batch_new(m.state, channels, channel_count);
    const double *in[] = {inputs[0], inputs[1], inputs[2]};
    double *out[CHANNELS_MAX];
    run(batch, &m, true, POSES);
    const size_t counts[] = {127, 128, 129, 192, 193, 256, 257, 260, 384, 511, 513, 700, POSES};
    for (size_t k = 0; k < 10 * sizeof counts / sizeof *counts; k++) {
        size_t count = counts[k / 10], shift = k % 10;
        memset(rows, 0xff, sizeof rows); // NaN
        for (size_t c = 0; c < channel_count; c++) out[c] = rows[c] + shift % 9 + (shift == 9 && c == 1);
        yk_batch_run(batch, in, out, NULL, count);
        for (size_t c = 0; c < channel_count; c++) {
            for (size_t i = 0; i < count; i++) assert_true(same_bits(out[c][i], outputs[c][i]));
            assert_true(isnan(out[c][count]) && (out[c] == rows[c] || isnan(out[c][-1])));
        }
    }
    yk_batch_free(batch);
    machine_free(&m);
}

// The references are those of the state, not of the pose in which it happens to stand.
static void test_angles_come_out_on_the_states_turn(void **unused)
{
    (void)unused;
    Machine m = machine_load("drag-link");
    list_channels(&m, false);
    YkSweep *sweep = machine_sweep(&m, "theta2", YK_PI / 2, YK_PI / 2 + 7 * YK_PI, 10, NULL, 0);
    uint64_t seed = 3;
    draw_inputs(&m, 3, &seed);
    for (int pass = 0; pass < 2; pass++) {
        YkBatch *batch = yk_batch_new(m.state, channels, channel_count);
        run(batch, &m, true, POSES);
        for (size_t k = 0; k < POSES; k++) check_pose("drag-link", &m, k);
        yk_batch_free(batch); // now the state stands at the last pose; its reference is where the sweep ended
    }
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void test_the_worst_status_is_returned(void **unused)
{
    (void)unused;
    Machine m = machine_load("non-grashof");
    YkChannel of[3] = {machine_channel(&m, "theta4"), machine_channel(&m, "theta4.rate"),
                       machine_channel(&m, "theta2.rate")};
    memcpy(channels, of, sizeof of);
    channel_count = 3;
    YkBatch *batch = yk_batch_new(m.state, channels, 3);
    double limit = acos(-0.44);
    for (size_t k = 0; k < POSES; k++) inputs[0][k] = 0.5 + (double)k / POSES;
    for (size_t k = 0; k < POSES; k++) inputs[1][k] = 1;
    memset(inputs[2], 0, sizeof inputs[2]);
    assert_int_equal(run(batch, &m, true, POSES), YK_OK);
    // one of the last values that close: within the width of a dead point
    double at = limit - 1e-6;
    while (nextafter(at, 3) < limit && machine_solve(&m, at, 1, 0) == YK_OK) at += 1e-16 + 0.5 * (limit - at);
    inputs[0][100] = at;
    YkStatus due = machine_solve(&m, at, 1, 0);
    assert_int_equal(due, YK_SINGULAR);
    assert_int_equal(run(batch, &m, true, POSES), YK_SINGULAR);
    assert_int_equal(status[100], YK_SINGULAR);
    check_pose("non-grashof", &m, 100);
    assert_true(outputs[1][100] == 0 && outputs[0][100] != 0);
    inputs[0][101] = limit + 0.1;
    assert_int_equal(run(batch, &m, true, POSES), YK_LIMIT);
    assert_int_equal(status[101], YK_LIMIT);
    assert_true(outputs[0][101] == 0);
    assert_int_equal(status[102], YK_OK);
    yk_batch_free(batch);
    machine_free(&m);
}

// A kite whose crank is as long as its ground: at 0 its moving pin lies on the rocker's, whose angle no loop
// determines. There and close by, a state settles the lane; its neighbours are not disturbed.
static void test_lanes_where_pins_coincide_are_those_of_a_state(void **unused)
{
    (void)unused;
    static const double near[] = {0, 1e-15, -1e-12, 1e-9, -1e-7, 1e-5, 2 * YK_PI, 4 * YK_PI, YK_PI};
    enum { NEAR = sizeof near / sizeof *near };
    Machine m = machine_parse("bodies:\n"
                              "  ground: {points: {O2: [0, 0], O4: [1, 0]}}\n"
                              "  crank: {points: {O2: [0, 0], A: [1, 0]}}\n"
                              "  coupler: {points: {A: [0, 0], B: [2, 0]}}\n"
                              "  rocker: {points: {O4: [0, 0], B: [2, 0], P: [1, 1]}}\n"
                              "joints:\n"
                              "  O2: {pin: [ground, crank], angle: theta2}\n"
                              "  A: {pin: [crank, coupler], angle: gamma}\n"
                              "  O4: {pin: [ground, rocker], angle: theta4}\n"
                              "  B: {pin: [coupler, rocker]}\n"
                              "drives: {theta2: 60 deg + 1 rad/s * t}\n"
                              "start: {gamma: 20 deg, theta4: 100 deg}\n",
                              true);
    uint64_t seed = 4;
    size_t settled = 0;
    list_channels(&m, false);
    draw_inputs(&m, 0.5, &seed);
    for (size_t k = 0; k < NEAR; k++) inputs[0][17 * k + 3] = near[k];
    YkBatch *batch = yk_batch_new(m.state, channels, channel_count);
    YkState *home = yk_state_new(m.mech);
    assert_true(batch && home);
    yk_state_copy(home, m.state);
    run(batch, &m, true, POSES);
    for (size_t k = 0; k < POSES; k++) {
        yk_state_copy(m.state, home);
        check_pose("kite", &m, k);
        settled += status[k] != YK_OK;
    }
    assert_int_equal(settled, NEAR - 1); // at half a turn it is stretched, and closes as any other
    yk_state_free(home);
    yk_batch_free(batch);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_batch_gives_the_bits_of_single_poses),
        cmocka_unit_test(test_a_batch_with_transmission_angles_gives_the_same_bits),
        cmocka_unit_test(test_a_batch_of_a_group_solves_each_pose_from_the_first),
        cmocka_unit_test(test_any_count_of_poses_is_the_same_poses),
        cmocka_unit_test(test_rows_may_begin_anywhere),
        cmocka_unit_test(test_a_missing_input_stands_for_the_states_own),
        cmocka_unit_test(test_angles_come_out_on_the_states_turn),
        cmocka_unit_test(test_the_worst_status_is_returned),
        cmocka_unit_test(test_lanes_where_pins_coincide_are_those_of_a_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
