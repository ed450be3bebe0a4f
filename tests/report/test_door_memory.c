// Equilibria, sketches, drawings by hand and batches of forces whose allocations fail one after the other: refused, or
// complete.
#include <yoke/yoke.h>
#include "../survive.h"
#include "solve/machine.h"

static bool rest(void *context)
{
    const Machine *m = context;
    YkRest *found = yk_rest_find(m->model, NULL, NULL);
    bool good = found != NULL;
    if (good) assert_true(yk_rest_count(found) > 0);
    YkStatus status = good ? yk_rest_reach(found) : YK_NO_MEMORY;
    assert_true(status >= 0 || status == YK_NO_MEMORY);
    yk_rest_free(found);
    return status >= 0;
}

static void equilibria_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    Machine m = machine_load("pendulum");
    survive(rest, &m, "rest");
    machine_free(&m);
}

static bool sketch(void *context)
{
    (void)context;
    static const char text[] =
        "bodies: {ground: {points: {O: [0, 0]}}, a: {points: {O: [0, 0], A: [1, 0]}}, b: {points: {A: [0, 0]}}}\n"
        "joints: {O: {pin: [ground, a]}}\n";
    YkSketch *s = yk_sketch_parse(text, sizeof text - 1, "sketch", NULL, NULL);
    bool good = s != NULL;
    if (good) assert_true(yk_sketch_lack_count(s) > 0);
    yk_sketch_free(s);
    return good;
}

static void sketches_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    survive(sketch, NULL, "sketch");
}

typedef struct Pictures {
    Machine m;
    YkDynamics *dynamics;
} Pictures;

static bool draw(void *context)
{
    const Pictures *p = context;
    YkCenters *centers = yk_centers_new(p->m.state, NULL);
    YkPolygon *polygon = centers ? yk_polygon_new(p->m.state, YK_POLYGON_ACCELERATION, NULL) : NULL;
    YkForcePolygons *forces = polygon ? yk_force_polygons_new(p->dynamics, NULL) : NULL;
    YkDrawing *drawing = forces ? yk_drawing_new(p->m.mech, NULL) : NULL;
    bool good = drawing && yk_polygon_svg(polygon) && yk_force_polygons_svg(forces) &&
                yk_drawing_pose(drawing, p->m.state) == YK_OK && yk_drawing_centers(drawing, centers) == YK_OK &&
                yk_drawing_svg(drawing);
    yk_drawing_free(drawing);
    yk_force_polygons_free(forces);
    yk_polygon_free(polygon);
    yk_centers_free(centers);
    return good;
}

static void pictures_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    Pictures p = {.m = machine_load("crank-press")};
    p.dynamics = yk_dynamics_new(p.m.mech, NULL);
    assert_true(yk_dynamics_solve(p.dynamics, p.m.state, YK_METHOD_REDUCED) >= 0);
    survive(draw, &p, "pictures");
    yk_dynamics_free(p.dynamics);
    machine_free(&p.m);
}

static bool batch(void *context)
{
    const Machine *m = context;
    YkChannel channels[2];
    if (yk_channel_parse(m->mech, "q.effort", &channels[0], NULL) ||
        yk_channel_parse(m->mech, "A.force", &channels[1], NULL))
        return false;
    YkBatch *b = yk_batch_new(m->state, channels, 2);
    double effort[3], force[3], *outputs[] = {effort, force};
    const double *inputs[3 * 8] = {NULL};
    bool good = b && yk_batch_run(b, inputs, outputs, NULL, 3) >= 0;
    if (good) assert_true(isfinite(effort[2]) && effort[0] == effort[2]);
    yk_batch_free(b);
    return good;
}

static void batches_survive(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    Machine m = machine_load("spring-slider-crank");
    survive(batch, &m, "batch");
    machine_free(&m);
}

static bool balance(void *context)
{
    const Machine *m = context;
    YkBalancing *b = yk_balancing_new(m->state, NULL, NULL);
    bool good = b != NULL;
    yk_balancing_free(b);
    return good;
}

static void balancing_survives(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    Machine m = machine_load("crank-press");
    survive(balance, &m, "balancing");
    machine_free(&m);
}

int main(void)
{
    start_counting();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equilibria_survive), cmocka_unit_test(sketches_survive),   cmocka_unit_test(pictures_survive),
        cmocka_unit_test(batches_survive),    cmocka_unit_test(balancing_survives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
