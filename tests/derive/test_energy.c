// Energies in symbols: the engine's numbers, and dE/dt = power, exactly.
#include "forces_check.h"
#include "derive/relations.h"

static size_t poses_seen, terms_seen;

static void compare_energies(Machine *m, const char *name)
{
    const YkDeriveForces *f = forces_of(m);
    YkDynamics *dynamics = dynamics_of(m);
    for (int k = 0; k < 4; k++) {
        if (!random_pose(m, k == 0) || !take_forces(m, dynamics, YK_METHOD_REDUCED)) continue;
        double T = 0, V = at_pose(m, yk_derive_potential(f));
        for (size_t b = 1; b < m->d->model->body_count; b++) T += at_pose(m, yk_derive_kinetic(f, (int32_t)b));
        YkEnergy energy = yk_dynamics_energy(dynamics);
        double most = 1 + fabs(energy.kinetic) + fabs(energy.potential);
        if (!(fabs(T - energy.kinetic) <= 1e-11 * most && fabs(V - energy.potential) <= 1e-11 * most)) {
            print_error("%s: T %.15g %.15g V %.15g %.15g\n", name, T, energy.kinetic, V, energy.potential);
            fail();
        }
        poses_seen++;
    }
    yk_dynamics_free(dynamics);
}

static void energies_are_the_numeric_engines(void **state)
{
    (void)state;
    each_example(compare_energies);
    assert_true(poses_seen > 150);
}

// force . velocity of where it acts + couple * spin
static const YkPoisson *power_of(const YkDeriveForces *f, const YkDeriveLoad *load)
{
    YkRing *ring = f->d->ring;
    const YkPoisson *sum = yk_ring_rational(ring, 0, 1), *i = yk_ring_i(ring);
    for (size_t p = 0; p < load->push_count; p++) {
        const YkDerivePush *push = &load->push[p];
        const YkPoisson *spin = f->d->bodies[push->body].spin;
        const YkPoisson *turning = yk_ring_product(ring, (const YkPoisson *[]){i, spin, push->arm}, 3);
        const YkPoisson *velocity = yk_ring_add(ring, f->bodies[push->body].velocity, turning);
        sum = yk_ring_add(ring, sum, yk_ring_dot(ring, push->force, velocity));
        sum = yk_ring_add(ring, sum, yk_ring_multiply(ring, push->moment, spin));
    }
    return sum;
}

// How fast a row would open: of a loop, or of a relation.
static const YkPoisson *row_rate(const YkDeriveForces *f, size_t row)
{
    YkRing *ring = f->d->ring;
    const YkDeriveMultipliers *m = yk_derive_multipliers(f);
    if (m->rows[row]) return yk_ring_time_derivative(ring, m->rows[row]);
    const YkDeriveRelation *tie = &f->d->ties[row - (m->count - f->d->tie_count)];
    const YkPoisson *rate = yk_ring_time_derivative(ring, tie->linear);
    if (tie->function < 0) return rate;
    const YkPoisson *slope = yk_ring_of(ring, tie->function + 1);
    return yk_ring_subtract(ring, rate, yk_ring_multiply(ring, slope, yk_ring_time_derivative(ring, tie->argument)));
}

// d(T + V)/dt + lambda . dPhi/dt = sum of q' (left - right) + power of all that has no potential: an identity of the
// ring.
static void check_power(Machine *m, const char *name)
{
    const YkDeriveForces *f = forces_of(m);
    YkRing *ring = m->d->ring;
    const YkPoisson *E = yk_derive_potential(f), *power = yk_ring_rational(ring, 0, 1);
    for (size_t b = 1; b < m->d->model->body_count; b++) E = yk_ring_add(ring, E, yk_derive_kinetic(f, (int32_t)b));
    const YkPoisson *rate = yk_ring_time_derivative(ring, E);
    const YkDeriveMultipliers *multipliers = yk_derive_multipliers(f);
    for (size_t k = 0; k < multipliers->count; k++)
        rate =
            yk_ring_add(ring, rate, yk_ring_multiply(ring, yk_ring_of(ring, multipliers->symbols[k]), row_rate(f, k)));
    for (size_t k = 0; k < m->d->coordinate_count; k++) {
        YkDeriveLagrange sides = yk_derive_lagrange(f, k);
        const YkPoisson *u = yk_ring_of(ring, yk_derive_freedom(m->d, k).rate);
        power = yk_ring_add(ring, power, yk_ring_multiply(ring, u, yk_ring_subtract(ring, sides.left, sides.right)));
    }
    for (size_t k = 0; k < f->load_count; k++)
        if (!f->loads[k].energy) power = yk_ring_add(ring, power, power_of(f, &f->loads[k]));
    assert_true(yk_ring_status(ring) == YK_RING_OK);
    if (!yk_ring_is_equal(ring, rate, power)) {
        print_error("%s\n", name);
        fail();
    }
    terms_seen += yk_ring_terms(rate);
}

static void the_energy_changes_by_the_power_of_the_loads_exactly(void **state)
{
    (void)state;
    assert_true(each_example(check_power) > 60);
    assert_true(terms_seen > 400);
}

static void a_springs_force_is_the_slope_of_its_energy(void **state)
{
    (void)state;
    Machine m = example("spring-slider-crank");
    const YkDeriveForces *f = forces_of(&m);
    YkRing *ring = m.d->ring;
    size_t springs = 0;
    for (size_t k = 0; k < f->load_count; k++) {
        if (f->loads[k].kind != YK_DERIVE_SPRING) continue;
        springs++;
        for (size_t c = 0; c < m.d->tree_count; c++) {
            const YkPoisson *slope = yk_ring_partial(ring, f->loads[k].energy, yk_derive_freedom(m.d, c).position);
            const YkPoisson *force = yk_derive_generalised(f, &f->loads[k], c);
            assert_true(yk_ring_is_equal(ring, yk_ring_negate(ring, slope), force));
        }
    }
    assert_int_equal(springs, 1);
    machine_end(&m);
}

static void kinetic_energy_prints_with_one_bracket_for_each_product_of_rates(void **state)
{
    (void)state;
    Machine m = example("double-pendulum");
    write_section(&m, "energy");
    check_says(
        &m,
        "T = 1/2 (I1 + I2 + m1 lc1^2 + m2 (l1^2 + lc2^2) + 2 m2 l1 lc2 cos(theta2)) theta1'^2 + (I2 + m2 lc2^2 + m2 l1 "
        "lc2 cos(theta2)) theta1' theta2' + 1/2 (I2 + m2 lc2^2) theta2'^2\n");
    check_says(&m, "V = -g ((m1 lc1 + m2 l1) cos(theta1) + m2 lc2 cos(theta1 + theta2))\n");
    check_says(&m, "T_link1 = 1/2 I1 theta1'^2 + 1/2 m1 lc1^2 theta1'^2\n");
    check_says(&m, "L = T - V = ");
    assert_true(check_page_reads_back(&m) > 5);
    machine_end(&m);
}

static void printed_energies_read_back_identical(void **state)
{
    (void)state;
    assert_true(check_section_reads_back("energy") > 150);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(energies_are_the_numeric_engines),
        cmocka_unit_test(the_energy_changes_by_the_power_of_the_loads_exactly),
        cmocka_unit_test(a_springs_force_is_the_slope_of_its_energy),
        cmocka_unit_test(kinetic_energy_prints_with_one_bracket_for_each_product_of_rates),
        cmocka_unit_test(printed_energies_read_back_identical),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
