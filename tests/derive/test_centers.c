// Instant centres in symbols: every line holds for the centres that the engine finds at a pose, and so do the rates.
#include "forces_check.h"

static size_t lines_seen, rates_seen;

static void visit(Machine *m, const char *name)
{
    if (yk_input_count(m->mech) != 1 || m->model->carriage_count > 0) return;
    write_section(m, "centers");
    for (int k = 0; k < 3; k++) {
        bool is_clear = random_pose(m, k == 0), is_rate = false;
        for (size_t b = 0; is_clear && b < yk_block_count(m->mech); b++)
            is_clear = yk_block_info(m->mech, b).kind > YK_BLOCK_RPR || yk_state_transmission(m->state, b) > 0.1;
        for (const YkLine *line = m->page.first; line && is_clear; line = line->next) {
            if (line->kind == YK_LINE_HEADING) is_rate = strcmp(line->text, "Rates by centres") == 0;
            const YkPoisson *zero = line->left ? line_vanishes(m->d->ring, line) : NULL;
            YkVec value = zero ? yk_ring_value(m->d->ring, zero, m->values) : yk_vec(NAN, NAN);
            if (!isfinite(value.x) || !isfinite(value.y)) continue; // a centre is at infinity here
            check_vanishes(m, zero, name, 1e-10);
            lines_seen++;
            rates_seen += is_rate;
        }
    }
}

static void every_line_holds_at_random_poses(void **state)
{
    (void)state;
    lines_seen = rates_seen = 0;
    assert_true(each_example(visit) > 30);
    assert_true(lines_seen > 500);
    assert_true(rates_seen > 60);
}

static void the_quick_returns_centres_are_the_textbooks(void **state)
{
    (void)state;
    Machine m = example("quick-return");
    write_section(&m, "centers");
    const char *text = page_text(&m, false);
    expect(text, "6 bodies have 15 centres.");
    expect(text, "the pin O1:  P_01 = [ 0  ]");
    expect(text, "P_23 of lever and block lies at infinity, in the direction n_S across the line of S.");
    expect(text, "by block:  (P_12 - P_13) x n_S = 0");
    expect(text, "lever:  theta2' (P_12 - P_02) = theta1' (P_12 - P_01)");
    check_formats(&m, "centers", NULL);
    machine_end(&m);
}

static void what_is_not_there_is_said(void **state)
{
    (void)state;
    Machine m = machine_of("bodies:\n  ground: {points: {O: [0, 0]}}\n  bar: {points: {O: [0, 0], A: [1, 0]}}\n"
                           "  tip: {points: {A: [0, 0]}}\n"
                           "joints:\n  O: {pin: [ground, bar], angle: theta}\n  A: {pin: [bar, tip], angle: phi}\n");
    write_section(&m, "centers");
    expect(page_text(&m, false), "There are no instant centres: the machine does not have exactly one freedom.");
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_line_holds_at_random_poses),
        cmocka_unit_test(the_quick_returns_centres_are_the_textbooks),
        cmocka_unit_test(what_is_not_there_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
