// What a report says is true: the joint it names is the one that does not close or stands at its dead point, and the
// number in its sentence is the miss or the sine by a closed form. Every sentence ends, whatever the names are.
#include "machine.h"
#include "solve/state.h"

// The joint that the report gives has the name that its message gives, and the number of the message is the report's.
static const YkReport *check_report(const Machine *m, YkStatus status, const char *joint, const char *words, double gap,
                                    double determinant)
{
    const YkReport *report = yk_state_report(m->state);
    char label[100];
    snprintf(label, sizeof label, "`%s`", joint);
    if (!strstr(report->message, label) || !strstr(report->message, words)) print_error("%s\n", report->message);
    assert_int_equal(report->status, status);
    assert_non_null(strstr(report->message, label));
    assert_non_null(strstr(report->message, words));
    CHECK_NEAR(report->gap, gap, 1e-12);
    CHECK_NEAR(report->determinant * report->determinant, determinant * determinant, 2e-15);
    assert_true(report->joint >= 0);
    assert_string_equal(m->model->joints[report->joint].name, joint);
    const char *number = strpbrk(strrchr(report->message, '`'), "0123456789");
    if (number) CHECK_NEAR(strtod(number, NULL), gap + report->determinant, 0.006 * (gap + report->determinant));
    return report;
}

// A machine assembled at its drives, with a report of that.
static Machine assembled(const char *text, YkStatus status)
{
    Machine m = machine_parse(text, false);
    assert_int_equal(yk_state_assemble(m.state), status);
    return m;
}

// Two parallelograms, driven apart from each other.
#define PARALLELOGRAMS(a, b, length)                                                                                   \
    "bodies:\n  ground: {points: {O: [0, 0], Q: [3, 0], P: [0, 5], R: [3, 5]}}\n"                                      \
    "  a: {points: {O: [0, 0], A: [1, 0]}}\n  b: {points: {A: [0, 0], B: [" length ", 0]}}\n"                          \
    "  c: {points: {Q: [0, 0], B: [1, 0]}}\n  d: {points: {P: [0, 0], C: [1, 0]}}\n"                                   \
    "  e: {points: {C: [0, 0], D: [" length ", 0]}}\n  f: {points: {R: [0, 0], D: [1, 0]}}\njoints:\n"                 \
    "  O: {pin: [ground, a], angle: th}\n  Q: {pin: [ground, c], angle: ps}\n  A: {pin: [a, b], angle: u}\n"           \
    "  B: {pin: [b, c]}\n  P: {pin: [ground, d], angle: ph}\n  R: {pin: [ground, f], angle: ch}\n"                     \
    "  C: {pin: [d, e], angle: v}\n  D: {pin: [e, f]}\ndrives: {th: " a ", ph: " b "}\n"                               \
    "start: {ps: " a ", ch: " b ", u: 0, v: 0}\n"

// The sine of a parallelogram's transmission angle is that of its crank's.
static void of_two_dead_points_the_nearer_is_told(void **unused)
{
    (void)unused;
    static const char *const texts[] = {PARALLELOGRAMS("0", "9e-8", "3"), PARALLELOGRAMS("9e-8", "0", "3"),
                                        PARALLELOGRAMS("1", "9e-8", "3"), PARALLELOGRAMS("0.4e-7", "0.9e-7", "3")};
    static const char *const joints[] = {"B", "D", "D", "B"};
    static const double sines[] = {0, 0, 9e-8, 0.4e-7};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        Machine m = assembled(texts[k], YK_SINGULAR);
        const YkReport *report = check_report(&m, YK_SINGULAR, joints[k], "dead point at joint", 0, sines[k]);
        assert_true(report->block >= 0);
        assert_string_equal(yk_block_info(m.mech, (size_t)report->block).label, joints[k]);
        machine_free(&m);
    }
}

// Where neither closes, it is the first in the order of solution, and the miss is that one's.
static void of_two_loops_that_gape_the_first_is_told(void **unused)
{
    (void)unused;
    Machine m = assembled(PARALLELOGRAMS("1", "3", "5.5"), YK_NO_ASSEMBLY);
    const YkReport *report = yk_state_report(m.state);
    bool is_first = strstr(report->message, "`B`");
    double theta = is_first ? 1 : 3;
    check_report(&m, YK_NO_ASSEMBLY, is_first ? "B" : "D", "cannot be assembled",
                 5.5 - 1 - hypot(3 - cos(theta), sin(theta)), 0);
    assert_int_equal(report->block, 0);
    machine_free(&m);
}

// A slot that leads past its lever's pivot at a distance `c`: the crank's pin must stay as far from the pivot.
#define SLOTTED(a, c, angle)                                                                                           \
    "bodies:\n  ground: {points: {O: [0, 0], C: [1, 0]}}\n  crank: {points: {O: [0, 0], A: [" a ", 0]}}\n"             \
    "  lever: {points: {C: [0, 0], F: [0, " c "]}}\njoints:\n  O: {pin: [ground, crank], angle: th}\n"                 \
    "  C: {pin: [ground, lever], angle: u}\n  A: {pin-slot: [lever, crank], along: x, from: F, at: A}\n"               \
    "drives: {th: " angle "}\nstart: {u: 1}\n"

static void a_pin_nearer_to_the_pivot_than_its_slot_says_by_how_much(void **unused)
{
    (void)unused;
    Machine m = assembled(SLOTTED("1", "0.3", "0.1"), YK_NO_ASSEMBLY);
    check_report(&m, YK_NO_ASSEMBLY, "A", "cannot be assembled", 0.3 - 2 * sin(0.05), 0);
    machine_free(&m);
    m = assembled(SLOTTED("1", "0.3", "1"), YK_OK);
    assert_int_equal(yk_state_report(m.state)->message[0], 0);
    assert_int_equal(machine_solve(&m, 0.2, 1, 0), YK_LIMIT); // to the same from a pose that closes
    check_report(&m, YK_LIMIT, "A", "past a limit position", 0.3 - 2 * sin(0.1), 0);
    machine_free(&m);
    m = assembled(SLOTTED("0.7", "0.3", "0"), YK_SINGULAR); // the pin on the circle about the pivot
    check_report(&m, YK_SINGULAR, "A", "dead point", 0, 0);
    machine_free(&m);
}

// A rod between a crank's pin and a block whose guide is on a beam that turns: they meet as long as the pin is within
// the rod's length of the guide.
static const char turning_guide[] =
    "bodies:\n  ground: {points: {O: [0, 0], C: [1, 0]}}\n  crank: {points: {O: [0, 0], A: [2, 0]}}\n"
    "  beam: {points: {C: [0, 0], G: [0.5, 0.1]}}\n  rod: {points: {A: [0, 0], B: [0.4, 0]}}\n"
    "  block: {points: {B: [0, 0]}}\njoints:\n  O: {pin: [ground, crank], angle: th}\n"
    "  C: {pin: [ground, beam], angle: be}\n  A: {pin: [crank, rod], angle: u}\n  B: {pin: [rod, block]}\n"
    "  S: {slide: [beam, block], along: 20 deg, from: G, to: B, distance: s}\ndrives: {th: 0.1, be: 0.2}\n"
    "start: {u: 1.5}\n";

static void a_guide_that_turns_says_how_far_off_it_is(void **unused)
{
    (void)unused;
    Machine m = machine_parse(turning_guide, false);
    for (double th = 0.1; th < 6; th += 0.5)
        for (double be = -3; be < 3; be += 0.7) {
            yk_state_set_input(m.state, 0, (YkMotion){th, 0, 0});
            yk_state_set_input(m.state, 1, (YkMotion){be, 0, 0});
            YkStatus status = yk_state_assemble(m.state);
            double x = 2 * cos(th) - 1 - 0.5 * cos(be) + 0.1 * sin(be);
            double y = 2 * sin(th) - 0.5 * sin(be) - 0.1 * cos(be), along = be + YK_PI / 9;
            double off = fabs(cos(along) * y - sin(along) * x) - 0.4;
            assert_int_equal(status, off < 0 ? YK_OK : YK_NO_ASSEMBLY);
            if (off > 0) check_report(&m, status, "B", "cannot be assembled", off, 0);
        }
    machine_free(&m);
}

// Two guides on beams that turn come to be parallel where the beams turn alike.
static void guides_that_turn_say_how_far_apart_they_are_where_they_are_parallel(void **unused)
{
    (void)unused;
    Machine m = machine_parse(
        "bodies:\n  ground: {points: {O: [0, 0], C: [1, 0.5]}}\n  a: {points: {O: [0, 0], G: [0.5, 0.1]}}\n"
        "  b: {points: {C: [0, 0], H: [0.4, 0.7]}}\n  block: {points: {T: [0, 0]}}\njoints:\n"
        "  O: {pin: [ground, a], angle: th}\n  C: {pin: [ground, b], angle: be}\n"
        "  S: {pin-slot: [a, block], along: x, from: G, at: T, distance: s}\n"
        "  T: {slide: [b, block], along: x, from: H, to: T}\ndrives: {th: 0.1, be: 0.9}\n",
        true);
    for (double th = -3; th < 3; th += 0.37) {
        yk_state_set_input(m.state, 0, (YkMotion){th, 0, 0});
        yk_state_set_input(m.state, 1, (YkMotion){th + 1, 0, 0});
        assert_int_equal(yk_state_solve(m.state), YK_OK);
        yk_state_set_input(m.state, 1, (YkMotion){th, 0, 0});
        assert_int_equal(yk_state_solve(m.state), YK_LIMIT);
        double apart = fabs(cos(th) * 0.5 - sin(th) * 1 + 0.7 - 0.1);
        check_report(&m, YK_LIMIT, "T", "are parallel", apart, 0);
    }
    machine_free(&m);
}

// Three cranks side by side on one bar: the third repeats what the others say.
static const char three_cranks[] =
    "parameters: {r: 1}\n"
    "bodies:\n  ground: {points: {O: [0, 0], Q: [3, 0], P: [5, 0]}}\n  a: {points: {O: [0, 0], A: [1, 0]}}\n"
    "  b: {points: {A: [0, 0], B: [3, 0], D: [5, 0]}}\n  c: {points: {Q: [0, 0], B: [1, 0]}}\n"
    "  d: {points: {P: [0, 0], D: [r, 0]}}\njoints:\n  O: {pin: [ground, a], angle: th}\n"
    "  Q: {pin: [ground, c], angle: ps}\n  A: {pin: [a, b], angle: u}\n  B: {pin: [b, c]}\n"
    "  P: {pin: [ground, d], angle: ph}\n  D: {pin: [b, d]}\ndrives: {th: 1}\nstart: {ps: 1, ph: 1, u: -1}\n";

static void a_repeated_constraint_that_does_not_fit_says_by_how_much(void **unused)
{
    (void)unused;
    const char *name = "r";
    Machine m = assembled(three_cranks, YK_REDUNDANT);
    assert_int_equal(yk_state_report(m.state)->message[0], 0);
    YkVariant *variant = yk_variant_new(m.mech, &name, 1, m.problems);
    assert_non_null(variant);
    YkState *own = m.state;
    m.state = yk_state_new(yk_variant_mechanism(variant));
    for (double r = 0.5; r < 2; r += 0.25) { // the bar's point stays 1 from the third crank's pivot
        assert_int_equal(yk_variant_set(variant, &r), YK_OK);
        YkStatus status = yk_state_assemble(m.state);
        assert_int_equal(status, r == 1 ? YK_REDUNDANT : YK_NO_ASSEMBLY);
        if (r == 1) continue;
        check_report(&m, status, "D", "does not fit", fabs(r - 1), 0);
    }
    yk_state_free(m.state);
    m.state = own;
    yk_variant_free(variant);
    machine_free(&m);
}

// Wheels that mesh, run in a belt or with a rack, and a law that says the same of them up to 1 rad and then turns twice
// as fast. The miss is that of the angle or the distance, not of the weights by which equations are compared.
#define TWICE(part, law, start)                                                                                        \
    "bodies:\n  ground: {points: {O: [0, 0], Q: [0.4, 0], G: [0, -0.1]}}\n  a: {points: {O: [0, 0]}}\n"                \
    "  b: {points: {Q: [0, 0]}}\n  bar: {}\njoints:\n  O: {pin: [ground, a], angle: th}\n"                             \
    "  Q: {pin: [ground, b], angle: ps}\n  R: {slide: [ground, bar], along: x, from: G, distance: x}\n" part           \
    "\nlaws: {turn: {table: [[-9, 9], [1, -1], [9, -17]], between: linear},\n"                                         \
    "  shift: {table: [[-9, -0.9], [1, 0.1], [9, 1.7]], between: linear}}\ndrives: {th: 0.5, " law "}\n"               \
    "start: {" start "}\n"

static void check_twice(const char *text, const char *relation, double per_radian, const char *unit)
{
    Machine m = machine_parse(text, true);
    char words[40];
    for (double angle = 1.5; angle < 5; angle += 0.5) {
        assert_int_equal(machine_solve(&m, 0.7, 1, 0), YK_REDUNDANT);
        assert_int_equal(machine_solve(&m, angle, 1, 0), YK_NO_ASSEMBLY);
        const YkReport *report = yk_state_report(m.state);
        snprintf(words, sizeof words, "misses by %g %s;", per_radian * (angle - 1), unit);
        if (!strstr(report->message, words)) print_error("%s: %s\n", words, report->message);
        assert_non_null(strstr(report->message, words));
        assert_non_null(strstr(report->message, relation));
        assert_true(report->gap > 0 && report->message[strlen(report->message) - 1] == 's');
    }
    machine_free(&m);
}

static void a_repeated_gear_or_law_that_does_not_fit_says_by_what_angle_or_distance(void **unused)
{
    (void)unused;
    check_twice(TWICE("gears: {g: {mesh: [a, b], teeth: [20, 20]}}", "ps: {law: turn, of: th}", "ps: -0.5"), "`ps`", 1,
                "rad");
    check_twice(TWICE("belts: {g: {between: [a, b], radii: [70 mm, 70 mm], crossed: true}}", "ps: {law: turn, of: th}",
                      "ps: -0.5"),
                "`ps`", 1, "rad");
    check_twice(TWICE("racks: {g: {pinion: a, rack: bar, radius: 100 mm}}", "x: {law: shift, of: th}", "x: 0.05"),
                "`x`", 0.1, "m");
}

// A name as long as names may be leaves room for the sentence, or the sentence is cut, never overrun.
static void the_longest_names_are_cut(void **unused)
{
    (void)unused;
    char text[2000], name[200] = "";
    for (int k = 0; k < 100; k++) strcat(name, "b");
    snprintf(text, sizeof text,
             "bodies:\n  ground: {points: {O: [0, 0], Q: [9, 0]}}\n  a: {points: {O: [0, 0], A: [1, 0]}}\n"
             "  b: {points: {A: [0, 0], B: [3, 0]}}\n  c: {points: {Q: [0, 0], B: [1, 0]}}\njoints:\n"
             "  O: {pin: [ground, a], angle: th}\n  Q: {pin: [ground, c], angle: ps}\n  A: {pin: [a, b], angle: u}\n"
             "  %s: {pin: [b, c], at: B}\ndrives: {th: 0}\n",
             name);
    Machine m = machine_parse(text, false);
    assert_int_equal(yk_state_assemble(m.state), YK_NO_ASSEMBLY);
    name[80] = 0;
    snprintf(text, sizeof text,
             "the loop that joint `%s` closes cannot be assembled with these inputs: it misses by 4 m", name);
    assert_string_equal(yk_state_report(m.state)->message, text);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_two_dead_points_the_nearer_is_told),
        cmocka_unit_test(of_two_loops_that_gape_the_first_is_told),
        cmocka_unit_test(a_pin_nearer_to_the_pivot_than_its_slot_says_by_how_much),
        cmocka_unit_test(a_guide_that_turns_says_how_far_off_it_is),
        cmocka_unit_test(guides_that_turn_say_how_far_apart_they_are_where_they_are_parallel),
        cmocka_unit_test(a_repeated_constraint_that_does_not_fit_says_by_how_much),
        cmocka_unit_test(a_repeated_gear_or_law_that_does_not_fit_says_by_what_angle_or_distance),
        cmocka_unit_test(the_longest_names_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
