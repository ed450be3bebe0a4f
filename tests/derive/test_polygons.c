// Polygons in symbols: every vector is that of the polygon in numbers, every sum holds on the machine's motion, every
// force is the engine's, and the steps read as a construction.
#include "forces_check.h"
#include "loads/loads.h"

static size_t vectors_seen, sums_seen, forces_seen;

static bool is_of_motion(const YkLine *line)
{
    return line->kind == YK_LINE_FORMULA && line->is_vector && !line->left;
}

// Returns the largest vector, at least the motion of a body over the machine's size: beside it a polygon leaves out
// what is rounding.
static double largest(const Machine *m, const YkPolygon *p, YkPolygonKind kind)
{
    double size = 1e-300;
    for (size_t b = 0; b < m->mech->model->body_count; b++) {
        YkBodyMotion motion = yk_body_motion(m->mech, &m->state->space, b);
        double rate = kind == YK_POLYGON_VELOCITY ? motion.w : fmax(fabs(motion.a), motion.w * motion.w);
        size = fmax(size, fabs(rate) * m->mech->size);
    }
    for (size_t k = 0; k < yk_polygon_vector_count(p); k++) {
        YkPolygonVector v = yk_polygon_vector(p, k);
        size = fmax(size, hypot(v.start[0], v.start[1]) + hypot(v.value[0], v.value[1]));
    }
    return size;
}

// Compares the lines of a polygon, from `line` on, with its vectors. Returns the line after them.
static const YkLine *check_vectors(Machine *m, const YkLine *line, YkPolygonKind kind)
{
    YkPolygon *p = yk_polygon_new(m->state, kind, NULL);
    assert_non_null(p);
    double size = largest(m, p, kind);
    for (size_t k = 0; k < yk_polygon_vector_count(p); k++) {
        YkPolygonVector v = yk_polygon_vector(p, k);
        while (line && !is_of_motion(line)) line = line->next;
        assert_non_null(line);
        YkVec value = yk_ring_value(m->d->ring, line->value, m->values);
        CHECK_NEAR(value.x, v.value[0], 1e-12 * size);
        CHECK_NEAR(value.y, v.value[1], 1e-12 * size);
        line = line->next;
        vectors_seen++;
    }
    yk_polygon_free(p);
    return line;
}

static bool is_clear_pose(const Machine *m)
{
    for (size_t b = 0; b < yk_block_count(m->mech); b++)
        if (yk_block_info(m->mech, b).kind <= YK_BLOCK_RPR && yk_state_transmission(m->state, b) < 0.1) return false;
    return true;
}

// The sums of motions; those of forces need forces.
static void check_sums(Machine *m, const char *name)
{
    for (const YkLine *line = m->page.first; line; line = line->next) {
        if (!line->left || !line->is_vector || line->text) continue;
        const YkPoisson *zero = line_vanishes(m->d->ring, line);
        check_vanishes(m, zero, name, 1e-11);
        sums_seen++;
    }
}

static bool has_value(Machine *m, const YkLine *line, const char *title, YkVec value, double size)
{
    while (line && !(line->kind == YK_LINE_HEADING && strcmp(line->text, title) == 0)) line = line->next;
    for (line = line ? line->next : NULL; line && line->kind != YK_LINE_HEADING; line = line->next) {
        if (!is_of_motion(line)) continue;
        YkVec is = yk_ring_value(m->d->ring, line->value, m->values);
        if (hypot(is.x - value.x, is.y - value.y) <= 1e-12 * size) return true;
    }
    return false;
}

// Every force at a joint, weight and inertia of the polygons in numbers is a line of its body.
static void check_forces(Machine *m, const char *name)
{
    YkDynamics *dynamics = yk_dynamics_new(m->mech, NULL);
    if (yk_dynamics_has_loads(dynamics) && take_forces(m, dynamics, YK_METHOD_REDUCED)) {
        YkForcePolygons *p = yk_force_polygons_new(dynamics, NULL);
        double size = 1e-300;
        for (size_t k = 0; k < yk_force_polygons_vector_count(p); k++)
            size = fmax(size, hypot(yk_force_polygons_vector(p, k).value[0], yk_force_polygons_vector(p, k).value[1]));
        for (size_t k = 0; k < yk_force_polygons_vector_count(p); k++) {
            YkForceVector v = yk_force_polygons_vector(p, k);
            char title[200];
            snprintf(title, sizeof title, "Force polygon of %s", m->model->bodies[v.body].name);
            bool is_own = v.part == YK_FORCE_WEIGHT || v.part == YK_FORCE_INERTIA || v.part == YK_FORCE_REACTION;
            if (!is_own || hypot(v.value[0], v.value[1]) == 0) continue;
            if (!has_value(m, m->page.first, title, yk_vec(v.value[0], v.value[1]), size)) {
                print_error("%s: no line for %s of %s\n", name, v.name, m->model->bodies[v.body].name);
                fail();
            }
            forces_seen++;
        }
        for (const YkLine *line = m->page.first; line; line = line->next)
            if (line->left && line->text && strcmp(line->text, "the polygon closes") == 0)
                check_vanishes(m, line->left, name, 1e-9);
        yk_force_polygons_free(p);
    }
    yk_dynamics_free(dynamics);
}

// Pins of several bodies and equal planets share forces in ways of their own.
static bool has_plain_forces(const Machine *m)
{
    for (size_t g = 0; g < m->model->gear_count; g++)
        if (m->model->gears[g].copies > 1) return false;
    return yk_derive_forces(m->d)->junction_count == 0;
}

static void visit(Machine *m, const char *name)
{
    write_section(m, "polygons");
    if (!m->page.first->next || m->d->most_depth > YK_DERIVE_DEPTH_MAX) return;
    for (size_t j = 0; j < m->model->joint_count; j++)
        if (m->model->joints[j].is_free) return;
    for (int k = 0; k < 2; k++) {
        if (!random_pose(m, k == 0) || !is_clear_pose(m)) continue;
        const YkLine *line = check_vectors(m, m->page.first, YK_POLYGON_VELOCITY);
        line = check_vectors(m, line, YK_POLYGON_ACCELERATION);
        while (line && line->kind != YK_LINE_HEADING) { // no vector is left over
            assert_false(is_of_motion(line));
            line = line->next;
        }
        check_sums(m, name);
        if (has_plain_forces(m)) check_forces(m, name);
    }
}

static void every_vector_is_that_of_the_polygon_in_numbers(void **state)
{
    (void)state;
    vectors_seen = sums_seen = forces_seen = 0;
    assert_true(each_example(visit) > 30);
    assert_true(vectors_seen > 1000);
    assert_true(sums_seen > 500);
    assert_true(forces_seen > 200);
}

// Whitworth's quick return: Coriolis' part with its factor 2, the pole, and the images that close the polygon.
static void the_steps_read_as_a_construction(void **state)
{
    (void)state;
    Machine m = example("quick-return");
    write_section(&m, "polygons");
    const char *text = page_text(&m, false);
    expect(text, "1. crank, whose motion is given.");
    expect(text, "v^{a} = v^{a'} + v^{a/a'}");
    expect(text, "perpendicular to the line on lever (Coriolis):  a_Coriolis^{a/a'} = [ -2 sin(theta2) theta2' d3' ]");
    expect(text, "along the line on lever:  a_sliding^{a/a'} = [ cos(theta2) d3'' ]");
    expect(text, "Force polygons\n  A body's known forces are drawn first");
    expect(text, "Two forces alone act on coupler, at B and at C");
    expect(text, "the polygon closes:  F_24 - F_45 = 0");
    check_formats(&m, "polygons", NULL);
    machine_end(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_vector_is_that_of_the_polygon_in_numbers),
        cmocka_unit_test(the_steps_read_as_a_construction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
