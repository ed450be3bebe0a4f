// Forces of a batch against the equations of every body, pose by pose: examples, random machines, random meshes; the
// same bits in lanes and alone.
#include "solve/machine.h"
#include <dirent.h>
#include "batch/forces.h"
#include "compile/mechanism.h"
#include "dynamics/dynamics.h"
#include "dynamics/random_geared.h"
#include "dynamics/random_machine.h"

enum { POSES = 200, CHANNELS_MAX = 700, INPUTS_MAX = 60 };
static double inputs[INPUTS_MAX][POSES], outputs[CHANNELS_MAX][POSES];
static signed char status[POSES];
static YkChannel channels[CHANNELS_MAX];
static size_t channel_count;
static size_t machines_in_lanes, poses_compared;

static void add(YkChannelKind kind, size_t index)
{
    if (channel_count < CHANNELS_MAX) channels[channel_count++] = (YkChannel){.kind = kind, .index = (int)index};
}

static void add_transmitted(size_t index)
{
    add(YK_CHANNEL_FORCE_X, index);
    add(YK_CHANNEL_FORCE_Y, index);
    add(YK_CHANNEL_FORCE, index);
    add(YK_CHANNEL_MOMENT, index);
}

static void list_channels(const Machine *m, const YkDynamics *dynamics)
{
    size_t joints = yk_model_joint_count(m->model);
    channel_count = 0;
    for (YkChannelKind kind = YK_CHANNEL_ENERGY; kind <= YK_CHANNEL_SHAKING_MOMENT; kind++) add(kind, 0);
    for (size_t k = 0; k < joints; k++) add_transmitted(k);
    for (size_t k = 0; k < yk_dynamics_contact_count(dynamics); k++) add_transmitted(joints + k);
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++)
        if (yk_dynamics_has_effort(dynamics, k)) add(YK_CHANNEL_EFFORT, k);
}

static const double *special; // positions of the first input that some poses have, or NULL
static size_t special_count;

static void draw_inputs(const Machine *m, double spread, uint64_t *seed)
{
    for (size_t i = 0; i < yk_input_count(m->mech); i++) {
        YkMotion at = yk_state_input(m->state, i);
        bool is_distance = yk_coordinate_info(m->mech, yk_input_coordinate(m->mech, i)).is_distance;
        double reach = is_distance ? spread * 0.1 * m->mech->size : spread;
        for (size_t k = 0; k < POSES; k++) {
            inputs[3 * i][k] = at.position + check_uniform(seed, -reach, reach);
            inputs[3 * i + 1][k] = check_uniform(seed, -3, 3);
            inputs[3 * i + 2][k] = check_uniform(seed, -3, 3);
        }
    }
    for (size_t k = 0; k < special_count; k++) inputs[0][17 * k + 3] = special[k];
}

static void set_pose(Machine *m, size_t k)
{
    for (size_t i = 0; i < yk_input_count(m->mech); i++)
        yk_state_set_input(m->state, i, (YkMotion){inputs[3 * i][k], inputs[3 * i + 1][k], inputs[3 * i + 2][k]});
}

static double tolerance_of(const Machine *m, const YkDynamics *d, YkChannelKind kind)
{
    double size = m->mech->size, margin = m->state->space.margin[0], loose = 1e-11 / (margin < 1e-2 ? margin : 1e-2);
    bool is_length = kind == YK_CHANNEL_MOMENT || kind == YK_CHANNEL_EFFORT || kind >= YK_CHANNEL_SHAKING_MOMENT;
    double largest = d->largest_force + 1e-9;
    for (size_t b = 1; b < yk_model_body_count(m->model); b++) {
        YkBalance balance = yk_dynamics_balance(d, b);
        largest = fmax(largest, yk_hypot(balance.inertia.force[0], balance.inertia.force[1]));
        largest = fmax(largest, fabs(balance.inertia.moment) / size);
        largest = fmax(largest, fabs(balance.loads.moment) / size);
    }
    for (size_t i = 0; i < m->mech->input_count; i++)
        largest = fmax(largest, fabs(d->drive[i]) / (1 < size ? 1 : size));
    YkEnergy energy = yk_dynamics_energy(d);
    if (kind >= YK_CHANNEL_ENERGY && kind <= YK_CHANNEL_POTENTIAL)
        return 1e-11 * (fabs(energy.kinetic) + fabs(energy.potential) + largest * size);
    return loose * largest * (is_length || kind == YK_CHANNEL_EFFORT ? fmax(size, 1) : 1);
}

// A pose of the batch against the free bodies of the engine.
static void check_pose(const char *name, Machine *m, YkDynamics *d, size_t k)
{
    set_pose(m, k);
    YkStatus one = yk_dynamics_solve(d, m->state, YK_METHOD_NEWTON_EULER);
    if (status[k] != YK_OK) {
        assert_true(one < 0 || one == YK_SINGULAR || m->state->space.margin[0] < 1e-9);
        for (size_t c = 0; c < channel_count; c++) assert_true(outputs[c][k] == 0);
        return;
    }
    assert_true(one >= 0);
    if (one == YK_SINGULAR || m->state->space.margin[0] < 1e-7) return;
    poses_compared++;
    for (size_t c = 0; c < channel_count; c++) {
        double due = yk_dynamics_channel(d, m->state, channels[c]), got = outputs[c][k];
        if (!(fabs(got - due) <= tolerance_of(m, d, channels[c].kind)))
            print_error("%s pose %zu: channel kind %d index %d is %.17g, by the free bodies %.17g (margin %g)\n", name,
                        k, channels[c].kind, channels[c].index, got, due, m->state->space.margin[0]);
        assert_true(fabs(got - due) <= tolerance_of(m, d, channels[c].kind));
    }
}

// Every third pose alone has the bits it has among others.
static void check_alone(YkBatch *batch, const double *const *in, size_t input_count)
{
    const double *at[INPUTS_MAX];
    static double alone[CHANNELS_MAX];
    double *out[CHANNELS_MAX];
    for (size_t c = 0; c < channel_count; c++) out[c] = &alone[c];
    for (size_t k = 0; k < POSES; k += 3) {
        for (size_t i = 0; i < 3 * input_count; i++) at[i] = in[i] + k;
        yk_batch_run(batch, at, out, NULL, 1);
        for (size_t c = 0; c < channel_count; c++)
            assert_true(memcmp(&alone[c], &outputs[c][k], sizeof(double)) == 0 || alone[c] == outputs[c][k]);
    }
}

static bool is_for_lanes(const Machine *m)
{
    bool fits;
    YkLaneForces *lanes = yk_lane_forces_new(m->mech, channels, channel_count, 8, &fits);
    bool is = lanes != NULL;
    yk_lane_forces_free(lanes);
    return is;
}

// One channel alone has the bits it has among others, although less of the pose is computed for it.
static void check_each(const Machine *m, const double *const *in)
{
    static double alone[POSES];
    static signed char own[POSES];
    for (size_t c = 0; c < channel_count; c += 1 + channel_count / 12) {
        YkBatch *batch = yk_batch_new(m->state, &channels[c], 1);
        assert_non_null(batch);
        yk_batch_run(batch, in, (double *[]){alone}, own, POSES);
        for (size_t k = 0; k < POSES; k++)
            if (own[k] == YK_OK && status[k] == YK_OK)
                assert_true(memcmp(&alone[k], &outputs[c][k], sizeof(double)) == 0 || alone[k] == outputs[c][k]);
        yk_batch_free(batch);
    }
}

static void check_machine(const char *name, Machine *m, double spread)
{
    uint64_t seed = 41;
    const double *in[INPUTS_MAX];
    double *out[CHANNELS_MAX];
    size_t n = yk_input_count(m->mech);
    YkDynamics *d = yk_dynamics_new(m->mech, m->problems);
    assert_non_null(d);
    for (size_t i = 0; i < n; i++) yk_dynamics_prescribe(d, i, true);
    list_channels(m, d);
    if (3 * n <= INPUTS_MAX && channel_count < CHANNELS_MAX && is_for_lanes(m)) {
        machines_in_lanes++;
        draw_inputs(m, spread, &seed);
        YkBatch *batch = yk_batch_new(m->state, channels, channel_count);
        assert_non_null(batch);
        for (size_t i = 0; i < 3 * n; i++) in[i] = inputs[i];
        for (size_t c = 0; c < channel_count; c++) out[c] = outputs[c];
        yk_batch_run(batch, in, out, status, POSES);
        check_alone(batch, in, n);
        check_each(m, in);
        for (size_t k = 0; k < POSES; k++) check_pose(name, m, d, k);
        yk_batch_free(batch);
    }
    yk_dynamics_free(d);
}

static void test_examples(void **unused)
{
    (void)unused;
    DIR *folder = opendir(YOKE_ROOT "/examples");
    assert_non_null(folder);
    machines_in_lanes = poses_compared = 0;
    for (struct dirent *entry; (entry = readdir(folder));) {
        char name[256];
        size_t length = strlen(entry->d_name);
        if (length < 6 || length > 250 || strcmp(entry->d_name + length - 5, ".yaml") != 0) continue;
        memcpy(name, entry->d_name, length - 5);
        name[length - 5] = '\0';
        Machine m = machine_load(name);
        check_machine(name, &m, 0.3);
        machine_free(&m);
    }
    closedir(folder);
    print_message("%zu examples in lanes, %zu poses\n", machines_in_lanes, poses_compared);
    assert_true(machines_in_lanes > 45 && poses_compared > 6000);
}

static void check_text(const char *name, const char *text)
{
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_model_parse(text, strlen(text), name, NULL, m.problems);
    assert_non_null(m.model);
    m.mech = yk_mechanism_compile(m.model, NULL, m.problems);
    assert_non_null(m.mech);
    m.state = yk_state_new(m.mech);
    if (yk_state_assemble(m.state) >= 0 && m.state->space.margin[0] > 1e-4) check_machine(name, &m, 0.1);
    machine_free(&m);
}

static void test_random_machines(void **unused)
{
    (void)unused;
    static RandomMachine machine;
    machines_in_lanes = poses_compared = 0;
    for (uint64_t number = 0; number < check_cases(150); number++) {
        random_machine(&machine, 7919 * number + 5);
        char name[40];
        snprintf(name, sizeof name, "random %d", (int)number);
        check_text(name, machine.text);
    }
    print_message("%zu random machines in lanes, %zu poses\n", machines_in_lanes, poses_compared);
    assert_true(machines_in_lanes > check_cases(30) && poses_compared > check_cases(3000));
}

static void test_forces_of_meshes(void **unused)
{
    (void)unused;
    static Geared geared;
    machines_in_lanes = poses_compared = 0;
    for (uint64_t number = 0; number < check_cases(60); number++) {
        geared_machine(&geared, 31 * number + 3);
        char name[40];
        snprintf(name, sizeof name, "geared %d", (int)number);
        check_text(name, geared.text);
    }
    print_message("%zu geared machines in lanes, %zu poses\n", machines_in_lanes, poses_compared);
    assert_true(poses_compared > check_cases(500));
}

// A kite whose moving pin comes to lie on the rocker's at 0: nothing tells the rocker's angle there, and forces grow
// without bound on the way. Such a pose has a status and no forces; those beside it in the block have theirs.
static void test_poses_without_forces(void **unused)
{
    (void)unused;
    static const double near[] = {0, 1e-15, -1e-12, 1e-9, -1e-7, 1e-5, 2 * YK_PI, 4 * YK_PI};
    special = near;
    special_count = sizeof near / sizeof *near;
    machines_in_lanes = poses_compared = 0;
    check_text("kite", "gravity: [0, -9.81]\n"
                       "bodies:\n"
                       "  ground: {points: {O2: [0, 0], O4: [1, 0]}}\n"
                       "  crank: {points: {O2: [0, 0], A: [1, 0]}, mass: 2, rod: [O2, A]}\n"
                       "  coupler: {points: {A: [0, 0], B: [2, 0]}, mass: 3, rod: [A, B]}\n"
                       "  rocker: {points: {O4: [0, 0], B: [2, 0]}, mass: 1, rod: [O4, B]}\n"
                       "joints:\n"
                       "  O2: {pin: [ground, crank], angle: theta2}\n"
                       "  A: {pin: [crank, coupler], angle: gamma}\n"
                       "  O4: {pin: [ground, rocker], angle: theta4}\n"
                       "  B: {pin: [coupler, rocker]}\n"
                       "drives: {theta2: 60 deg + 1 rad/s * t}\n"
                       "start: {gamma: 20 deg, theta4: 100 deg}\n");
    special_count = 0;
    assert_int_equal(machines_in_lanes, 1);
    for (size_t k = 0; k < sizeof near / sizeof *near; k++) assert_int_equal(status[17 * k + 3], YK_SINGULAR);
    assert_true(poses_compared > POSES / 2);
}

// A machine with a group, each pose of which a state solves: a spring turns by the first coordinate of all, which no
// input is.
static void test_springs_of_a_group(void **unused)
{
    (void)unused;
    machines_in_lanes = poses_compared = 0;
    check_text(
        "triad",
        "gravity: [0, -9.81]\nbodies:\n"
        "  ground: {points: {O2: [0, 0], O4: [4, 0], O6: [6, 2.5]}}\n"
        "  crank: {points: {O2: [0, 0], A: [1, 0]}, mass: 1, rod: [O2, A]}\n"
        "  coupler: {points: {A: [0, 0], B: [3.5, 0], C: [2, 1.5]}, mass: 2, rod: [A, B]}\n"
        "  rocker: {points: {O4: [0, 0], B: [3, 0]}}\n"
        "  link: {points: {C: [0, 0], D: [4.5, 0]}, mass: 1, rod: [C, D]}\n"
        "  output: {points: {O6: [0, 0], D: [2.5, 0]}}\n"
        "joints:\n  O2: {pin: [ground, crank], angle: theta2}\n  O6: {pin: [ground, output], angle: theta6}\n"
        "  D: {pin: [output, link], angle: theta5}\n  A: {pin: [crank, coupler], angle: theta3}\n"
        "  O4: {pin: [ground, rocker], angle: theta4}\n  B: {pin: [coupler, rocker]}\n  C: {pin: [coupler, link]}\n"
        "springs: {s: {along: theta2, stiffness: 300}}\ndrives: {theta6: 120 deg + 0.1 rad/s * t}\n"
        "start: {theta2: 120 deg, theta3: -90 deg, theta4: 119 deg, theta5: -101 deg}\n");
    assert_int_equal(machines_in_lanes, 1);
    assert_true(poses_compared > POSES / 2);
}

// A motor turns a wheel by a pinion: it feels the wheel's inertia by the square of the ratio. For this alone the
// wheel's acceleration is needed, and nothing else of the pose.
static void test_a_motor_feels_a_wheel_by_the_square_of_the_ratio(void **unused)
{
    (void)unused;
    Machine m =
        machine_parse("bodies: {ground: {points: {P: [0.06, 0]}}, pinion: {}, wheel: {points: {P: [0, 0]}, mass: 3, "
                      "inertia: 0.5}}\n"
                      "joints: {O: {pin: [ground, pinion], angle: q}, P: {pin: [ground, wheel], angle: theta}}\n"
                      "gears: {g: {mesh: [pinion, wheel], teeth: [20, 40], module: 2 mm}}\ndrives: {q: 10 rad/s * t}\n",
                      true);
    uint64_t seed = 8;
    YkChannel effort = machine_channel(&m, "q.effort");
    YkBatch *batch = yk_batch_new(m.state, &effort, 1);
    assert_non_null(batch);
    draw_inputs(&m, 3, &seed);
    assert_int_equal(yk_batch_run(batch, (const double *[]){inputs[0], inputs[1], inputs[2]}, (double *[]){outputs[0]},
                                  status, POSES),
                     YK_OK);
    for (size_t k = 0; k < POSES; k++) CHECK_NEAR(outputs[0][k], 0.5 / 4 * inputs[2][k], 1e-15);
    yk_batch_free(batch);
    machine_free(&m);
}

// All that turns in a gear train at a fixed ratio to its input has rates that are multiples of one rate: the torque and
// the couple on the ring are such a multiple and a number, one operation each, and what does not vary is copied.
static void test_ratios_are_joined(void **unused)
{
    (void)unused;
    bool fits;
    Machine m = machine_load("planetary-gear");
    static const char *const names[] = {"theta.effort", "R.moment", "S.force.x", "S.force.y"};
    for (channel_count = 0; channel_count < 4; channel_count++)
        assert_int_equal(yk_channel_parse(m.mech, names[channel_count], &channels[channel_count], m.problems), YK_OK);
    YkLaneForces *forces = yk_lane_forces_new(m.mech, channels, channel_count, 8, &fits);
    assert_non_null(forces);
    assert_int_equal(yk_lane_forces_length(forces), 4);
    for (size_t c = 0; c < 4; c++) assert_int_equal(yk_lane_forces_tell(forces, c), c < 2);
    yk_lane_forces_free(forces);
    machine_free(&m);
}

// Dry friction is settled by iteration. It begins anew at each pose: the last digits depend on nothing but the pose, in
// whatever order and company the poses come.
static void test_dry_friction_has_no_memory(void **unused)
{
    (void)unused;
    static const char *const names[] = {"O.force.x", "R.force.x", "theta.effort"};
    static double backwards[3][POSES];
    Machine m = machine_load("crank-press");
    uint64_t seed = 5;
    for (size_t k = 0; k < 3; k++) channels[k] = machine_channel(&m, names[k]);
    YkBatch *batch = yk_batch_new(m.state, channels, 3);
    assert_non_null(batch);
    assert_int_equal(yk_input_count(m.mech), 1);
    draw_inputs(&m, 3, &seed);
    const double *const all[] = {inputs[0], inputs[1], inputs[2]};
    assert_int_equal(yk_batch_run(batch, all, (double *[]){outputs[0], outputs[1], outputs[2]}, NULL, POSES), YK_OK);
    for (size_t k = POSES; k-- > 0;) {
        const double *const one[] = {inputs[0] + k, inputs[1] + k, inputs[2] + k};
        double *const here[] = {backwards[0] + k, backwards[1] + k, backwards[2] + k};
        assert_int_equal(yk_batch_run(batch, one, here, NULL, 1), YK_OK);
    }
    for (size_t k = 0; k < 3; k++) assert_memory_equal(backwards[k], outputs[k], sizeof backwards[k]);
    yk_batch_free(batch);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_examples),
        cmocka_unit_test(test_random_machines),
        cmocka_unit_test(test_forces_of_meshes),
        cmocka_unit_test(test_poses_without_forces),
        cmocka_unit_test(test_ratios_are_joined),
        cmocka_unit_test(test_springs_of_a_group),
        cmocka_unit_test(test_dry_friction_has_no_memory),
        cmocka_unit_test(test_a_motor_feels_a_wheel_by_the_square_of_the_ratio),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
