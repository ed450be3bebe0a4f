// Gear trains in symbols: the textbook's lines, every line true of the engine and of the relations, read back, random
// trains.
#include "derive/gears/gears.h"
#include "derive/relations.h"
#include "derive_check.h"
#include "ring/proof/field.h"

static const char *text_of(Machine *m, bool numbers)
{
    m->page.first = m->page.last = NULL;
    m->page.has_numbers = numbers;
    assert_true(yk_derive_write(m->d, section_of("gears"), &m->page));
    if (numbers) take_values(m);
    return page_text(m, numbers);
}

static void the_train_of_the_book_prints_as_in_the_book(void **state)
{
    (void)state;
    Machine m = example("epicyclic");
    yk_state_set_time(m.state, 0, NULL);
    assert_true(yk_state_assemble(m.state) >= 0);
    const char *text = text_of(&m, true);
    expect(text, "v_Q1 = omega1 x p^{Q1/O} = omegaC x p^{P/O} + omega_planet x p^{Q1/P}\n");
    expect(text, "v_Q2 = omegaC x p^{P/O} + omega_planet x p^{Q2/P} = omega4 x p^{Q2/O}\n");
    expect(text, "omega1 N1 = omegaC (N1 + N2) - omega_planet N2\n");
    expect(text, "(omega1 - omegaC) N1 = - (omega_planet - omegaC) N2\n");
    expect(text, "(omega_planet - omegaC) N3 = (omega4 - omegaC) N4\n");
    expect(text, "omega4 = omegaC (1 + N1 N3/(N2 N4)) - omega1 N1 N3/(N2 N4) = 1.66107\n");
    expect(text, "omega4 = 35/29 omegaC - 6/29 omega1 = 1.66107\n");
    expect(text, "omega4 = 460/29 rpm");
    expect(text, "[ 0    1       -N1/N2        -N1 N3/(N2 N4)    ]");
    machine_end(&m);
}

static void without_numbers_there_are_symbols_only(void **state)
{
    (void)state;
    Machine m = example("epicyclic");
    const char *text = text_of(&m, false);
    assert_null(strstr(text, "29"));
    assert_null(strstr(text, "rpm"));
    machine_end(&m);
}

static void ratios_of_a_shift_table_are_those_of_its_exact_fractions(void **state)
{
    (void)state;
    Machine m = example("gearbox-8hp70");
    assert_true(random_pose(&m, true));
    text_of(&m, true);
    const YkTrain *train = yk_derive_train(m.d)->train;
    size_t seen = 0;
    for (const YkLine *line = m.page.first; line; line = line->next)
        for (size_t k = 0; line->text && line->kind == YK_LINE_FORMULA && k < yk_train_gear_count(train); k++) {
            YkTrainGear gear = yk_train_gear(train, k);
            if (strcmp(line->text, gear.lock) != 0) continue;
            const YkPoisson *number = line->last->over; // "= 108/23"
            CHECK_NEAR(yk_ring_value(m.d->ring, number, m.values).x, gear.ratio.value, 1e-15 * fabs(gear.ratio.value));
            const YkPagePiece *piece = line->first->next->next; // behind `omega_input / omega_output =`
            double sign = 1, value = 1;
            if (piece->kind == YK_PIECE_SIGN && *piece->text == '-') sign = -1, piece = piece->next;
            for (int side = 0; side < 2 && piece->factors[side]; side++)
                for (size_t f = 0; f < piece->factor_count[side]; f++) {
                    double factor = yk_ring_value(m.d->ring, piece->factors[side][f], m.values).x;
                    value = side == 0 ? value * factor : value / factor;
                }
            if (!piece->factors[0]) value = yk_ring_value(m.d->ring, piece->over, m.values).x;
            CHECK_NEAR(sign * value, gear.ratio.value, 1e-14 * fabs(gear.ratio.value));
            seen++;
        }
    assert_int_equal(seen, 9);
    machine_end(&m);
}

// --- Every line of every train

static size_t lines_seen, lines_proved, lines_read;

static bool has_vectors(const YkLine *line)
{
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next)
        if (piece->kind == YK_PIECE_VECTOR || piece->kind == YK_PIECE_MATRIX) return true;
    return false;
}

static void check_line_at_pose(const Machine *m, const YkLine *line, const char *name)
{
    const YkPoisson *zero = line_vanishes(m->d->ring, line);
    double value = yk_ring_value(m->d->ring, zero, m->values).x, size = 1;
    for (size_t s = 0; s < yk_ring_symbol_count(m->d->ring); s++) { // what its terms come to
        if (!yk_ring_mentions(m->d->ring, zero, (int32_t)s)) continue;
        const YkPoisson *slope = yk_ring_partial(m->d->ring, zero, (int32_t)s);
        size += fabs(yk_ring_value(m->d->ring, slope, m->values).x * m->values[s]);
    }
    if (!(fabs(value) <= 1e-12 * size)) print_error("%s: %s: %g\n", name, line->text ? line->text : "", value);
    CHECK_NEAR(value, 0, 1e-12 * size);
    lines_seen++;
}

// By the relations of `loops`, for all numbers of teeth: at a random point of the prime field.
static void check_line_in_field(Machine *m, const YkLine *line, const YkFieldPoint *point, const char *name)
{
    const YkPoisson *zero = yk_derive_in_joints(m->d, line_vanishes(m->d->ring, line));
    assert_non_null(zero);
    uint64_t value = yk_ring_field(m->d->ring, zero, point, false);
    if (value != 0) print_error("%s: %s\n", name, line->text ? line->text : "");
    assert_int_equal(value, 0);
    lines_proved++;
}

// As printed, the line is an equation that --check finds true.
static void check_line_read(Machine *m, const YkLine *line, const char *name)
{
    YkText text = {0};
    YkPrinting printing = {.ring = m->d->ring, .text = &text};
    if (has_vectors(line)) return;
    yk_print_formula_text(&printing, line, &text);
    YkCheckVerdict verdict = verdict_on(m, yk_text_get(&text));
    bool may_be_here = line->is_in_numbers || m->mech->loop_count > 0; // proofs on geared loops are not to be had
    bool is_right = verdict.kind == YK_CHECK_TRUE || (may_be_here && verdict.kind == YK_CHECK_TRUE_HERE);
    if (!is_right) print_error("%s: %s: %s\n", name, yk_text_get(&text), yk_problems_text(m->problems, 0));
    assert_true(is_right);
    yk_text_free(&text);
    lines_read++;
}

static void check_pieces(Machine *m, const YkPoisson *a)
{
    static const YkRingFormat formats[] = {YK_RING_TEXT, YK_RING_BOOK, YK_RING_LATEX, YK_RING_C};
    for (size_t k = 0; a && k < 4; k++) {
        YkText text = {0};
        assert_true(yk_ring_write(m->d->ring, a, formats[k], YK_RING_TEXTBOOK, &text));
        const YkPoisson *back =
            yk_ring_read(m->d->ring, formats[k], yk_text_get(&text), text.length, (YkPlace){1, 1, 0}, m->problems);
        assert_true(yk_ring_is_same(a, back));
        yk_text_free(&text);
    }
}

static void visit(Machine *m, const char *name)
{
    if (m->model->gear_count + m->model->belt_count + m->model->rack_count == 0) return;
    text_of(m, true);
    for (const YkLine *line = m->page.first; line; line = line->next) {
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
            check_pieces(m, piece->over);
            check_pieces(m, piece->under);
            for (int side = 0; side < 2; side++)
                for (size_t k = 0; k < piece->factor_count[side]; k++) check_pieces(m, piece->factors[side][k]);
        }
    }
    for (int k = 0; k < 3; k++) {
        if (!random_pose(m, k == 0)) continue;
        for (const YkLine *line = m->page.first; line; line = line->next)
            if (line->left) check_line_at_pose(m, line, name);
    }
    bool is_possible;
    YkFieldPoint *point = loop_point(m->d, 2025, &is_possible);
    for (const YkLine *line = m->page.first; line && point; line = line->next)
        if (line->left && !line->is_in_numbers && m->mech->loop_count == 0) check_line_in_field(m, line, point, name);
    yk_field_point_free(point);
    for (const YkLine *line = m->page.first; line; line = line->next)
        if (line->left) check_line_read(m, line, name);
    check_formats(m, name, page_values(m));
}

static void every_line_of_every_example_is_true_and_reads_back(void **state)
{
    (void)state;
    lines_seen = lines_proved = lines_read = 0;
    each_example(visit);
    assert_true(lines_seen > 150);
    assert_true(lines_proved > 50);
    assert_true(lines_read > 50);
}

// --- Racks, belts, linkages

static void visit_text(const char *text)
{
    Machine m = machine_of(text);
    visit(&m, "text");
    machine_end(&m);
}

static void racks_belts_and_rolling_wheels_are_told_too(void **state)
{
    (void)state;
    visit_text(
        "bodies: {carriage: {}, wheel: {}}\n"
        "joints: {R: {slide: [ground, carriage], along: x, distance: d}, A: {pin: [carriage, wheel], angle: phi}}\n"
        "racks: {k: {pinion: wheel, rack: ground, radius: 0.3}}\n"
        "drives: {d: 2 m/s * t}\n");
    visit_text("parameters: {r: 3/10}\n"
               "bodies: {ground: {points: {A: [0, 0], B: [1, 0]}}, p1: {}, p2: {}, bar: {}}\n"
               "joints: {A: {pin: [ground, p1], angle: theta1}, B: {pin: [ground, p2], angle: theta2},\n"
               "  S: {slide: [ground, bar], along: x, from: B, distance: d}}\n"
               "belts: {b: {between: [p1, p2], radii: [r, 0.2], crossed: true}}\n"
               "racks: {k: {pinion: p2, rack: bar, radius: 0.1}}\n"
               "drives: {theta1: 30 rpm * t}\n");
}

static void a_geared_linkage_has_its_meshes_and_leaves_the_loops(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {a: 1, b: 2, c: 2.5, e: 1.2, g: 2.2, N1: 20, N2: 30}\n"
                           "bodies:\n"
                           "  ground: {points: {O: [0, 0], Q: [g, 0]}}\n"
                           "  left: {points: {O: [0, 0], A: [a, 0]}}\n"
                           "  right: {points: {Q: [0, 0], B: [e, 0]}}\n"
                           "  l2: {points: {A: [0, 0], C: [b, 0]}}\n"
                           "  l3: {points: {B: [0, 0], C: [c, 0]}}\n"
                           "joints:\n"
                           "  O: {pin: [ground, left], angle: theta1}\n"
                           "  A: {pin: [left, l2], angle: theta2}\n"
                           "  Q: {pin: [ground, right], angle: theta3}\n"
                           "  B: {pin: [right, l3], angle: theta4}\n"
                           "  C: {pin: [l2, l3]}\n"
                           "gears: {m: {mesh: [left, right], teeth: [N1, N2]}}\n"
                           "drives: {theta1: 10 rpm * t}\n"
                           "start: {theta1: 60 deg, theta2: -30 deg, theta3: 60 deg, theta4: 90 deg}\n");
    expect(text_of(&m, false), "omega3 = - omega1 N1/N2\n");
    visit(&m, "five-bar");
    machine_end(&m);
}

// Wheels that the file puts onto one point have teeth, but no pitch point.
static void a_train_without_geometry_has_no_pitch_points(void **state)
{
    (void)state;
    Machine m = machine_of(
        "bodies: {sun: {}, planet: {}, arm: {}}\n"
        "joints: {S: {pin: [ground, sun], angle: theta1}, A: {pin: [ground, arm]}, P: {pin: [arm, planet]}}\n"
        "gears:\n"
        "  a: {mesh: [sun, planet], teeth: [20, 30], carrier: arm}\n"
        "  b: {mesh: [planet, ground], teeth: [30, 80], carrier: arm, internal: true}\n"
        "drives: {theta1: 100 rpm * t}\n");
    const char *text = text_of(&m, false);
    assert_null(strstr(text, "v_P1"));
    expect(text, "no pitch point");
    expect(text, "omega_arm = omega1 z_sun / (z_sun + z_ground)\n");
    visit(&m, "on one point");
    machine_end(&m);
}

// Forty wheels have no readable formula, but a number.
static void a_long_train_keeps_its_numbers(void **state)
{
    (void)state;
    YkText text = {0};
    yk_text_puts(&text, "bodies: {");
    for (int k = 0; k < 40; k++) yk_text_format(&text, "g%d: {}%s", k, k < 39 ? ", " : "}\njoints:\n");
    for (int k = 0; k < 40; k++) yk_text_format(&text, "  J%d: {pin: [ground, g%d], angle: theta%d}\n", k, k, k);
    yk_text_puts(&text, "gears:\n");
    for (int k = 1; k < 40; k++)
        yk_text_format(&text, "  m%d: {mesh: [g%d, g%d], teeth: [20, 30], carrier: ground}\n", k, k - 1, k);
    Machine m = machine_of(yk_text_get(&text));
    yk_text_free(&text);
    assert_true(random_pose(&m, true));
    const char *page = text_of(&m, true);
    expect(page, "g39: no formula of a readable size");
    expect(page, "omega39 = - 549755813888/4052555153018976267 omega0"); // (2/3)^39
    machine_end(&m);
}

static void a_parameter_keeps_its_name_before_a_speed(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {omega1: 3 rad/s}\n"
                           "bodies: {a: {}, b: {}}\n"
                           "joints: {A: {pin: [ground, a], angle: theta1}, B: {pin: [ground, b], angle: theta2}}\n"
                           "gears: {m: {mesh: [a, b], teeth: [10, 20]}}\n"
                           "drives: {theta1: omega1 * t}\n");
    expect(text_of(&m, false), "omega2 = - omega_a z_a/z_b\n");
    assert_int_equal(verdict_on(&m, "omega_a = theta1'").kind, YK_CHECK_TRUE);
    visit(&m, "named");
    machine_end(&m);
}

static void a_machine_without_gears_says_so(void **state)
{
    (void)state;
    Machine m = example("four-bar");
    expect(text_of(&m, false), "no gears, racks or belts");
    machine_end(&m);
}

// --- --check

static void speeds_are_checked_by_name(void **state)
{
    (void)state;
    Machine m = example("epicyclic");
    assert_int_equal(verdict_on(&m, "omega4 = omegaC*(1 + N1*N3/(N2*N4)) - omega1*N1*N3/(N2*N4)").kind, YK_CHECK_TRUE);
    YkCheckVerdict wrong = verdict_on(&m, "omega4 = omegaC*(1 + N1*N3/(N2*N4)) + omega1*N1*N3/(N2*N4)");
    assert_int_equal(wrong.kind, YK_CHECK_FALSE);
    assert_non_null(wrong.slip);
    assert_true(fabs(wrong.shown.left - wrong.shown.right) > 1e-3); // the pose shows it
    YkCheckVerdict here = verdict_on(&m, "ring.rate = 35/29*arm.rate - 6/29*sun.rate");
    assert_int_equal(here.kind, YK_CHECK_TRUE_HERE);
    assert_false(here.is_refuted || here.is_false_there); // numbers of teeth must fit: nothing is said of others
    machine_end(&m);
}

// --- Random trains

// Wheels and arms on one axis; each new wheel is pinned to the ground or an arm and meshes with an earlier one there.
static void write_random(YkText *text, uint64_t *seed)
{
    int carriers = 1 + (int)(check_random(seed) % 2), count = 2 + (int)(check_random(seed) % 6);
    int on[16];
    yk_text_puts(text, "bodies: {");
    for (int k = 1; k < carriers; k++) yk_text_format(text, "arm%d: {}, ", k);
    for (int k = 0; k < count; k++) yk_text_format(text, "w%d: {}%s", k, k + 1 < count ? ", " : "}\njoints:\n");
    for (int k = 1; k < carriers; k++) yk_text_format(text, "  A%d: {pin: [ground, arm%d], angle: alpha%d}\n", k, k, k);
    for (int k = 0; k < count; k++) {
        on[k] = k == 0 ? 0 : (int)(check_random(seed) % (uint64_t)carriers);
        if (on[k] == 0)
            yk_text_format(text, "  W%d: {pin: [ground, w%d], angle: theta%d}\n", k, k, k);
        else
            yk_text_format(text, "  W%d: {pin: [arm%d, w%d], angle: theta%d}\n", k, on[k], k, k);
    }
    yk_text_puts(text, "gears:\n");
    for (int k = 1; k < count; k++) {
        int other = (int)(check_random(seed) % (uint64_t)k), carrier = on[k] ? on[k] : on[other];
        if (on[k] && on[other] && on[k] != on[other]) other = 0;
        bool is_internal = check_random(seed) % 3 == 0;
        unsigned small = 12 + (unsigned)(check_random(seed) % 30),
                 large = small + 10 + (unsigned)(check_random(seed) % 40);
        yk_text_format(text, "  m%d: {mesh: [w%d, w%d], teeth: [%u, %u], internal: %s", k, k, other, small, large,
                       is_internal ? "true" : "false");
        if (carrier)
            yk_text_format(text, ", carrier: arm%d}\n", carrier);
        else
            yk_text_puts(text, ", carrier: ground}\n");
    }
}

static void random_trains_agree_with_the_engine(void **state)
{
    (void)state;
    uint64_t seed = 20261121;
    size_t before = lines_seen;
    for (int k = 0; k < 60; k++) {
        YkText text = {0};
        write_random(&text, &seed);
        Machine m = machine_of(yk_text_get(&text));
        visit(&m, yk_text_get(&text));
        machine_end(&m);
        yk_text_free(&text);
    }
    assert_true(lines_seen > before + 1500);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_train_of_the_book_prints_as_in_the_book),
        cmocka_unit_test(without_numbers_there_are_symbols_only),
        cmocka_unit_test(ratios_of_a_shift_table_are_those_of_its_exact_fractions),
        cmocka_unit_test(every_line_of_every_example_is_true_and_reads_back),
        cmocka_unit_test(racks_belts_and_rolling_wheels_are_told_too),
        cmocka_unit_test(a_geared_linkage_has_its_meshes_and_leaves_the_loops),
        cmocka_unit_test(a_train_without_geometry_has_no_pitch_points),
        cmocka_unit_test(a_long_train_keeps_its_numbers),
        cmocka_unit_test(a_parameter_keeps_its_name_before_a_speed),
        cmocka_unit_test(a_machine_without_gears_says_so),
        cmocka_unit_test(speeds_are_checked_by_name),
        cmocka_unit_test(random_trains_agree_with_the_engine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
