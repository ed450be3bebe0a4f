// Every formula of every section, on every example: true at random poses of the numeric engine, and the same when read
// back from print.
#include "derive_check.h"

static size_t formulas_seen, poses_seen;

static void write_all(Machine *m, const char *name)
{
    for (size_t k = 0; k <= section_of("points"); k++)
        if (!yk_derive_write(m->d, k, &m->page)) {
            print_error("%s: %s: %s\n", name, yk_derive_sections[k].name,
                        yk_ring_status_text(yk_ring_status(m->d->ring)));
            fail();
        }
}

static bool is_an_angle_row(const Machine *m, const YkLine *line)
{
    (void)m;
    return line->text && strcmp(line->text, "angle") == 0;
}

static void check_formulas(Machine *m, const char *name)
{
    for (const YkLine *line = m->page.first; line; line = line->next) {
        if (!line->left || is_an_angle_row(m, line)) continue;
        const YkPoisson *zero = line_vanishes(m->d->ring, line);
        YkVec value = yk_ring_value(m->d->ring, zero, m->values);
        double size = hypot(value.x, value.y), allowed = 1e-12 * off_machine(m, zero);
        if (!(size <= allowed)) {
            YkText text = {0};
            yk_ring_write(m->d->ring, zero, YK_RING_TEXT, YK_RING_TEXTBOOK, &text);
            print_error("%s, %s: %s = %g, allowed %g\n", name, line->section, yk_text_get(&text), size, allowed);
            yk_text_free(&text);
            fail();
        }
        formulas_seen++;
    }
}

static size_t slidings_seen;

// Returns the value of the vector to which a line of this group gives the name; the group ends with the next heading.
static YkVec named_vector(const Machine *m, const YkLine *line, const char *name)
{
    for (line = line->next; line && line->kind != YK_LINE_HEADING; line = line->next) {
        const YkPagePiece *last = line->last;
        if (!last || last->kind != YK_PIECE_MATRIX || !line->first->sub || strcmp(line->first->sub, name) != 0)
            continue;
        double part[2];
        for (size_t k = 0; k < 2; k++) {
            const YkRingView entry = yk_shown_entry(last->matrix, k);
            part[k] = yk_ring_value(m->d->ring, yk_ring_view(m->d->ring, &entry), m->values).x;
        }
        return yk_vec(part[0], part[1]);
    }
    fail_msg("no %s", name);
    return yk_vec(NAN, NAN);
}

// Returns how many accelerations of points the sums of this group have, or how often they have that of one point.
static int points_in(const YkLine *line, const char *point)
{
    int count = 0;
    for (line = line->next; line && line->kind != YK_LINE_HEADING; line = line->next)
        for (const YkPagePiece *piece = line->first ? line->first->next : NULL; piece; piece = piece->next)
            if (piece->kind == YK_PIECE_VECTOR && piece->super)
                count += point == NULL || strcmp(piece->super, point) == 0;
    return count;
}

// Where a body slides on one that turns, the parts add up to the engine's acceleration of its point; that of the
// guide's origin is among them where it has one.
static void check_slidings(Machine *m, const char *name)
{
    for (const YkLine *line = m->page.first; line; line = line->next)
        for (size_t j = 0; line->kind == YK_LINE_HEADING && j < m->model->joint_count; j++) {
            char ending[200];
            snprintf(ending, sizeof ending, "%s slides on %s (%s)", m->model->bodies[m->model->joints[j].body[1]].name,
                     m->model->bodies[m->model->joints[j].body[0]].name, m->model->joints[j].name);
            YkDerivePlace place = yk_derive_place(m->d, (int32_t)j, 1);
            if (strcmp(line->text, ending) != 0 || place.point == YK_NONE) continue;
            int32_t guide = m->model->joints[j].body[0];
            const YkPoisson *origin = yk_derive_origin(m->d, guide);
            origin = yk_ring_time_derivative(m->d->ring, yk_ring_time_derivative(m->d->ring, origin));
            YkVec sum = yk_ring_value(m->d->ring, origin, m->values);
            int moves = sum.x != 0 || sum.y != 0;
            assert_int_equal(points_in(line, yk_derive_point_name(m->d, guide, YK_NONE)), moves);
            assert_int_equal(points_in(line, NULL), 1 + moves); // and the place that it slides over
            double size = 1;
            static const char *const parts[] = {"tangential", "centripetal", "Coriolis", "relative"};
            for (size_t k = 0; k < 4; k++) {
                YkVec part = named_vector(m, line, parts[k]);
                sum = yk_add(sum, part), size += hypot(part.x, part.y);
            }
            YkPointMotion is = yk_state_point(m->state, (size_t)place.point);
            if (hypot(sum.x - is.acceleration[0], sum.y - is.acceleration[1]) > 1e-9 * size)
                print_error("%s: %s\n", name, ending);
            CHECK_NEAR(sum.x, is.acceleration[0], 1e-9 * size);
            CHECK_NEAR(sum.y, is.acceleration[1], 1e-9 * size);
            slidings_seen++;
        }
}

static void visit_poses(Machine *m, const char *name)
{
    write_all(m, name);
    for (int k = 0; k < 4; k++)
        if (random_pose(m, k == 0)) {
            // Near a dead point the engine's own rates carry large rounding: ask at poses with a margin.
            bool is_clear = true;
            for (size_t b = 0; b < yk_block_count(m->mech); b++)
                is_clear &= yk_block_info(m->mech, b).kind > YK_BLOCK_RPR || yk_state_transmission(m->state, b) > 0.1;
            if (!is_clear) continue;
            check_formulas(m, name);
            check_slidings(m, name);
            poses_seen++;
        }
}

static void every_formula_holds_at_random_poses_of_the_engine(void **state)
{
    (void)state;
    formulas_seen = poses_seen = slidings_seen = 0;
    assert_true(each_example(visit_poses) > 30);
    assert_true(formulas_seen > 1000);
    assert_true(poses_seen > 60 && slidings_seen >= 8);
}

static void check_back(Machine *m, const YkPoisson *a)
{
    static const YkRingFormat formats[] = {YK_RING_TEXT, YK_RING_BOOK, YK_RING_LATEX, YK_RING_C};
    if (!a) return;
    for (size_t k = 0; k < 4; k++) {
        YkText text = {0};
        if (formats[k] == YK_RING_C && !yk_ring_is_real(m->d->ring, a)) continue;
        assert_true(yk_ring_write(m->d->ring, a, formats[k], YK_RING_TEXTBOOK, &text));
        const YkPoisson *back =
            yk_ring_read(m->d->ring, formats[k], yk_text_get(&text), text.length, (YkPlace){1, 1, 0}, m->problems);
        if (!yk_ring_is_same(a, back)) {
            print_error("%s\n%s", yk_text_get(&text), yk_problems_text(m->problems, 0));
            fail();
        }
        yk_text_free(&text);
    }
}

static void visit_print(Machine *m, const char *name)
{
    write_all(m, name);
    for (const YkLine *line = m->page.first; line; line = line->next)
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
            const YkRingView shown = {piece->over, piece->changes, YK_RING_WHOLE};
            check_back(m, yk_ring_view(m->d->ring, &shown));
            check_back(m, piece->under);
            for (size_t k = 0; piece->matrix && k < piece->matrix->rows * piece->matrix->columns; k++) {
                const YkRingView entry = yk_shown_entry(piece->matrix, k);
                check_back(m, yk_ring_view(m->d->ring, &entry));
            }
        }
}

static void what_is_printed_reads_back_as_the_same(void **state)
{
    (void)state;
    assert_true(each_example(visit_print) > 30);
}

static void visit_formats(Machine *m, const char *name)
{
    write_all(m, name);
    bool posed = random_pose(m, true);
    for (size_t format = 0; format < YK_PAGE_FORMATS; format++)
        for (int numbers = 0; numbers <= posed; numbers++) {
            YkText text = {0};
            assert_true(yk_page_write(&m->page, (YkPageFormat)format, name, numbers ? page_values(m) : NULL, &text));
            assert_true(text.length > 100);
            for (const char *nan = strstr(yk_text_get(&text), "nan"); nan; nan = strstr(nan + 1, "nan"))
                assert_true(nan[-1] >= 'a' && nan[-1] <= 'z'); // as in "Determinants"
            yk_text_free(&text);
        }
}

static void every_format_prints_every_example(void **state)
{
    (void)state;
    assert_true(each_example(visit_formats) > 30);
}

static void sections_know_whose_they_are(void **state)
{
    (void)state;
    Machine plain = example("four-bar"), geared = example("epicyclic"), cam = example("cep-cam");
    const YkDeriveSectionEntry *gears = &yk_derive_sections[section_of("gears")];
    const YkDeriveSectionEntry *cams = &yk_derive_sections[section_of("cam")];
    assert_null(yk_derive_sections[section_of("loops")].is_of);
    assert_false(gears->is_of(plain.model) || cams->is_of(plain.model));
    assert_true(gears->is_of(geared.model) && !cams->is_of(geared.model));
    assert_true(!gears->is_of(cam.model) && cams->is_of(cam.model));
    machine_end(&plain);
    machine_end(&geared);
    machine_end(&cam);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_formula_holds_at_random_poses_of_the_engine),
        cmocka_unit_test(what_is_printed_reads_back_as_the_same),
        cmocka_unit_test(every_format_prints_every_example),
        cmocka_unit_test(sections_know_whose_they_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
