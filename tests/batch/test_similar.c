// Examples in other units (tests/similar.h): a batch gives similar numbers in every lane, those of poses beside a limit
// too.
#include <yoke/batch.h>
#include "../similar.h"

enum { POSES = 40, CHANNELS = 120, ROWS = 12 };
static const int units[][3] = {{-35, 24, 33}};

static size_t list_channels(const Similar *m, YkChannel *channels)
{
    static const char *const endings[] = {"", ".rate", ".accel", ".effort"};
    char name[256];
    size_t count = 0;
    for (size_t k = 0; k < yk_coordinate_count(m->mech); k++)
        for (size_t e = 0; e < 4 && count < CHANNELS; e++) {
            snprintf(name, sizeof name, "%s%s", yk_coordinate_info(m->mech, k).name, endings[e]);
            if (e < 3 || yk_dynamics_has_effort(m->dynamics, k))
                assert_int_equal(yk_channel_parse(m->mech, name, &channels[count++], m->problems), YK_OK);
        }
    for (size_t j = 0; j < yk_model_joint_count(m->model) && count < CHANNELS; j++) {
        yk_channel_name(m->mech, (YkChannel){j % 2 ? YK_CHANNEL_FORCE_X : YK_CHANNEL_FORCE_Y, (int)j, 0, 0}, name,
                        sizeof name);
        assert_int_equal(yk_channel_parse(m->mech, name, &channels[count++], m->problems), YK_OK);
    }
    return count;
}

// Draws inputs within `spread` of the pose, and the same in the other units.
static void draw(const Similar *a, double spread, double one[][POSES], double two[][POSES])
{
    uint64_t seed = 5;
    for (size_t i = 0; i < yk_input_count(a->mech); i++) {
        bool is_distance = yk_coordinate_info(a->mech, yk_input_coordinate(a->mech, i)).is_distance;
        double size = is_distance ? 0.2 * yk_mechanism_size(a->mech) : 1;
        for (size_t k = 0; k < POSES; k++) {
            double at = yk_state_input(a->state, i).position + check_uniform(&seed, -spread, spread) * size;
            YkMotion q = {at, check_uniform(&seed, -9, 9), check_uniform(&seed, -9, 9)},
                     p = similar_motion(q, is_distance);
            one[3 * i][k] = q.position, one[3 * i + 1][k] = q.velocity, one[3 * i + 2][k] = q.acceleration;
            two[3 * i][k] = p.position, two[3 * i + 1][k] = p.velocity, two[3 * i + 2][k] = p.acceleration;
        }
    }
}

static void run(const Similar *m, const YkChannel *channels, size_t count, double inputs[][POSES],
                double outputs[][POSES], signed char *status)
{
    const double *in[ROWS];
    double *out[CHANNELS];
    YkBatch *batch = yk_batch_new(m->state, channels, count);
    assert_non_null(batch);
    for (size_t i = 0; i < 3 * yk_input_count(m->mech); i++) in[i] = inputs[i];
    for (size_t c = 0; c < count; c++) out[c] = outputs[c];
    yk_batch_run(batch, in, out, status, POSES);
    yk_batch_free(batch);
}

static void check_pair(Similar *a, Similar *b, size_t unused)
{
    static double in[2][ROWS][POSES], out[2][CHANNELS][POSES];
    signed char status[2][POSES];
    YkChannel channels[CHANNELS];
    (void)unused;
    if (3 * yk_input_count(a->mech) > ROWS) return;
    size_t count = list_channels(a, channels);
    draw(a, 1.5, in[0], in[1]);
    run(a, channels, count, in[0], out[0], status[0]);
    run(b, channels, count, in[1], out[1], status[1]);
    assert_memory_equal(status[0], status[1], POSES);
    for (size_t c = 0; c < count; c++)
        similar_check_values(out[0][c], out[1][c], POSES, channels[c], a->file, "a channel of a batch");
}

static void test_batches_of_every_example_in_other_units(void **unused)
{
    (void)unused;
    similar_each_pair(units, sizeof units / sizeof *units, check_pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_batches_of_every_example_in_other_units)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
