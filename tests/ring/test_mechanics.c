// Mechanics in the ring: the double pendulum as the books print it, Lagrange against Newton and Euler, loops.
#include "ring/field_check.h"
#include "ring/machines.h"

static const char *const EQUATION_1 = "(I1 + I2 + m1 lc1^2 + m2 (l1^2 + lc2^2) + 2 m2 l1 lc2 cos(theta2)) theta1'' + "
                                      "(I2 + m2 lc2^2 + m2 l1 lc2 cos(theta2)) theta2''"
                                      " - m2 l1 lc2 sin(theta2) theta2' (2 theta1' + theta2') + g ((m1 lc1 + m2 l1) "
                                      "sin(theta1) + m2 lc2 sin(theta1 + theta2))";
static const char *const EQUATION_2 =
    "(I2 + m2 lc2^2 + m2 l1 lc2 cos(theta2)) theta1'' + (I2 + m2 lc2^2) theta2'' + m2 l1 lc2 sin(theta2) theta1'^2"
    " + m2 lc2 g sin(theta1 + theta2)";

static void the_double_pendulum_prints_as_in_the_books(void **state)
{
    (void)state;
    Machine m = chain(2, true);
    Element T, V;
    energies(&m, &T, &V);
    check_written(m.ring, lagrange(&m, T, V, 0), YK_RING_BOOK, YK_RING_TEXTBOOK, EQUATION_1);
    check_written(m.ring, lagrange(&m, T, V, 1), YK_RING_BOOK, YK_RING_TEXTBOOK, EQUATION_2);
    check_written(
        m.ring, T, YK_RING_BOOK, YK_RING_TEXTBOOK,
        "1/2 I1 theta1'^2 + 1/2 I2 (theta1' + theta2')^2 + 1/2 m1 lc1^2 theta1'^2 + 1/2 m2 (l1^2 theta1'^2 + lc2^2 "
        "(theta1' + theta2')^2) + m2 l1 lc2 cos(theta2) theta1' (theta1' + theta2')");
    check_written(
        m.ring, T, YK_RING_BOOK, YK_RING_BRACKETS,
        "1/2 (I1 + I2 + m1 lc1^2 + m2 (l1^2 + lc2^2) + 2 m2 l1 lc2 cos(theta2)) theta1'^2 + (I2 + m2 lc2^2 + m2 l1 lc2 "
        "cos(theta2)) theta1' theta2' + 1/2 (I2 + m2 lc2^2) theta2'^2");
    check_written(m.ring, V, YK_RING_BOOK, YK_RING_TEXTBOOK,
                  "-g ((m1 lc1 + m2 l1) cos(theta1) + m2 lc2 cos(theta1 + theta2))");
    assert_int_equal(yk_ring_status(m.ring), YK_RING_OK);
    yk_ring_free(m.ring);
}

static void check_both_ways(const Machine *m)
{
    YkRing *r = m->ring;
    Element T, V, power = yk_ring_rational(r, 0, 1);
    energies(m, &T, &V);
    for (int i = 0; i < m->count; i++) {
        Element equation = lagrange(m, T, V, i);
        check_same(r, equation, newton_euler(m, i));
        power = yk_ring_add(r, power, yk_ring_multiply(r, yk_ring_of(r, m->u[i]), equation));
    }
    check_same(r, yk_ring_time_derivative(r, yk_ring_add(r, T, V)), power);
    assert_int_equal(yk_ring_status(r), YK_RING_OK);
}

static void lagrange_equals_projected_newton_and_euler_and_energy_is_power(void **state)
{
    (void)state;
    for (int n = 1; n <= 6; n++)
        for (int joint_angles = 0; joint_angles < 2; joint_angles++) {
            Machine m = chain(n, joint_angles);
            check_both_ways(&m);
            yk_ring_free(m.ring);
        }
    Machine m = toggle();
    check_both_ways(&m);
    yk_ring_free(m.ring);
}

// In body angles, then mapped to joint angles: rates by symbols, e^(i theta) by products. The same as derived there.
static void body_angles_mapped_to_joint_angles_give_the_same_energy(void **state)
{
    (void)state;
    enum { N = 4 };
    Machine body = chain(N, false), joint = chain(N, true);
    Element T_body, V_body, T, V;
    energies(&body, &T_body, &V_body);
    energies(&joint, &T, &V);
    YkRing *r = body.ring;
    YkRingChange changes[2 * N];
    Element unit = yk_ring_rational(r, 1, 1), rate = yk_ring_rational(r, 0, 1);
    for (int i = 0; i < N; i++) {
        unit = yk_ring_multiply(r, unit, yk_ring_unit(r, body.q[i]));
        rate = yk_ring_add(r, rate, yk_ring_of(r, body.u[i]));
        changes[2 * i] = (YkRingChange){body.q[i], NULL, unit};
        changes[2 * i + 1] = (YkRingChange){body.u[i], rate, NULL};
    }
    YkText text = {0};
    assert_true(yk_ring_write(joint.ring, T, YK_RING_TEXT, YK_RING_TEXTBOOK, &text));
    check_written(r, yk_ring_substitute(r, T_body, changes, 2 * N), YK_RING_TEXT, YK_RING_TEXTBOOK, yk_text_get(&text));
    yk_text_free(&text);
    yk_ring_free(body.ring);
    yk_ring_free(joint.ring);
}

static void loops_differentiate_to_their_jacobian_and_dyads_have_one_term(void **state)
{
    (void)state;
    Machine m = toggle();
    YkRing *r = m.ring;
    for (int k = 0; k < m.loops; k++) {
        Element rate = yk_ring_rational(r, 0, 1);
        for (int i = 0; i < m.count; i++)
            rate =
                yk_ring_add(r, rate, yk_ring_multiply(r, yk_ring_partial(r, m.loop[k], m.q[i]), yk_ring_of(r, m.u[i])));
        check_same(r, rate, yk_ring_time_derivative(r, m.loop[k]));
    }
    // The determinant of a dyad's block is the cross product of its two columns.
    Element first = yk_ring_cross(r, yk_ring_partial(r, m.loop[0], m.q[1]), yk_ring_partial(r, m.loop[0], m.q[2]));
    Element second = yk_ring_cross(r, yk_ring_partial(r, m.loop[1], m.q[3]), yk_ring_partial(r, m.loop[1], m.q[4]));
    check_written(r, first, YK_RING_BOOK, YK_RING_TEXTBOOK, "l2 l3 sin(theta1 + theta2 - theta3)");
    check_written(r, second, YK_RING_BOOK, YK_RING_TEXTBOOK, "l4 cos(theta3 + theta4)");
    check_written(r, yk_ring_real(r, m.loop[0]), YK_RING_BOOK, YK_RING_TEXTBOOK,
                  "-a0x + l1 cos(theta1) - l3 cos(theta3) + l2 cos(theta1 + theta2)");
    yk_ring_free(r);
}

// A random point of a four-bar's motion over the prime field: angles free, the ground's coordinates solve the loop,
// rates solve J u = 0. There l3 sin(theta3 - theta2) theta3' = l1 sin(theta1 - theta2) theta1', which is false
// elsewhere.
static void an_equation_that_holds_on_the_loop_alone_is_proved_at_points_of_the_loop(void **state)
{
    (void)state;
    Machine m = {.ring = yk_ring_new()};
    YkRing *r = m.ring;
    for (int i = 1; i <= 3; i++) machine_symbol(r, "l", i, YK_RING_CONSTANT);
    int32_t x = yk_ring_symbol(r, "x4", YK_RING_CONSTANT), y = yk_ring_symbol(r, "y4", YK_RING_CONSTANT);
    for (int i = 0; i < 3; i++) machine_coordinate(&m, (const char *[]){"theta1", "theta2", "theta3"}[i], true);
    machine_rates(&m);
    Element loop = read_as(r, YK_RING_TEXT, "l1*exp(i*theta1) + l2*exp(i*theta2) - l3*exp(i*theta3) - x4 - i*y4");
    Element rows[] = {yk_ring_real(r, loop), yk_ring_imaginary(r, loop)};
    Element right = read_as(r, YK_RING_TEXT, "l3*sin(theta3 - theta2)*theta3' - l1*sin(theta1 - theta2)*theta1'");
    Element wrong = read_as(r, YK_RING_TEXT, "l3*sin(theta3 - theta2)*theta3' + l1*sin(theta1 - theta2)*theta1'");
    YkFieldPoint *point = yk_field_point_new(r, 1);
    assert_true(yk_ring_field(r, right, point, false) != 0);
    uint64_t A[6], b[2], solution[3];
    for (int i = 0; i < 2; i++) { // x4 and y4 enter with -1
        uint64_t rest = yk_field_add(yk_ring_field(r, rows[i], point, false), yk_field_point_get(point, i ? y : x));
        yk_field_point_set(point, i ? y : x, rest);
        assert_true(yk_ring_field(r, rows[i], point, false) == 0);
    }
    for (int i = 0; i < 6; i++) A[i] = yk_ring_field(r, yk_ring_partial(r, rows[i / 3], m.q[i % 3]), point, false);
    b[0] = b[1] = 0;
    for (int i = 0; i < 3; i++) solution[i] = yk_field_point_get(point, m.u[i]);
    assert_int_equal(solve_dense(A, b, 2, 3, solution), 2);
    for (int i = 0; i < 3; i++) yk_field_point_set(point, m.u[i], solution[i]);
    assert_true(yk_ring_field(r, right, point, false) == 0);
    assert_true(yk_ring_field(r, wrong, point, false) != 0);
    yk_field_point_free(point);
    yk_ring_free(r);
}

// Every equation of every machine here, in every format, reads back.
static void equations_read_back(void **state)
{
    (void)state;
    Machine machines[] = {chain(1, true), chain(3, true), chain(4, false), toggle()};
    static const YkRingFormat formats[] = {YK_RING_TEXT, YK_RING_BOOK, YK_RING_LATEX, YK_RING_C};
    for (size_t k = 0; k < sizeof machines / sizeof *machines; k++) {
        Machine *m = &machines[k];
        Element T, V;
        energies(m, &T, &V);
        for (int i = 0; i < m->count; i++)
            for (int way = 0; way < 12; way++) {
                YkText text = {0};
                Element equation = lagrange(m, T, V, i);
                assert_true(yk_ring_write(m->ring, equation, formats[way % 4], (YkRingStyle)(way / 4), &text));
                check_same(m->ring, read_as(m->ring, formats[way % 4], yk_text_get(&text)), equation);
                yk_text_free(&text);
            }
        yk_ring_free(m->ring);
    }
}

// How many terms with cos and sin all equations have: signs between terms stand outside of parentheses.
static size_t real_terms(const Machine *m)
{
    Element T, V;
    size_t sum = 0;
    energies(m, &T, &V);
    for (int i = 0; i < m->count; i++) {
        YkText text = {0};
        assert_true(yk_ring_write(m->ring, lagrange(m, T, V, i), YK_RING_TEXT, YK_RING_EXPANDED, &text));
        int depth = 0;
        sum++;
        for (const char *c = yk_text_get(&text); *c; c++) {
            depth += (*c == '(') - (*c == ')');
            sum += depth == 0 && *c == ' ' && (c[1] == '+' || c[1] == '-');
        }
        yk_text_free(&text);
    }
    return sum;
}

static void body_angles_keep_the_equations_of_chains_short(void **state)
{
    (void)state;
    static const struct {
        int n;
        size_t in_body_angles, in_joint_angles;
    } counts[] = {{2, 12, 21}, {3, 31, 85}, {5, 115, 664}, {8, 416, 5736}};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        for (int joint_angles = 0; joint_angles < 2; joint_angles++) {
            Machine m = chain(counts[i].n, joint_angles);
            assert_int_equal(real_terms(&m), joint_angles ? counts[i].in_joint_angles : counts[i].in_body_angles);
            yk_ring_free(m.ring);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_double_pendulum_prints_as_in_the_books),
        cmocka_unit_test(lagrange_equals_projected_newton_and_euler_and_energy_is_power),
        cmocka_unit_test(body_angles_mapped_to_joint_angles_give_the_same_energy),
        cmocka_unit_test(loops_differentiate_to_their_jacobian_and_dyads_have_one_term),
        cmocka_unit_test(an_equation_that_holds_on_the_loop_alone_is_proved_at_points_of_the_loop),
        cmocka_unit_test(equations_read_back),
        cmocka_unit_test(body_angles_keep_the_equations_of_chains_short),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
