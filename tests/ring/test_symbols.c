// Symbols: names, aliases, rates, functions; and their names in every format.
#include "ring/ring_check.h"

static void names_are_checked(void **state)
{
    (void)state;
    static const char *const bad[] = {"",   "1a", "a b", "a-b", "cos",      "pi",     "pi_7",    "pow",
                                      "a.", "'",  "a'b", "a*",  "\xce\xb8", "theta1", "theta1'", "theta1.rate"};
    Fixture f = fixture_new(1);
    size_t count = yk_ring_symbol_count(f.ring);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int angle = 0; angle < 2; angle++) {
            yk_ring_clear(f.ring);
            if ((angle ? yk_ring_angle(f.ring, bad[i]) : yk_ring_symbol(f.ring, bad[i], YK_RING_CONSTANT)) != -1)
                fail_msg("%s", bad[i]);
            assert_int_equal(yk_ring_status(f.ring), YK_RING_NAME);
        }
    assert_int_equal(yk_ring_symbol_count(f.ring), count);
    yk_ring_clear(f.ring);
    char longest[202];
    memset(longest, 'a', 201);
    longest[201] = '\0';
    assert_int_equal(yk_ring_symbol(f.ring, longest, YK_RING_MASS), -1);
    assert_true(yk_ring_symbol(f.ring, longest + 1, YK_RING_MASS) >= 0);
    yk_ring_free(f.ring);
}

static void words_that_contain_functions_are_names(void **state)
{
    (void)state;
    static const char *const names[] = {"pi_", "cosine", "sin1", "exp_", "sqrt.a", "pi_7a", "pix", "powder", "cos'"};
    YkRing *ring = yk_ring_new();
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        int32_t symbol = yk_ring_symbol(ring, names[i], YK_RING_CONSTANT);
        assert_true(symbol >= 0);
        check_same(ring, read_as(ring, YK_RING_TEXT, names[i]), yk_ring_of(ring, symbol));
    }
    yk_ring_free(ring);
}

static void a_symbol_tells_what_it_is(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    YkRing *r = f.ring;
    assert_true(yk_ring_alias(r, f.parameter[0], "J1") && yk_ring_find(r, "J1") == f.parameter[0]);
    assert_false(yk_ring_alias(r, f.parameter[0], "J1"));
    yk_ring_clear(r);
    assert_false(yk_ring_alias(r, 10000, "J2"));
    assert_false(yk_ring_alias(r, 0, "J 2"));
    yk_ring_clear(r);
    assert_string_equal(yk_ring_symbol_name(r, f.rate[0]), "theta1'");
    assert_int_equal(yk_ring_symbol_class(r, f.rate[0]), YK_RING_RATE);
    assert_int_equal(yk_ring_symbol_class(r, f.rate[0] + 1), YK_RING_ACCELERATION);
    assert_int_equal(yk_ring_find(r, "theta1.accel"), f.rate[0] + 1);
    assert_true(yk_ring_is_angle(r, f.angle[2]) && !yk_ring_is_angle(r, f.parameter[0]));
    assert_int_equal(yk_ring_find(r, "nobody"), -1);
    yk_ring_free(r);
}

// NAME.rate and NAME.accel are understood without being entered, so no other symbol may take them.
static void the_other_names_of_rates_are_taken(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    YkRing *r = f.ring;
    const char *const taken[] = {"theta1.rate", "theta1.accel", "d3.rate", "A.angle.accel"};
    for (size_t k = 0; k < sizeof taken / sizeof *taken; k++) {
        assert_int_equal(yk_ring_symbol(r, taken[k], YK_RING_CONSTANT), -1);
        assert_int_equal(yk_ring_status(r), YK_RING_NAME);
        yk_ring_clear(r);
        assert_false(yk_ring_alias(r, f.parameter[0], taken[k]));
        yk_ring_clear(r);
    }
    assert_int_equal(yk_ring_find(r, "d3.rate"), f.distance_rate);
    assert_int_equal(yk_ring_find(r, "A.angle.accel"), f.rate[2] + 1);
    assert_int_equal(yk_ring_find(r, "l1.rate"), -1); // does not move
    assert_int_equal(yk_ring_find(r, ".rate"), -1);
    check_same(r, read_text(&f, "theta1.rate^2 + d3.accel"), read_text(&f, "theta1'^2 + d3''"));
    assert_true(yk_ring_alias(r, f.angle[0], "phi")); // of another name they are not
    assert_int_equal(yk_ring_find(r, "phi.rate"), -1);
    int32_t own = yk_ring_symbol(r, "x.accel", YK_RING_CONSTANT), x = yk_ring_symbol(r, "x", YK_RING_COORDINATE);
    assert_true(own >= 0 && x >= 0);
    assert_int_equal(yk_ring_rates(r, x), -1); // whose name it would take
    assert_int_equal(yk_ring_status(r), YK_RING_NAME);
    assert_int_equal(yk_ring_find(r, "x.accel"), own);
    yk_ring_free(r);
}

static void what_cannot_be_declared_is_refused(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    YkRing *r = f.ring;
    Element one = number(&f, 1, 1);
    const char *const names[] = {"f", "l1"};
    assert_null(yk_ring_unit(r, f.parameter[0])); // not an angle
    assert_int_equal(yk_ring_status(r), YK_RING_NAME);
    assert_null(yk_ring_of(r, -1));
    assert_null(yk_ring_exp(r, (const YkAngleTerm[]){{100000, 1}}, 1));
    assert_int_equal(yk_ring_rates(r, -1), -1);
    assert_int_equal(yk_ring_rates(r, f.angle[0]), -1); // they exist
    assert_int_equal(yk_ring_function(r, names, 2, f.angle[0]), -1);
    assert_int_equal(yk_ring_function(r, names, 0, f.angle[0]), -1);
    assert_int_equal(yk_ring_function(r, names, 1, 100000), -1);
    assert_false(yk_ring_set_rate(r, 100000, one));
    assert_false(yk_ring_set_rate(r, 0, NULL));
    assert_false(yk_ring_set_partial(r, 100000, 0, one));
    assert_false(yk_ring_set_partial(r, 0, 100000, one));
    assert_false(yk_ring_set_partial(r, 0, 1, NULL));
    assert_int_equal(yk_ring_root(r, "L", NULL), -1);
    assert_int_equal(yk_ring_status(r), YK_RING_NAME); // the first failure sticks
    for (int status = YK_RING_OK; status <= YK_RING_MEMORY; status++)
        assert_true(strlen(yk_ring_status_text((YkRingStatus)status)) > 10);
    assert_string_equal(yk_ring_status_text((YkRingStatus)99), "unknown");
    yk_ring_free(r);
    yk_ring_free(NULL);
}

static void names_are_set_as_engineers_write_them(void **state)
{
    (void)state;
    static const struct {
        const char *name, *latex, *mathml, *c;
    } table[] = {
        {"m", "m", "<mi>m</mi>", "m"},
        {"l1", "l_{1}", "<msub><mi>l</mi><mi>1</mi></msub>", "l1"},
        {"lc12", "l_{c12}", "<msub><mi>l</mi><mi>c12</mi></msub>", "lc12"},
        {"F01x", "F_{01x}", "<msub><mi>F</mi><mi>01x</mi></msub>", "F01x"},
        {"F_x", "F_{x}", "<msub><mi>F</mi><mi>x</mi></msub>", "F_x"},
        {"a_b_c", "a_{b,c}", "<msub><mi>a</mi><mi>b,c</mi></msub>", "a_b_c"},
        {"tau1", "\\tau_{1}", "<msub><mi>τ</mi><mi>1</mi></msub>", "tau1"},
        {"Omega", "\\Omega", "<mi>Ω</mi>", "Omega"},
        {"etaX", "\\eta_{X}", "<msub><mi>η</mi><mi>X</mi></msub>", "etaX"},
        {"module", "\\mathit{module}", "<mi>module</mi>", "module"},
        {"mod2", "\\mathit{mod}_{2}", "<msub><mi>mod</mi><mi>2</mi></msub>", "mod2"},
        {"R.distance", "\\mathit{R.distance}", "<mi>R.distance</mi>", "R_distance"},
        {"_a", "\\mathit{\\_a}", "<mi>_a</mi>", "_a"},
        {"f'", "\\dot{f}", "<mover><mi>f</mi><mo>˙</mo></mover>", "f_d1"},
        {"f'''", "\\dddot{f}", "<mover><mi>f</mi><mo>¨˙</mo></mover>", "f_d3"},
        {"while", "\\mathit{while}", "<mi>while</mi>", "while_"},
    };
    YkRing *ring = yk_ring_new();
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        int32_t symbol = yk_ring_symbol(ring, table[i].name, YK_RING_CONSTANT);
        assert_string_equal(yk_ring_name_in(ring, symbol, YK_RING_TEXT), table[i].name);
        assert_string_equal(yk_ring_name_in(ring, symbol, YK_RING_BOOK), table[i].name);
        assert_string_equal(yk_ring_name_in(ring, symbol, YK_RING_LATEX), table[i].latex);
        assert_string_equal(yk_ring_name_in(ring, symbol, YK_RING_MATHML), table[i].mathml);
        assert_string_equal(yk_ring_name_in(ring, symbol, YK_RING_C), table[i].c);
    }
    int32_t theta = yk_ring_angle(ring, "theta"), rate = yk_ring_rates(ring, theta);
    assert_string_equal(yk_ring_name_in(ring, rate, YK_RING_LATEX), "\\dot{\\theta}");
    assert_string_equal(yk_ring_name_in(ring, rate + 1, YK_RING_LATEX), "\\ddot{\\theta}");
    assert_string_equal(yk_ring_name_in(ring, rate, YK_RING_C), "theta_rate");
    assert_string_equal(yk_ring_name_in(ring, rate + 1, YK_RING_C), "theta_accel");
    yk_ring_free(ring);
}

static void names_in_latex_and_c_are_unique(void **state)
{
    (void)state;
    static const char *const names[] = {"lc1",  "l_c1", "lc_1", "l__c1",  "A.b",    "A_b",
                                        "A_b_", "f'",   "f_d1", "double", "double_"};
    enum { NAMES = sizeof names / sizeof *names };
    YkRing *ring = yk_ring_new();
    for (int i = 0; i < NAMES; i++) yk_ring_symbol(ring, names[i], YK_RING_CONSTANT);
    for (int i = 0; i < NAMES; i++)
        for (int k = 0; k < i; k++) {
            assert_string_not_equal(yk_ring_name_in(ring, i, YK_RING_LATEX), yk_ring_name_in(ring, k, YK_RING_LATEX));
            assert_string_not_equal(yk_ring_name_in(ring, i, YK_RING_C), yk_ring_name_in(ring, k, YK_RING_C));
        }
    yk_ring_free(ring);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_are_checked),
        cmocka_unit_test(words_that_contain_functions_are_names),
        cmocka_unit_test(a_symbol_tells_what_it_is),
        cmocka_unit_test(the_other_names_of_rates_are_taken),
        cmocka_unit_test(what_cannot_be_declared_is_refused),
        cmocka_unit_test(names_are_set_as_engineers_write_them),
        cmocka_unit_test(names_in_latex_and_c_are_unique),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
