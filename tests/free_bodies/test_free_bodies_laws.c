// Laws that hold for every machine: each body in balance as Newton says in world axes, power, forward and inverse as
// each other's inverse, least norm, the same numbers in another place of the world; and cost that grows with the
// machine alone.
#include "loads_check.h"
#include "../check_vec.h"
#include "compile/ladder.h"
#include "free_bodies/inside.h"
#include "num/dense.h"

// Masses for all bodies, now and then none.
static void give_masses(Machine *m, uint64_t *seed, bool all)
{
    double size = m->mech->size;
    for (size_t b = 1; b < m->model->body_count; b++) {
        YkBody *body = &m->model->bodies[b];
        if (!all && check_random(seed) % 4 == 0) continue;
        body->has_mass = true;
        body->mass = check_uniform(seed, 0.2, 3);
        body->inertia = body->mass * size * size * check_uniform(seed, 0.02, 0.2);
        body->center = yk_scale(size, check_vec(seed, -0.5, 0.5, -0.5, 0.5));
    }
}

static bool is_redundant(const Rig *r)
{
    return r->m.mech->redundant_count > 0;
}

// An example at a random velocity, well away from dead points.
static bool open_example(size_t e, uint64_t *seed, bool all, Rig *r)
{
    Machine m = machine_load(all_examples[e]);
    give_masses(&m, seed, all);
    *r = rig_of(m);
    for (size_t i = 0; i < m.mech->input_count; i++) {
        YkMotion q = yk_state_input(m.state, i);
        double step = m.mech->coordinates[m.mech->inputs[i]].is_distance ? 0.02 * m.mech->size : 0.05;
        yk_state_set_input(m.state, i,
                           (YkMotion){q.position + check_uniform(seed, -step, step), check_uniform(seed, -3, 3),
                                      check_uniform(seed, -5, 5)});
    }
    if (yk_state_solve(m.state) >= 0 && m.state->space.margin[0] > 0.003) return true;
    rig_free(r);
    return false;
}

static void load_at_random(Rig *r, uint64_t *seed)
{
    load_clear(r);
    load_gravity(r, yk_vec(check_uniform(seed, -3, 3), -9.81));
    for (size_t b = 1; b < r->m.model->body_count; b++) {
        YkVec at = yk_scale(r->m.mech->size, check_vec(seed, -1, 1, -1, 1));
        load_force(r, b, place_of(r, b, at), check_vec(seed, -5, 5, -5, 5));
    }
}

static double largest_force(const Rig *r)
{
    double largest = 1e-3;
    for (size_t j = 0; j < r->m.model->joint_count; j++) {
        YkJointForce f = yk_free_bodies_joint(r->bodies, j);
        largest = fmax(largest, fmax(yk_norm(f.force), fabs(f.moment) / r->m.mech->size));
    }
    for (size_t b = 1; b < r->m.model->body_count; b++) {
        const YkBody *body = &r->m.model->bodies[b];
        YkBodyMotion m = yk_body_motion(r->m.mech, &r->m.state->space, b);
        largest = fmax(largest, yk_norm(r->load[b].force));
        if (body->has_mass) largest = fmax(largest, body->mass * yk_norm(m.acceleration));
    }
    for (size_t i = 0; i < r->m.mech->input_count; i++) {
        bool is_distance = r->m.mech->coordinates[r->m.mech->inputs[i]].is_distance;
        largest = fmax(largest, fabs(yk_free_bodies_effort(r->bodies, i)) / (is_distance ? 1 : r->m.mech->size));
    }
    return largest;
}

// --- every body in balance ------------------------------------------------------------------------------------------

typedef struct Wrench { // about the world's origin
    YkVec force;
    double moment;
} Wrench;

static void exert(Wrench *w, YkVec at, YkVec force, double moment)
{
    w->force = yk_add(w->force, force);
    w->moment += yk_cross(at, force) + moment;
}

// A force and a moment on a joint's second body at its point, the opposite on the first at the same place.
static void exert_pair(Wrench *sum, const Rig *r, const YkJoint *j, YkVec force, double moment)
{
    YkVec at = place_of(r, (size_t)j->body[1], j->at[1]);
    exert(&sum[j->body[1]], at, force, moment);
    exert(&sum[j->body[0]], at, yk_scale(-1, force), -moment);
}

static void check_balance(const Rig *r, double tolerance)
{
    const YkModel *model = r->m.model;
    Wrench *sum = calloc(model->body_count, sizeof *sum);
    for (size_t j = 0; j < model->joint_count; j++) {
        YkJointForce f = yk_free_bodies_joint(r->bodies, j);
        exert_pair(sum, r, &model->joints[j], f.force, f.moment);
    }
    for (size_t i = 0; i < r->m.mech->input_count; i++) {
        const YkTreeCoordinate *c = &r->m.mech->coordinates[r->m.mech->inputs[i]];
        const YkJoint *j = &model->joints[c->joint];
        double effort = yk_free_bodies_effort(r->bodies, i);
        YkBodyMotion a = yk_body_motion(r->m.mech, &r->m.state->space, (size_t)j->body[0]);
        exert_pair(sum, r, j, c->is_distance ? yk_scale(effort, yk_mul(a.e, j->along)) : yk_vec(0, 0),
                   c->is_distance ? 0 : effort);
    }
    double force = largest_force(r), far = r->m.mech->size;
    for (size_t b = 1; b < model->body_count; b++)
        far = fmax(far, yk_norm(yk_body_motion(r->m.mech, &r->m.state->space, b).at));
    for (size_t b = 1; b < model->body_count; b++) {
        YkBodyMotion m = yk_body_motion(r->m.mech, &r->m.state->space, b);
        exert(&sum[b], m.at, r->load[b].force, r->load[b].moment);
        double mass = model->bodies[b].has_mass ? model->bodies[b].mass : 0;
        YkVec momentum = yk_scale(mass, m.acceleration);
        CHECK_NEAR(yk_norm(yk_sub(sum[b].force, momentum)), 0, tolerance * force);
        double spin = mass > 0 ? model->bodies[b].inertia * m.a : 0;
        CHECK_NEAR(sum[b].moment, yk_cross(m.at, momentum) + spin, 4 * tolerance * force * far);
    }
    free(sum);
}

static void test_every_body_of_every_machine_is_in_balance(void **unused)
{
    (void)unused;
    uint64_t seed = 41;
    size_t solved = 0;
    for (size_t e = 0; e < EXAMPLE_COUNT; e++)
        for (uint64_t round = 0; round < check_cases(8); round++) {
            Rig r;
            if (!open_example(e, &seed, false, &r)) continue;
            load_at_random(&r, &seed);
            YkStatus status = rig_inverse(&r);
            assert_int_equal(status, is_redundant(&r) ? YK_REDUNDANT : YK_OK);
            assert_true(imbalance_of(r.bodies) < 1e-13);
            check_balance(&r, 1e-12);
            solved++;
            rig_free(&r);
        }
    assert_true(4 * solved > 3 * check_cases(8) * EXAMPLE_COUNT);
}

// Work of the inputs and loads against the growth of kinetic energy: reactions do no work.
static void test_efforts_deliver_what_kinetic_energy_takes(void **unused)
{
    (void)unused;
    uint64_t seed = 42;
    for (size_t e = 0; e < EXAMPLE_COUNT; e++)
        for (uint64_t round = 0; round < check_cases(8); round++) {
            Rig r;
            if (!open_example(e, &seed, false, &r)) continue;
            load_at_random(&r, &seed);
            assert_true(rig_inverse(&r) >= 0);
            double sum = 0, most = 0;
            for (size_t i = 0; i < r.m.mech->input_count; i++) {
                double power = yk_free_bodies_effort(r.bodies, i) * yk_state_input(r.m.state, i).velocity;
                sum += power;
                most += fabs(power);
            }
            for (size_t b = 1; b < r.m.model->body_count; b++) {
                const YkBody *body = &r.m.model->bodies[b];
                YkBodyMotion m = yk_body_motion(r.m.mech, &r.m.state->space, b);
                double mass = body->has_mass ? body->mass : 0, inertia = body->has_mass ? body->inertia : 0;
                double power = yk_dot(r.load[b].force, m.velocity) + r.load[b].moment * m.w;
                double growth = mass * yk_dot(m.velocity, m.acceleration) + inertia * m.w * m.a;
                sum += power - growth;
                most += fabs(power) + fabs(growth);
            }
            CHECK_NEAR(sum, 0, 1e-12 * most);
            rig_free(&r);
        }
}

// --- forward and inverse --------------------------------------------------------------------------------------------

static void check_round_trip(Rig *r, uint64_t *seed, const char *name)
{
    size_t inputs = r->m.mech->input_count, joints = r->m.model->joint_count;
    YkJointForce *before = calloc(joints + 1, sizeof *before);
    double effort[64];
    load_at_random(r, seed);
    for (size_t i = 0; i < inputs; i++) {
        r->is_prescribed[i] = check_random(seed) % 3 == 0;
        r->accelerations[i] = r->is_prescribed[i] ? check_uniform(seed, -5, 5) : NAN;
        if (!r->is_prescribed[i]) load_input(r, i, check_uniform(seed, -5, 5));
    }
    int culprit;
    YkStatus status = rig_forward(r, &culprit);
    if (status != YK_OK && status != YK_REDUNDANT) print_error("%s: %d, input %d\n", name, status, culprit);
    assert_int_equal(status, is_redundant(r) ? YK_REDUNDANT : YK_OK);
    assert_true(imbalance_of(r->bodies) < 1e-12);
    for (size_t j = 0; j < joints; j++) before[j] = yk_free_bodies_joint(r->bodies, j);
    for (size_t i = 0; i < inputs; i++) effort[i] = yk_free_bodies_effort(r->bodies, i);
    rig_accelerate(r);
    assert_int_equal(rig_inverse(r), status);
    double largest = largest_force(r), size = r->m.mech->size;
    for (size_t i = 0; i < inputs; i++) {
        double unit = r->m.mech->coordinates[r->m.mech->inputs[i]].is_distance ? 1 : size;
        CHECK_NEAR(yk_free_bodies_effort(r->bodies, i), r->is_prescribed[i] ? effort[i] : 0, 1e-11 * largest * unit);
    }
    for (size_t j = 0; j < joints; j++) {
        YkJointForce after = yk_free_bodies_joint(r->bodies, j);
        CHECK_VEC(after.force, before[j].force.x, before[j].force.y, 1e-11 * largest);
        CHECK_NEAR(after.moment, before[j].moment, 1e-11 * largest * size);
        assert_int_equal(after.is_determinate, before[j].is_determinate);
    }
    free(before);
}

static void test_inverse_undoes_forward_on_every_machine(void **unused)
{
    (void)unused;
    uint64_t seed = 43;
    size_t solved = 0;
    for (size_t e = 0; e < EXAMPLE_COUNT; e++)
        for (uint64_t round = 0; round < check_cases(8); round++) {
            Rig r;
            if (!open_example(e, &seed, true, &r)) continue;
            for (int k = 0; k < 3; k++) check_round_trip(&r, &seed, all_examples[e]);
            solved++;
            rig_free(&r);
        }
    assert_true(4 * solved > 3 * check_cases(8) * EXAMPLE_COUNT);
}

// Without any mass no freedom resists: some input is named, in any pose and wherever rounding leaves a little.
static void test_machines_without_inertia_name_an_input(void **unused)
{
    (void)unused;
    uint64_t seed = 45;
    for (size_t e = 0; e < EXAMPLE_COUNT; e++)
        for (uint64_t round = 0; round < check_cases(8); round++) {
            Rig r;
            if (!open_example(e, &seed, true, &r)) continue;
            for (size_t b = 1; b < r.m.model->body_count; b++) r.m.model->bodies[b].has_mass = false;
            int culprit = -1;
            assert_int_equal(rig_forward(&r, &culprit), YK_SINGULAR);
            if (culprit < 0) print_error("%s: no input is named\n", all_examples[e]);
            assert_true(culprit >= 0 && (size_t)culprit < r.m.mech->input_count);
            for (size_t i = 0; i < r.m.mech->input_count; i++) r.is_prescribed[i] = true;
            assert_int_equal(rig_forward(&r, &culprit), is_redundant(&r) ? YK_REDUNDANT : YK_OK);
            assert_int_equal(culprit, -1);
            rig_free(&r);
        }
}

// --- redundant parts ------------------------------------------------------------------------------------------------

// The least-norm solution the dense way: f = A^T y with A A^T y = b.
static void check_least_norm(const Rig *r)
{
    enum { ROWS = 60 };
    static double A[ROWS][ROWS], N[ROWS * ROWS], scale[ROWS];
    double y[ROWS] = {0}, worst = 0, largest = 0;
    int pivot[ROWS];
    const YkFreeBodies *f = r->bodies;
    assert_int_equal(f->part_count, 1);
    size_t m = 3 * f->parts[0].body_count, n = f->column_count;
    assert_true(m <= ROWS && n <= ROWS);
    memset(A, 0, sizeof A); // by columns
    for (size_t k = 0; k < n; k++) wrench_add(f, &f->columns[k], 1, A[k]);
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < m; j++) {
            N[i * m + j] = 0;
            for (size_t k = 0; k < n; k++) N[i * m + j] += A[k][i] * A[k][j];
        }
    for (size_t k = 0; k < n; k++)
        for (size_t i = 0; i < m; i++) y[i] += f->columns[k].share * A[k][i]; // b, as the solution has it
    assert_true(yk_lu_factor(m, N, pivot, scale) != 0);
    yk_lu_solve(m, N, pivot, y);
    for (size_t k = 0; k < n; k++) {
        double share = 0;
        for (size_t i = 0; i < m; i++) share += A[k][i] * y[i];
        worst = fmax(worst, fabs(share - f->columns[k].share));
        largest = fmax(largest, fabs(share));
    }
    CHECK_NEAR(worst, 0, 1e-10 * largest);
}

// A joint is determinate exactly if no column of it takes part in any f with A f = 0: taking it out lowers the rank.
static void check_determinacy(const Rig *r)
{
    enum { ROWS = 60 };
    static double A[ROWS * ROWS], tau[ROWS];
    static size_t order[ROWS];
    const YkFreeBodies *f = r->bodies;
    size_t m = 3 * f->parts[0].body_count, n = f->column_count;
    for (size_t k = 0; k < n; k++) { // rank without column k
        for (size_t j = 0; j < n; j++) {
            double column[ROWS] = {0};
            if (j != k) wrench_add(f, &f->columns[j], 1, column);
            for (size_t i = 0; i < m; i++) A[i * n + j] = column[i];
        }
        size_t rank = yk_qr_factor(m, n, A, order, tau, 1e-10);
        assert_int_equal(f->columns[k].freeness == 0, rank < m);
    }
}

static void test_redundant_reactions_are_the_least_in_norm_and_say_which_are_determined(void **unused)
{
    (void)unused;
    uint64_t seed = 44;
    size_t solved = 0;
    for (size_t e = 0; e < EXAMPLE_COUNT; e++)
        for (uint64_t round = 0; round < check_cases(4); round++) {
            Rig r;
            if (!open_example(e, &seed, true, &r)) continue;
            if (is_redundant(&r)) {
                load_at_random(&r, &seed);
                assert_int_equal(rig_inverse(&r), YK_REDUNDANT);
                check_least_norm(&r);
                check_determinacy(&r);
                solved++;
            }
            rig_free(&r);
        }
    assert_true(solved >= 2 * check_cases(4));
}

// --- long machines --------------------------------------------------------------------------------------------------

// Gives all bodies mass and weight, and solves inverse and forward dynamics twice.
static void solve_long(const Machine *m, YkStatus expected, YkFreeBodies **bodies)
{
    size_t n = m->model->body_count, inputs = m->mech->input_count;
    YkLoad *load = calloc(n, sizeof *load);
    bool *is_prescribed = calloc(inputs + 1, sizeof *is_prescribed);
    double *accelerations = calloc(inputs + 1, sizeof *accelerations);
    for (size_t b = 1; b < n; b++) {
        YkBody *body = &m->model->bodies[b];
        body->has_mass = true;
        body->mass = 1;
        body->center = yk_vec(0.5, 0);
        body->inertia = 0.1;
        load[b].force = yk_vec(0, -9.81);
    }
    YkFreeBodies *f = *bodies = yk_free_bodies_new(m->mech);
    for (int k = 0; k < 2; k++) {
        assert_int_equal(yk_free_bodies_forward(f, &m->state->space, load, is_prescribed, accelerations, NULL),
                         expected);
        assert_true(imbalance_of(f) < 1e-12);
        assert_int_equal(yk_free_bodies_inverse(f, &m->state->space, load, false), expected);
        assert_true(imbalance_of(f) < 1e-13);
    }
    free(load);
    free(is_prescribed);
    free(accelerations);
}

static void solve_story(Story story)
{
    YkFreeBodies *f;
    Machine m = machine_parse(story.text, true);
    solve_long(&m, YK_OK, &f);
    yk_free_bodies_free(f);
    machine_free(&m);
    free(story.text);
}

// At a quadratic cost they would not end before the test's time limit.
static void test_long_chains_and_ladders_are_solved(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    solve_story(chain(60000));
    solve_story(ladder(30000));
}

// A long chain hangs from a crosshead on two guides: the guides share their forces, everything else is determined.
static void test_a_doubled_guide_leaves_a_long_chain_sparse_and_determinate(void **unused)
{
    (void)unused;
    Story plain = chain(4000), story = story_new(plain.length + 1000);
    char *joints = strstr(plain.text, "joints:\n"), *rest = strstr(plain.text, "  J1: ");
    tell(&story, "%.*s  head: {points: {J0: [0, 0], S: [0.5, 0]}}\n", (int)(joints - plain.text), plain.text);
    tell(&story,
         "joints:\n  U: {slide: [ground, head], along: x, distance: u}\n  V: {slide: [ground, head], along: x, to: "
         "S}\n  J0: {pin: [head, b0], angle: a0}\n%s",
         rest);
    solve_story(plain);
    Machine m = machine_parse(story.text, true);
    YkFreeBodies *f;
    solve_long(&m, YK_REDUNDANT, &f);
    assert_int_equal(f->part_count, 1);
    for (size_t j = 0; j < m.model->joint_count; j++)
        assert_int_equal(yk_free_bodies_joint(f, j).is_determinate, m.model->joints[j].kind != YK_SLIDE);
    yk_free_bodies_free(f);
    machine_free(&m);
    free(story.text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_body_of_every_machine_is_in_balance),
        cmocka_unit_test(test_efforts_deliver_what_kinetic_energy_takes),
        cmocka_unit_test(test_inverse_undoes_forward_on_every_machine),
        cmocka_unit_test(test_machines_without_inertia_name_an_input),
        cmocka_unit_test(test_redundant_reactions_are_the_least_in_norm_and_say_which_are_determined),
        cmocka_unit_test(test_long_chains_and_ladders_are_solved),
        cmocka_unit_test(test_a_doubled_guide_leaves_a_long_chain_sparse_and_determinate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
