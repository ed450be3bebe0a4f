// Open trees: forward dynamics against closed forms, against a dense mass matrix, and against the laws.
#include "light_tree.h"

static const char *const pendulum =
    "parameters: {l1: 0.5, lc1: 0.35, lc2: 0.3, m1: 0.5, m2: 0.4, I1: 0.025, I2: 0.02}\n"
    "gravity: [0, -9.81]\n"
    "bodies:\n"
    "  ground: {points: {O: [0, 0]}}\n"
    "  link1: {points: {O: [0, 0], A: [0, -l1]}, mass: m1, center: [0, -lc1], inertia: I1}\n"
    "  link2: {points: {A: [0, 0]}, mass: m2, center: [0, -lc2], inertia: I2}\n"
    "joints:\n"
    "  O: {pin: [ground, link1], angle: theta1}\n"
    "  A: {pin: [link1, link2], angle: theta2}\n";

// M q'' + C = tau for the same machine, from its Lagrangian.
static void pendulum_closed_form(const double *q, const double *v, const double *tau, double *a)
{
    const double l1 = 0.5, lc1 = 0.35, lc2 = 0.3, m1 = 0.5, m2 = 0.4, I1 = 0.025, I2 = 0.02, g = 9.81;
    double b = m2 * l1 * lc2, D = I2 + m2 * lc2 * lc2;
    double m11 = I1 + D + m1 * lc1 * lc1 + m2 * l1 * l1 + 2 * b * cos(q[1]), m12 = D + b * cos(q[1]);
    double g2 = g * m2 * lc2 * sin(q[0] + q[1]), g1 = g * (m1 * lc1 + m2 * l1) * sin(q[0]) + g2;
    double r1 = tau[0] + b * sin(q[1]) * (2 * v[0] + v[1]) * v[1] - g1, r2 = tau[1] - b * sin(q[1]) * v[0] * v[0] - g2;
    double determinant = m11 * D - m12 * m12;
    a[0] = (D * r1 - m12 * r2) / determinant;
    a[1] = (m11 * r2 - m12 * r1) / determinant;
}

static void test_double_pendulum_as_published(void **unused)
{
    (void)unused;
    OpenTree t = open_tree(pendulum);
    const double q[2] = {YK_PI / 3, YK_PI / 4}, v[2] = {0.1, -0.2}, tau[2] = {0.5, -0.2};
    double a[2], exact[2];
    assert_int_equal(yk_tree_accelerate(t.tree, q, v, tau, a), -1);
    pendulum_closed_form(q, v, tau, exact);
    CHECK_NEAR(a[0], -9.55276, 5e-6);
    CHECK_NEAR(a[1], -7.09408, 5e-6);
    for (int i = 0; i < 2; i++) CHECK_NEAR(a[i], exact[i], 1e-13);
    open_tree_free(&t);
}

static void test_double_pendulum_is_its_closed_form_everywhere(void **unused)
{
    (void)unused;
    OpenTree t = open_tree(pendulum);
    uint64_t seed = 1;
    for (int k = 0; k < 1000; k++) {
        double q[2], v[2], tau[2], a[2], exact[2];
        for (int i = 0; i < 2; i++) {
            q[i] = check_uniform(&seed, -7, 7);
            v[i] = check_uniform(&seed, -3, 3);
            tau[i] = check_uniform(&seed, -1, 1);
        }
        assert_int_equal(yk_tree_accelerate(t.tree, q, v, tau, a), -1);
        pendulum_closed_form(q, v, tau, exact);
        for (int i = 0; i < 2; i++) CHECK_NEAR(a[i], exact[i], 1e-13 * (10 + fabs(exact[i])));
    }
    open_tree_free(&t);
}

static void test_without_efforts_is_with_efforts_of_zero(void **unused)
{
    (void)unused;
    OpenTree t = open_tree(pendulum);
    const double q[2] = {1, 2}, v[2] = {3, 4}, zero[2] = {0, 0};
    double a[2], b[2];
    assert_int_equal(yk_tree_accelerate(t.tree, q, v, NULL, a), -1);
    assert_int_equal(yk_tree_accelerate(t.tree, q, v, zero, b), -1);
    for (int i = 0; i < 2; i++) CHECK_NEAR(a[i], b[i], 0);
    open_tree_free(&t);
}

// --- the dense way: M = sum of J^T m J over the bodies, J by rates of one coordinate at a time

typedef struct Dense {
    double *M, *r; // [n][n], [n]
} Dense;

static void add_dense_body(const OpenTree *t, Dense *dense, const BodyJet *column, const BodyJet *still, size_t k)
{
    size_t n = t->n, bodies = t->model->body_count;
    const YkBody *body = &t->model->bodies[k];
    VecJet bias = center_of(t, still, k);
    YkVec pull = yk_scale(body->mass, yk_sub(t->model->gravity, bias.a));
    for (size_t i = 0; i < n; i++) {
        const BodyJet *ci = column + i * bodies;
        VecJet pi = center_of(t, ci, k);
        dense->r[i] += yk_dot(pi.v, pull) - body->inertia * ci[k].angle.v * still[k].angle.a;
        for (size_t j = 0; j < n; j++) {
            const BodyJet *cj = column + j * bodies;
            dense->M[i * n + j] +=
                body->mass * yk_dot(pi.v, center_of(t, cj, k).v) + body->inertia * ci[k].angle.v * cj[k].angle.v;
        }
    }
}

static void solve_dense(Dense *dense, size_t n)
{
    double *M = dense->M, *r = dense->r;
    for (size_t k = 0; k < n; k++) { // positive definite: no pivoting
        assert_true(M[k * n + k] > 0);
        for (size_t i = k + 1; i < n; i++) {
            double f = M[i * n + k] / M[k * n + k];
            for (size_t j = k; j < n; j++) M[i * n + j] -= f * M[k * n + j];
            r[i] -= f * r[k];
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++) r[k] -= M[k * n + j] * r[j];
        r[k] /= M[k * n + k];
    }
}

// Into a: the accelerations by the dense way.
static void accelerate_densely(const OpenTree *t, const double *q, const double *v, const double *effort, double *a)
{
    size_t n = t->n, bodies = t->model->body_count;
    double *rate = numbers(n), *zero = numbers(n);
    Dense dense = {numbers(n * n), a};
    BodyJet *column = calloc(n * bodies, sizeof *column), *still = calloc(bodies, sizeof *still);
    assert_non_null(column);
    assert_non_null(still);
    for (size_t i = 0; i < n; i++) {
        rate[i] = 1;
        place_bodies(t, q, rate, zero, column + i * bodies);
        rate[i] = 0;
        a[i] = effort[i];
    }
    place_bodies(t, q, v, zero, still);
    for (size_t k = 1; k < bodies; k++)
        if (t->model->bodies[k].has_mass) add_dense_body(t, &dense, column, still, k);
    solve_dense(&dense, n);
    free(dense.M);
    free(column);
    free(still);
    free(rate);
    free(zero);
}

typedef struct Motion {
    double *q, *v, *effort, *a, *dense;
} Motion;

static Motion random_motion(const OpenTree *t, uint64_t *seed)
{
    Motion m = {numbers(t->n), numbers(t->n), numbers(t->n), numbers(t->n), numbers(t->n)};
    for (size_t i = 0; i < t->n; i++) {
        m.q[i] = check_uniform(seed, -3, 3);
        m.v[i] = check_uniform(seed, -2, 2);
        m.effort[i] = check_uniform(seed, -5, 5);
    }
    return m;
}

static void free_motion(Motion *m)
{
    free(m->q), free(m->v), free(m->effort), free(m->a), free(m->dense);
}

static double largest(const double *x, size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; i++) most = fmax(most, fabs(x[i]));
    return most;
}

static void check_against_dense(uint64_t seed, TreeRecipe recipe)
{
    OpenTree t = random_tree(&seed, recipe);
    for (int pose = 0; pose < 3; pose++) {
        Motion m = random_motion(&t, &seed);
        assert_int_equal(yk_tree_accelerate(t.tree, m.q, m.v, m.effort, m.a), -1);
        accelerate_densely(&t, m.q, m.v, m.effort, m.dense);
        double scale = 1 + largest(m.dense, t.n);
        for (size_t i = 0; i < t.n; i++) CHECK_NEAR(m.a[i], m.dense[i], 1e-11 * scale);
        free_motion(&m);
    }
    open_tree_free(&t);
}

static void test_trees_of_pins_agree_with_a_dense_mass_matrix(void **unused)
{
    (void)unused;
    for (uint64_t seed = 0; seed < check_cases(150); seed++)
        check_against_dense(seed, (TreeRecipe){.bodies = 2 + seed % 14, .pins_only = true, .is_chain = seed % 4 == 0});
}

static void test_trees_of_all_joints_agree_with_a_dense_mass_matrix(void **unused)
{
    (void)unused;
    for (uint64_t seed = 1000; seed < 1000 + check_cases(600); seed++)
        check_against_dense(seed, (TreeRecipe){.bodies = 2 + seed % 12, .is_chain = seed % 5 == 0});
}

// --- laws

// d(T + V)/dt of the bodies, moved by the accelerations found, is the power of the efforts.
static void check_power(uint64_t seed, TreeRecipe recipe)
{
    OpenTree t = random_tree(&seed, recipe);
    Motion m = random_motion(&t, &seed);
    BodyJet *body = calloc(t.model->body_count, sizeof *body);
    double stored = 0, given = 0, scale = 1;
    assert_non_null(body);
    assert_int_equal(yk_tree_accelerate(t.tree, m.q, m.v, m.effort, m.a), -1);
    place_bodies(&t, m.q, m.v, m.a, body);
    for (size_t k = 1; k < t.model->body_count; k++) {
        const YkBody *b = &t.model->bodies[k];
        VecJet c = center_of(&t, body, k);
        double linear = b->mass * yk_dot(c.v, yk_sub(c.a, t.model->gravity));
        double angular = b->inertia * body[k].angle.v * body[k].angle.a;
        stored += linear + angular;
        scale += fabs(linear) + fabs(angular);
    }
    for (size_t i = 0; i < t.n; i++) given += m.effort[i] * m.v[i];
    CHECK_NEAR(stored, given, 1e-12 * scale);
    free(body);
    free_motion(&m);
    open_tree_free(&t);
}

static void test_energy_changes_by_the_power_of_the_efforts(void **unused)
{
    (void)unused;
    for (uint64_t seed = 5000; seed < 5000 + check_cases(200); seed++)
        check_power(seed, (TreeRecipe){.bodies = 2 + seed % 30});
    for (uint64_t seed = 5200; seed < 5200 + check_cases(100); seed++)
        check_power(seed, (TreeRecipe){.bodies = 2 + seed % 40, .pins_only = true});
}

// With neither gravity nor effort a machine at rest stays at rest; with gravity it falls the same whatever it weighs.
static void test_a_heavier_machine_falls_the_same(void **unused)
{
    (void)unused;
    for (uint64_t seed = 7000; seed < 7000 + check_cases(50); seed++) {
        uint64_t s = seed;
        OpenTree t = random_tree(&s, (TreeRecipe){.bodies = 10});
        Motion m = random_motion(&t, &s);
        bool fits;
        assert_int_equal(yk_tree_accelerate(t.tree, m.q, m.v, NULL, m.a), -1);
        for (size_t k = 1; k < t.model->body_count; k++) {
            t.model->bodies[k].mass *= 1024; // a power of two: not a bit changes
            t.model->bodies[k].inertia *= 1024;
        }
        YkTreeDynamics *heavy = yk_tree_dynamics_new(t.mech, &fits);
        assert_non_null(heavy);
        assert_int_equal(yk_tree_accelerate(heavy, m.q, m.v, NULL, m.dense), -1);
        for (size_t i = 0; i < t.n; i++) CHECK_NEAR(m.dense[i], m.a[i], 0);
        yk_tree_dynamics_free(heavy);
        free_motion(&m);
        open_tree_free(&t);
    }
}

// A double pendulum does so, too, even where the product of its inertias overflows, or underflows and loses digits.
static void test_a_pendulum_of_any_weight_falls_the_same(void **unused)
{
    (void)unused;
    static const char *const model =
        "gravity: [0, -9.81]\nbodies:\n"
        "  ground: {points: {O: [0, 0]}}\n"
        "  a: {points: {O: [0, 0], A: [1, 0.5]}, mass: 3, center: [0.5, 0], inertia: 0.1}\n"
        "  b: {points: {A: [0, 0]}, mass: 2, center: [1, 0.2], inertia: 0.2}\n"
        "joints: {O: {pin: [ground, a]}, A: {pin: [a, b]}}\n";
    const double q[] = {0.7, -0.4}, v[] = {1, 2};
    const int weight[] = {0, -400, -520, -600, 400, 520, 900};
    double a[2], first[2];
    for (size_t k = 0; k < sizeof weight / sizeof *weight; k++) {
        OpenTree t = open_tree_compile(model);
        for (size_t i = 1; i < 3; i++) {
            t.model->bodies[i].mass = ldexp(t.model->bodies[i].mass, weight[k]);
            t.model->bodies[i].inertia = ldexp(t.model->bodies[i].inertia, weight[k]);
        }
        bool fits;
        t.tree = yk_tree_dynamics_new(t.mech, &fits);
        assert_int_equal(yk_tree_accelerate(t.tree, q, v, NULL, a), -1);
        if (k == 0) memcpy(first, a, sizeof a);
        for (size_t i = 0; i < 2; i++) CHECK_NEAR(a[i], first[i], 1e-13 * fabs(first[i]));
        open_tree_free(&t);
    }
}

// Whole turns change nothing but the last digits, however many; angles may be large.
static void test_whole_turns_change_nothing(void **unused)
{
    (void)unused;
    for (uint64_t seed = 8000; seed < 8000 + check_cases(40); seed++) {
        uint64_t s = seed;
        OpenTree t = random_tree(&s, (TreeRecipe){.bodies = 12, .pins_only = seed % 2});
        Motion m = random_motion(&t, &s);
        assert_int_equal(yk_tree_accelerate(t.tree, m.q, m.v, m.effort, m.a), -1);
        for (size_t i = 0; i < t.n; i++)
            if (!yk_coordinate_info(t.mech, yk_input_coordinate(t.mech, i)).is_distance)
                m.q[i] += 2 * YK_PI * (double)(check_random(&s) % 100);
        assert_int_equal(yk_tree_accelerate(t.tree, m.q, m.v, m.effort, m.dense), -1);
        for (size_t i = 0; i < t.n; i++) CHECK_NEAR(m.dense[i], m.a[i], 1e-10 * (1 + largest(m.a, t.n)));
        free_motion(&m);
        open_tree_free(&t);
    }
}

// --- long chains against the recursion written for them alone, in long double

static OpenTree hanging_chain(size_t n)
{
    Text text = {0};
    add(&text, "gravity: [0, -9.81]\nbodies:\n  ground: {points: {J0: [0, 0]}}\n");
    for (size_t i = 0; i < n; i++)
        add(&text, "  b%zu: {points: {J%zu: [0, 0], J%zu: [0, -1]}, mass: 1, rod: [J%zu, J%zu]}\n", i, i, i + 1, i,
            i + 1);
    add(&text, "joints:\n  J0: {pin: [ground, b0]}\n");
    for (size_t i = 1; i < n; i++) add(&text, "  J%zu: {pin: [b%zu, b%zu]}\n", i, i - 1, i);
    OpenTree t = open_tree(text.at);
    free(text.at);
    return t;
}

typedef struct Rod {
    long double ex, ey, J, hx, hy, u;
} Rod;

// Uniform rods of 1 m and 1 kg; absolute angles from the downward vertical, rates, accelerations; tau[n + 1]: torques
// along the joints. (The recursion "d3" of bench/reference.)
static void recursion(size_t n, const long double *theta, const long double *w, const double *tau, long double *alpha,
                      Rod *rod)
{
    const long double c = 0.5L, I = 1 / 12.0L, g = 9.81; // as the model file's double
    long double xx = 0, xy = 0, yy = 0, fx = 0, fy = 0, ax = 0, ay = 0;
    for (size_t i = n; i-- > 0;) {
        long double ex = sinl(theta[i]), ey = -cosl(theta[i]), px = -ey, py = ex, w2 = w[i] * w[i];
        long double gx = fx - w2 * (xx * ex + xy * ey), gy = fy - w2 * (xy * ex + yy * ey);
        long double qx = xx * px + xy * py, qy = xy * px + yy * py, J = I + c * c + px * qx + py * qy;
        long double hx = c * px + qx, hy = c * py + qy;
        long double moment = tau[i] - tau[i + 1], u = (moment - g * c * py - px * gx - py * gy) / J;
        rod[i] = (Rod){ex, ey, J, hx, hy, u};
        xx = 1 + xx - hx * hx / J;
        xy = xy - hx * hy / J;
        yy = 1 + yy - hy * hy / J;
        fx = -c * w2 * ex + gx + hx * u;
        fy = -c * w2 * ey + g + gy + hy * u;
    }
    for (size_t i = 0; i < n; i++) {
        alpha[i] = rod[i].u - (rod[i].hx * ax + rod[i].hy * ay) / rod[i].J;
        ax += -rod[i].ey * alpha[i] - w[i] * w[i] * rod[i].ex;
        ay += rod[i].ex * alpha[i] - w[i] * w[i] * rod[i].ey;
    }
}

// Joint i at bend * (an irregular number of 0 to 10), a small rate and an effort that sets every link moving.
static void check_chain(size_t n, double bend, double tolerance)
{
    OpenTree t = hanging_chain(n);
    double *q = numbers(n), *v = numbers(n), *a = numbers(n), *tau = numbers(n);
    long double *theta = calloc(3 * n, sizeof *theta), *w = theta + n, *alpha = theta + 2 * n, angle = 0, rate = 0;
    Rod *rod = calloc(n, sizeof *rod);
    assert_non_null(theta);
    assert_non_null(rod);
    for (size_t i = 0; i < n; i++) {
        q[i] = bend * (double)(i * 7 % 11);
        v[i] = 0.001 * ((double)(i * 5 % 7) - 3);
        tau[i] = i * 3 % 5 < 2 ? 1 : -1;
        theta[i] = angle += q[i];
        w[i] = rate += v[i];
    }
    recursion(n, theta, w, tau, alpha, rod);
    assert_int_equal(yk_tree_accelerate(t.tree, q, v, tau, a), -1);
    double most = 0, sum = 0;
    for (size_t i = 0; i < n; i++) most = fmax(most, fabs((double)alpha[i]));
    for (size_t i = 0; i < n; i++) {
        CHECK_NEAR(a[i], (double)(alpha[i] - (i ? alpha[i - 1] : 0)), tolerance * most);
        sum += a[i];
    }
    CHECK_NEAR(sum, (double)alpha[n - 1], 10 * tolerance * most);
    free(q), free(v), free(a), free(tau), free(theta), free(rod);
    open_tree_free(&t);
}

static void test_chains_of_any_length_follow_the_recursion(void **unused)
{
    (void)unused;
    static const size_t lengths[] = {1, 2, 3, 7, 8, 9, 10, 16, 127, 128, 129, 130, 255, 256, 257, 1000};
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) check_chain(lengths[k], 0.01, 1e-13);
}

static void test_a_chain_of_100000_links_follows_the_recursion(void **unused)
{
    (void)unused;
    check_without_sanitizers();
    check_chain(100000, 0.01, 1e-13);
}

// Coils up over thousands of turns: digits are not lost on the way out.
static void test_a_coiled_chain_keeps_its_digits(void **unused)
{
    (void)unused;
    check_chain(20000, 0.6, 5e-14);
}

// --- forks

// Equal arms on one hub, which is on the ground's point; each weighs `weight` times as much as is written there.
static OpenTree fork_of(int arms, int weight)
{
    Text text = {0};
    add(&text, "gravity: [3, -9.81]\nbodies:\n  ground: {points: {O: [0, 0]}}\n  hub: {points: {O: [0, 0]");
    for (int k = 0; k < arms; k++) add(&text, ", A%d: [1, 0.5]", k);
    add(&text, "}, mass: 5, center: [0.1, 0.2], inertia: 1}\n");
    for (int k = 0; k < arms; k++) {
        add(&text, "  arm%d: {points: {A%d: [0, 0], B%d: [1, 0]}, mass: %d, rod: [A%d, B%d]}\n", k, k, k, weight, k, k);
        add(&text, "  tip%d: {points: {B%d: [0, 0]}, mass: %d, center: [0, 1], inertia: %d/10}\n", k, k, 2 * weight,
            weight);
    }
    add(&text, "joints:\n  O: {pin: [ground, hub]}\n");
    for (int k = 0; k < arms; k++)
        add(&text, "  A%d: {pin: [hub, arm%d]}\n  B%d: {pin: [arm%d, tip%d]}\n", k, k, k, k, k);
    OpenTree t = open_tree(text.at);
    free(text.at);
    assert_int_equal(t.n, 2 * arms + 1);
    return t;
}

// Moves all arms alike and accelerates them.
static Motion move_fork(const OpenTree *t)
{
    Motion m = {numbers(t->n), numbers(t->n), numbers(t->n), numbers(t->n), numbers(t->n)};
    for (size_t i = 0; i < t->n; i++) {
        m.q[i] = i == 0 ? 0.3 : i % 2 ? -1 : 2;
        m.v[i] = i == 0 ? 1 : i % 2 ? 0.5 : -1.5;
    }
    assert_int_equal(yk_tree_accelerate(t->tree, m.q, m.v, NULL, m.a), -1);
    return m;
}

static void test_like_arms_move_as_one_of_their_weight(void **unused)
{
    (void)unused;
    enum { ARMS = 200 };
    OpenTree many = fork_of(ARMS, 1), one = fork_of(1, ARMS);
    Motion m = move_fork(&many), of_one = move_fork(&one);
    for (size_t i = 3; i < many.n; i++) CHECK_NEAR(m.a[i], m.a[i - 2], 1e-12 * largest(m.a, many.n));
    for (size_t i = 0; i < 3; i++) CHECK_NEAR(m.a[i], of_one.a[i], 1e-12 * largest(m.a, many.n));
    free_motion(&m);
    free_motion(&of_one);
    open_tree_free(&many);
    open_tree_free(&one);
}

static void test_like_arms_agree_with_a_dense_mass_matrix(void **unused)
{
    (void)unused;
    OpenTree t = fork_of(20, 1);
    Motion m = move_fork(&t);
    accelerate_densely(&t, m.q, m.v, m.effort, m.dense);
    for (size_t i = 0; i < t.n; i++) CHECK_NEAR(m.a[i], m.dense[i], 1e-10 * largest(m.a, t.n));
    free_motion(&m);
    open_tree_free(&t);
}

// --- what does not move

static void test_welded_to_the_ground_nothing_moves(void **unused)
{
    (void)unused;
    OpenTree t = open_tree("bodies: {ground: {}, a: {mass: 1}, b: {mass: 2}}\n"
                           "joints: {A: {weld: [ground, a]}, B: {weld: [b, a], turned: 1}}\n");
    double x = 1;
    assert_int_equal(t.n, 0);
    assert_int_equal(yk_tree_accelerate(t.tree, &x, &x, &x, &x), -1);
    CHECK_NEAR(x, 1, 0);
    open_tree_free(&t);
}

// A rod welded of two halves is the rod.
static void test_welded_halves_are_the_whole(void **unused)
{
    (void)unused;
    OpenTree whole = open_tree(
        "gravity: [0, -9.81]\nbodies: {ground: {}, rod: {points: {P: [0, 0], Q: [2, 0]}, mass: 4, rod: [P, Q]}}\n"
        "joints: {O: {pin: [ground, rod]}}\n");
    OpenTree halves =
        open_tree("gravity: [0, -9.81]\n"
                  "bodies:\n  ground: {}\n  near: {points: {P: [0, 0], W: [1, 0]}, mass: 2, rod: [P, W]}\n"
                  "  far: {points: {W: [5, 0], Q: [5, 1]}, mass: 2, rod: [W, Q]}\n"
                  "joints: {O: {pin: [ground, near]}, W: {weld: [near, far], turned: -90 deg}}\n");
    for (double q = -3; q < 3; q += 0.37) {
        double a, b, v = 2, tau = 0.7;
        assert_int_equal(yk_tree_accelerate(whole.tree, &q, &v, &tau, &a), -1);
        assert_int_equal(yk_tree_accelerate(halves.tree, &q, &v, &tau, &b), -1);
        CHECK_NEAR(a, (tau - 4 * 9.81 * cos(q)) / (16.0 / 3), 1e-13);
        CHECK_NEAR(b, a, 1e-13);
    }
    open_tree_free(&whole);
    open_tree_free(&halves);
}

// --- freedoms without inertia

// With the first coordinate at `first` and all angles after it at `angle`: names the coordinate `culprit`, or (NULL)
// none.
static void check_culprit_at(const OpenTree *t, const char *culprit, double first, double angle)
{
    Motion m = {numbers(t->n), numbers(t->n), numbers(t->n), numbers(t->n), numbers(t->n)};
    m.q[0] = first;
    for (size_t i = 1; i < t->n; i++)
        if (!yk_coordinate_info(t->mech, yk_input_coordinate(t->mech, i)).is_distance) m.q[i] = angle;
    int found = yk_tree_accelerate(t->tree, m.q, m.v, m.effort, m.a);
    if (culprit) {
        if (found < 0) print_error("%s has inertia at %.17g, %.17g\n", culprit, first, angle);
        assert_true(found >= 0);
        assert_string_equal(yk_coordinate_info(t->mech, yk_input_coordinate(t->mech, (size_t)found)).name, culprit);
    } else {
        assert_int_equal(found, -1);
        for (size_t i = 0; i < t->n; i++) assert_true(isfinite(m.a[i]));
    }
    free_motion(&m);
}

// The same in many directions: what is 0 exactly is small and of either sign when rounded.
static void check_culprit(const char *bodies_and_joints, const char *culprit, double angle)
{
    char text[2000];
    snprintf(text, sizeof text, "gravity: [0, -9.81]\n%s", bodies_and_joints);
    OpenTree t = open_tree(text);
    for (double first = -3; first < 3; first += 0.01) check_culprit_at(&t, culprit, first, angle);
    open_tree_free(&t);
}

static void test_a_freedom_without_inertia_is_named(void **unused)
{
    (void)unused;
    check_culprit("bodies: {ground: {}, a: {}}\njoints: {O: {pin: [ground, a]}}\n", "O.angle", 0);
    check_culprit("bodies: {ground: {}, a: {mass: 1}}\njoints: {O: {pin: [ground, a]}}\n", "O.angle", 0);
    check_culprit("bodies: {ground: {}, a: {}}\njoints: {R: {slide: [ground, a], along: x}}\n", "R.distance", 0);
    check_culprit("bodies: {ground: {}, a: {mass: 1}}\njoints: {R: {slide: [ground, a], along: x}}\n", NULL, 0);
    check_culprit("bodies: {ground: {}, a: {mass: 1}}\njoints: {R: {pin-slot: [ground, a], along: x}}\n", "R.angle", 0);
    check_culprit("bodies: {ground: {}, a: {}, b: {mass: 1, inertia: 1}}\n"
                  "joints: {O: {pin: [ground, b]}, R: {slide: [b, a], along: x}}\n",
                  "R.distance", 1);
    check_culprit("bodies: {ground: {}, a: {}, b: {mass: 1, inertia: 1}}\n"
                  "joints: {O: {pin: [ground, b]}, R: {pin-slot: [b, a], along: x}}\n",
                  "R.angle", 1);
}

// A link without mass carries a point mass on a second one: fine, but for both in one line, where it has no inertia.
static void test_a_massless_link_between(void **unused)
{
    (void)unused;
    static const char *const model = "bodies: {ground: {points: {O: [0, 0]}}, a: {points: {O: [0, 0], A: [1, 0]}}, b: "
                                     "{points: {A: [0, 0]}, mass: 2, "
                                     "center: [1, 0]}}\njoints: {O: {pin: [ground, a]}, A: {pin: [a, b]}}\n";
    check_culprit(model, NULL, 1);
    check_culprit(model, NULL, 1e-3);
    check_culprit(model, "O.angle", 0);
    check_culprit(model, "O.angle", YK_PI);
}

// The same where something slides as well, somewhere else.
static void test_a_massless_link_beside_a_slide(void **unused)
{
    (void)unused;
    static const char *const model =
        "bodies: {ground: {points: {O: [0, 0]}}, a: {points: {O: [0, 0], A: [1, 0]}}, b: {points: {A: [0, 0]}, mass: "
        "2, "
        "center: [1, 0]}, side: {mass: 1}}\n"
        "joints: {O: {pin: [ground, a]}, A: {pin: [a, b]}, S: {slide: [ground, side], along: x}}\n";
    check_culprit(model, NULL, 1);
    check_culprit(model, "O.angle", 0);
    check_culprit(model, "O.angle", YK_PI);
}

// A point mass on a pinned bar on a slider on a massless bar: what the pin leaves of it, the slider takes.
static void test_a_massless_bar_with_a_slider(void **unused)
{
    (void)unused;
    static const char *const model =
        "bodies: {ground: {}, a: {}, b: {points: {X: [1, 0]}}, c: {points: {X: [0, 0]}, mass: 2, center: [1, 0]}}\n"
        "joints: {O: {pin: [ground, a]}, S: {slide: [a, b], along: x}, X: {pin: [b, c]}}\n";
    check_culprit(model, "O.angle", 1);
    check_culprit(model, "O.angle", 0);
}

// Two slides along the same line: the second one has nothing left to move.
static void test_two_slides_in_one_line(void **unused)
{
    (void)unused;
    for (double along = -3; along < 3; along += 0.037) {
        char model[500];
        snprintf(model, sizeof model,
                 "bodies: {ground: {}, a: {}, b: {mass: 0.3}}\n"
                 "joints: {R: {slide: [ground, a], along: %.17g}, S: {slide: [a, b], along: %.17g, turned: 1}}\n",
                 along, along);
        OpenTree t = open_tree(model);
        check_culprit_at(&t, "R.distance", 0.4, 0);
        open_tree_free(&t);
    }
}

// --- fewer masses than freedoms

static void test_freedoms_that_no_mass_shows_are_never_inertia(void **unused)
{
    (void)unused;
    size_t lacking = 0;
    for (uint64_t seed = 12000; seed < 12000 + check_cases(300); seed++) {
        uint64_t s = seed;
        Text text = {0};
        LightTree light = light_tree(&s, &text, false);
        if (lacks_mass(light)) {
            OpenTree t = open_tree(text.at);
            for (size_t pose = 0; pose < 20; pose++) {
                Motion m = random_motion(&t, &s);
                int found = yk_tree_accelerate(t.tree, m.q, m.v, m.effort, m.a);
                if (found < 0) print_error("seed %d, pose %zu:\n%s", (int)seed, pose, text.at);
                assert_true(found >= 0);
                free_motion(&m);
            }
            open_tree_free(&t);
            lacking++;
        }
        free(text.at);
    }
    assert_true(lacking >= check_cases(300) / 4);
}

static void test_a_failure_leaves_no_trace(void **unused)
{
    (void)unused;
    // A fork: two arms on a massless link; one has no inertia in line.
    OpenTree t = open_tree("gravity: [0, -9.81]\nbodies:\n"
                           "  ground: {points: {O: [0, 0]}}\n  a: {points: {O: [0, 0], A: [1, 0], B: [1, 0]}}\n"
                           "  b: {points: {A: [0, 0]}, mass: 2, center: [1, 0]}\n"
                           "  c: {points: {B: [0, 0]}, mass: 1, center: [1, 0]}\n"
                           "joints: {O: {pin: [ground, a]}, A: {pin: [a, b]}, B: {pin: [a, c]}}\n");
    const double bent[3] = {0.1, 1, 0.5}, straight[3] = {0.1, 0, 0}, v[3] = {1, 2, 3};
    double first[3], again[3];
    assert_int_equal(yk_tree_accelerate(t.tree, bent, v, NULL, first), -1);
    assert_int_equal(yk_tree_accelerate(t.tree, straight, v, NULL, again), 0);
    assert_int_equal(yk_tree_accelerate(t.tree, bent, v, NULL, again), -1);
    for (int i = 0; i < 3; i++) CHECK_NEAR(again[i], first[i], 0);
    open_tree_free(&t);
}

static void test_what_is_not_a_number_is_no_inertia(void **unused)
{
    (void)unused;
    OpenTree t = open_tree(pendulum);
    const double q[2] = {0, (double)NAN}, v[2] = {0, 0};
    double a[2];
    assert_true(yk_tree_accelerate(t.tree, q, v, NULL, a) >= 0);
    open_tree_free(&t);
}

// --- which machines fit

static void check_fits(const OpenTree *t, bool expected)
{
    bool fits = !expected;
    YkTreeDynamics *tree = yk_tree_dynamics_new(t->mech, &fits);
    assert_int_equal(fits, expected);
    assert_int_equal(tree != NULL, expected);
    yk_tree_dynamics_free(tree);
}

static void test_loops_and_drives_do_not_fit(void **unused)
{
    (void)unused;
    OpenTree loop = open_tree_compile(
        "bodies: {ground: {points: {A: [0, 0], B: [1, 0]}}, a: {points: {A: [0, 0], C: [1, 0]}, mass: 1}, b: "
        "{points: {C: [0, 0], D: [1, 0]}}, c: {points: {D: [0, 0], B: [1, 0]}}}\n"
        "joints: {A: {pin: [ground, a]}, C: {pin: [a, b]}, D: {pin: [b, c]}, B: {pin: [c, ground]}}\n");
    check_fits(&loop, false);
    open_tree_free(&loop);
    OpenTree driven = open_tree_compile("bodies: {ground: {}, a: {mass: 1, inertia: 1}}\n"
                                        "joints: {O: {pin: [ground, a], angle: phi}}\ndrives: {phi: 1 rad/s * t}\n");
    check_fits(&driven, false);
    open_tree_free(&driven);
}

static void test_other_loads_do_not_fit(void **unused)
{
    (void)unused;
    OpenTree t = open_tree_compile(pendulum);
    check_fits(&t, true);
    size_t *const counts[] = {&t.model->force_count, &t.model->spring_count, &t.model->stop_count};
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        *counts[k] = 1;
        check_fits(&t, false);
        *counts[k] = 0;
    }
    t.model->joints[1].has_friction = true;
    check_fits(&t, false);
    t.model->joints[1].has_friction = false;
    check_fits(&t, true);
    open_tree_free(&t);
    yk_tree_dynamics_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_double_pendulum_as_published),
        cmocka_unit_test(test_double_pendulum_is_its_closed_form_everywhere),
        cmocka_unit_test(test_without_efforts_is_with_efforts_of_zero),
        cmocka_unit_test(test_trees_of_pins_agree_with_a_dense_mass_matrix),
        cmocka_unit_test(test_trees_of_all_joints_agree_with_a_dense_mass_matrix),
        cmocka_unit_test(test_energy_changes_by_the_power_of_the_efforts),
        cmocka_unit_test(test_a_heavier_machine_falls_the_same),
        cmocka_unit_test(test_a_pendulum_of_any_weight_falls_the_same),
        cmocka_unit_test(test_whole_turns_change_nothing),
        cmocka_unit_test(test_chains_of_any_length_follow_the_recursion),
        cmocka_unit_test(test_a_chain_of_100000_links_follows_the_recursion),
        cmocka_unit_test(test_a_coiled_chain_keeps_its_digits),
        cmocka_unit_test(test_like_arms_move_as_one_of_their_weight),
        cmocka_unit_test(test_like_arms_agree_with_a_dense_mass_matrix),
        cmocka_unit_test(test_welded_to_the_ground_nothing_moves),
        cmocka_unit_test(test_welded_halves_are_the_whole),
        cmocka_unit_test(test_a_freedom_without_inertia_is_named),
        cmocka_unit_test(test_a_massless_link_between),
        cmocka_unit_test(test_a_massless_link_beside_a_slide),
        cmocka_unit_test(test_a_massless_bar_with_a_slider),
        cmocka_unit_test(test_two_slides_in_one_line),
        cmocka_unit_test(test_freedoms_that_no_mass_shows_are_never_inertia),
        cmocka_unit_test(test_a_failure_leaves_no_trace),
        cmocka_unit_test(test_what_is_not_a_number_is_no_inertia),
        cmocka_unit_test(test_loops_and_drives_do_not_fit),
        cmocka_unit_test(test_other_loads_do_not_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
