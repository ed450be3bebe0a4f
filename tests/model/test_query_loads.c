// The public answers about a model's loads.
#include "model/fixture.h"

static const char loaded[] = "parameters: {k: 5 N/m}\ngravity: [0, -9.81]\n"
                             "bodies:\n"
                             "  ground: {points: {O: [0, 0], W: [1, 0]}}\n"
                             "  crank:  {points: {O: [0, 0], A: [0.1, 0]}, mass: 2, inertia: 0.1}\n"
                             "  block:  {points: {A: [0, 0]}, mass: 0.5}\n"
                             "  rider:  {points: {A: [0, 0]}}\n"
                             "joints:\n"
                             "  O: {pin: [ground, crank], angle: theta, friction: {viscous: 0.1}}\n"
                             "  S: {slide: [crank, block], along: x, distance: d}\n"
                             "  T: {slide: [block, rider], along: x, distance: e}\n"
                             "efforts: {theta: 2 N*m}\n"
                             "forces: {F: {body: block, value: [1, 0]}}\n"
                             "springs:\n"
                             "  s1: {along: d, stiffness: k}\n"
                             "  s2: {between: [ground.W, crank.A], stiffness: k, damping: 2}\n"
                             "  s3: {between: [ground.W, block.A], damping: 2}\n"
                             "stops: {d: [0, 1], e: [-1, 1]}\n";

static void loads_are_counted_by_kind(void **state)
{
    (void)state;
    YkModel *model = fixture_load(loaded);
    YkLoadCounts counts = yk_model_loads(model);
    assert_true(counts.has_gravity);
    assert_int_equal(counts.masses, 2);
    assert_true(fabs(counts.mass - 2.5) < 1e-15);
    assert_int_equal(counts.efforts, 1);
    assert_int_equal(counts.forces, 1);
    assert_int_equal(counts.springs, 2);
    assert_int_equal(counts.dampers, 2);
    assert_int_equal(counts.frictions, 1);
    assert_int_equal(counts.stops, 2);
    yk_model_free(model);
}

static void masses_belong_to_their_bodies(void **state)
{
    (void)state;
    YkModel *model = fixture_load(loaded);
    assert_true(yk_model_body_mass(model, yk_model_find_body(model, "crank")) == 2);
    assert_true(yk_model_body_mass(model, yk_model_find_body(model, "block")) == 0.5);
    assert_true(yk_model_body_mass(model, yk_model_find_body(model, "rider")) == 0);
    assert_true(yk_model_body_mass(model, 0) == 0);
    assert_true(yk_model_body_mass(model, 99) == 0);
    yk_model_free(model);
}

static void a_machine_of_motion_alone_has_none(void **state)
{
    (void)state;
    YkModel *model = fixture_load(CRANK "gravity: [0, 0]\n");
    YkLoadCounts counts = yk_model_loads(model);
    assert_false(counts.has_gravity);
    assert_true(counts.mass == 0);
    assert_int_equal(counts.masses + counts.efforts + counts.forces + counts.springs + counts.dampers +
                         counts.frictions + counts.stops,
                     0);
    yk_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loads_are_counted_by_kind),
        cmocka_unit_test(masses_belong_to_their_bodies),
        cmocka_unit_test(a_machine_of_motion_alone_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
