// Force polygons: they close, their moments too, and every vector is the engine's or a law's.
#include "assembled.h"
#include <glob.h>
#include <stdlib.h>
#include "base/codes.h"
#include "base/vec.h"
#include "model/model.h"

typedef struct Loaded {
    Assembled machine;
    YkDynamics *dynamics;
    YkForcePolygons *polygons;
} Loaded;

static bool open_loaded(Loaded *m, const char *path, const char *text)
{
    *m = (Loaded){0};
    if (!assembled_open(&m->machine, path, text, 0.02) || !yk_state_has_rates(m->machine.state)) return false;
    m->dynamics = yk_dynamics_new(m->machine.mech, NULL);
    if (!yk_dynamics_has_loads(m->dynamics)) return false;
    YkStatus status = yk_dynamics_solve(m->dynamics, m->machine.state, YK_METHOD_REDUCED);
    if (status != YK_OK && status != YK_REDUNDANT) return false;
    m->polygons = yk_force_polygons_new(m->dynamics, NULL);
    assert_non_null(m->polygons);
    return true;
}
static void close_loaded(Loaded *m)
{
    yk_force_polygons_free(m->polygons);
    yk_dynamics_free(m->dynamics);
    assembled_close(&m->machine);
}

// What the engine says of a vector's force, or what the law of gravity does.
static YkVec expected(const Loaded *m, const YkForceVector *v)
{
    YkReaction r = {0};
    const YkBody *body = &m->machine.model->bodies[v->body];
    if (v->part == YK_FORCE_WEIGHT) return yk_scale(body->mass, m->machine.model->gravity);
    if (v->part == YK_FORCE_INERTIA) {
        YkBalance balance = yk_dynamics_balance(m->dynamics, v->body);
        return yk_vec(-balance.inertia.force[0], -balance.inertia.force[1]);
    }
    for (size_t j = 0; v->part == YK_FORCE_REACTION && j < yk_model_joint_count(m->machine.model); j++)
        if (strcmp(yk_model_joint_name(m->machine.model, j), v->name) == 0) r = yk_dynamics_reaction(m->dynamics, j);
    for (size_t k = 0; v->part == YK_FORCE_CONTACT && k < yk_dynamics_contact_count(m->dynamics); k++)
        if (strcmp(yk_dynamics_contact_name(m->dynamics, k), v->name) == 0) r = yk_dynamics_contact(m->dynamics, k);
    if (r.by == r.on) return yk_vec(v->value[0], v->value[1]); // a law's: closing tells whether it is right
    double sign = r.on == v->body ? 1 : -1;
    return yk_scale(sign, yk_vec(r.force[0], r.force[1]));
}

// A body's vectors follow head to tail and end where they begin; their moments about its centre of mass vanish, and
// about any other point as well. Returns where the next body begins.
static size_t check_body(const Loaded *m, size_t first, double size)
{
    YkForceVector head = yk_force_polygons_vector(m->polygons, first);
    YkVec end = {0, 0};
    double moment = 0, turned = 0, reach = 1e-300;
    size_t k = first;
    for (; k < yk_force_polygons_vector_count(m->polygons); k++) {
        YkForceVector v = yk_force_polygons_vector(m->polygons, k);
        if (v.body != head.body) break;
        YkVec force = yk_vec(v.value[0], v.value[1]), at = yk_vec(v.at[0], v.at[1]);
        CHECK_NEAR(v.start[0], end.x, 1e-12 * size);
        CHECK_NEAR(v.start[1], end.y, 1e-12 * size);
        end = yk_add(end, force);
        moment += v.moment + yk_cross(yk_sub(at, yk_vec(head.at[0], head.at[1])), force);
        turned += v.moment + yk_cross(yk_sub(at, yk_vec(0.3, -0.2)), force);
        reach = fmax(reach, fabs(v.moment) + (yk_norm(at) + 0.5) * yk_norm(force));
        if (v.part == YK_FORCE_LOADS || v.part == YK_FORCE_PLANETS) continue;
        YkVec is = expected(m, &v);
        CHECK_NEAR(force.x, is.x, 1e-12 * size);
        CHECK_NEAR(force.y, is.y, 1e-12 * size);
    }
    CHECK_NEAR(end.x, 0, 1e-10 * size);
    CHECK_NEAR(end.y, 0, 1e-10 * size);
    if (m->machine.model->bodies[head.body].copies > 1) return k; // its moments are those of all planets
    CHECK_NEAR(moment, 0, 1e-9 * reach);
    CHECK_NEAR(turned, 0, 1e-9 * reach);
    return k;
}

// Newton's third law: what one body does to another, that one does to it, with the opposite sign.
static void check_counterpart(const Loaded *m, const YkForceVector *v, double size)
{
    size_t found = 0;
    if (v->by == YK_NOT_FOUND || v->by == 0 || m->machine.model->bodies[v->body].copies > 1) return;
    assert_true(v->by != v->body);
    for (size_t i = 0; i < yk_force_polygons_vector_count(m->polygons); i++) {
        YkForceVector u = yk_force_polygons_vector(m->polygons, i);
        if (u.body != v->by || u.by != v->body || u.part != v->part || strcmp(u.name, v->name) != 0) continue;
        CHECK_NEAR(u.value[0], -v->value[0], 1e-12 * size);
        CHECK_NEAR(u.value[1], -v->value[1], 1e-12 * size);
        found++;
    }
    if (found != 1 && m->machine.model->bodies[v->by].copies <= 1)
        print_error("%s on %s: %zu counterparts\n", v->name, yk_model_body_name(m->machine.model, v->body), found);
    assert_true(found == 1 || m->machine.model->bodies[v->by].copies > 1);
}

// Checks the polygons of all bodies and returns how many vectors there are.
static size_t check_all(const Loaded *m)
{
    double size = 1e-300;
    size_t count = yk_force_polygons_vector_count(m->polygons), bodies = 0;
    for (size_t i = 0; i < count; i++) {
        YkForceVector v = yk_force_polygons_vector(m->polygons, i);
        size = fmax(size, yk_hypot(v.value[0], v.value[1]));
    }
    for (size_t i = 0; i < count; bodies++) i = check_body(m, i, size);
    for (size_t i = 0; i < count; i++) {
        YkForceVector v = yk_force_polygons_vector(m->polygons, i);
        check_counterpart(m, &v, size);
    }
    assert_int_equal(bodies, yk_force_polygons_step_count(m->polygons));
    assert_non_null(yk_force_polygons_svg(m->polygons));
    return count;
}

// The couples of a belt are in the ratio of its radii, the carrier feels the rest; a law's drive acts on four bodies.
static void polygons_of_belts_and_laws_close(void **state)
{
    (void)state;
    Loaded m;
    static const char text[] =
        "laws:\n  lift: {period: 360 deg, segments: [{rise: {to: 180 deg, by: 0.1 m, law: cycloidal}}, {fall: {to: 360 "
        "deg, "
        "by: 0.1 m, law: cycloidal}}]}\n  swing: {period: 360 deg, segments: [{rise: {to: 180 deg, by: 20 deg, law: "
        "cycloidal}}, {fall: {to: 360 deg, by: 20 deg, law: cycloidal}}]}\n"
        "bodies:\n  ground: {points: {O: [0, 0]}}\n  arm: {points: {O: [0, 0], A: [0.2, 0], B: [0.5, 0.1]}, mass: 2, "
        "center: "
        "[0.1, 0], inertia: 0.1}\n  p: {points: {A: [0, 0]}, mass: 1, inertia: 0.02}\n  q: {points: {B: [0, 0]}, mass: "
        "1, "
        "inertia: 0.03}\n  b: {mass: 3, inertia: 0.1}\n  c: {points: {O: [0, 0]}, mass: 1, inertia: 0.3}\n"
        "joints:\n  O: {pin: [ground, arm], angle: th}\n  A: {pin: [arm, p], angle: ph}\n  B: {pin: [arm, q]}\n  S: "
        "{slide: "
        "[arm, b], along: 40 deg, distance: d}\n  C: {pin: [ground, c], at: O, angle: ps}\n"
        "belts: {belt: {between: [p, q], radii: [0.1, 0.04]}}\n"
        "drives: {th: 40 deg + 3 rad/s * t + 5 rad/s^2 * t^2, ph: 2 rad/s * t + 40 rad/s^2 * t^2, d: {law: lift, of: "
        "ph}, ps: "
        "{law: swing, of: ph}}\ngravity: [0, -9.81 m/s^2]\n";
    assert_true(open_loaded(&m, NULL, text));
    assert_true(check_all(&m) >= 15);
    close_loaded(&m);
}

static void every_polygon_of_the_gallery_closes(void **state)
{
    (void)state;
    glob_t found;
    size_t machines = 0, vectors = 0;
    assert_int_equal(glob(YOKE_ROOT "/examples/*.yaml", 0, NULL, &found), 0);
    for (size_t k = 0; k < found.gl_pathc; k++) {
        Loaded m;
        if (open_loaded(&m, found.gl_pathv[k], NULL)) {
            size_t count = check_all(&m);
            machines += count > 0;
            vectors += count;
        }
        close_loaded(&m);
    }
    globfree(&found);
    assert_true(machines >= 30);
    assert_true(vectors >= 300);
}

// A mass that a massless bar carries round at a given rate.
static void a_bob_on_a_turning_bar_by_hand(void **state)
{
    (void)state;
    Loaded m;
    static const char text[] = "bodies:\n  ground: {points: {O: [0, 0]}}\n  bar: {points: {O: [0, 0], A: [2 m, 0]}}\n"
                               "  bob: {mass: 3 kg, points: {A: [0, 0]}}\n"
                               "joints:\n  O: {pin: [ground, bar], angle: theta}\n  A: {pin: [bar, bob], angle: phi}\n"
                               "drives: {theta: -90 deg + 2 rad/s * (t - 0.02 s), phi: 0}\ngravity: [0, -9.81 m/s^2]\n";
    assert_true(open_loaded(&m, NULL, text));
    // The bob goes round at 2 rad/s on 2 m: it weighs 29.43 N, its inertia force points outwards with 3 * 4 * 2 = 24 N.
    size_t count = yk_force_polygons_vector_count(m.polygons);
    YkForceVector first = yk_force_polygons_vector(m.polygons, 0);
    assert_int_equal(count, 5);
    assert_string_equal(yk_model_body_name(m.machine.model, first.body), "bar");
    CHECK_NEAR(yk_hypot(first.value[0], first.value[1]), 53.43, 1e-12);
    assert_non_null(strstr(yk_force_polygons_step(m.polygons, 0), "bar: two forces of 53.43 N act, "));
    assert_non_null(
        strstr(yk_force_polygons_step(m.polygons, 1), "bob: weight, 29.43 N; inertia, 24 N. One force closes"));
    assert_null(yk_force_polygons_step(m.polygons, 2));
    YkForceVector inertia = yk_force_polygons_vector(m.polygons, 3);
    assert_int_equal(inertia.part, YK_FORCE_INERTIA);
    CHECK_NEAR(inertia.value[1], -24, 1e-12);
    close_loaded(&m);
}

// Lengths in the picture are the vectors' times the scale of their body.
static void the_picture_is_to_scale(void **state)
{
    (void)state;
    Loaded m;
    assert_true(open_loaded(&m, YOKE_ROOT "/examples/gas-engine.yaml", NULL));
    size_t index = 0;
    double scale = 0;
    for (const char *at = yk_force_polygons_svg(m.polygons); (at = strchr(at, '<')) != NULL; at++) {
        double x1, y1, x2, y2;
        const char *told = strncmp(at, "<g ", 3) == 0 ? strstr(at, "data-scale=\"") : NULL;
        if (told) scale = strtod(told + 12, NULL);
        if (sscanf(at, "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf\"", &x1, &y1, &x2, &y2) != 4) continue;
        if (strncmp(strstr(at, "class="), "class=\"scale\"", 13) == 0) continue;
        YkForceVector v = yk_force_polygons_vector(m.polygons, index++);
        while (scale * yk_hypot(v.value[0], v.value[1]) <= 0.05) v = yk_force_polygons_vector(m.polygons, index++);
        CHECK_NEAR(x2 - x1, v.value[0] * scale, 0.011);
        CHECK_NEAR(y1 - y2, v.value[1] * scale, 0.011);
    }
    assert_int_equal(index, yk_force_polygons_vector_count(m.polygons));
    close_loaded(&m);
}

static void what_is_not_there_is_said(void **state)
{
    (void)state;
    assert_null(yk_force_polygons_new(NULL, NULL));
    assert_null(yk_force_polygons_svg(NULL));
    assert_null(yk_force_polygons_step(NULL, 0));
    assert_int_equal(yk_force_polygons_vector_count(NULL), 0);
    assert_int_equal(yk_force_polygons_vector(NULL, 3).by, YK_NOT_FOUND);
    yk_force_polygons_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_polygon_of_the_gallery_closes), cmocka_unit_test(polygons_of_belts_and_laws_close),
        cmocka_unit_test(a_bob_on_a_turning_bar_by_hand),      cmocka_unit_test(the_picture_is_to_scale),
        cmocka_unit_test(what_is_not_there_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
