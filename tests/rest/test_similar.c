// Examples in other units (tests/similar.h): equilibria are found alike, with similar matrices, modes and roots.
#include "../similar.h"

static YkRest *find(const Similar *m)
{
    YkRestOptions options = yk_default_rest_options();
    options.starts = 4;
    YkRest *rest = yk_rest_find(m->model, &options, m->problems);
    if (!rest) print_error("%s: %s", m->file, yk_problems_text(m->problems, 0));
    assert_non_null(rest);
    return rest;
}

// Entry (i, j) of a matrix that makes of an input of unit j an effort of unit i, both rad or m.
static double entry(const double *matrix, const YkRest *rest, size_t i, size_t j)
{
    return matrix[i * yk_rest_freedom(rest) + j];
}

static bool is_distance(const YkRest *rest, size_t k)
{
    return yk_coordinate_info(yk_rest_mechanism(rest), yk_rest_input(rest, k)).is_distance;
}

// Compares an entry of mass, damping or stiffness: an effort by an acceleration, a rate or a place.
static void check_entry(double a, double b, int order, int lengths, const char *file)
{
    // J s^order / rad^2, less a length for each of its two inputs that is one.
    double energy = similar_to(1, YK_QUANTITY_ENERGY), second = similar_to(1, YK_QUANTITY_TIME);
    double metre = similar_to(1, YK_QUANTITY_LENGTH), unit = energy;
    for (int k = 0; k < order; k++) unit *= second;
    for (int k = 0; k < lengths; k++) unit /= metre;
    similar_check(a * unit, b, YK_QUANTITY_NUMBER, file, "an entry of a matrix");
}

static void check_point(const Similar *a, YkRest *one, YkRest *two, size_t p)
{
    size_t f = yk_rest_freedom(one);
    YkEquilibrium e = yk_rest_equilibrium(one, p), g = yk_rest_equilibrium(two, p);
    SIMILAR_EQUAL(a->file, e.stability, g.stability);
    similar_check(e.potential, g.potential, YK_QUANTITY_ENERGY, a->file, "potential energy");
    similar_check(e.force, g.force, YK_QUANTITY_NUMBER, a->file, "force that is left");
    YkState *s = yk_rest_state(one, p), *t = yk_rest_state(two, p);
    for (size_t c = 0; c < yk_coordinate_count(yk_rest_mechanism(one)); c++)
        similar_check(yk_state_coordinate(s, c).position, yk_state_coordinate(t, c).position,
                      similar_quantity(yk_rest_mechanism(one), c), a->file, "place of a coordinate");
    for (size_t i = 0; i < f; i++)
        for (size_t j = 0; j < f; j++) {
            int lengths = is_distance(one, i) + is_distance(one, j);
            check_entry(entry(yk_rest_mass(one, p), one, i, j), entry(yk_rest_mass(two, p), two, i, j), 2, lengths,
                        a->file);
            check_entry(entry(yk_rest_damping(one, p), one, i, j), entry(yk_rest_damping(two, p), two, i, j), 1,
                        lengths, a->file);
            check_entry(entry(yk_rest_stiffness(one, p), one, i, j), entry(yk_rest_stiffness(two, p), two, i, j), 0,
                        lengths, a->file);
        }
    for (size_t k = 0; k < f; k++) {
        YkMode m = yk_rest_mode(one, p, k), n = yk_rest_mode(two, p, k);
        similar_check(m.frequency, n.frequency, YK_QUANTITY_ANGLE_RATE, a->file, "frequency");
        similar_check(m.damping_ratio, n.damping_ratio, YK_QUANTITY_NUMBER, a->file, "damping ratio");
    }
    for (size_t k = 0; k < 2 * f; k++) { // from a matrix of rates and accelerations: their factors differ
        double x[2], y[2], rate = similar_to(1, YK_QUANTITY_ANGLE_RATE), near;
        yk_rest_root(one, p, k, &x[0], &x[1]);
        yk_rest_root(two, p, k, &y[0], &y[1]);
        near = 1e-12 * hypot(x[0], x[1]);
        CHECK_NEAR(x[0], y[0] / rate, near);
        CHECK_NEAR(x[1], y[1] / rate, near);
    }
}

static void test_equilibria_in_other_units(void **unused)
{
    (void)unused;
    static const char *const files[] = {"examples/rocking-four-bar.yaml",
                                        "examples/damped-pendulum.yaml",
                                        "examples/toggle.yaml",
                                        "examples/five-bar-motors.yaml",
                                        "examples/cubic-spring.yaml",
                                        "examples/chain.yaml",
                                        "examples/spring-slider-crank.yaml",
                                        "examples/double-pendulum-boxes.yaml",
                                        "examples/cart-pendulum.yaml",
                                        "examples/swing-arm.yaml",
                                        "examples/andrews.yaml"};
    static const int units[][3] = {{33, -26, 5}, {-35, 24, -3}}; // square roots of masses: even powers
    for (size_t k = 0; k < check_cases(sizeof files / sizeof *files); k++)
        for (size_t u = 0; u < sizeof units / sizeof *units; u++) {
            similar_set(0, 0, 0);
            Similar a = similar_load(files[k], NULL);
            YkRest *one = find(&a);
            similar_set(units[u][0], units[u][1], units[u][2]);
            Similar b = similar_load(files[k], NULL);
            YkRest *two = find(&b);
            SIMILAR_EQUAL(files[k], yk_rest_count(one), yk_rest_count(two));
            SIMILAR_EQUAL(files[k], yk_rest_is_complete(one), yk_rest_is_complete(two));
            for (size_t p = 0; p < yk_rest_count(one); p++) check_point(&a, one, two, p);
            yk_rest_free(one);
            yk_rest_free(two);
            similar_free(&a);
            similar_free(&b);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_equilibria_in_other_units)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
