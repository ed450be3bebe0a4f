// What is written reads well, and reads back as the identical element.
#include "ring/ring_check.h"

static const YkRingFormat read_formats[] = {YK_RING_TEXT, YK_RING_BOOK, YK_RING_LATEX, YK_RING_C};

static void check_round_trips(Fixture *f, Element a)
{
    bool real = yk_ring_is_real(f->ring, a);
    for (size_t i = 0; i < sizeof read_formats / sizeof *read_formats; i++)
        for (int style = 0; style < YK_RING_STYLES; style++) {
            YkText text = {0};
            if (read_formats[i] == YK_RING_C && !real) continue;
            if (!yk_ring_write(f->ring, a, read_formats[i], (YkRingStyle)style, &text))
                fail_msg("%s", yk_ring_status_text(yk_ring_status(f->ring)));
            Element back = read_as(f->ring, read_formats[i], yk_text_get(&text));
            if (!yk_ring_is_same(a, back)) fail_msg("does not read back: %s", yk_text_get(&text));
            yk_text_free(&text);
        }
}

static void random_elements_read_back_as_themselves_in_every_format_and_style(void **state)
{
    (void)state;
    Fixture f = fixture_new(1);
    for (uint64_t i = 0; i < check_cases(5000); i++) {
        if (i % 300 == 299) { // start anew: the ring keeps all it ever made
            uint64_t seed = f.seed;
            yk_ring_free(f.ring);
            f = fixture_new(seed);
        }
        Element a = random_element(&f, below(&f, 12));
        if (below(&f, 2)) a = yk_ring_real(f.ring, a);
        if (below(&f, 10) == 0)
            a = yk_ring_multiply(f.ring, a, yk_ring_real(f.ring, yk_ring_turn(f.ring, 1 + below(&f, 13), 7)));
        check_round_trips(&f, a);
    }
    assert_int_equal(yk_ring_status(f.ring), YK_RING_OK);
    yk_ring_free(f.ring);
}

// Polynomials in the squares of rates, masses and cosines, which are what the grouping is for.
static Element random_energy(Fixture *f)
{
    YkRing *r = f->ring;
    Element sum = number(f, 0, 1);
    for (int i = 1 + below(f, 4); i > 0; i--) {
        Element mass = yk_ring_of(r, f->parameter[below(f, 3)]), linear = number(f, 0, 1);
        for (int k = 0; k < ANGLES; k++) {
            int under = 1 + below(f, 2), over = below(f, 5) - 2;
            linear = yk_ring_add(r, linear, yk_ring_scale(r, yk_ring_of(r, f->rate[k]), over, under));
        }
        Element other = below(f, 2) ? linear : yk_ring_of(r, f->rate[below(f, ANGLES)]);
        Element term = yk_ring_multiply(r, mass, yk_ring_multiply(r, linear, other));
        int power = below(f, 3);
        term = yk_ring_multiply(r, term, yk_ring_power(r, yk_ring_of(r, f->parameter[3 + below(f, 3)]), power));
        if (below(f, 2)) term = yk_ring_multiply(r, term, yk_ring_real(r, random_unit(f)));
        sum = yk_ring_add(r, sum, yk_ring_scale(r, term, 1 + below(f, 3), 2));
    }
    return below(f, 2) ? sum : yk_ring_time_derivative(r, sum);
}

static void energies_and_their_derivatives_read_back(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    for (int i = 0; i < 600; i++) check_round_trips(&f, random_energy(&f));
    yk_ring_free(f.ring);
}

typedef struct Written {
    const char *in, *out;
} Written;

static void check_list(YkRingFormat format, YkRingStyle style, const Written *list, size_t count)
{
    Fixture f = fixture_new(3);
    for (size_t i = 0; i < count; i++) check_written(f.ring, read_text(&f, list[i].in), format, style, list[i].out);
    yk_ring_free(f.ring);
}

static void text_is_ordered_and_grouped_for_the_reader(void **state)
{
    (void)state;
    static const Written list[] = {
        {"-d3*cos(theta2) + cos(theta1)*l1", "l1*cos(theta1) - d3*cos(theta2)"},
        {"0", "0"},
        {"-3/6", "-1/2"},
        {"l1*m1 + I1", "I1 + m1*l1"},
        {"m2 l1^2 + m2 lc1^2 + m1 lc1^2", "m1*lc1^2 + m2*(l1^2 + lc1^2)"},
        {"m1 lc1 + m2 lc1", "(m1 + m2)*lc1"},
        {"-m1 l1 lc1/3 - m2 l1 lc1", "-1/3*(m1 + 3*m2)*l1*lc1"},
        {"(m1 lc1 + m2 lc1) theta1''", "(m1 + m2)*lc1*theta1''"},
        {"-l1 sin(theta1) theta1'' - lc1 cos(theta1) theta1''", "-(lc1*cos(theta1) + l1*sin(theta1))*theta1''"},
        {"-theta1'' - l1 theta2''", "-theta1'' - l1*theta2''"},
        {"m2 l1^2/2 + m2 lc1^2", "1/2*m2*(l1^2 + 2*lc1^2)"},
        {"theta1'^2 + 2 theta1' theta2' + theta2'^2", "(theta1' + theta2')^2"},
        {"m1 theta2'^2 + 2*m1*theta2'*theta1'", "m1*theta2'*(2*theta1' + theta2')"},
        {"-4 sin(theta1) theta1' theta2' - 4 sin(theta1) theta1'^2 - sin(theta1) theta2'^2",
         "-sin(theta1)*(2*theta1' + theta2')^2"},
        {"theta1'^2 + theta2'^2", "theta1'^2 + theta2'^2"},
        {"g l1 m1 cos(theta1)", "m1*l1*g*cos(theta1)"},
        {"-g l1 m1 cos(theta1) - g m2 lc1 cos(theta2)", "-g*(m1*l1*cos(theta1) + m2*lc1*cos(theta2))"},
        {"g m1 cos(theta1) - g m2 cos(theta2)", "g*(m1*cos(theta1) - m2*cos(theta2))"},
        {"F01x l1 sin(theta1) + theta1'' I1 - m1 theta1' d3'", "I1*theta1'' - m1*theta1'*d3' + l1*F01x*sin(theta1)"},
        {"theta1 r_2 - d3", "r_2*theta1 - d3"},
        {"l1/r_2 + cos(theta1)/(l1*r_2^2)", "l1/r_2 + cos(theta1)/(l1*r_2^2)"},
        {"1/l1", "1/l1"},
        {"cos(theta1 - theta2)", "cos(theta1 - theta2)"},
        {"sin(theta2 - theta1)", "-sin(theta1 - theta2)"},
        {"cos(pi/6)", "1/2*sqrt(3)"},
        {"l1 cos(theta1 + pi/3)", "l1*cos(theta1 + pi/3)"},
        {"l1 sin(theta1 + pi/6)", "l1*cos(theta1 - pi/3)"},
        {"l1 cos(theta1 + 3*pi/7)", "l1*cos(theta1 + 3*pi/7)"},
        {"i l1 exp(i theta1)", "i*l1*exp(i*theta1)"},
        {"exp(i*(theta1 - theta2)) + 1", "1 + exp(i*(theta1 - theta2))"},
        {"exp(-i*theta1)", "exp(i*(-theta1))"},
        {"s1*theta2'", "s1*theta2'"},
        {"pi*r_2", "r_2*pi"},
    };
    check_list(YK_RING_TEXT, YK_RING_TEXTBOOK, list, sizeof list / sizeof *list);
}

static void rates_get_a_bracket_each_when_asked(void **state)
{
    (void)state;
    static const Written list[] = {
        {"I1 theta1'^2/2 + m1 l1^2 theta1'^2/2 + m1 l1 theta1' d3'",
         "1/2 (I1 + m1 l1^2) theta1'^2 + m1 l1 theta1' d3'"},
        {"theta1'^2 - theta1' theta2'", "theta1'^2 - theta1' theta2'"},
    };
    check_list(YK_RING_BOOK, YK_RING_BRACKETS, list, sizeof list / sizeof *list);
}

static void every_term_stands_alone_when_expanded(void **state)
{
    (void)state;
    static const Written list[] = {
        {"m1 (l1 + lc1)^2", "m1*l1^2 + 2*m1*l1*lc1 + m1*lc1^2"},
        {"(theta1' + theta2')^2 sin(theta1)",
         "sin(theta1)*theta1'^2 + 2*sin(theta1)*theta1'*theta2' + sin(theta1)*theta2'^2"},
    };
    check_list(YK_RING_TEXT, YK_RING_EXPANDED, list, sizeof list / sizeof *list);
}

static void latex_has_greek_letters_dots_and_subscripts(void **state)
{
    (void)state;
    static const Written list[] = {
        {"lc1*sin(theta1)*theta1'^2/2", "\\tfrac{1}{2} l_{c1} \\sin(\\theta_{1}) \\dot{\\theta}_{1}^{2}"},
        {"theta2''/l1", "\\frac{\\ddot{\\theta}_{2}}{l_{1}}"},
        {"r_2*exp(i*theta1)", "r_{2} e^{\\mathrm{i} \\theta_{1}}"},
        {"A.angle'", "\\dot{\\mathit{A.angle}}"},
        {"F01x*cos(theta1 - pi/3)", "F_{01x} \\cos(\\theta_{1} - \\tfrac{\\pi}{3})"},
        {"sqrt(2)", "\\sqrt{2}"},
    };
    check_list(YK_RING_LATEX, YK_RING_TEXTBOOK, list, sizeof list / sizeof *list);
}

static void c_has_identifiers_doubles_and_no_powers(void **state)
{
    (void)state;
    static const Written list[] = {
        {"lc1^2*sin(2*theta1)*theta1'/2", "1.0/2.0*lc1*lc1*sin(2.0*theta1)*theta1_rate"},
        {"l1^7/lc1^2 + A.angle''", "A_angle_accel + pow(l1, 7)/(lc1*lc1)"},
        {"cos(theta1 + pi/4)", "1.0/2.0*sqrt(2.0)*cos(theta1) - 1.0/2.0*sqrt(2.0)*sin(theta1)"},
    };
    check_list(YK_RING_C, YK_RING_TEXTBOOK, list, sizeof list / sizeof *list);
}

static void complex_elements_have_no_c(void **state)
{
    (void)state;
    Fixture f = fixture_new(4);
    YkText text = {0};
    assert_false(yk_ring_write(f.ring, yk_ring_unit(f.ring, f.angle[0]), YK_RING_C, YK_RING_TEXTBOOK, &text));
    assert_int_equal(yk_ring_status(f.ring), YK_RING_NOT_REAL);
    assert_false(yk_ring_write(f.ring, NULL, YK_RING_TEXT, YK_RING_TEXTBOOK, &text));
    yk_text_free(&text);
    yk_ring_free(f.ring);
}

// Elements are closed in the order they were opened, each once; text is outside of tags only.
static void check_nesting(const char *xml)
{
    const char *open[400];
    size_t depth = 0;
    for (const char *c = strchr(xml, '<'); c; c = strchr(c, '<')) {
        bool closes = c[1] == '/';
        const char *name = c + 1 + closes;
        size_t length = strcspn(name, " >");
        if (!closes) {
            assert_true(depth < 400);
            open[depth++] = name;
        } else {
            assert_true(depth > 0);
            assert_int_equal(strncmp(open[--depth], name, length), 0);
        }
        c = strchr(c, '>');
        assert_non_null(c);
    }
    assert_int_equal(depth, 0);
}

// How many children the elements of fixed arity have: mfrac, msup, msub, mover 2, msqrt 1. Returns behind the element.
static const char *check_arity(const char *c)
{
    static const char *const pairs[] = {"mfrac", "msup", "msub", "mover"};
    size_t length = strcspn(c + 1, " >"), children = 0;
    const char *name = c + 1;
    c = strchr(c, '>') + 1;
    for (;;) {
        c = strchr(c, '<');
        assert_non_null(c);
        if (c[1] == '/') break;
        c = check_arity(c);
        children++;
    }
    for (size_t i = 0; i < 4; i++)
        if (strlen(pairs[i]) == length && strncmp(name, pairs[i], length) == 0) assert_int_equal(children, 2);
    if (length == 5 && strncmp(name, "msqrt", 5) == 0) assert_int_equal(children, 1);
    return strchr(c, '>') + 1;
}

static void mathml_is_well_formed(void **state)
{
    (void)state;
    Fixture f = fixture_new(5);
    for (int i = 0; i < 300; i++) {
        YkText text = {0};
        Element a = i % 3 == 0 ? random_energy(&f) : random_element(&f, below(&f, 8));
        assert_true(yk_ring_write(f.ring, a, YK_RING_MATHML, (YkRingStyle)(i % YK_RING_STYLES), &text));
        check_nesting(yk_text_get(&text));
        check_arity(yk_text_get(&text));
        yk_text_free(&text);
    }
    check_written(f.ring, read_text(&f, "theta1'^2/2"), YK_RING_MATHML, YK_RING_TEXTBOOK,
                  "<mrow><mrow><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><msup><msub><mover><mi>θ</mi><mo>˙</"
                  "mo></mover>"
                  "<mi>1</mi></msub><mn>2</mn></msup></mrow></mrow>");
    yk_ring_free(f.ring);
}

// Elements made in another order in another ring have other numbers inside, but the same print.
static void the_order_depends_on_the_symbols_alone(void **state)
{
    (void)state;
    Fixture first = fixture_new(6), second = fixture_new(6);
    for (int i = 0; i < 50; i++) random_element(&second, 10);
    uint64_t seed = 77;
    for (int i = 0; i < 200; i++) {
        first.seed = second.seed = check_random(&seed);
        YkText text = {0};
        Element a = random_energy(&first), b = random_energy(&second);
        assert_true(yk_ring_write(first.ring, a, YK_RING_TEXT, YK_RING_TEXTBOOK, &text));
        check_written(second.ring, b, YK_RING_TEXT, YK_RING_TEXTBOOK, yk_text_get(&text));
        yk_text_free(&text);
    }
    yk_ring_free(first.ring);
    yk_ring_free(second.ring);
}

static void names_that_look_alike_stay_apart(void **state)
{
    (void)state;
    static const char *const names[] = {"lc1",    "l_c1", "lc_1",   "p_i2",    "x.y",  "x_y",   "x_y_", "tau",
                                        "taua",   "tauA", "double", "double_", "e",    "i",     "mod",  "theta",
                                        "theta_", "_x",   "pi2",    "f'",      "f_d1", "cosine"};
    YkRing *ring = yk_ring_new();
    Element sum = yk_ring_rational(ring, 0, 1);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        int32_t index = yk_ring_symbol(ring, names[i], YK_RING_CONSTANT);
        assert_true(index >= 0);
        Element term = yk_ring_scale(ring, yk_ring_power(ring, yk_ring_of(ring, index), 1 + (int)i % 3), (int)i + 2, 1);
        sum = yk_ring_add(ring, sum, term);
    }
    Fixture f = {.ring = ring};
    check_round_trips(&f, sum);
    check_round_trips(&f, yk_ring_multiply(ring, sum, yk_ring_i(ring)));
    yk_ring_free(ring);
}

static size_t count_of(const char *text, const char *word)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, word)); at++) count++;
    return count;
}

// n cos(theta + k 15 deg) is shown as it is, as one term, and i n e^(i ...) likewise.
static void an_angle_turned_by_twelfths_is_one_term(void **state)
{
    (void)state;
    Fixture f = fixture_new(12);
    YkRing *r = f.ring;
    for (int k = 0; k < 24; k++)
        for (int is_sine = 0; is_sine < 2; is_sine++) {
            YkText text = {0};
            Element unit = yk_ring_multiply(r, yk_ring_unit(r, f.angle[0]), yk_ring_turn(r, k, 12));
            Element a = yk_ring_scale(r, is_sine ? yk_ring_imaginary(r, unit) : yk_ring_real(r, unit), 7, 3);
            assert_true(yk_ring_write(r, a, YK_RING_TEXT, YK_RING_EXPANDED, &text));
            const char *shown = yk_text_get(&text);
            if (count_of(shown, "cos") + count_of(shown, "sin") != 1) print_error("%s\n", shown);
            assert_int_equal(count_of(shown, "cos") + count_of(shown, "sin"), 1);
            assert_null(strstr(shown, "sqrt"));
            check_same(r, read_text(&f, shown), a);
            yk_text_free(&text);
        }
    yk_ring_free(r);
}

// A name of three small letters or more is a word, whichever letters they are; what follows it is a subscript.
static void words_are_words_with_any_letter(void **state)
{
    (void)state;
    for (char c = 'a'; c <= 'z'; c++) {
        Fixture f = fixture_new(13);
        char name[16], shown[64];
        for (int place = 0; place < 3; place++) {
            snprintf(name, sizeof name, "jvk%d", place + 1);
            name[place] = c;
            snprintf(shown, sizeof shown, "\\mathit{%.3s}_{%d}", name, place + 1);
            Element a = yk_ring_of(f.ring, yk_ring_symbol(f.ring, name, YK_RING_CONSTANT));
            check_written(f.ring, a, YK_RING_LATEX, YK_RING_EXPANDED, shown);
        }
        yk_ring_free(f.ring);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_elements_read_back_as_themselves_in_every_format_and_style),
        cmocka_unit_test(energies_and_their_derivatives_read_back),
        cmocka_unit_test(text_is_ordered_and_grouped_for_the_reader),
        cmocka_unit_test(rates_get_a_bracket_each_when_asked),
        cmocka_unit_test(every_term_stands_alone_when_expanded),
        cmocka_unit_test(latex_has_greek_letters_dots_and_subscripts),
        cmocka_unit_test(c_has_identifiers_doubles_and_no_powers),
        cmocka_unit_test(complex_elements_have_no_c),
        cmocka_unit_test(mathml_is_well_formed),
        cmocka_unit_test(the_order_depends_on_the_symbols_alone),
        cmocka_unit_test(names_that_look_alike_stay_apart),
        cmocka_unit_test(an_angle_turned_by_twelfths_is_one_term),
        cmocka_unit_test(words_are_words_with_any_letter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
