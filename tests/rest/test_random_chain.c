// Random hanging chains of one to four links with torsion springs and dampers: mass, stiffness and damping by
// Lagrange's equations, written here in the links' own angles; modes and roots by what they have to fulfil.
#include <complex.h>
#include <stdlib.h>
#include "check.h"
#include <yoke/yoke.h>

enum { LINKS = 4, CHAINS = 60 };
static const double gravity = 9.81;

typedef struct Chain {
    size_t n;
    double length[LINKS], center[LINKS], mass[LINKS], inertia[LINKS], spring[LINKS], damper[LINKS];
    double M[LINKS * LINKS], C[LINKS * LINKS], K[LINKS * LINKS]; // [n][n], in the joints' angles
} Chain;

static void draw(Chain *c, uint64_t *seed)
{
    c->n = 1 + check_random(seed) % LINKS;
    for (size_t k = 0; k < c->n; k++) {
        c->length[k] = check_uniform(seed, 0.3, 1.5);
        c->center[k] = check_uniform(seed, 0.1, 1);
        c->mass[k] = check_uniform(seed, 0.2, 3);
        c->inertia[k] = check_uniform(seed, 0.01, 0.5);
        c->spring[k] = check_uniform(seed, 0, 20);
        c->damper[k] = check_uniform(seed, 0, 2);
    }
}

// Link i's angle is the sum of the joints' up to it: what belongs to links i and j counts for all joints above both.
static void add(double *to, size_t n, size_t i, size_t j, double value)
{
    for (size_t a = 0; a <= i; a++)
        for (size_t b = 0; b <= j; b++) to[a * n + b] += value;
}

static void write_matrices(Chain *c)
{
    for (size_t i = 0; i < c->n; i++) {
        double below = 0; // the mass of the links under this one
        for (size_t k = i + 1; k < c->n; k++) below += c->mass[k];
        double own = c->inertia[i] + c->mass[i] * c->center[i] * c->center[i] + below * c->length[i] * c->length[i];
        add(c->M, c->n, i, i, own);
        add(c->K, c->n, i, i, gravity * (c->mass[i] * c->center[i] + below * c->length[i]));
        c->K[i * c->n + i] += c->spring[i];
        c->C[i * c->n + i] += c->damper[i];
        for (size_t j = i + 1; j < c->n; j++) {
            double beyond = 0;
            for (size_t k = j + 1; k < c->n; k++) beyond += c->mass[k];
            double mixed = c->length[i] * (c->mass[j] * c->center[j] + beyond * c->length[j]);
            add(c->M, c->n, i, j, mixed);
            add(c->M, c->n, j, i, mixed);
        }
    }
}

#define ADD(...) snprintf(text + strlen(text), size - strlen(text), __VA_ARGS__)

static void write_text(const Chain *c, char *text, size_t size)
{
    *text = 0;
    ADD("gravity: [0, -%g]\nbodies:\n  ground: {points: {P0: [0, 0]}}\n", gravity);
    for (size_t k = 0; k < c->n; k++)
        ADD("  b%zu: {points: {P%zu: [0, 0], P%zu: [0, %.17g]}, mass: %.17g, center: [0, %.17g], inertia: %.17g}\n", k,
            k, k + 1, -c->length[k], c->mass[k], -c->center[k], c->inertia[k]);
    ADD("joints:\n");
    for (size_t k = 0; k < c->n; k++)
        if (k == 0)
            ADD("  P0: {pin: [ground, b0], angle: q0}\n");
        else
            ADD("  P%zu: {pin: [b%zu, b%zu], angle: q%zu}\n", k, k - 1, k, k);
    ADD("springs:\n");
    for (size_t k = 0; k < c->n; k++)
        ADD("  s%zu: {along: q%zu, stiffness: %.17g, damping: %.17g}\n", k, k, c->spring[k], c->damper[k]);
}

static void check_matrix(const double *found, const double *due, size_t n)
{
    double most = 1e-3;
    for (size_t k = 0; k < n * n; k++) most = fmax(most, fabs(due[k]));
    for (size_t k = 0; k < n * n; k++) CHECK_NEAR(found[k], due[k], 1e-7 * most);
}

static double product(const double *left, const double *matrix, const double *right, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) sum += left[i] * matrix[i * n + j] * right[j];
    return sum;
}

// K s = omega^2 M s in every row, frequencies in order, shapes that share no energy, their damping.
static void check_modes(const Chain *c, const YkRest *rest)
{
    double before = 0;
    for (size_t k = 0; k < c->n; k++) {
        YkMode mode = yk_rest_mode(rest, 0, k);
        double square = mode.frequency * mode.frequency, most = 0, own = product(mode.shape, c->M, mode.shape, c->n);
        assert_true(mode.frequency >= before);
        before = mode.frequency;
        for (size_t i = 0; i < c->n; i++) {
            double row[LINKS] = {0};
            row[i] = 1;
            double stiff = product(row, c->K, mode.shape, c->n), swings = square * product(row, c->M, mode.shape, c->n);
            CHECK_NEAR(stiff, swings, 1e-6 * (fabs(stiff) + c->K[0]));
            most = fmax(most, mode.shape[i]);
            assert_true(fabs(mode.shape[i]) <= 1);
        }
        CHECK_NEAR(most, 1, 0);
        double damping = product(mode.shape, c->C, mode.shape, c->n);
        CHECK_NEAR(mode.damping_ratio, damping / (2 * mode.frequency * own), 1e-6 * (1 + mode.damping_ratio));
        for (size_t l = 0; l < k; l++) {
            YkMode other = yk_rest_mode(rest, 0, l);
            double others = product(other.shape, c->M, other.shape, c->n);
            CHECK_NEAR(product(mode.shape, c->M, other.shape, c->n), 0, 1e-6 * sqrt(own * others));
        }
    }
}

// The determinant of M x^2 + C x + K, by elimination.
static double complex determinant(const Chain *c, double complex x)
{
    double complex A[LINKS][LINKS], value = 1;
    for (size_t i = 0; i < c->n; i++)
        for (size_t j = 0; j < c->n; j++) {
            size_t at = i * c->n + j;
            A[i][j] = (c->M[at] * x + c->C[at]) * x + c->K[at];
        }
    for (size_t p = 0; p < c->n; p++) {
        size_t best = p;
        for (size_t i = p; i < c->n; i++)
            if (cabs(A[i][p]) > cabs(A[best][p])) best = i;
        for (size_t j = 0; j < c->n; j++) {
            double complex held = A[p][j];
            A[p][j] = A[best][j];
            A[best][j] = held;
        }
        value *= best == p ? A[p][p] : -A[p][p];
        for (size_t i = p + 1; i < c->n && A[p][p] != 0; i++) {
            double complex times = A[i][p] / A[p][p];
            for (size_t j = p; j < c->n; j++) A[i][j] -= times * A[p][j];
        }
    }
    return value;
}

// At points away from the roots, det(M x^2 + C x + K) = det M times the product of x less each root.
static void check_roots(const Chain *c, const YkRest *rest)
{
    double unit = yk_rest_mode(rest, 0, c->n - 1).frequency;
    double scaled = creal(determinant(c, 1e9)) / pow(1e9, 2.0 * (double)c->n); // det M, to 1e-8
    for (int k = 0; k < 5; k++) {
        double complex x = unit * (0.3 + 0.4 * k) * cexp(I * (0.5 + k)), due = scaled;
        for (size_t r = 0; r < 2 * c->n; r++) {
            double real, imaginary;
            yk_rest_root(rest, 0, r, &real, &imaginary);
            assert_true(real < 1e-7 * unit); // it hangs, and dampers take energy
            due *= x - (real + I * imaginary);
        }
        double complex found = determinant(c, x);
        CHECK_NEAR(cabs(found - due), 0, 1e-4 * cabs(due));
    }
}

static void hanging_chains_swing_as_lagrange_says(void **unused)
{
    (void)unused;
    uint64_t seed = 15;
    for (uint64_t k = 0; k < check_cases(CHAINS); k++) {
        Chain c = {0};
        char text[4000];
        draw(&c, &seed);
        write_matrices(&c);
        write_text(&c, text, sizeof text);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_parse(text, strlen(text), "chain.yaml", NULL, problems);
        YkRestOptions options = yk_default_rest_options();
        options.starts = 0;
        YkRest *rest = model ? yk_rest_find(model, &options, problems) : NULL;
        if (!rest) print_error("%s%s", text, yk_problems_text(problems, 0));
        assert_non_null(rest);
        assert_int_equal(yk_rest_freedom(rest), c.n);
        assert_true(yk_rest_count(rest) > 0);
        assert_int_equal(yk_rest_equilibrium(rest, 0).stability, YK_STABILITY_STABLE);
        check_matrix(yk_rest_mass(rest, 0), c.M, c.n);
        check_matrix(yk_rest_stiffness(rest, 0), c.K, c.n);
        check_matrix(yk_rest_damping(rest, 0), c.C, c.n);
        check_modes(&c, rest);
        check_roots(&c, rest);
        yk_rest_free(rest);
        yk_model_free(model);
        yk_problems_free(problems);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hanging_chains_swing_as_lagrange_says),
    };
    return cmocka_run_group_tests_name("rest/random_chain", tests, NULL, NULL);
}
