// The exact print for machines that are in every textbook; and named vectors.
#include "derive_check.h"

// The lines of a section as text.
static char *printed(Machine *m, const char *section)
{
    YkText text = {0};
    m->page.first = m->page.last = NULL;
    assert_true(yk_derive_write(m->d, section_of(section), &m->page));
    assert_true(yk_page_write(&m->page, YK_PAGE_TEXT, NULL, NULL, &text));
    return text.data;
}

static void check_lines(Machine *m, const char *section, const char *const *lines, size_t count)
{
    char *text = printed(m, section);
    const char *at = text;
    for (size_t k = 0; k < count; k++) {
        const char *found = strstr(at, lines[k]);
        if (!found) print_error("%s\nin\n%s\n", lines[k], text);
        assert_non_null(found);
        at = found + strlen(lines[k]); // in this order
    }
    free(text);
}

static void the_quick_returns_loops_are_the_textbooks(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "p^{O1/O2} + p^{A/O1} - p^{A/O2} = 0\n",
        "x:  l1 cos(theta1) - d3 cos(theta2) = 0\n",
        "y:  a1 + l1 sin(theta1) - d3 sin(theta2) = 0\n",
        "p^{O2/C0} + p^{B/O2} + p^{C/B} - p^{C/C0} = 0\n",
        "x:  -d5 + l2 cos(theta2) + l4 cos(theta2 + theta4) = 0\n",
        "y:  -a1 - a2 + l2 sin(theta2) + l4 sin(theta2 + theta4) = 0\n",
    };
    Machine m = example("quick-return");
    check_lines(&m, "loops", lines, sizeof lines / sizeof *lines);
    machine_end(&m);
}

static void its_rates_are_solved_block_by_block(void **state)
{
    (void)state;
    static const char *const velocities[] = {
        "theta2' = l1 cos(theta1 - theta2) / d3 * theta1'\n",
        "d3' = -l1 sin(theta1 - theta2) theta1'\n",
        "d5' = l2 sin(theta4) / cos(theta2 + theta4) * theta2'\n",
        "coupler.angle' = -l2 cos(theta2) / (l4 cos(theta2 + theta4)) * theta2'\n",
        "k_theta2 = l1 cos(theta1 - theta2) / d3\n",
        "k_d5 = l2 sin(theta4) / cos(theta2 + theta4) * k_theta2\n",
    };
    static const char *const accelerations[] = {
        "block slides on lever (S)",
        "a^{A} = a^{A1} + a_Coriolis + a_relative\n",
        "a_centripetal = [ -d3 cos(theta2) theta2'^2 ]",
        "a_Coriolis = [ -2 sin(theta2) theta2' d3' ]",
        "theta2'' = (l1 cos(theta1 - theta2) theta1'' - 2 theta2' d3' - l1 sin(theta1 - theta2) theta1'^2) / d3\n",
        "d3'' = -l1 sin(theta1 - theta2) theta1'' + d3 theta2'^2 - l1 cos(theta1 - theta2) theta1'^2\n",
    };
    Machine m = example("quick-return");
    check_lines(&m, "velocity", velocities, sizeof velocities / sizeof *velocities);
    check_lines(&m, "acceleration", accelerations, sizeof accelerations / sizeof *accelerations);
    machine_end(&m);
}

static void the_toggle_reads_as_in_a_book(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "p^{O1/O2} + p^{A/O1} + p^{J/A} - p^{J/O2} = 0\n",
        "x:  -a0x + l1 cos(theta1) - l3 cos(theta3) + l2 cos(theta1 + theta2) = 0\n",
        "y:  a0y + l1 sin(theta1) - l3 sin(theta3) + l2 sin(theta1 + theta2) = 0\n",
        "y:  l3 sin(theta3) + l4 sin(theta3 + theta4) = 0\n",
    };
    static const char *const determinants[] = {"D_1 = l2 l3 sin(theta1 + theta2 - theta3)\n",
                                               "D_2 = l4 cos(theta3 + theta4)\n"};
    static const char *const points[] = {"C1, centre of mass of link1", "p^{C1} = [ 1/2 l1 cos(theta1) ]"};
    Machine m = example("toggle");
    check_lines(&m, "loops", lines, sizeof lines / sizeof *lines);
    check_lines(&m, "jacobian", determinants, 2);
    check_lines(&m, "points", points, 2);
    machine_end(&m);
}

static void the_four_bars_rates_are_quotients_of_sines(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "theta4' = a sin(gamma) / (c sin(theta2 + gamma - theta4)) * theta2'\n",
        "coupler.angle' = -a sin(theta2 - theta4) / (b sin(theta2 + gamma - theta4)) * theta2'\n",
    };
    Machine m = example("four-bar");
    check_lines(&m, "velocity", lines, 2);
    machine_end(&m);
}

static void points_are_named_as_short_as_is_clear(void **state)
{
    (void)state;
    Machine m = machine_of("bodies:\n"
                           "  ground: {points: {O: [0, 0], P: [3, 1]}}\n"
                           "  arm: {points: {O: [0, 0], A: [1, 0], P: [2, 0]}}\n"
                           "  leg: {points: {A: [0, 0]}, mass: 1}\n"
                           "joints:\n"
                           "  O: {pin: [ground, arm], angle: q}\n"
                           "  A: {pin: [arm, leg], angle: r}\n");
    const YkModel *model = m.model;
    size_t ground_P = yk_model_find_point(model, "ground.P"), arm_P = yk_model_find_point(model, "arm.P");
    size_t arm_A = yk_model_find_point(model, "arm.A"), leg_A = yk_model_find_point(model, "leg.A");
    assert_string_equal(yk_derive_point_name(m.d, 0, (int32_t)ground_P), "ground.P");
    assert_string_equal(yk_derive_point_name(m.d, 1, (int32_t)arm_P), "arm.P");
    assert_string_equal(yk_derive_point_name(m.d, 1, (int32_t)arm_A), "A");
    assert_string_equal(yk_derive_point_name(m.d, 2, (int32_t)leg_A), "A");
    assert_string_equal(yk_derive_point_name(m.d, 1, YK_NONE), "O"); // the file put O at the origin
    assert_string_equal(yk_derive_center_name(m.d, 2), "C1");
    machine_end(&m);
}

static void paths_between_points_add_up_to_the_difference_of_positions(void **state)
{
    (void)state;
    Machine m = example("quick-return");
    for (size_t p = 0; p < m.model->point_count; p++)
        for (size_t q = 0; q < m.model->point_count; q++) {
            YkDerivePath path;
            YkDerivePlace from = {m.model->points[p].body, (int32_t)p}, to = {m.model->points[q].body, (int32_t)q};
            assert_true(yk_derive_path(m.d, from, to, &path));
            const YkPoisson *a = yk_derive_position(m.d, to.body, yk_derive_at(m.d, to.point));
            const YkPoisson *b = yk_derive_position(m.d, from.body, yk_derive_at(m.d, from.point));
            assert_true(yk_ring_is_same(path.sum, yk_ring_subtract(m.d->ring, a, b)));
        }
    machine_end(&m);
}

static void latex_is_well_formed(void **state)
{
    (void)state;
    static const char *const parts[] = {
        "\\documentclass{article}", "\\mathbf{p}^{A/O_{1}}", "\\begin{array}{c|cc|cc}", "\\hline", "\\frac{",
        "\\end{document}"};
    Machine m = example("quick-return");
    YkText text = {0};
    for (size_t k = 0; k <= section_of("points"); k++) assert_true(yk_derive_write(m.d, k, &m.page));
    assert_true(yk_page_write(&m.page, YK_PAGE_LATEX, "A & B_1", NULL, &text));
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) assert_non_null(strstr(yk_text_get(&text), parts[k]));
    assert_non_null(strstr(yk_text_get(&text), "A \\& B\\_1"));
    int braces = 0;
    for (const char *c = yk_text_get(&text); *c; c++) {
        braces += (*c == '{') - (*c == '}');
        assert_true(braces >= 0);
    }
    assert_int_equal(braces, 0);
    yk_text_free(&text);
    machine_end(&m);
}

static void mathml_closes_what_it_opens(void **state)
{
    (void)state;
    Machine m = example("toggle");
    YkText text = {0};
    for (size_t k = 0; k <= section_of("points"); k++) assert_true(yk_derive_write(m.d, k, &m.page));
    assert_true(yk_page_write(&m.page, YK_PAGE_MATHML, "T", NULL, &text));
    const char *stack[64];
    size_t depth = 0;
    for (const char *c = strstr(yk_text_get(&text), "<body>"); c && (c = strchr(c, '<')) != NULL; c++) {
        size_t length = strcspn(c + 1, " >");
        if (c[1] != '/') {
            assert_true(depth < 64);
            stack[depth++] = c + 1;
            continue;
        }
        if (depth == 0) break; // </html>
        depth--;
        assert_int_equal(strncmp(stack[depth], c + 2, length - 1), 0);
    }
    assert_int_equal(depth, 0);
    yk_text_free(&text);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_quick_returns_loops_are_the_textbooks),
        cmocka_unit_test(its_rates_are_solved_block_by_block),
        cmocka_unit_test(the_toggle_reads_as_in_a_book),
        cmocka_unit_test(the_four_bars_rates_are_quotients_of_sines),
        cmocka_unit_test(points_are_named_as_short_as_is_clear),
        cmocka_unit_test(paths_between_points_add_up_to_the_difference_of_positions),
        cmocka_unit_test(latex_is_well_formed),
        cmocka_unit_test(mathml_closes_what_it_opens),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
