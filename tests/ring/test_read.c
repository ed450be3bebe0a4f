// Reading text by people and programs: what is understood, and what is refused with a helpful message.
#include "ring/ring_check.h"

static void many_ways_of_writing_mean_the_same(void **state)
{
    (void)state;
    static const struct {
        YkRingFormat format;
        const char *one, *other;
    } pairs[] = {
        {YK_RING_TEXT, "2*l1", " 2 l1 "},
        {YK_RING_TEXT, "l1/2 m1", "m1*l1/2"},
        {YK_RING_TEXT, "-l1^2", "-(l1*l1)"},
        {YK_RING_TEXT, "- -l1", "l1"},
        {YK_RING_TEXT, "l1^-2", "1/(l1 l1)"},
        {YK_RING_TEXT, "l1^(-2)", "1/l1/l1"},
        {YK_RING_TEXT, "0.25 l1", "l1/4"},
        {YK_RING_TEXT, ".5", "1/2"},
        {YK_RING_TEXT, "1e-3", "1/1000"},
        {YK_RING_TEXT, "theta1.rate", "theta1'"},
        {YK_RING_TEXT, "A.angle.accel", "A.angle''"},
        {YK_RING_TEXT, "(l1 + m1)(l1 - m1)", "l1^2 - m1^2"},
        {YK_RING_TEXT, "(l1 + m1)^2", "l1^2 + 2 l1 m1 + m1^2"},
        {YK_RING_TEXT, "pow(l1 + m1, 2)", "(l1 + m1)^2"},
        {YK_RING_TEXT, "cos((theta1 + theta2)*2 - theta2)", "cos(2 theta1 + theta2)"},
        {YK_RING_TEXT, "cos(theta1)cos(theta1)", "1 - sin(theta1)^2"},
        {YK_RING_TEXT, "cos (theta1)", "cos(-theta1)"},
        {YK_RING_TEXT, "2i", "2*1i"},
        {YK_RING_TEXT, "exp(1i*theta1)", "cos(theta1) + i sin(theta1)"},
        {YK_RING_TEXT, "sqrt(12)", "2 sqrt(3)"},
        {YK_RING_TEXT, "cos(pi*0.25)", "sqrt(2)/2"},
        {YK_RING_TEXT, "+l1", "l1"},
        {YK_RING_TEXT, "l1 - -m1", "l1 + m1"},
        {YK_RING_TEXT, "  l1  \t\n  *   m1  ", "l1*m1"},
        {YK_RING_LATEX, "\\quad~~ l_1 \\, ~\\;  m_1", "l_1 m_1"},
        {YK_RING_LATEX, "\\frac{l_1}{2}", "\\tfrac{1}{2} l_{1}"},
        {YK_RING_LATEX, "\\left( l_{1} + m_{1} \\right)^2", "(l_1 + m_1)^{2}"},
        {YK_RING_LATEX, "l_1 \\cdot m_1", "l_1\\,m_1"},
        {YK_RING_LATEX, "\\dot{\\theta}_1", "\\dot{\\theta}_{1}"},
        {YK_RING_LATEX, "e^{\\mathrm{i}\\theta_1}", "\\cos(\\theta_1) + \\mathrm{i}\\sin(\\theta_1)"},
        {YK_RING_LATEX, "\\cos\\left(\\theta_{1} - \\tfrac{\\pi}{3}\\right)", "\\sin(\\theta_1 + \\frac{\\pi}{6})"},
        {YK_RING_C, "theta1_rate*2.0", "theta1_rate + theta1_rate"},
        {YK_RING_C, "1.0/2.0*cos(A_angle)", "0.5*cos(A_angle)"},
    };
    Fixture f = fixture_new(1);
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        check_same(f.ring, read_as(f.ring, pairs[i].format, pairs[i].one),
                   read_as(f.ring, pairs[i].format, pairs[i].other));
    yk_ring_free(f.ring);
}

// What reading `text` reports: one problem with this code, at this column, with this word in message or hint.
static void check_refused(Fixture *f, YkRingFormat format, const char *text, int code, unsigned column,
                          const char *word)
{
    YkProblems *problems = yk_problems_new();
    Element a = yk_ring_read(f->ring, format, text, strlen(text), (YkPlace){7, 11, 0}, problems);
    const YkProblem *problem = yk_problems_count(problems) == 1 ? yk_problems_get(problems, 0) : NULL;
    bool fits = !a && problem && problem->code == code && problem->place.line == 7 &&
                problem->place.column == 10 + column &&
                (strstr(problem->message, word) || (problem->hint && strstr(problem->hint, word)));
    if (!fits) fail_msg("%s: %s", text, yk_problems_text(problems, 0));
    assert_int_equal(yk_ring_status(f->ring), YK_RING_OK);
    yk_problems_free(problems);
    assert_null(yk_ring_read(f->ring, format, text, strlen(text), (YkPlace){1, 1, 0}, NULL));
}

static void mistakes_are_told_at_their_place(void **state)
{
    (void)state;
    Fixture f = fixture_new(2);
    check_refused(&f, YK_RING_TEXT, "", YK_CODE_EXPR_SYNTAX, 1, "ends");
    check_refused(&f, YK_RING_TEXT, "l1 +", YK_CODE_EXPR_SYNTAX, 5, "ends");
    check_refused(&f, YK_RING_TEXT, "l1 ) m1", YK_CODE_EXPR_SYNTAX, 4, "operator");
    check_refused(&f, YK_RING_TEXT, "(l1 + m1", YK_CODE_EXPR_SYNTAX, 9, "`)`");
    check_refused(&f, YK_RING_TEXT, "cos(theta1", YK_CODE_EXPR_SYNTAX, 11, "`)`");
    check_refused(&f, YK_RING_TEXT, "cos(theta1}", YK_CODE_EXPR_SYNTAX, 11, "`)`");
    check_refused(&f, YK_RING_LATEX, "e^{\\mathrm{i}\\theta_1)", YK_CODE_EXPR_SYNTAX, 22, "`}`");
    check_refused(&f, YK_RING_LATEX, "l_1 \\quadx", YK_CODE_UNKNOWN_NAME, 5, "quadx");
    check_refused(&f, YK_RING_TEXT, "l1 # m1", YK_CODE_EXPR_SYNTAX, 4, "operator");
    check_refused(&f, YK_RING_TEXT, "l1 \xc2\xb7 m1", YK_CODE_EXPR_CHARACTER, 4, "character");
    check_refused(&f, YK_RING_TEXT, "l1 + lc2", YK_CODE_UNKNOWN_NAME, 6, "lc1");
    check_refused(&f, YK_RING_TEXT, "theta1'''", YK_CODE_UNKNOWN_NAME, 1, "theta1''");
    check_refused(&f, YK_RING_TEXT, "cos(l1)", YK_CODE_RING_ANGLE, 5, "angle");
    check_refused(&f, YK_RING_TEXT, "cos(theta1/2)", YK_CODE_RING_ANGLE, 5, "whole");
    check_refused(&f, YK_RING_TEXT, "cos(theta1 + 1)", YK_CODE_RING_ANGLE, 5, "angle");
    check_refused(&f, YK_RING_TEXT, "cos(theta1')", YK_CODE_RING_ANGLE, 5, "angle");
    check_refused(&f, YK_RING_TEXT, "exp(theta1)", YK_CODE_RING_ANGLE, 5, "angle");
    check_refused(&f, YK_RING_TEXT, "cos theta1", YK_CODE_EXPR_SYNTAX, 5, "`(`");
    check_refused(&f, YK_RING_TEXT, "1/(l1 + m1)", YK_CODE_RING_DIVISOR, 1, "single term");
    check_refused(&f, YK_RING_TEXT, "l1/0", YK_CODE_RING_DIVISOR, 1, "zero");
    check_refused(&f, YK_RING_TEXT, "l1^m1", YK_CODE_EXPR_SYNTAX, 4, "whole");
    check_refused(&f, YK_RING_TEXT, "l1^99999999", YK_CODE_RING_SIZE, 1, "power");
    check_refused(&f, YK_RING_TEXT, "(l1 + m1)^100", YK_CODE_RING_SIZE, 1, "coefficient");
    check_refused(&f, YK_RING_TEXT, "99999999999999999999", YK_CODE_RING_SIZE, 1, "large");
    check_refused(&f, YK_RING_TEXT, "0.1234567890123456789", YK_CODE_RING_SIZE, 1, "large");
    check_refused(&f, YK_RING_TEXT, "sqrt(5)", YK_CODE_EXPR_SYNTAX, 6, "roots");
    check_refused(&f, YK_RING_TEXT, "pow(l1)", YK_CODE_EXPR_SYNTAX, 7, "`,`");
    check_refused(&f, YK_RING_TEXT, "pow(l1, m1)", YK_CODE_RING_SIZE, 5, "power");
    check_refused(&f, YK_RING_LATEX, "\\frac{l_1", YK_CODE_EXPR_SYNTAX, 10, "`}`");
    check_refused(&f, YK_RING_LATEX, "\\frac l_1", YK_CODE_EXPR_SYNTAX, 7, "`{`");
    check_refused(&f, YK_RING_LATEX, "\\foo", YK_CODE_UNKNOWN_NAME, 1, "foo");
    check_refused(&f, YK_RING_LATEX, "\\dot{\\theta", YK_CODE_UNKNOWN_NAME, 1, "theta");
    yk_ring_free(f.ring);
}

static void nesting_has_a_limit(void **state)
{
    (void)state;
    Fixture f = fixture_new(3);
    char text[4001];
    memset(text, '(', 4000);
    text[4000] = '\0';
    check_refused(&f, YK_RING_TEXT, text, YK_CODE_EXPR_TOO_DEEP, 202, "deeply");
    memset(text, '-', 3998);
    memcpy(text + 3998, "l1", 3);
    check_same(f.ring, read_text(&f, text), symbol(&f, "l1")); // signs do not nest
    yk_ring_free(f.ring);
}

// Any bytes give an element or one problem, and never leave the ring failed.
static void garbage_is_refused(void **state)
{
    (void)state;
    static const char *const pieces[] = {"l1",     "theta1", "'",       "(", ")",   "{",     "}",    "+",
                                         "-",      "*",      "/",       "^", "cos", "\\cos", "exp(", "e^{\\mathrm{i}",
                                         "\\frac", "\\dot{", "\\theta", "_", "1",   "0.5",   "i",    "pi",
                                         " ",      "sqrt(",  "pow(",    ",", "2",   "\\",    "\xff"};
    Fixture f = fixture_new(4);
    for (int i = 0; i < 20000; i++) {
        char text[200] = "";
        for (int k = below(&f, 12); k > 0; k--) strcat(text, pieces[below(&f, sizeof pieces / sizeof *pieces)]);
        YkProblems *problems = yk_problems_new();
        Element a = yk_ring_read(f.ring, (YkRingFormat)below(&f, YK_RING_FORMATS), text, strlen(text),
                                 (YkPlace){1, 1, 0}, problems);
        if ((a != NULL) != (yk_problems_count(problems) == 0)) fail_msg("%s", text);
        assert_int_equal(yk_ring_status(f.ring), YK_RING_OK);
        yk_problems_free(problems);
    }
    yk_ring_free(f.ring);
}

static void a_symbol_named_i_takes_its_name_back(void **state)
{
    (void)state;
    YkRing *ring = yk_ring_new();
    int32_t ratio = yk_ring_symbol(ring, "i", YK_RING_CONSTANT);
    check_same(ring, read_as(ring, YK_RING_TEXT, "i"), yk_ring_of(ring, ratio));
    check_same(ring, read_as(ring, YK_RING_TEXT, "1i"), yk_ring_i(ring));
    check_written(ring, yk_ring_add(ring, yk_ring_i(ring), yk_ring_of(ring, ratio)), YK_RING_TEXT, YK_RING_TEXTBOOK,
                  "i + 1i");
    yk_ring_free(ring);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(many_ways_of_writing_mean_the_same),
        cmocka_unit_test(mistakes_are_told_at_their_place),
        cmocka_unit_test(nesting_has_a_limit),
        cmocka_unit_test(garbage_is_refused),
        cmocka_unit_test(a_symbol_named_i_takes_its_name_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
