// Batches along a path: in parts of any length they have the bits of a state that goes the same way, turn by turn; the
// forces of a batch in which no pose follows another, where they are wanted; and they end before a limit.
#include <yoke/move.h>
#include "batch/batch.h"
#include "solve/machine.h"
#include "solve/state.h"
#include "compile/mechanism.h"

enum { POSES = 420, CHANNELS_MAX = 40, INPUTS_MAX = 12 };
static double inputs[INPUTS_MAX][POSES], along[CHANNELS_MAX][POSES], apart[CHANNELS_MAX][POSES];
static bool wanted[POSES];
static YkChannel channels[CHANNELS_MAX];
static size_t channel_count;

static void add(const Machine *m, const char *name)
{
    assert_true(channel_count < CHANNELS_MAX);
    channels[channel_count++] = machine_channel(m, name);
}

// Forces first: what a batch takes for its first channel must not be special. Then coordinates, with their rates.
static void list_channels(const Machine *m, bool with_forces)
{
    char name[200];
    channel_count = 0;
    if (with_forces) {
        add(m, "shaking.x");
        add(m, "kinetic");
        add(m, "potential");
        for (size_t j = 0; j < 4; j++) {
            snprintf(name, sizeof name, "%s.force.y", yk_model_joint_name(m->model, j));
            add(m, name);
        }
        snprintf(name, sizeof name, "%s.effort", yk_coordinate_info(m->mech, yk_input_coordinate(m->mech, 0)).name);
        add(m, name);
    }
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++) {
        add(m, yk_coordinate_info(m->mech, k).name);
        snprintf(name, sizeof name, "%s.accel", yk_coordinate_info(m->mech, k).name);
        add(m, name);
    }
}

// The first input goes round more than twice, in steps of 2 degrees.
static void draw(const Machine *m, uint64_t *seed)
{
    for (size_t i = 0; i < yk_input_count(m->mech); i++) {
        double at = yk_state_input(m->state, i).position;
        for (size_t k = 0; k < POSES; k++) {
            inputs[3 * i][k] = i == 0 ? at + 0.035 * (double)(k + 1) : at;
            inputs[3 * i + 1][k] = check_uniform(seed, -3, 3);
            inputs[3 * i + 2][k] = check_uniform(seed, -3, 3);
        }
    }
    for (size_t k = 0; k < POSES; k++) wanted[k] = k < 200 || check_uniform(seed, 0, 1) < 0.3;
}

// Goes through the poses in parts. Returns how many are on the path.
static size_t go(YkBatch *batch, const Machine *m, bool chooses)
{
    static const size_t parts[] = {1, 3, 1, 64, 65, 2, 127};
    const double *in[INPUTS_MAX];
    double *out[CHANNELS_MAX];
    size_t at = 0;
    for (size_t c = 0; c < channel_count; c++)
        for (size_t k = 0; k < POSES; k++) along[c][k] = 12345; // what is not wanted is written too
    yk_batch_begin(batch, m->state);
    for (size_t part = 0; at < POSES; part++) {
        size_t count = parts[part % 7] < POSES - at ? parts[part % 7] : POSES - at;
        for (size_t i = 0; i < 3 * yk_input_count(m->mech); i++) in[i] = inputs[i] + at;
        for (size_t c = 0; c < channel_count; c++) out[c] = along[c] + at;
        size_t clear = yk_batch_run_along(batch, in, out, NULL, (YkAlong){chooses ? wanted + at : NULL, NULL}, count);
        at += clear;
        if (clear < count) break;
    }
    return at;
}

static void run_apart(const Machine *m)
{
    const double *in[INPUTS_MAX];
    double *out[CHANNELS_MAX];
    YkBatch *batch = yk_batch_new(m->state, channels, channel_count);
    for (size_t i = 0; i < 3 * yk_input_count(m->mech); i++) in[i] = inputs[i];
    for (size_t c = 0; c < channel_count; c++) out[c] = apart[c];
    yk_batch_run(batch, in, out, NULL, POSES);
    yk_batch_free(batch);
}

static void check_pose(const char *file, const Machine *m, YkState *state, size_t k)
{
    YkMotion goal[INPUTS_MAX / 3];
    for (size_t i = 0; i < yk_input_count(m->mech); i++)
        goal[i] = (YkMotion){inputs[3 * i][k], inputs[3 * i + 1][k], inputs[3 * i + 2][k]};
    assert_true(yk_state_move_to(state, goal, NULL, NULL) >= 0);
    for (size_t i = 0; i < yk_input_count(m->mech); i++) yk_state_set_input(state, i, goal[i]);
    assert_true(yk_state_solve(state) >= 0);
    for (size_t c = 0; c < channel_count; c++) {
        bool is_force = yk_channel_needs_forces(channels[c]), is_off = is_force && !wanted[k];
        double due = is_off ? 0 : is_force ? apart[c][k] : yk_state_channel(state, channels[c]);
        if (!(along[c][k] == due))
            print_error("%s pose %zu channel %zu: %.17g, not %.17g\n", file, k, c, along[c][k], due);
        assert_true(along[c][k] == due);
    }
}

static void check_machine(const char *file, bool with_forces, size_t most)
{
    Machine m = machine_load(file);
    uint64_t seed = 12;
    list_channels(&m, with_forces);
    assert_true(yk_batch_can_follow(m.mech, channels, channel_count) && 3 * yk_input_count(m.mech) <= INPUTS_MAX);
    draw(&m, &seed);
    run_apart(&m);
    YkBatch *batch = yk_batch_new_along(m.state, channels, channel_count);
    YkState *state = yk_state_new(m.mech);
    assert_true(batch && state && yk_batch_has_lanes(batch));
    yk_state_copy(state, m.state);
    size_t count = go(batch, &m, true);
    if (count != most) print_message("%s: %zu poses on the path\n", file, count);
    assert_true(most == POSES ? count == POSES : count > 5 && count < most);
    for (size_t k = 0; k < count; k++) check_pose(file, &m, state, k);
    yk_batch_refer(batch, m.state); // the turns that the path has counted
    for (size_t c = 0; c < yk_coordinate_count(m.mech) && count == POSES; c++) {
        double at = yk_state_coordinate(state, c).position, turn = yk_nearest_turn(at, m.state->reference[c]);
        if (!yk_coordinate_info(m.mech, c).is_distance && m.mech->coordinates[c].input == YK_NONE)
            CHECK_NEAR(turn, at, 0);
    }
    yk_batch_free(batch);
    yk_state_free(state);
    machine_free(&m);
}

static void test_a_path_has_the_bits_of_a_state_that_goes_it(void **unused)
{
    (void)unused;
    check_machine("gas-engine", true, POSES);
    check_machine("steam-engine", true, POSES);
    check_machine("drag-link", false, POSES);
    check_machine("jansen", false, POSES);
    check_machine("non-grashof", false, POSES / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_path_has_the_bits_of_a_state_that_goes_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
