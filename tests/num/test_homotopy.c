// Following a root while its equation changes, against roots in closed form.
#include "num/homotopy.h"
#include "check.h"

// x[k]^(k + 2) = a for every k, where a goes round the origin: a = exp(2 pi i turns t). The root then is exp(2 pi i
// turns t / (k + 2)), another branch than the one it began on.
typedef struct Roots {
    size_t n;
    double turns;
    YkVec a;
    bool is_undetermined;
    size_t asked, most;
} Roots;

static YkVec power(YkVec x, size_t exponent)
{
    YkVec product = yk_vec(1, 0);
    for (size_t k = 0; k < exponent; k++) product = yk_mul(product, x);
    return product;
}

static YkVec quotient(YkVec a, YkVec b)
{
    return yk_scale(1 / (b.x * b.x + b.y * b.y), yk_mul(a, yk_conj(b)));
}

static void go_to(void *context, double t)
{
    Roots *roots = context;
    roots->a = yk_vec(cos(2 * YK_PI * roots->turns * t), sin(2 * YK_PI * roots->turns * t));
}

static bool tangent(void *context, const YkVec *x, YkVec *rate)
{
    const Roots *roots = context;
    YkVec change = yk_mul(yk_vec(0, 2 * YK_PI * roots->turns), roots->a);
    for (size_t k = 0; k < roots->n; k++) rate[k] = quotient(change, yk_scale((double)k + 2, power(x[k], k + 1)));
    return !roots->is_undetermined;
}

static double correct(void *context, YkVec *x)
{
    const Roots *roots = context;
    double most = 0;
    for (size_t k = 0; k < roots->n; k++) {
        YkVec miss = yk_sub(power(x[k], k + 2), roots->a),
              step = quotient(miss, yk_scale((double)k + 2, power(x[k], k + 1)));
        x[k] = yk_sub(x[k], step);
        most = fmax(most, hypot(step.x, step.y));
    }
    return most;
}

static bool goes_on(void *context, const YkVec *x)
{
    Roots *roots = context;
    (void)x;
    return roots->asked++ < roots->most;
}

static YkHomotopy homotopy_of(Roots *roots)
{
    return (YkHomotopy){.n = roots->n,
                        .context = roots,
                        .go_to = go_to,
                        .tangent = tangent,
                        .correct = correct,
                        .goes_on = goes_on,
                        .first_step = 0.05,
                        .least_step = 1e-8,
                        .steps = 1000,
                        .enough = 1e-12,
                        .at_most = 1e-9};
}

static void start(const Roots *roots, YkVec *x)
{
    for (size_t k = 0; k < roots->n; k++) x[k] = yk_vec(1, 0);
}

static void roots_end_on_the_branch_that_they_turn_to(void **state)
{
    (void)state;
    for (size_t n = 1; n <= 6; n++)
        for (double turns = -2; turns <= 2; turns += 0.375) {
            Roots roots = {.n = n, .turns = turns, .most = SIZE_MAX};
            YkHomotopy homotopy = homotopy_of(&roots);
            YkVec x[YK_HOMOTOPY_UNKNOWNS];
            start(&roots, x);
            assert_true(yk_homotopy_follow(&homotopy, x));
            assert_true(roots.asked < 400); // steps: the error of each is that of the fourth order
            yk_homotopy_polish(&homotopy, 5, x);
            for (size_t k = 0; k < n; k++) {
                double angle = 2 * YK_PI * turns / ((double)k + 2);
                CHECK_NEAR(x[k].x, cos(angle), 4e-15);
                CHECK_NEAR(x[k].y, sin(angle), 4e-15);
            }
        }
}

static void what_hinders_it_ends_it(void **state)
{
    (void)state;
    YkVec x[YK_HOMOTOPY_UNKNOWNS];
    Roots roots = {.n = 2, .turns = 1, .most = SIZE_MAX};
    YkHomotopy homotopy = homotopy_of(&roots);
    start(&roots, x);
    assert_true(yk_homotopy_follow(&homotopy, x));
    size_t steps = roots.asked;
    for (size_t most = 0; most < steps; most++) { // one step too few, or told not to go on
        for (int way = 0; way < 2; way++) {
            roots.asked = 0, roots.most = way ? most : SIZE_MAX;
            homotopy.steps = way ? 1000 : (int)most;
            start(&roots, x);
            assert_false(yk_homotopy_follow(&homotopy, x));
            assert_int_equal(roots.asked, most + (size_t)way);
        }
    }
    homotopy.steps = (int)steps, roots.asked = 0, roots.most = steps;
    start(&roots, x);
    assert_true(yk_homotopy_follow(&homotopy, x));
    roots.is_undetermined = true;
    start(&roots, x);
    assert_false(yk_homotopy_follow(&homotopy, x));
    roots.is_undetermined = false;
    homotopy.least_step = 1; // no step is short enough
    start(&roots, x);
    assert_false(yk_homotopy_follow(&homotopy, x));
}

// Newton's method doubles the digits until only rounding is left; the last step that counts is reported.
static void polishing_stops_at_rounding(void **state)
{
    (void)state;
    Roots roots = {.n = 1};
    YkHomotopy homotopy = homotopy_of(&roots);
    YkVec x = {1.1, 0.1};
    go_to(&roots, 0);
    assert_true(yk_homotopy_polish(&homotopy, 1, &x) > 0.01);
    assert_true(hypot(x.x - 1, x.y) > 1e-4);
    assert_true(yk_homotopy_polish(&homotopy, 20, &x) < 1e-8);
    CHECK_NEAR(x.x, 1, 1e-15);
    CHECK_NEAR(x.y, 0, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(roots_end_on_the_branch_that_they_turn_to),
        cmocka_unit_test(what_hinders_it_ends_it),
        cmocka_unit_test(polishing_stops_at_rounding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
