// Four-bars: classes against who can turn through, decided link by link from the triangle inequality; and which rings
// of four pins there are, against trying all quadruples of joints.
#include <yoke/design.h>
#include "compile/machine.h"
#include "compile/table.h"

// Can p turn all the way against q, the other two being r and s? Their ends must stay within reach at both extremes.
static bool turns_through(double p, double q, double r, double s)
{
    return fabs(p - q) >= fabs(r - s) && p + q <= r + s;
}

// By the motions of the links against the frame, without Grashof's sum.
static YkFourBarClass expected_class(const double *l)
{
    double frame = l[0], input = l[1], coupler = l[2], output = l[3];
    bool in = turns_through(frame, input, coupler, output), out = turns_through(frame, output, coupler, input);
    if (in && out) return YK_FOUR_BAR_DRAG_LINK;
    if (in) return YK_FOUR_BAR_CRANK_ROCKER;
    if (out) return YK_FOUR_BAR_ROCKER_CRANK;
    return turns_through(coupler, input, frame, output) ? YK_FOUR_BAR_DOUBLE_ROCKER : YK_FOUR_BAR_TRIPLE_ROCKER;
}

static YkFourBar four_bar_of(const double *l, bool driven_right)
{
    char text[1200];
    YkFourBar found;
    snprintf(text, sizeof text,
             "parameters: {f: %.17g, a: %.17g, c: %.17g, b: %.17g}\n"
             "bodies:\n  ground: {points: {O: [0, 0], Q: [f, 0]}}\n" LINK("left", "O", "A", "a") LINK("coupler", "A",
                                                                                                      "B", "c")
                 LINK("right", "Q", "B", "b") "joints: {O: {pin: [ground, left], angle: p}, A: {pin: [left, coupler]}, "
                                              "Q: {pin: [ground, right], angle: q}, B: {pin: [coupler, right]}}\n"
                                              "start: {%s: 1}\n",
             l[0], l[1], l[2], l[3], driven_right ? "q" : "p");
    Machine m = machine(text);
    assert_int_equal(yk_four_bars(m.mech, &found, 1), 1);
    assert_string_equal(yk_model_body_name(m.model, found.body[0]), "ground");
    assert_string_equal(yk_model_body_name(m.model, found.body[1]), driven_right ? "right" : "left");
    assert_string_equal(yk_model_body_name(m.model, found.body[2]), "coupler");
    assert_string_equal(yk_model_joint_name(m.model, found.joint[0]), driven_right ? "Q" : "O");
    assert_string_equal(yk_model_joint_name(m.model, found.joint[1]), driven_right ? "B" : "A");
    machine_free(&m);
    return found;
}

static void classes_say_which_links_turn_through(void **state)
{
    (void)state;
    uint64_t seed = 61;
    size_t seen[6] = {0};
    for (int trial = 0; trial < 3000; trial++) {
        double l[4];
        for (size_t k = 0; k < 4; k++) l[k] = check_uniform(&seed, 0.1, 3);
        bool right = check_random(&seed) % 2;
        YkFourBar f = four_bar_of(l, right);
        const double lengths[4] = {l[0], right ? l[3] : l[1], l[2], right ? l[1] : l[3]}; // the input comes second
        for (size_t k = 0; k < 4; k++) CHECK_NEAR(f.length[k], lengths[k], 1e-15);
        YkFourBarClass expected = expected_class(lengths);
        if (f.kind != expected)
            print_error("trial %d of seed 61: %g %g %g %g\n", trial, lengths[0], lengths[1], lengths[2], lengths[3]);
        assert_int_equal(f.kind, expected);
        seen[f.kind]++;
    }
    for (int k = 0; k < 6; k++) assert_true(seen[k] > 100 || k == YK_FOUR_BAR_CHANGE_POINT);
}

static void the_four_inversions_of_a_grashof_chain_are_all_told(void **state)
{
    (void)state;
    static const double ring[4] = {1, 3, 4, 3.5};
    static const YkFourBarClass expected[4] = {YK_FOUR_BAR_DRAG_LINK, YK_FOUR_BAR_ROCKER_CRANK,
                                               YK_FOUR_BAR_DOUBLE_ROCKER, YK_FOUR_BAR_CRANK_ROCKER};
    for (size_t turn = 0; turn < 4; turn++) {
        double l[4];
        for (size_t k = 0; k < 4; k++) l[k] = ring[(k + turn) % 4];
        assert_int_equal(four_bar_of(l, false).kind, expected[turn]);
    }
}

static void equal_sums_are_change_points_in_any_order_and_unit(void **state)
{
    (void)state;
    static const double sums[][4] = {{1, 4, 2, 3}, {2, 1, 2, 1}, {1, 1, 1, 1}, {0.3, 0.6, 0.4, 0.5}};
    for (size_t s = 0; s < 4; s++)
        for (size_t a = 0; a < 4; a++)
            for (size_t b = 0; b < 4; b++)
                for (double unit = 1e-5; unit < 1e6; unit *= 1000) {
                    double l[4];
                    for (size_t k = 0; k < 4; k++) l[k] = unit * sums[s][k];
                    double t = l[a];
                    l[a] = l[b];
                    l[b] = t;
                    assert_int_equal(four_bar_of(l, false).kind, YK_FOUR_BAR_CHANGE_POINT);
                }
    double nearly[4] = {1, 4, 2, 3 + 1e-9};
    assert_int_equal(four_bar_of(nearly, false).kind, YK_FOUR_BAR_DRAG_LINK);
    nearly[3] = 3 - 1e-9;
    assert_int_equal(four_bar_of(nearly, false).kind, YK_FOUR_BAR_TRIPLE_ROCKER);
}

// --- finding them
// -------------------------------------------------------------------------------------------------------

static bool is_pin(const Machine *m, size_t joint)
{
    return strcmp(yk_model_joint_kind(m->model, joint), "pin") == 0;
}

static bool joins(const Machine *m, size_t joint, size_t a, size_t b)
{
    size_t p = yk_model_joint_body(m->model, joint, 0), q = yk_model_joint_body(m->model, joint, 1);
    return (p == a && q == b) || (p == b && q == a);
}

// Rings frame - A - C - B - frame over four pins, each counted once: the frame is their first body, its pins in order.
static size_t count_rings(const Machine *m, size_t frame)
{
    size_t joints = yk_model_joint_count(m->model), bodies = yk_model_body_count(m->model), count = 0;
    for (size_t j0 = 0; j0 < joints; j0++)
        for (size_t j3 = j0 + 1; j3 < joints; j3++)
            for (size_t A = frame + 1; A < bodies; A++)
                for (size_t B = frame + 1; B < bodies; B++) {
                    if (A == B || !is_pin(m, j0) || !is_pin(m, j3) || !joins(m, j0, frame, A) ||
                        !joins(m, j3, frame, B))
                        continue;
                    for (size_t C = frame + 1; C < bodies; C++)
                        for (size_t j1 = 0; j1 < joints; j1++)
                            for (size_t j2 = 0; j2 < joints; j2++)
                                count += C != A && C != B && is_pin(m, j1) && is_pin(m, j2) && joins(m, j1, A, C) &&
                                         joins(m, j2, C, B);
                }
    return count;
}

static size_t expected_count(const Machine *m)
{
    size_t count = count_rings(m, 0);
    for (size_t frame = 1; count == 0 && frame < yk_model_body_count(m->model); frame++) count = count_rings(m, frame);
    return count;
}

static void check_ring(const Machine *m, const YkFourBar *f)
{
    for (size_t k = 0; k < 4; k++) {
        assert_true(is_pin(m, f->joint[k]));
        assert_true(joins(m, f->joint[k], f->body[k], f->body[(k + 1) % 4]));
        for (size_t other = 0; other < k; other++)
            assert_true(f->body[k] != f->body[other] && f->joint[k] != f->joint[other]);
    }
}

static void every_ring_of_four_pins_is_found_once(void **state)
{
    (void)state;
    size_t total = 0;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        YkFourBar found[16];
        size_t count = yk_four_bars(m.mech, found, 16);
        if (count != expected_count(&m)) print_error("%s\n", machines[k].source);
        assert_int_equal(count, expected_count(&m));
        assert_in_range(count, 0, 16);
        for (size_t i = 0; i < count; i++) {
            check_ring(&m, &found[i]);
            for (size_t other = 0; other < i; other++)
                assert_false(found[i].joint[0] == found[other].joint[0] && found[i].joint[3] == found[other].joint[3] &&
                             found[i].body[2] == found[other].body[2]);
        }
        total += count;
        machine_free(&m);
    }
    assert_true(total > 20);
}

static void where_no_ring_stands_on_the_ground_one_that_floats_is_found(void **state)
{
    (void)state;
    Machine m =
        machine("bodies:\n  arm: {points: {O: [0, 0], Q: [4, 0]}}\n" LINK("a", "O", "A", "1") LINK("b", "A", "B", "3.5")
                    LINK("c", "Q", "B", "3") "joints: {P: {pin: [ground, arm]}, Q: {pin: [arm, c]}, B: {pin: [b, c]}, "
                                             "A: {pin: [a, b]}, O: {pin: [arm, a]}}\n"
                                             "start: {P.angle: 1, O.angle: 1}\n");
    YkFourBar found[4];
    assert_int_equal(yk_four_bars(m.mech, found, 4), 1); // once, though it could be told from any of its bodies
    assert_string_equal(yk_model_body_name(m.model, found[0].body[0]), "arm");
    assert_string_equal(yk_model_body_name(m.model, found[0].body[1]), "a"); // the side whose angle is an input
    assert_int_equal(found[0].kind, YK_FOUR_BAR_CRANK_ROCKER);
    machine_free(&m);
}

static void the_gallery_is_classified_as_its_names_say(void **state)
{
    (void)state;
    static const struct {
        const char *source;
        YkFourBarClass kind;
    } cases[] = {{"four-bar", YK_FOUR_BAR_CRANK_ROCKER},
                 {"drag-link", YK_FOUR_BAR_DRAG_LINK},
                 {"chebyshev", YK_FOUR_BAR_DOUBLE_ROCKER},
                 {"non-grashof", YK_FOUR_BAR_TRIPLE_ROCKER},
                 {"parallelogram", YK_FOUR_BAR_CHANGE_POINT},
                 {"kite", YK_FOUR_BAR_CHANGE_POINT},
                 {"change-point-four-bar", YK_FOUR_BAR_CHANGE_POINT},
                 {"hoeken", YK_FOUR_BAR_CRANK_ROCKER}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        Machine m = machine(cases[k].source);
        YkFourBar found;
        assert_int_equal(yk_four_bars(m.mech, &found, 1), 1);
        assert_int_equal(found.kind, cases[k].kind);
        machine_free(&m);
    }
}

static void the_count_is_told_where_there_is_no_room(void **state)
{
    (void)state;
    Machine m = machine("three-crank-parallelogram");
    YkFourBar one = {.kind = YK_FOUR_BAR_TRIPLE_ROCKER};
    assert_int_equal(yk_four_bars(m.mech, NULL, 0), 3);
    assert_int_equal(yk_four_bars(m.mech, &one, 1), 3);
    assert_int_equal(one.kind, YK_FOUR_BAR_CHANGE_POINT);
    machine_free(&m);
}

// A four-bar with many bolts for one pin, and a plate that is bolted to the ground very often: as many rings as bolts,
// and no look at pairs of the plate's bolts.
static void many_pins_between_two_bodies_cost_no_more_than_they_are(void **state)
{
    (void)state;
    enum { BOLTS = 100, PINS = 20000, ROOM = 64 * (PINS + BOLTS) };
    char *text = malloc(ROOM);
    assert_non_null(text);
    size_t at = (size_t)snprintf(text, ROOM,
                                 "bodies:\n  ground: {points: {O: [0, 0], Q: [4, 0]}}\n"
                                 "  a: {points: {O: [0, 0], A: [1, 0]}}\n  c: {points: {A: [0, 0], B: [3, 0]}}\n"
                                 "  b: {points: {Q: [0, 0], B: [3, 0]}}\n  plate: {}\njoints:\n"
                                 "  O: {pin: [ground, a], angle: q}\n  Q: {pin: [ground, b], angle: r}\n"
                                 "  B: {pin: [c, b]}\n");
    for (int k = 0; k < BOLTS; k++) at += (size_t)snprintf(text + at, ROOM - at, "  A%d: {pin: [a, c], at: A}\n", k);
    for (int k = 0; k < PINS; k++) at += (size_t)snprintf(text + at, ROOM - at, "  P%d: {pin: [ground, plate]}\n", k);
    snprintf(text + at, ROOM - at, "start: {q: 1, r: 2}\n");
    Machine m = machine(text);
    free(text);
    YkFourBar found[2];
    assert_int_equal(yk_four_bars(m.mech, found, 2), BOLTS); // would end before, if it tried all pairs
    assert_int_equal(found[1].joint[1], 4);
    machine_free(&m);
}

static void classes_have_names_of_their_own(void **state)
{
    (void)state;
    for (int a = YK_FOUR_BAR_CRANK_ROCKER; a <= YK_FOUR_BAR_TRIPLE_ROCKER; a++)
        for (int b = YK_FOUR_BAR_CRANK_ROCKER; b < a; b++)
            assert_string_not_equal(yk_four_bar_name((YkFourBarClass)a), yk_four_bar_name((YkFourBarClass)b));
    assert_string_equal(yk_four_bar_name(YK_FOUR_BAR_CRANK_ROCKER), "crank-rocker (Grashof)");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(classes_say_which_links_turn_through),
        cmocka_unit_test(the_four_inversions_of_a_grashof_chain_are_all_told),
        cmocka_unit_test(equal_sums_are_change_points_in_any_order_and_unit),
        cmocka_unit_test(every_ring_of_four_pins_is_found_once),
        cmocka_unit_test(where_no_ring_stands_on_the_ground_one_that_floats_is_found),
        cmocka_unit_test(the_gallery_is_classified_as_its_names_say),
        cmocka_unit_test(the_count_is_told_where_there_is_no_room),
        cmocka_unit_test(classes_have_names_of_their_own),
        cmocka_unit_test(many_pins_between_two_bodies_cost_no_more_than_they_are),
    };
    return cmocka_run_group_tests_name("design/four_bar", tests, NULL, NULL);
}
