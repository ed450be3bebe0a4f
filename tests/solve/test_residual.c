// Every pose closes: by the library's own measure, and by the places of both sides of every joint, which are worked out
// here from nothing but the answers for bodies and points.
#include "machine.h"
#include "solve/state.h"

enum { STEPS = 720 };

// What the joints of a pose miss, measured by the answers; velocities and accelerations over the largest in the
// machine.
typedef struct Misses {
    double place, rate, accel;
} Misses;

static void keep(double *worst, double miss)
{
    *worst = miss <= *worst ? *worst : miss;
}

static void add_point_joint(Misses *worst, Misses *scale, const Place *a, const Place *b)
{
    keep(&worst->place, yk_norm(yk_sub(a->place, b->place)));
    keep(&worst->rate, yk_norm(yk_sub(a->rate, b->rate)));
    keep(&worst->accel, yk_norm(yk_sub(a->accel, b->accel)));
    keep(&scale->rate, yk_norm(a->rate));
    keep(&scale->accel, yk_norm(a->accel));
}

// Off its line, and turned against it where the joint keeps the angle.
static void add_line_joint(Misses *worst, const YkJoint *joint, const Place *a, const Place *b)
{
    YkVec e = yk_mul(yk_unit(a->angle), joint->along), off = yk_sub(b->place, a->place);
    keep(&worst->place, fabs(yk_cross(e, off)));
    if (joint->kind == YK_PIN_SLOT) return;
    keep(&worst->place, fabs(angle_between(b->angle - a->angle, joint->turned)));
}

static Misses misses_of(const Machine *m)
{
    Misses worst = {0, 0, 0}, scale = {0, 0, 0};
    for (size_t j = 0; j < m->model->joint_count; j++) {
        const YkJoint *joint = &m->model->joints[j];
        Place a, b;
        if (!body_place(m, (size_t)joint->body[0], joint->at[0], &a)) continue;
        if (!body_place(m, (size_t)joint->body[1], joint->at[1], &b)) continue;
        double size = yk_mechanism_size(m->mech);
        keep(&scale.rate, fmax(fabs(a.spin), fabs(b.spin)) * size);
        keep(&scale.accel, fmax(a.spin * a.spin, b.spin * b.spin) * size);
        if (joint->kind == YK_PIN || joint->kind == YK_WELD) add_point_joint(&worst, &scale, &a, &b);
        if (joint->kind == YK_SLIDE || joint->kind == YK_PIN_SLOT) add_line_joint(&worst, joint, &a, &b);
    }
    double size = yk_mechanism_size(m->mech);
    return (Misses){worst.place / size, scale.rate > 0 ? worst.rate / scale.rate : 0,
                    scale.accel > 0 ? worst.accel / scale.accel : 0};
}

// The least sine of a transmission angle: rounding in a pose grows by its inverse in rates, by its square in
// accelerations, and shows in loops that repeat others.
static double least_sine(const Machine *m)
{
    double least = 1;
    for (size_t b = 0; b < yk_block_count(m->mech); b++) {
        YkBlockKind kind = yk_block_info(m->mech, b).kind;
        if (kind <= YK_BLOCK_PP) least = fmin(least, sin(yk_state_transmission(m->state, b)));
    }
    return least;
}

static void check_pose(const char *file, const Machine *m, double at)
{
    YkResiduals r = yk_state_residuals(m->state);
    Misses misses = misses_of(m);
    double s = least_sine(m), rate = 1e-12 + 1e-15 / s, accel = 1e-11 + 1e-14 / (s * s);
    if (r.position <= 1e-12 && r.velocity <= rate && r.acceleration <= accel && misses.place <= 2e-12 &&
        misses.rate <= 2 * rate && misses.accel <= accel)
        return;
    print_error("%s at %.17g: residuals %.3g %.3g %.3g, joints miss by %.3g %.3g %.3g\n", file, at, r.position,
                r.velocity, r.acceleration, misses.place, misses.rate, misses.accel);
    fail();
}

// Rates of this machine's first input; whole turns of an angle, a third of the value either way for a distance.
static void check_example(const char *file)
{
    Machine m = machine_load(file);
    if (yk_input_count(m.mech) == 0) {
        machine_free(&m);
        return;
    }
    size_t coordinate = yk_input_coordinate(m.mech, 0), closed = 0;
    YkCoordinateInfo info = yk_coordinate_info(m.mech, coordinate);
    double from = yk_state_input(m.state, 0).position, span = info.is_distance ? 0.3 * fabs(from) : 2 * YK_PI;
    for (int way = -1; way <= 1; way += 2) {
        Machine again = machine_load(file); // forward and back each start from the file's pose
        for (int k = 0; k <= STEPS; k++) {
            double at = from + way * span * k / STEPS;
            if (machine_solve(&again, at, 1.3, -0.7) < 0) break;
            check_pose(file, &again, at);
            closed++;
        }
        machine_free(&again);
    }
    assert_true(closed >= 20); // each machine moves
    YkSweep *sweep = machine_sweep(&m, info.name, from, from + span, STEPS, NULL, 0);
    CHECK_NEAR(yk_sweep_worst_residual(sweep), 0, 1e-12);
    assert_true(yk_sweep_row_count(sweep) == STEPS + 1 || yk_sweep_status(sweep) == YK_LIMIT);
    yk_sweep_free(sweep);
    machine_free(&m);
}

static void test_every_pose_of_every_example_closes(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < EXAMPLE_COUNT; k++) check_example(all_examples[k]);
}

static void test_the_measure_sees_a_machine_that_does_not_close(void **unused)
{
    (void)unused;
    Machine m = machine_load("four-bar");
    assert_true(misses_of(&m).place < 1e-13);
    m.model->joints[3].at[0].x += 1e-6; // the model is constant: put back below
    assert_true(misses_of(&m).place > 1e-7);
    m.model->joints[3].at[0].x -= 1e-6;
    machine_free(&m);
}

// A body's unit vector turned by 1e-4, its rate off by 1e-3 or its acceleration by 1e-2: what loops miss by the
// library's measure is about what joints miss by the answers. Both are over the largest in the machine, which they take
// from different places.
static void damage(const Machine *m, size_t orientation, int order)
{
    YkTurn t = yk_space_turn(&m->state->space, (int32_t)orientation);
    YkVec e = yk_mul(yk_vec(t.c[0], t.s[0]), yk_unit(1e-4));
    if (order == 0) *t.c = e.x, *t.s = e.y;
    if (order == 1) *t.w += 1e-3;
    if (order == 2) *t.a += 1e-2;
}

static void check_damage(const char *file)
{
    Machine m = machine_load(file);
    double from = yk_state_input(m.state, 0).position;
    for (int order = 0; order < 3; order++)
        for (size_t o = 1; o < m.mech->orientation_count; o++) {
            assert_true(machine_solve(&m, from, 1.3, -0.7) >= 0);
            damage(&m, o, order);
            Misses misses = misses_of(&m);
            YkResiduals r = yk_state_residuals(m.state);
            const double found[3] = {r.position, r.velocity, r.acceleration},
                         due[3] = {misses.place, misses.rate, misses.accel};
            for (int k = order; k < 3; k++) {
                bool is_near = due[k] < 1e-9 ? found[k] < 1e-8 : found[k] > 0.1 * due[k] && found[k] < 10 * due[k];
                if (!is_near)
                    print_error("%s, orientation %zu, order %d: %g, by joints %g\n", file, o, k, found[k], due[k]);
                assert_true(is_near);
            }
            for (int k = 0; k < order; k++) assert_true(found[k] < 1e-12); // what comes before is as it was
            CHECK_NEAR(yk_state_gap(m.state), r.position, 0);
            m.state->has_rates = false; // at a dead point: places alone
            YkResiduals places = yk_state_residuals(m.state);
            CHECK_NEAR(places.position, r.position, 0);
            assert_true(places.velocity == 0 && places.acceleration == 0);
        }
    machine_free(&m);
}

static void damage_shows_as_large_as_it_is(void **unused)
{
    (void)unused;
    static const char *const files[] = {"four-bar", "drag-link", "stephenson-six-bar", "double-butterfly", "klann"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) check_damage(files[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_pose_of_every_example_closes),
        cmocka_unit_test(damage_shows_as_large_as_it_is),
        cmocka_unit_test(test_the_measure_sees_a_machine_that_does_not_close),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
