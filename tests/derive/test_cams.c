// Motion programs and cams in symbols: the textbook's lines, every line true where it holds, shapes against the numbers
// of `cam`, and reading back.
#include <yoke/cam.h>
#include "derive/relations.h"
#include "derive_check.h"

static void write_cam(Machine *m)
{
    m->page.first = m->page.last = NULL;
    if (!yk_derive_write(m->d, section_of("cam"), &m->page)) {
        print_error("%s\n", yk_ring_status_text(yk_ring_status(m->d->ring)));
        fail();
    }
}

static const char *text_of(Machine *m)
{
    write_cam(m);
    return page_text(m, false);
}

// Turns the cam to an angle.
static bool turn_to(Machine *m, double angle)
{
    yk_state_set_time(m->state, 0, NULL);
    if (yk_state_assemble(m->state) < 0) return false;
    yk_state_set_input(m->state, 0, (YkMotion){angle, 1.5, 0.5});
    if (yk_state_solve(m->state) < 0) return false;
    take_values(m);
    return true;
}

static double value_of(const Machine *m, const YkPoisson *a)
{
    return yk_ring_value(m->d->ring, a, m->values).x;
}

static double quotient(const Machine *m, const YkLine *line)
{
    return value_of(m, line->value) / (line->value_under ? value_of(m, line->value_under) : 1);
}

static bool holds(const Machine *m, const YkLine *line)
{
    double within = line->within ? value_of(m, line->within) : 0.5;
    return within >= 0 && within <= 1;
}

// --- The cam of the format

static void the_cep_cam_prints_as_in_the_book(void **state)
{
    (void)state;
    Machine m = example("cep-cam");
    const char *text = text_of(&m);
    expect(text, "s = h [64 u^3 - 192 u^4 + 192 u^5 - 64 u^6]\n");
    expect(text, "lift_v = h/beta [192 u^2 - 768 u^3 + 960 u^4 - 384 u^5]\n");
    expect(text, "lift_a = h/beta^2 [384 u - 2304 u^2 + 3840 u^3 - 1920 u^4]\n");
    expect(text, "lift_j = h/beta^3 [384 - 4608 u + 11520 u^2 - 7680 u^3]\n");
    expect(text, "u = theta / beta = theta / (4/3 pi)\n");
    expect(text, "[ 1  2/3 pi  4/9 pi^2   8/27 pi^3   16/81 pi^4    32/243 pi^5    64/729 pi^6  ]");
    expect(text, "C3 = 27 h/pi^3\n");
    expect(text, "C6 = -729/64 h/pi^6\n");
    expect(text, "the fundamental law of cam design holds");
    expect(text, "tan(alpha) = lift_v / (R_b + R_r + lift)\n");
    machine_end(&m);
}

static const YkShownMatrix *matrix_of(const Machine *m, int which)
{
    for (const YkLine *line = m->page.first; line; line = line->next)
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next)
            if (piece->kind == YK_PIECE_MATRIX && which-- == 0) return piece->matrix;
    return NULL;
}

// The printed system, its printed solution: A C = b, exactly, in the ring.
static void its_system_is_solved_exactly(void **state)
{
    (void)state;
    Machine m = example("cep-cam");
    write_cam(&m);
    const YkShownMatrix *A = matrix_of(&m, 0), *x = matrix_of(&m, 1), *b = matrix_of(&m, 2);
    assert_int_equal(A->rows, 7);
    for (size_t i = 0; i < 7; i++) {
        const YkPoisson *sum = yk_ring_rational(m.d->ring, 0, 1);
        for (size_t k = 0; k < 7; k++) {
            const YkPoisson *entry = A->entries[7 * i + k];
            if (!entry) continue;
            const YkPoisson *c = yk_derive_in_joints(m.d, x->entries[k]);
            sum = yk_ring_add(m.d->ring, sum, yk_ring_multiply(m.d->ring, entry, yk_derive_in_joints(m.d, c)));
        }
        assert_true(yk_ring_is_same(yk_derive_in_joints(m.d, sum), b->entries[i]));
    }
    machine_end(&m);
}

static void symbols_of_the_file_stay_symbols(void **state)
{
    (void)state;
    Machine m = machine_of("parameters: {h: 20 mm, beta: 100 deg}\n"
                           "laws: {lift: {period: 2*pi, segments: [\n"
                           "  {polynomial: [{at: 0, s: 0, v: 0}, {at: beta/4, s: h/4}, {at: beta, s: h, v: 0}]},\n"
                           "  {fall: {to: 2*beta, by: h, law: cycloidal}}, {dwell: {to: 2*pi}}]}}\n"
                           "cams: {c: {cam: shaft, follower: tappet, law: lift, face: flat, base: 200 mm}}\n"
                           "bodies: {shaft: {}, tappet: {}}\n"
                           "joints: {K: {pin: [ground, shaft], angle: theta},\n"
                           "  T: {slide: [ground, tappet], along: y, distance: s}}\n");
    const char *text = text_of(&m);
    expect(text, "s = h [17/3 u1^2 - 22/3 u1^3 + 8/3 u1^4]\n"); // by hand
    expect(text, "lift_v = h/beta [34/3 u1 - 22 u1^2 + 32/3 u1^3]\n");
    expect(text, "u2 = (2 beta - theta) / beta\n");
    expect(text, "s = h [u2 - 1/2 sin(phi2)/pi]\n");
    expect(text, "lift_v = - h/beta [1 - cos(phi2)]\n");
    machine_end(&m);
}

static void jumps_are_named(void **state)
{
    (void)state;
    Machine m = machine_of("laws: {lift: {period: 2*pi, segments: [\n"
                           "  {rise: {to: pi, by: 0.2, law: harmonic}}, {dwell: {to: 1.25*pi}},\n"
                           "  {fall: {to: 2*pi, by: 0.2, law: 3-4-5}}]}}\n"
                           "cams: {c: {cam: shaft, follower: tappet, law: lift, roller: 0.1, base: 0.5}}\n"
                           "bodies: {shaft: {}, tappet: {}}\n"
                           "joints: {K: {pin: [ground, shaft], angle: theta},\n"
                           "  T: {slide: [ground, tappet], along: y, distance: s}}\n");
    const char *text = text_of(&m);
    expect(text, "does not hold");
    expect(text, "a jumps by 0.1 at theta = 0 (SI)\n");
    machine_end(&m);
}

// --- Every line of every program

// A program of all laws, falls, halves, parts.
static const char *const programs[] = {
    "parameters: {h: 30 mm, beta: 60 deg, L: 12 mm}\n"
    "laws:\n"
    "  lift:\n"
    "    period: 2*pi\n"
    "    segments:\n"
    "      - {rise: {to: beta, by: h, law: cycloidal}}\n"
    "      - {dwell: {to: 70 deg}}\n"
    "      - {fall: {to: 100 deg, by: L, law: harmonic}}\n"
    "      - {rise: {to: 130 deg, by: L, law: double-harmonic}}\n"
    "      - {fall: {to: 160 deg, by: h/2, law: modified-trapezoid, half: first}}\n"
    "      - {fall: {to: 190 deg, by: h/2, law: modified-trapezoid, half: second}}\n"
    "      - {rise: {to: 210 deg, by: 10 mm, law: constant-velocity, blend: 0.25}}\n"
    "      - {rise: {to: 230 deg, by: 5 mm, law: parabolic}}\n"
    "      - {rise: {to: 250 deg, by: 5 mm, law: 4-5-6-7}}\n"
    "      - {fall: {to: 280 deg, by: 20 mm, law: scca, scca: {b: 0.3, c: 0.2, d: 0.5}}}\n"
    "      - {constant-velocity: {to: 300 deg, v: 30 mm/rad}}\n"
    "      - {fall: {to: 330 deg, by: 7 mm, law: double-harmonic, half: first}}\n"
    "      - {rise: {to: 340 deg, by: 7 mm, law: modified-sine, half: second}}\n"
    "      - {fall: {to: 2*pi, by: 10*pi/3 * 1 mm, law: double-harmonic, half: second}}\n",
    "laws:\n"
    "  lift:\n"
    "    period: 2*pi\n"
    "    segments:\n"
    "      - {dwell: {to: 20 deg}}\n"
    "      - {polynomial: [{at: 20 deg, s: 0, v: 0, a: 0}, {at: 50 deg, v: 30 mm/rad}, {at: 110 deg, s: 20 mm, v: 0, "
    "a: 0}]}\n"
    "      - {polynomial: [{at: 110 deg, s: 20 mm, v: 0, a: 0, j: 0}, {at: 160 deg, s: 11 mm}, {at: 250 deg, s: 0, v: "
    "0, "
    "a: 0, j: 0}]}\n"
    "      - {rise: {to: 2*pi, by: 0, law: 3-4-5}}\n",
    // degree 20
    "laws:\n"
    "  lift:\n"
    "    period: 2*pi\n"
    "    segments:\n"
    "      - polynomial: [{at: 0, s: 0, v: 0, a: 0, j: 0, p: 0}, {at: 30 deg, s: 3 mm}, {at: 60 deg, s: 11 mm, v: 2 "
    "mm/rad},\n"
    "          {at: 75 deg, s: 17 mm}, {at: 100 deg, s: 20 mm, v: 0}, {at: 120 deg, s: 19 mm},\n"
    "          {at: 140 deg, s: 18 mm, v: 1 mm/rad}, {at: 160 deg, s: 12 mm}, {at: 200 deg, s: 10 mm},\n"
    "          {at: 240 deg, s: 0, v: 0, a: 0, j: 0, p: 0}]\n"
    "      - {dwell: {to: 2*pi}}\n",
};
static const char rest[] = "cams: {c: {cam: shaft, follower: tappet, law: lift, face: flat, base: 900 mm}}\n"
                           "bodies: {shaft: {}, tappet: {}}\n"
                           "joints:\n"
                           "  K: {pin: [ground, shaft], angle: theta}\n"
                           "  T: {slide: [ground, tappet], along: y, distance: s}\n";

static size_t lines_seen, lines_read;

// What the terms of an element come to: the measure for rounding.
static double size_of(const Machine *m, const YkPoisson *a)
{
    double size = 0;
    for (int32_t s = yk_ring_next_symbol(m->d->ring, a, -1); s >= 0; s = yk_ring_next_symbol(m->d->ring, a, s)) {
        YkVec slope = yk_ring_value(m->d->ring, yk_ring_partial(m->d->ring, a, s), m->values);
        size += hypot(slope.x, slope.y) * fabs(m->values[s]);
        int32_t low, high;
        if (!yk_ring_powers(m->d->ring, a, s, &low, &high)) continue;
        for (int32_t k = low; k <= high && high > low; k++) // a polynomial's terms cancel
            size += fabs(value_of(m, yk_ring_coefficient(m->d->ring, a, s, k)) * pow(m->values[s], k));
    }
    return size;
}

static void check_lines(Machine *m, const char *name)
{
    for (const YkLine *line = m->page.first; line; line = line->next) {
        if (!line->left || !holds(m, line)) continue;
        const YkPoisson *zero = line_vanishes(m->d->ring, line);
        double value = value_of(m, zero), size = size_of(m, zero);
        if (!(fabs(value) <= 1e-12 * size + 1e-14)) {
            YkText text = {0};
            YkPrinting printing = {.ring = m->d->ring, .text = &text};
            yk_print_formula_text(&printing, line, &text);
            print_error("%s: %s: %g of %g\n", name, yk_text_get(&text), value, size);
            yk_text_free(&text);
        }
        CHECK_NEAR(value, 0, 1e-12 * size + 1e-14);
        lines_seen++;
    }
}

// As printed the line is an equation again, with the same value.
static void check_read(Machine *m, const YkLine *line)
{
    YkText text = {0};
    YkPrinting printing = {.ring = m->d->ring, .text = &text};
    YkEquation equation;
    int equals = 0;
    if (!line->left) return;
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
        if (piece->kind == YK_PIECE_VECTOR || piece->kind == YK_PIECE_MATRIX || piece->kind == YK_PIECE_WORDS) return;
        equals += piece->kind == YK_PIECE_SIGN && *piece->text == '=';
    }
    if (equals != 1) return;
    yk_print_formula_text(&printing, line, &text);
    bool good = yk_equation_read(m->d, yk_text_get(&text), text.length, (YkPlace){1, 1, 0}, m->problems, &equation);
    if (!good) print_error("%s\n%s", yk_text_get(&text), yk_problems_text(m->problems, 0));
    assert_true(good);
    double right = yk_form_value(m->d->ring, equation.right, m->values).x;
    if (line->value) {
        double under = line->value_under ? value_of(m, line->value_under) : 1;
        CHECK_NEAR(right, value_of(m, line->value) / under, 1e-13 * (fabs(right) + size_of(m, line->value)));
    }
    lines_read++;
    yk_text_free(&text);
}

static void check_pieces(Machine *m, const YkPoisson *a)
{
    static const YkRingFormat formats[] = {YK_RING_TEXT, YK_RING_BOOK, YK_RING_LATEX, YK_RING_C};
    for (size_t k = 0; a && k < 4; k++) {
        YkText text = {0};
        assert_true(yk_ring_write(m->d->ring, a, formats[k], YK_RING_TEXTBOOK, &text));
        const YkPoisson *back =
            yk_ring_read(m->d->ring, formats[k], yk_text_get(&text), text.length, (YkPlace){1, 1, 0}, m->problems);
        if (!yk_ring_is_same(a, back)) print_error("%s\n%s", yk_text_get(&text), yk_problems_text(m->problems, 0));
        assert_true(yk_ring_is_same(a, back));
        yk_text_free(&text);
    }
}

static void visit(Machine *m, const char *name)
{
    if (m->model->law_count == 0) return;
    write_cam(m);
    for (const YkLine *line = m->page.first; line; line = line->next)
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
            check_pieces(m, piece->over);
            check_pieces(m, piece->under);
        }
    bool turns = yk_input_count(m->mech) > 0;
    for (int k = 0; k < 73 && turns; k++) {
        if (!turn_to(m, 0.02 + k * 0.0871)) continue;
        check_lines(m, name);
        for (const YkLine *line = m->page.first; line && k % 12 == 0; line = line->next) check_read(m, line);
    }
    if (!turns && random_pose(m, true)) check_lines(m, name);
    check_formats(m, name, page_values(m));
}

static void every_line_is_true_where_it_holds(void **state)
{
    (void)state;
    lines_seen = lines_read = 0;
    each_example(visit);
    for (size_t k = 0; k < sizeof programs / sizeof *programs; k++) {
        char text[4000];
        snprintf(text, sizeof text, "%s%s", programs[k], rest);
        Machine m = machine_of(text);
        visit(&m, text);
        machine_end(&m);
    }
    assert_true(lines_seen > 2000);
    assert_true(lines_read > 300);
}

// Wherever the cam stands, lines that hold there have the program's lift and its derivatives. (In the third program
// much cancels.)
static void every_place_has_its_lines(void **state)
{
    (void)state;
    for (size_t k = 0; k < 2; k++) {
        char text[4000];
        snprintf(text, sizeof text, "%s%s", programs[k], rest);
        Machine m = machine_of(text);
        write_cam(&m);
        for (int place = 0; place < 36; place++) {
            double angle = 0.02 + place * 0.1742, is[YK_LAW_ORDER + 1];
            assert_true(turn_to(&m, angle));
            yk_law_eval(m.model->laws[0].law, angle, is);
            bool is_dwell = is[1] == 0 && is[2] == 0; // whose lines are numbers
            for (int order = 0; order < 3 && !is_dwell; order++) {
                if (is[order] == 0) continue;
                bool is_there = false;
                for (const YkLine *line = m.page.first; line && !is_there; line = line->next)
                    is_there = line->within && line->value && holds(&m, line) &&
                               fabs(quotient(&m, line) - is[order]) <= 1e-9 * (1e-3 + fabs(is[order]));
                if (!is_there) print_error("program %zu: no line has derivative %d at %g\n", k, order, angle);
                assert_true(is_there);
            }
        }
        machine_end(&m);
    }
}

static void a_second_page_says_the_same(void **state)
{
    (void)state;
    char text[4000], first[40000];
    snprintf(text, sizeof text, "%s%s", programs[0], rest);
    Machine m = machine_of(text);
    snprintf(first, sizeof first, "%s", text_of(&m));
    assert_string_equal(text_of(&m), first);
    machine_end(&m);
}

static void a_machine_without_laws_says_so(void **state)
{
    (void)state;
    Machine m = example("four-bar");
    expect(text_of(&m), "no `laws:`");
    machine_end(&m);
}

// --- Shapes against the numbers of `cam`

static const YkLine *line_of(const Machine *m, const char *remark)
{
    for (const YkLine *line = m->page.first; line; line = line->next)
        if (line->kind == YK_LINE_FORMULA && line->text && strncmp(line->text, remark, strlen(remark)) == 0)
            return line;
    return NULL;
}

static void check_vector(const Machine *m, const YkLine *line, const double expected[2])
{
    YkVec value = yk_ring_value(m->d->ring, line->value, m->values);
    CHECK_NEAR(value.x, expected[0], 1e-13);
    CHECK_NEAR(value.y, expected[1], 1e-13);
}

static void check_shape(Machine *m, bool has_roller)
{
    YkCamDesign *design = yk_cam_design_new(m->model, 0);
    write_cam(m);
    for (int k = 0; k < 40; k++) {
        if (!turn_to(m, 0.03 + k * 0.157)) continue;
        YkCamPoint point = yk_cam_at(design, m->values[m->d->ties[0].variable]);
        check_vector(m, line_of(m, "cam surface"), point.surface);
        if (has_roller) check_vector(m, line_of(m, "pitch curve"), point.pitch);
        CHECK_NEAR(quotient(m, line_of(m, "pressure angle")), tan(point.pressure_angle), 1e-12);
        double rho = quotient(m, line_of(m, "radius of curvature"));
        CHECK_NEAR(1 / rho, 1 / point.pitch_radius, 1e-11 * fabs(1 / rho));
    }
    yk_cam_design_free(design);
}

static void shapes_are_those_of_the_cam_verb(void **state)
{
    (void)state;
    static const struct {
        const char *cam, *joints, *points;
        bool has_roller, goes_below; // the law, below 0
    } kinds[] = {
        {"roller: 0.1, base: 0.5", "T: {slide: [ground, f], along: y, distance: s}", "", true},
        {"roller: 0.1, base: 0.5, offset: 0.12", "T: {slide: [ground, f], along: 30 deg, distance: s}", "", true},
        {"roller: 0.1, base: 0.5, offset: -0.12", "T: {slide: [ground, f], along: 37 deg, distance: s}", "", true},
        {"face: knife, base: 0.6", "T: {slide: [ground, f], along: x, distance: s}", "", false},
        {"face: flat, base: 0.7", "T: {slide: [ground, f], along: 100 deg, distance: s}", "", false},
        {"roller: 0.1, base: 0.5, at: P", "Q: {pin: [ground, f], angle: phi}",
         "  ground: {points: {O: [0, 0], Q: [1.1, 0.3]}}\n  f: {points: {Q: [0, 0], P: [-0.9, 0]}}\n", true},
        {"roller: 0.1, base: 0.5, at: P", "Q: {pin: [ground, f], angle: phi}",
         "  ground: {points: {O: [0, 0], Q: [1.1, -0.3]}}\n  f: {points: {Q: [0, 0], P: [-0.9, 0.6]}}\n", true, true},
        {"face: flat, base: 0.4", "Q: {pin: [ground, f], angle: phi}",
         "  ground: {points: {O: [0, 0], Q: [1.5, 0.3]}}\n  f: {points: {Q: [0, 0]}}\n", false},
    };
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        char text[3000];
        bool is_angle = *kinds[k].points != '\0';
        snprintf(text, sizeof text,
                 "laws: {lift: {period: 2*pi, segments: [{%s: {to: 2, by: 0.2 %s, law: cycloidal}},\n"
                 "  {%s: {to: 5, by: 0.2 %s, law: 4-5-6-7}}, {dwell: {to: 2*pi}}]}}\n"
                 "cams: {c: {cam: shaft, follower: f, law: lift, %s}}\n"
                 "bodies:\n  shaft: {points: {O: [0, 0]}}\n%s"
                 "joints:\n  O: {pin: [ground, shaft], angle: theta}\n  %s\n",
                 kinds[k].goes_below ? "fall" : "rise", is_angle ? "rad" : "m", kinds[k].goes_below ? "rise" : "fall",
                 is_angle ? "rad" : "m", kinds[k].cam,
                 is_angle ? kinds[k].points : "  ground: {points: {O: [0, 0]}}\n  f: {}\n", kinds[k].joints);
        Machine m = machine_of(text);
        check_shape(&m, kinds[k].has_roller);
        machine_end(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cep_cam_prints_as_in_the_book), cmocka_unit_test(its_system_is_solved_exactly),
        cmocka_unit_test(symbols_of_the_file_stay_symbols),  cmocka_unit_test(jumps_are_named),
        cmocka_unit_test(every_line_is_true_where_it_holds), cmocka_unit_test(every_place_has_its_lines),
        cmocka_unit_test(a_second_page_says_the_same),       cmocka_unit_test(a_machine_without_laws_says_so),
        cmocka_unit_test(shapes_are_those_of_the_cam_verb),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
