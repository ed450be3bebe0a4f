// Rows, blocks and determinants of J.
#include "derive_check.h"

static const YkDeriveBlocks *blocks_of(Machine *m)
{
    const YkDeriveBlocks *blocks = yk_derive_blocks(m->d);
    assert_non_null(blocks);
    return blocks;
}

static void visit_derivative(Machine *m, const char *name)
{
    YkRing *ring = m->d->ring;
    const YkDeriveBlocks *blocks = blocks_of(m);
    (void)name;
    for (size_t r = 0; r < blocks->row_count; r++) {
        const YkDeriveRow *row = &blocks->rows[r];
        const YkPoisson *sum = yk_ring_rational(ring, 0, 1);
        for (size_t k = 0; k < m->d->coordinate_count; k++)
            sum = yk_ring_add(ring, sum,
                              yk_ring_multiply(ring, yk_derive_entry(m->d, row, (int32_t)k),
                                               yk_ring_of(ring, m->d->coordinates[k].rate)));
        assert_true(yk_ring_is_same(sum, yk_ring_time_derivative(ring, row->value)));
    }
}

static void the_time_derivative_of_a_loop_is_J_q_dot_identically(void **state)
{
    (void)state;
    assert_true(each_example(visit_derivative) > 30);
}

static void visit_triangle(Machine *m, const char *name)
{
    const YkDeriveBlocks *blocks = blocks_of(m);
    (void)name;
    assert_int_equal(blocks->column_count, m->d->coordinate_count);
    for (size_t b = 0; b < blocks->block_count; b++) {
        const YkDeriveBlock *block = &blocks->blocks[b];
        size_t behind = block->first_column + block->column_count;
        assert_int_equal(block->row_count, block->column_count);
        for (size_t i = 0; i < block->row_count; i++)
            for (size_t k = behind; k < blocks->column_count; k++)
                assert_true(yk_ring_is_zero(yk_derive_entry(
                    m->d, &blocks->rows[blocks->row_order[block->first_row + i]], blocks->column_order[k])));
    }
}

static void J_is_block_triangular_on_every_machine(void **state)
{
    (void)state;
    assert_true(each_example(visit_triangle) > 30);
}

// One term: c * monomial * cos or sin of one angle.
static bool is_one_term(YkRing *ring, const YkPoisson *a)
{
    YkText text = {0};
    assert_true(yk_ring_write(ring, a, YK_RING_TEXT, YK_RING_EXPANDED, &text));
    bool one = !yk_print_has_sum(yk_text_get(&text) + (*yk_text_get(&text) == '-'));
    yk_text_free(&text);
    return one;
}

static void dyads_have_determinants_of_one_term(void **state)
{
    (void)state;
    static const char *const names[] = {"quick-return",        "toggle",     "four-bar", "slider-crank",
                                        "crank-slotted-lever", "scotch-yoke"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        Machine m = example(names[n]);
        const YkDeriveBlocks *blocks = blocks_of(&m);
        assert_true(blocks->block_count > 0);
        for (size_t b = 0; b < blocks->block_count; b++) {
            assert_non_null(blocks->blocks[b].determinant);
            assert_true(is_one_term(m.d->ring, blocks->blocks[b].determinant));
        }
        machine_end(&m);
    }
}

static void the_quick_return_has_the_textbooks_two_blocks(void **state)
{
    (void)state;
    Machine m = example("quick-return");
    const YkDeriveBlocks *blocks = blocks_of(&m);
    static const char *const J[4][5] = {
        {"-l1*sin(theta1)", "d3*sin(theta2)", "-cos(theta2)", "0", "0"},
        {"l1*cos(theta1)", "-d3*cos(theta2)", "-sin(theta2)", "0", "0"},
        {"0", "-l2*sin(theta2) - l4*sin(theta2 + theta4)", "0", "-l4*sin(theta2 + theta4)", "-1"},
        {"0", "l2*cos(theta2) + l4*cos(theta2 + theta4)", "0", "l4*cos(theta2 + theta4)", "0"}};
    assert_int_equal(blocks->row_count, 4);
    assert_int_equal(blocks->input_count, 1);
    assert_int_equal(blocks->block_count, 2);
    for (size_t r = 0; r < 4; r++) {
        assert_int_equal(blocks->row_order[r], r);
        for (size_t k = 0; k < 5; k++) {
            assert_int_equal(blocks->column_order[k], k);
            check_element(&m, yk_derive_entry(m.d, &blocks->rows[r], (int32_t)k), J[r][k]);
        }
    }
    check_element(&m, blocks->blocks[0].determinant, "-d3");
    check_element(&m, blocks->blocks[1].determinant, "l4*cos(theta2 + theta4)");
    machine_end(&m);
}

static void a_second_guide_adds_a_row_that_says_nothing_and_a_distance(void **state)
{
    (void)state;
    Machine m = example("doubled-guide");
    const YkDeriveBlocks *blocks = blocks_of(&m);
    assert_int_equal(blocks->row_count, 3); // x, y of the rod's end; x of the second guide; its y is 0 = 0
    assert_int_equal(blocks->solved_row_count, 3);
    assert_int_equal(m.d->coordinate_count, m.d->tree_count + 1);
    assert_string_equal(m.d->coordinates[m.d->tree_count].name, "lower.distance");
    machine_end(&m);
}

static void a_third_crank_leaves_a_row_that_repeats_others(void **state)
{
    (void)state;
    Machine m = example("three-crank-parallelogram");
    const YkDeriveBlocks *blocks = blocks_of(&m);
    assert_int_equal(blocks->solved_row_count + 1, blocks->row_count);
    machine_end(&m);
}

static void a_group_of_more_than_a_dyad_is_shown_as_a_system(void **state)
{
    (void)state;
    Machine m = example("stephenson-awkward");
    const YkDeriveBlocks *blocks = blocks_of(&m);
    size_t largest = 0;
    for (size_t b = 0; b < blocks->block_count; b++)
        if (blocks->blocks[b].row_count > largest) largest = blocks->blocks[b].row_count;
    assert_true(largest > YK_CRAMER_MAX);
    assert_true(yk_derive_write(m.d, section_of("velocity"), &m.page));
    machine_end(&m);
}

static void determinants_follow_their_definition(void **state)
{
    (void)state;
    Machine m = example("four-bar");
    YkRing *ring = m.d->ring;
    const YkPoisson *A[9];
    static const int64_t numbers[9] = {2, -1, 3, 0, 4, 5, 7, 1, -2};
    for (size_t k = 0; k < 9; k++) A[k] = yk_ring_rational(ring, numbers[k], 1);
    int64_t over, under;
    assert_true(yk_ring_is_rational(yk_derive_determinant(ring, A, 3), &over, &under));
    assert_int_equal(over, 2 * (-8 - 5) + 7 * (-5 - 12)); // along the first column
    assert_int_equal(under, 1);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_time_derivative_of_a_loop_is_J_q_dot_identically),
        cmocka_unit_test(J_is_block_triangular_on_every_machine),
        cmocka_unit_test(dyads_have_determinants_of_one_term),
        cmocka_unit_test(the_quick_return_has_the_textbooks_two_blocks),
        cmocka_unit_test(a_second_guide_adds_a_row_that_says_nothing_and_a_distance),
        cmocka_unit_test(a_third_crank_leaves_a_row_that_repeats_others),
        cmocka_unit_test(a_group_of_more_than_a_dyad_is_shown_as_a_system),
        cmocka_unit_test(determinants_follow_their_definition),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
