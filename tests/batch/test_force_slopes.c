// Derivatives of rates, accelerations, angles of transmission and forces by parameters, backwards: against complex
// steps through closed forms with their derivatives by time, and against machines beside.
#include "batch/forces.h"
#include <complex.h>
#include "../compile/machine.h"
#include "batch/batch.h"
#include "batch/pose_forces.h"
#include "compile/gradient.h"
#include "compile/variant.h"
#include "program/forces.h"
#include <yoke/move.h>

// --- closed forms: numbers with a complex step, and their derivatives by time

typedef struct Jet {
    double complex v[3];
} Jet;

static Jet constant(double complex a)
{
    return (Jet){{a, 0, 0}};
}
static Jet add(Jet a, Jet b, double complex k) // a + k b
{
    return (Jet){{a.v[0] + k * b.v[0], a.v[1] + k * b.v[1], a.v[2] + k * b.v[2]}};
}
static Jet times(Jet a, Jet b)
{
    return (Jet){
        {a.v[0] * b.v[0], a.v[1] * b.v[0] + a.v[0] * b.v[1], a.v[2] * b.v[0] + 2 * a.v[1] * b.v[1] + a.v[0] * b.v[2]}};
}
static Jet inverse(Jet a)
{
    double complex r = 1 / a.v[0];
    return (Jet){{r, -a.v[1] * r * r, 2 * a.v[1] * a.v[1] * r * r * r - a.v[2] * r * r}};
}
static Jet root(Jet a)
{
    double complex s = csqrt(a.v[0]), first = a.v[1] / (2 * s);
    return (Jet){{s, first, (a.v[2] - 2 * first * first) / (2 * s)}};
}

typedef struct Place {
    Jet x, y;
} Place;
static Place place_add(Place a, Place b, Jet k)
{
    return (Place){add(a.x, times(b.x, k), 1), add(a.y, times(b.y, k), 1)};
}
static Place left_of(Place a)
{
    return (Place){add(constant(0), a.y, -1), a.x};
}
static double complex dot(Place a, int i, Place b, int k)
{
    return a.x.v[i] * b.x.v[k] + a.y.v[i] * b.y.v[k];
}
static double complex cross(Place a, int i, Place b, int k)
{
    return a.x.v[i] * b.y.v[k] - a.y.v[i] * b.x.v[k];
}

enum { A, B, C, G, PX, PY, M, J, M2, J2, K, L0, ANGLE, COUNT };
static const char *const names[COUNT] = {"a", "b", "c", "g", "px", "py", "m", "J", "m2", "J2", "k", "l0", "tilt"};
static const double values[COUNT] = {0.2, 0.7, 0.5, 0.6, 0.3, 0.25, 2, 0.06, 1.5, 0.04, 300, 0.4, 0.3};
static const double omega = 7;

static const char source[] =
    "parameters: {a: 0.2, b: 0.7, c: 0.5, g: 0.6, px: 0.3, py: 0.25, m: 2, J: 0.06, m2: 1.5, J2: 0.04, k: 300, l0: "
    "0.4,\n"
    "             tilt: 0.3}\n"
    "gravity: [0, -9.81 m/s^2]\n"
    "bodies:\n  ground: {points: {A0: [0, 0], B0: [g*cos(tilt), g*sin(tilt)], S: [-0.3, 0.9]}}\n"
    "  crank: {points: {A0: [0, 0], A: [a, 0]}}\n"
    "  rod: {points: {A: [0, 0], B: [b, 0], P: [px, py]}, mass: m*1 kg, center: [px, py], inertia: J*1 kg*m^2}\n"
    "  rocker: {points: {B0: [0, 0], B: [c, 0]}, mass: m2*1 kg, center: [c/2, 0], inertia: J2*1 kg*m^2}\n"
    "joints:\n  A0: {pin: [ground, crank], angle: theta}\n  A: {pin: [crank, rod], angle: phi}\n"
    "  B0: {pin: [ground, rocker], angle: psi}\n  B: {pin: [rod, rocker]}\n"
    "springs: {s: {between: [ground.S, rod.B], stiffness: k*1 N/m, length: l0*1 m}}\n"
    "drives: {theta: 7 rad/s * t}\nstart: {phi: 0.9, psi: 1.5}\nunits: {length: m}\n";

enum { EFFORT, X_RATE, Y_ACCEL, SPEED, TURN, TRANSMISSION, KINETIC, ANSWERS };
static const char *const answers[ANSWERS] = {"theta.effort", "rod.P.x.rate",   "rod.P.y.accel", "rod.P.speed",
                                             "psi.accel",    "B.transmission", "kinetic"};

static void closed_form(const double complex *p, double theta, double complex *answer)
{
    double c = cos(theta), s = sin(theta);
    Jet cosine = {{c, -omega * s, -omega * omega * c}}, sine = {{s, omega * c, -omega * omega * s}};
    Place a = {times(constant(p[A]), cosine), times(constant(p[A]), sine)};
    Place pivot = {constant(p[G] * ccos(p[ANGLE])), constant(p[G] * csin(p[ANGLE]))},
          d = place_add(pivot, a, constant(-1));
    Jet dd = add(times(d.x, d.x), times(d.y, d.y), 1), per = inverse(dd);
    Jet along = add(constant(0.5), times(constant(p[B] * p[B] - p[C] * p[C]), per), 0.5);
    Jet across = root(add(times(constant(p[B] * p[B]), per), times(along, along), -1));
    Place b = place_add(place_add(a, d, along), left_of(d), across), link = place_add(b, a, constant(-1));
    Place at = place_add(place_add(a, link, constant(p[PX] / p[B])), left_of(link), constant(p[PY] / p[B]));
    Place arm = place_add(b, pivot, constant(-1)), half = place_add(pivot, arm, constant(0.5));
    Place spring = {add(b.x, constant(-0.3), -1), add(b.y, constant(0.9), -1)};
    Jet length = root(add(times(spring.x, spring.x), times(spring.y, spring.y), 1));
    double complex w = cross(link, 0, link, 1) / (p[B] * p[B]), alpha = cross(link, 0, link, 2) / (p[B] * p[B]);
    double complex w2 = cross(arm, 0, arm, 1) / (p[C] * p[C]), alpha2 = cross(arm, 0, arm, 2) / (p[C] * p[C]);
    double complex power = p[M] * (dot(at, 2, at, 1) + 9.81 * at.y.v[1]) + p[J] * w * alpha;
    power += p[M2] * (dot(half, 2, half, 1) + 9.81 * half.y.v[1]) + p[J2] * w2 * alpha2;
    power += p[K] * (length.v[0] - p[L0]) * length.v[1];
    answer[EFFORT] = power / omega;
    answer[X_RATE] = at.x.v[1];
    answer[Y_ACCEL] = at.y.v[2];
    answer[SPEED] = csqrt(dot(at, 1, at, 1));
    answer[TURN] = alpha2;
    double complex sinus = cross(link, 0, arm, 0) / (p[B] * p[C]);
    answer[TRANSMISSION] = casin(creal(sinus) < 0 ? -sinus : sinus);
    answer[KINETIC] = (p[M] * dot(at, 1, at, 1) + p[J] * w * w + p[M2] * dot(half, 1, half, 1) + p[J2] * w2 * w2) / 2;
}

// --- the engine

typedef struct Fit {
    Machine m;
    YkVariant *variant;
    const YkMechanism *mech;
    YkState *state;
    YkGradient *gradient;
} Fit;

static Fit fit_of(const char *text, const char *const *name, size_t count)
{
    Fit f = {.m = machine(text)};
    f.variant = yk_variant_new(f.m.mech, name, count, f.m.problems);
    if (!f.variant) print_error("%s\n", yk_problems_text(f.m.problems, 0));
    assert_non_null(f.variant);
    f.mech = yk_variant_mechanism(f.variant);
    f.state = yk_state_new(f.mech);
    f.gradient = yk_gradient_new(f.variant);
    assert_true(f.state && f.gradient);
    assert_int_equal(yk_state_set_time(f.state, 0, NULL), YK_OK);
    assert_true(yk_state_assemble(f.state) >= 0);
    return f;
}

static void fit_free(Fit *f)
{
    yk_gradient_free(f->gradient);
    yk_state_free(f->state);
    yk_variant_free(f->variant);
    machine_free(&f->m);
}

static void linearise(Fit *f)
{
    size_t o = f->mech->orientation_count - 1, n = yk_variable_count(f->mech);
    double *x = calloc(3 * n + 1, sizeof *x);
    assert_non_null(x);
    for (int order = 0; order < 3; order++) {
        for (size_t k = 1; k <= o; k++)
            x[(size_t)order * n + k - 1] = yk_state_channel(
                f->state, (YkChannel){YK_CHANNEL_BODY, f->mech->orientation_body[k], order, YK_QUANTITY_ANGLE});
        for (size_t j = 0; j < f->mech->model->joint_count; j++)
            if (f->mech->joint_distance[j] >= 0)
                x[(size_t)order * n + o + (size_t)f->mech->joint_distance[j]] = yk_state_channel(
                    f->state, (YkChannel){YK_CHANNEL_JOINT_DISTANCE, (int)j, order, YK_QUANTITY_LENGTH});
    }
    assert_true(yk_gradient_design(f->gradient));
    assert_true(yk_gradient_pose(f->gradient, x, x + n, x + 2 * n));
    free(x);
}

// The derivatives of one channel, by its own tape. Returns the tape's length, or 0 where it needs none.
static size_t slopes_of(Fit *f, YkChannel channel, double *slope)
{
    bool fits = true;
    YkLaneForces *forces = yk_channel_needs_forces(channel) ? yk_force_slopes_new(f->mech, &channel, 1, &fits) : NULL;
    assert_true(fits && (forces || yk_gradient_covers(f->mech, channel)));
    linearise(f);
    yk_gradient_start(f->gradient);
    if (forces) {
        size_t count = yk_force_slopes_count(forces), inputs = yk_input_count(f->mech);
        double *by = calloc(count + 1, sizeof *by), weight = 1;
        double *input = calloc(3 * inputs + 1, sizeof *input);
        for (size_t i = 0; i < inputs; i++) {
            YkMotion own = yk_state_input(f->state, i);
            input[3 * i] = own.position, input[3 * i + 1] = own.velocity, input[3 * i + 2] = own.acceleration;
        }
        YkSlopesAt at = {input, 0, &weight};
        assert_true(yk_force_slopes_take(forces, f->gradient, &at, by));
        free(by);
        free(input);
    } else {
        yk_gradient_take(f->gradient, (YkWeighted){channel, 1});
    }
    yk_gradient_finish(f->gradient, slope);
    size_t length = forces ? yk_lane_forces_length(forces) : 0;
    yk_lane_forces_free(forces);
    return length;
}

static void every_answer_has_the_slopes_of_a_complex_step(void **state)
{
    (void)state;
    enum { POSES = 17 };
    Fit f = fit_of(source, names, COUNT);
    for (int pose = 0; pose < POSES; pose++) {
        double theta = 2 * YK_PI * pose / POSES;
        double complex p[COUNT], answer[ANSWERS];
        YkMotion goal = {.position = theta};
        assert_true(yk_state_move_to(f.state, &goal, NULL, NULL) >= 0);
        yk_state_set_input_to(f.state, 0, theta, omega, 0);
        assert_true(yk_state_solve(f.state) >= 0);
        for (int c = 0; c < ANSWERS; c++) {
            YkChannel channel;
            double slope[COUNT] = {0}, largest = 0;
            assert_int_equal(yk_channel_parse(f.mech, answers[c], &channel, NULL), YK_OK);
            slopes_of(&f, channel, slope);
            for (int k = 0; k < COUNT; k++) largest = fmax(largest, fabs(slope[k] * values[k]));
            assert_true(largest > 0);
            for (int k = 0; k < COUNT; k++) {
                for (int i = 0; i < COUNT; i++) p[i] = values[i] + (i == k ? 1e-30 * I : 0);
                closed_form(p, theta, answer);
                CHECK_NEAR(slope[k] * values[k], cimag(answer[c]) * 1e30 * values[k], 1e-11 * largest);
            }
            if (!yk_channel_needs_forces(channel))
                CHECK_NEAR(yk_state_channel(f.state, channel), creal(answer[c]),
                           1e-11 * fabs(creal(answer[c])) + 1e-12);
        }
    }
    fit_free(&f);
}

// --- the gallery, beside

static bool value_beside(Fit *f, const double *own, size_t k, double by, const YkChannel *channel, double *value)
{
    double moved[64];
    memcpy(moved, own, 64 * sizeof *own);
    moved[k] += by;
    if (yk_variant_set(f->variant, moved) != YK_OK) return false;
    YkBatch *batch = yk_batch_new(f->state, channel, 1);
    const double **inputs = calloc(3 * yk_input_count(f->mech) + 1, sizeof *inputs);
    bool good = batch && inputs && yk_batch_run(batch, inputs, &value, NULL, 1) == YK_OK;
    free((void *)inputs);
    yk_batch_free(batch);
    return good;
}

// Compares all channels of a machine with those of machines beside it, extrapolated. Returns how many numbers.
static size_t compare(const char *example)
{
    Machine m = machine(example);
    const char *name[64];
    double own[64] = {0};
    size_t count = 0, compared = 0;
    for (size_t k = 0; k < m.model->parameter_count && count < 12; k++) {
        YkProblems *unheard = yk_problems_new();
        const char *one = m.model->parameters[k].name;
        YkVariant *variant = yk_variant_new(m.mech, &one, 1, unheard);
        if (variant && yk_problems_count(unheard) == 0) {
            own[count] = yk_model_parameter(m.model, one);
            name[count++] = one;
        }
        yk_variant_free(variant);
        yk_problems_free(unheard);
    }
    if (count == 0) {
        machine_free(&m);
        return 0;
    }
    Fit f = fit_of(example, name, count);
    for (size_t i = 0; i < yk_input_count(f.mech); i++) {
        YkMotion at = yk_state_input(f.state, i);
        yk_state_set_input_to(f.state, i, at.position + 0.13, 1.5, 0.7);
    }
    assert_true(yk_state_solve(f.state) >= 0);
    YkChannel channels[200];
    size_t channel_count = 0;
    const size_t joints = f.mech->model->joint_count, coordinates = f.mech->coordinate_count;
    for (size_t k = 0; k < f.mech->model->point_count && channel_count < 60; k += 2)
        for (int order = 0; order < 3; order++)
            channels[channel_count++] =
                (YkChannel){YK_CHANNEL_POINT_X + (int)(k / 2) % 2, (int)k, order, YK_QUANTITY_LENGTH};
    for (size_t k = 0; k < coordinates && channel_count < 100; k++)
        for (int order = 0; order < 3; order++)
            channels[channel_count++] = (YkChannel){YK_CHANNEL_COORDINATE, (int)k, order, YK_QUANTITY_NUMBER};
    for (size_t k = 0; k < f.mech->block_count && channel_count < 120; k++) {
        YkChannel c = {YK_CHANNEL_TRANSMISSION, (int)k, 0, YK_QUANTITY_ANGLE};
        if (yk_gradient_covers(f.mech, c)) channels[channel_count++] = c;
    }
    if (yk_model_has_forces(f.mech->model)) {
        for (size_t k = 0; k < joints && channel_count < 150; k++) {
            channels[channel_count++] = (YkChannel){YK_CHANNEL_FORCE_X, (int)k, 0, YK_QUANTITY_FORCE};
            channels[channel_count++] = (YkChannel){YK_CHANNEL_FORCE, (int)k, 0, YK_QUANTITY_FORCE};
        }
        for (int kind = YK_CHANNEL_ENERGY; kind <= YK_CHANNEL_SHAKING_MOMENT; kind++)
            channels[channel_count++] = (YkChannel){kind, 0, 0, YK_QUANTITY_FORCE};
        channels[channel_count++] =
            (YkChannel){YK_CHANNEL_EFFORT, (int)yk_input_coordinate(f.mech, 0), 0, YK_QUANTITY_TORQUE};
    }
    for (size_t c = 0; c < channel_count; c++) {
        bool fits = true;
        double slope[64] = {0}, base = 0;
        if (yk_channel_needs_forces(channels[c])) {
            YkLaneForces *forces = yk_force_slopes_new(f.mech, &channels[c], 1, &fits);
            yk_lane_forces_free(forces);
        }
        assert_int_equal(yk_variant_set(f.variant, own), YK_OK);
        if (!fits || !value_beside(&f, own, 0, 0, &channels[c], &base)) continue;
        assert_true(yk_state_solve(f.state) >= 0);
        slopes_of(&f, channels[c], slope);
        double scale = fabs(base);
        for (size_t k = 0; k < count; k++) scale = fmax(scale, fabs(slope[k]) * fmax(fabs(own[k]), 1e-3));
        for (size_t k = 0; k < count; k++) {
            double size = fmax(fabs(own[k]), 1e-3), h = 2e-4 * size, v[4];
            static const double way[4] = {-1, 1, -2, 2};
            bool good = true;
            for (int i = 0; i < 4; i++) good = good && value_beside(&f, own, k, way[i] * h, &channels[c], &v[i]);
            if (!good) continue;
            double by = (8 * (v[1] - v[0]) - (v[3] - v[2])) / (12 * h);
            if (!(fabs(slope[k] - by) * size <= 2e-8 * scale + 1e-10))
                print_error("%s: channel %d of %d, order %d, by %s: %.12g is not %.12g\n", example,
                            (int)channels[c].kind, channels[c].index, channels[c].order, name[k], slope[k], by);
            CHECK_NEAR(slope[k] * size, by * size, 2e-8 * scale + 1e-10);
            compared++;
        }
    }
    fit_free(&f);
    machine_free(&m);
    return compared;
}

static void the_gallery_has_the_slopes_of_machines_beside(void **state)
{
    (void)state;
    static const char *const examples[] = {"andrews",  "slider-crank",        "crank-press",  "jansen",
                                           "marghitu", "quick-return",        "whitworth-kg", "toggle",
                                           "five-bar", "oscillating-cylinder"};
    for (size_t k = 0; k < sizeof examples / sizeof *examples; k++) assert_true(compare(examples[k]) >= 38);
}

// The tape backwards takes a few times the operations of the forces, for 3 parameters as for 13.
static void backwards_takes_a_few_times_the_forces(void **state)
{
    (void)state;
    static const char *const effort[] = {"theta.effort", "B.force"};
    for (int c = 0; c < 2; c++) {
        size_t length[2];
        for (int way = 0; way < 2; way++) {
            Fit f = fit_of(source, names, way == 0 ? 3 : COUNT);
            YkChannel channel;
            double slope[COUNT] = {0};
            assert_int_equal(yk_channel_parse(f.mech, effort[c], &channel, NULL), YK_OK);
            bool none, good;
            YkPoseForces *plain = yk_pose_forces_new(f.mech, &channel, 1, 1, &none);
            good = plain && plain->lanes;
            assert_true(good);
            length[way] = slopes_of(&f, channel, slope);
            assert_true(length[way] <= 4 * yk_lane_forces_length(plain->lanes));
            yk_pose_forces_free(plain);
            fit_free(&f);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_answer_has_the_slopes_of_a_complex_step),
        cmocka_unit_test(the_gallery_has_the_slopes_of_machines_beside),
        cmocka_unit_test(backwards_takes_a_few_times_the_forces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
