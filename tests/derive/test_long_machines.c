// Machines of many bodies: sections that go from body to body are complete, those about all bodies at once say where
// they end, and a page in parts is the same page.
#include "derive/inside.h"
#include "forces_check.h"
#include "ring/inside.h"

// n rods, each pinned to the one before.
static Machine chain(int n)
{
    YkText text = {0};
    yk_text_puts(&text, "parameters: {l: 0.3, m: 0.2, g: 9.81}\ngravity: [0, -g]\n"
                        "bodies:\n  ground: {points: {P1: [0, 0]}}\n");
    for (int k = 1; k <= n; k++)
        yk_text_format(&text, "  b%d: {points: {P%d: [0, 0], P%d: [l, 0]}, mass: m, rod: [P%d, P%d]}\n", k, k, k + 1, k,
                       k + 1);
    yk_text_puts(&text, "joints:\n  P1: {pin: [ground, b1], angle: q1}\n");
    for (int k = 2; k <= n; k++) yk_text_format(&text, "  P%d: {pin: [b%d, b%d], angle: q%d}\n", k, k - 1, k, k);
    yk_text_puts(&text, "start: {q1: 10 deg");
    for (int k = 2; k <= n; k++)
        yk_text_format(&text, ", q%d: %d deg, q%d.rate: %d deg/s", k, 17 * k % 23 - 11, k, k % 5);
    yk_text_puts(&text, "}\n");
    Machine m = machine_of(yk_text_get(&text));
    yk_text_free(&text);
    return m;
}

// n parallelograms side by side.
static Machine ladder(int n)
{
    YkText text = {0};
    yk_text_puts(&text, "gravity: [0, -9.81]\nbodies:\n  ground: {points: {A0: [0, 0]");
    for (int k = 1; k <= n; k++) yk_text_format(&text, ", A%d: [%d, 0]", k, k);
    yk_text_puts(&text, "}}\n");
    for (int k = 0; k <= n; k++)
        yk_text_format(&text, "  link%d: {points: {A%d: [0, 0], B%d: [1, 0]}, mass: 1, rod: [A%d, B%d]}\n", k, k, k, k,
                       k);
    for (int k = 1; k <= n; k++)
        yk_text_format(&text, "  rod%d: {points: {B%d: [0, 0], B%d: [1, 0]}, mass: 1, rod: [B%d, B%d]}\n", k, k - 1, k,
                       k - 1, k);
    yk_text_puts(&text, "joints:\n");
    for (int k = 0; k <= n; k++) yk_text_format(&text, "  A%d: {pin: [ground, link%d], angle: theta%d}\n", k, k, k);
    for (int k = 1; k <= n; k++)
        yk_text_format(&text,
                       "  D%d: {pin: [link%d, rod%d], at: B%d, angle: psi%d}\n  C%d: {pin: [rod%d, link%d], at: B%d}\n",
                       k, k - 1, k, k - 1, k, k, k, k, k);
    yk_text_puts(&text, "start: {theta0: 70 deg");
    for (int k = 1; k <= n; k++) yk_text_format(&text, ", theta%d: 70 deg, psi%d: -70 deg", k, k);
    yk_text_puts(&text, ", theta0.rate: -1 rad/s}\n");
    Machine m = machine_of(yk_text_get(&text));
    yk_text_free(&text);
    return m;
}

// Every equation of the section is true with the engine's accelerations and reactions; returns how many there are.
static size_t check_section_holds(Machine *m, const char *section, const char *name)
{
    write_section(m, section);
    YkDynamics *dynamics = dynamics_of(m);
    assert_true(random_pose(m, true));
    assert_true(take_forces(m, dynamics, YK_METHOD_REDUCED));
    size_t count = check_page(m, name, 1e-9);
    yk_dynamics_free(dynamics);
    return count;
}

static void accelerations_far_from_the_ground_go_from_body_to_body(void **state)
{
    (void)state;
    enum { N = YK_DERIVE_DEPTH_MAX + 20 };
    Machine m = chain(N);
    const YkDeriveForces *f = forces_of(&m);
    assert_non_null(f->bodies[YK_DERIVE_DEPTH_MAX].position);
    assert_null(f->bodies[YK_DERIVE_DEPTH_MAX + 1].position);
    // five equations a body, and two for each acceleration that is a symbol
    assert_true(check_section_holds(&m, "newton-euler", "a chain") >= 4 * N + 2 * 20);
    check_says(&m, "acceleration:  a_C120x = ");
    for (int b = 1; b <= N; b++) assert_true(yk_ring_terms(yk_derive_newton(f, b)) < 12 * YK_DERIVE_DEPTH_MAX);
    machine_end(&m);
}

static void a_chain_takes_linear_room(void **state)
{
    (void)state;
    size_t terms[2];
    for (int k = 0; k < 2; k++) {
        Machine m = chain(k == 0 ? 400 : 800);
        const YkDeriveForces *f = forces_of(&m);
        terms[k] = 0;
        for (size_t b = YK_DERIVE_DEPTH_MAX + 1; b < m.model->body_count; b++)
            terms[k] += yk_ring_terms(yk_derive_newton(f, (int32_t)b)) + yk_ring_terms(yk_derive_euler(f, (int32_t)b)) +
                        yk_ring_terms(f->bodies[b].step);
        terms[k] /= m.model->body_count - YK_DERIVE_DEPTH_MAX - 1;
        machine_end(&m);
    }
    assert_true(terms[0] > 0 && terms[0] == terms[1]);
}

static void a_ladder_is_written_body_by_body(void **state)
{
    (void)state;
    Machine m = ladder(30);
    assert_true(check_section_holds(&m, "newton-euler", "a ladder") > 61 * 4);
    m.page = (YkPage){.arena = m.page.arena, .ring = m.d->ring};
    assert_true(check_section_holds(&m, "velocity", "velocities of a ladder") > 60);
    machine_end(&m);
}

// Returns how many terms of elements printing the free bodies makes; each formula reads back as what it shows.
static size_t print_free_bodies(int n)
{
    YkText text = {0};
    Machine m = ladder(n);
    write_section(&m, "free-bodies");
    size_t before = m.d->ring->made;
    assert_true(yk_page_write(&m.page, YK_PAGE_TEXT, "ladder", NULL, &text));
    size_t made = m.d->ring->made - before;
    assert_true(check_page_reads_back(&m) > 10 * (size_t)n);
    yk_text_free(&text);
    machine_end(&m);
    return made;
}

static void alike_bodies_are_printed_from_one_pattern(void **state)
{
    (void)state;
    size_t made = print_free_bodies(15);
    assert_true(made > 0);
    assert_int_equal(print_free_bodies(30), made);
}

static void what_speaks_of_all_bodies_says_where_it_ends(void **state)
{
    (void)state;
    static const char *const sections[] = {"points", "energy", "lagrange"};
    for (size_t k = 0; k < 3; k++) {
        Machine m = chain(YK_DERIVE_DEPTH_MAX + 1);
        write_section(&m, sections[k]);
        check_says(&m, "Up to 101 joints stand between a body and the ground");
        machine_end(&m);
    }
    Machine m = ladder(YK_DERIVE_TOGETHER_MAX / 2 + 10);
    write_section(&m, "lagrange");
    check_says(&m, "Lagrange's equations of 1021 coordinates are not written");
    write_section(&m, "energy");
    check_says(&m, "T and V are the sums of these");
    machine_end(&m);
}

static void angles_of_a_very_long_chain_have_no_joint_form(void **state)
{
    (void)state;
    Machine m = chain(2600);
    assert_null(yk_derive_body_angle(m.d, 2600));
    assert_int_equal(yk_ring_status(m.d->ring), YK_RING_SIZE);
    assert_false(yk_derivation_ran_out(m.d)); // too large is not out of memory
    machine_end(&m);
    m = chain(2600); // from body to body it is written all the same
    write_section(&m, "free-bodies");
    check_says(&m, "b2600.angle = q2600 + b2599.angle");
    machine_end(&m);
}

typedef struct Parts {
    YkPrinting printing;
    size_t count;
} Parts;

static void put_part(void *context, YkPage *page)
{
    Parts *parts = context;
    assert_true(yk_page_add_part(&parts->printing, page));
    yk_page_forget(page);
    parts->count++;
}

static void write_page(const char *name, YkPageFormat format, bool in_parts, YkText *text)
{
    Machine m = example(name);
    Parts parts = {.printing = {.ring = m.d->ring, .text = text, .title = "title", .format = format}};
    if (in_parts) m.page.passing = yk_arena_new(), m.page.part_ends = put_part, m.page.context = &parts;
    for (size_t k = 0; yk_derive_sections[k].name; k++) assert_true(yk_derive_write(m.d, k, &m.page));
    if (in_parts) {
        put_part(&parts, &m.page);
        assert_true(yk_page_end_parts(&parts.printing));
        assert_true(parts.count > 10);
    } else {
        assert_true(yk_page_write(&m.page, format, "title", NULL, text));
    }
    yk_arena_free(m.page.passing);
    machine_end(&m);
}

static void a_page_in_parts_is_the_page(void **state)
{
    (void)state;
    static const char *const names[] = {"toggle", "epicyclic", "cep-cam", "spring-slider-crank"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        for (int format = 0; format < YK_PAGE_FORMATS; format++) {
            YkText whole = {0}, text = {0};
            if (!yk_page_has_parts((YkPageFormat)format)) continue;
            write_page(names[k], (YkPageFormat)format, false, &whole);
            write_page(names[k], (YkPageFormat)format, true, &text);
            assert_string_equal(yk_text_get(&text), yk_text_get(&whole));
            yk_text_free(&text);
            yk_text_free(&whole);
        }
    assert_false(yk_page_has_parts(YK_PAGE_C));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(accelerations_far_from_the_ground_go_from_body_to_body),
        cmocka_unit_test(a_chain_takes_linear_room),
        cmocka_unit_test(a_ladder_is_written_body_by_body),
        cmocka_unit_test(alike_bodies_are_printed_from_one_pattern),
        cmocka_unit_test(what_speaks_of_all_bodies_says_where_it_ends),
        cmocka_unit_test(angles_of_a_very_long_chain_have_no_joint_form),
        cmocka_unit_test(a_page_in_parts_is_the_page),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
