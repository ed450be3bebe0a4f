// Examples in other units (tests/similar.h): designs with their poses, derivatives by parameters and accelerations of
// many states are similar.
#include <yoke/study.h>
#include "../similar.h"

enum { DESIGNS = 5, POSES = 9, PARAMETERS = 3, CHANNELS = 8, INPUTS = 24 };

typedef struct Answers {
    double extent[CHANNELS][DESIGNS][3], value[CHANNELS][DESIGNS * POSES];
    double by_derivative[CHANNELS][PARAMETERS], by_difference[CHANNELS][PARAMETERS], acceleration[INPUTS][DESIGNS];
    signed char status[DESIGNS * POSES], worst[DESIGNS], motion[DESIGNS];
} Answers;

typedef struct Asked {
    const char *file, *parameters[PARAMETERS];
    YkChannel channels[CHANNELS];
    size_t parameter_count, channel_count;
} Asked;

// Asks for coordinates, rates and accelerations in turn, and for an energy and an effort where there are any.
static void ask(Asked *asked, const Similar *m)
{
    static const char *const endings[] = {"", ".rate", ".accel", ".effort"};
    size_t coordinates = yk_coordinate_count(m->mech);
    while (asked->parameter_count < PARAMETERS && asked->parameters[asked->parameter_count]) asked->parameter_count++;
    for (size_t k = 0; k < 3 * coordinates && asked->channel_count + 2 < CHANNELS; k++) {
        char name[256];
        snprintf(name, sizeof name, "%s%s", yk_coordinate_info(m->mech, k % coordinates).name,
                 endings[(k + k / coordinates) % 3]);
        assert_int_equal(yk_channel_parse(m->mech, name, &asked->channels[asked->channel_count++], m->problems), YK_OK);
    }
    if (!m->dynamics->has_mass) return;
    assert_int_equal(yk_channel_parse(m->mech, "kinetic", &asked->channels[asked->channel_count++], m->problems),
                     YK_OK);
    assert_int_equal(yk_channel_parse(m->mech, "shaking.x", &asked->channels[asked->channel_count++], m->problems),
                     YK_OK);
}

// What the machine of the other units has for 1.
static double unit_of(const Similar *a, const Similar *m, const char *parameter)
{
    return yk_model_parameter(m->model, parameter) / yk_model_parameter(a->model, parameter);
}

static void answer(const Asked *asked, const Similar *a, const Similar *m, Answers *to)
{
    uint64_t seed = 3;
    double values[PARAMETERS][DESIGNS], inputs[3][POSES], extra[INPUTS][2][DESIGNS];
    const double *parameter[PARAMETERS], *input[3 * INPUTS] = {NULL}, *position[INPUTS], *rate[INPUTS];
    double *value[CHANNELS], *acceleration[INPUTS];
    YkExtent extents[CHANNELS * DESIGNS];
    for (size_t c = 0; c < asked->channel_count; c++) value[c] = to->value[c];
    for (size_t p = 0; p < asked->parameter_count; p++) {
        double own = yk_model_parameter(a->model, asked->parameters[p]), unit = unit_of(a, m, asked->parameters[p]);
        for (size_t d = 0; d < DESIGNS; d++) values[p][d] = unit * (own * check_uniform(&seed, 0.97, 1.03));
        parameter[p] = values[p];
    }
    for (size_t k = 0; k < POSES; k++) {
        YkMotion q = {yk_state_input(a->state, 0).position + 0.7 * (double)k, 2, -3};
        if (m != a) q = similar_motion(q, false);
        inputs[0][k] = q.position, inputs[1][k] = q.velocity, inputs[2][k] = q.acceleration;
    }
    for (int k = 0; k < 3; k++) input[k] = inputs[k];
    YkStudyOptions options = {
        asked->parameters, asked->parameter_count, asked->channels, asked->channel_count, 1, NULL, {0}, false};
    YkStudy *study = yk_study_new(m->state, &options, m->problems);
    if (!study) print_error("%s: %s", asked->file, yk_problems_text(m->problems, 0));
    assert_non_null(study);
    assert_true(yk_input_count(m->mech) <= INPUTS);
    YkStudyCase cases = {parameter, DESIGNS, input, POSES, false, NULL};
    yk_study_run(study, &cases, value, to->status);
    yk_study_reduce(study, &cases, extents, to->worst, NULL);
    for (size_t k = 0; k < asked->channel_count * DESIGNS; k++) {
        double *extent = to->extent[k / DESIGNS][k % DESIGNS];
        extent[0] = extents[k].least, extent[1] = extents[k].largest, extent[2] = extents[k].mean;
    }
    double derivative[CHANNELS * PARAMETERS], difference[CHANNELS * PARAMETERS];
    yk_study_sensitivities(study, NULL, derivative, difference);
    for (size_t k = 0; k < asked->channel_count * asked->parameter_count; k++) {
        to->by_derivative[k / asked->parameter_count][k % asked->parameter_count] = derivative[k];
        to->by_difference[k / asked->parameter_count][k % asked->parameter_count] = difference[k];
    }
    yk_study_free(study);
    if (!m->dynamics->has_mass) return;
    YkMotionBatch *batch = yk_motion_batch_new(m->state, asked->parameters, asked->parameter_count, 1, m->problems);
    assert_true(batch || m->model->gear_count > 0);
    if (!batch) return; // the module of wheels makes another machine
    for (size_t i = 0; i < yk_input_count(m->mech); i++) {
        for (size_t d = 0; d < DESIGNS; d++) {
            YkMotion q = {yk_state_input(a->state, i).position + check_uniform(&seed, -0.1, 0.1),
                          check_uniform(&seed, -1, 1), 0};
            if (m != a) q = similar_motion(q, false);
            extra[i][0][d] = q.position, extra[i][1][d] = q.velocity;
        }
        position[i] = extra[i][0], rate[i] = extra[i][1], acceleration[i] = to->acceleration[i];
    }
    yk_motion_batch_run(batch, &(YkMotionCase){parameter, position, rate, NULL, DESIGNS}, acceleration, to->motion);
    yk_motion_batch_free(batch);
}

static void compare(const Asked *asked, const Similar *a, const Similar *b, const Answers *one, const Answers *two)
{
    assert_memory_equal(one->status, two->status, sizeof one->status);
    assert_memory_equal(one->worst, two->worst, sizeof one->worst);
    assert_memory_equal(one->motion, two->motion, sizeof one->motion);
    for (size_t c = 0; c < asked->channel_count; c++) {
        YkChannel channel = asked->channels[c];
        char name[256];
        yk_channel_name(a->mech, channel, name, sizeof name);
        similar_check_values(one->value[c], two->value[c], DESIGNS * POSES, channel, a->file, name);
        similar_check_values(one->extent[c][0], two->extent[c][0], DESIGNS * 3, channel, a->file, name);
        for (size_t p = 0; p < asked->parameter_count; p++) {
            double unit = unit_of(a, b, asked->parameters[p]);
            double due = similar_to(one->by_difference[c][p], channel.quantity), near = 1e-9 * fabs(due);
            similar_check(one->by_derivative[c][p], two->by_derivative[c][p] * unit, channel.quantity, a->file, name);
            CHECK_NEAR(two->by_difference[c][p] * unit, due, near);
        }
    }
    YkChannel by_forces = {YK_CHANNEL_FORCE, 0, 0, YK_QUANTITY_ANGLE_ACCELERATION};
    for (size_t i = 0; i < yk_input_count(a->mech); i++)
        similar_check_values(one->acceleration[i], two->acceleration[i], DESIGNS, by_forces, a->file, "acceleration");
}

static void test_studies_in_other_units(void **unused)
{
    (void)unused;
    static const char *const files[][1 + PARAMETERS] = {
        {"toggle", "l2", "m4", "a0x"},   {"double-pendulum", "l1", "m2", "I1"},
        {"steam-engine", "r", "l", "m"}, {"five-bar", "a", "w"},
        {"chain", "l", "m", "g"},        {"inverted-slider-crank", "a", "gamma"},
        {"crank-press", "r", "l"},       {"planetary-gear", "mod", "load"}};
    for (size_t k = 0; k < check_cases(sizeof files / sizeof *files); k++) {
        char path[100];
        snprintf(path, sizeof path, "examples/%s.yaml", files[k][0]);
        Asked asked = {.file = path, .parameters = {files[k][1], files[k][2], files[k][3]}};
        static Answers answers[2];
        memset(answers, 0, sizeof answers);
        similar_set(0, 0, 0);
        Similar a = similar_load(path, NULL);
        assert_true(yk_state_set_time(a.state, 0, a.problems) >= 0 && yk_state_assemble(a.state) >= 0);
        ask(&asked, &a);
        answer(&asked, &a, &a, &answers[0]);
        similar_set(33, -26, 25);
        Similar b = similar_load(path, NULL);
        assert_true(yk_state_set_time(b.state, 0, b.problems) >= 0 && yk_state_assemble(b.state) >= 0);
        answer(&asked, &a, &b, &answers[1]);
        compare(&asked, &a, &b, &answers[0], &answers[1]);
        similar_free(&a);
        similar_free(&b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_studies_in_other_units)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
