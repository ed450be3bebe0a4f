// Every allocation may fail: mapping then says so, loses nothing, and can be repeated.
#include "check.h"
#include "interposed.h"
#include <yoke/map.h>
#include <yoke/yoke.h>
#include "base/problems.h"

static void check_each_failure(YkModel *model)
{
    YkProblems *problems = yk_problems_new();
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    YkState *state = yk_state_new(mech);
    assert_true(state && yk_state_set_time(state, 0, problems) >= 0 && yk_state_assemble(state) >= 0);
    const YkMapPicture picture = {.coordinate = 1, .angle_unit = "rad", .length_unit = "m", .angle = 1, .length = 1};
    long failures = 0, blocks = live;
    // The first of them one by one, then, since cells are alike, with growing gaps.
    for (long allowed = 0;; allowed += 1 + allowed / 40) {
        countdown = allowed;
        has_failed = false;
        YkMap *map = yk_map_new(state, yk_input_coordinate(mech, 0), NULL);
        const char *svg = map ? yk_map_picture(map, &picture) : NULL;
        countdown = -1;
        if (!has_failed) {
            assert_true(map && svg && yk_map_is_complete(map));
            yk_map_free(map);
            break;
        }
        failures++;
        assert_true(!map || !svg);
        yk_map_free(map);
        assert_int_equal(live, blocks);
    }
    assert_true(failures >= 50);
    assert_int_equal(live, blocks);
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void test_each_failure_is_told(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    static const char *const geared = "bodies:\n  ground: {points: {A: [0, 0], E: [1, 2.2]}}\n"
                                      "  a: {points: {A: [0, 0], B: [0.5, 0]}}\n"
                                      "  b: {points: {C: [0, 0], B: [-1.5, 0]}}\n"
                                      "  c: {points: {C: [0, 0], D: [1, 0]}}\n"
                                      "  d: {points: {D: [0, 0], E: [2.5, 0]}}\njoints:\n"
                                      "  A: {pin: [ground, a], angle: t1}\n  B: {pin: [a, b], angle: t2}\n"
                                      "  C: {pin: [b, c], angle: t3}\n  D: {pin: [c, d], angle: t4}\n"
                                      "  E: {pin: [ground, d]}\n"
                                      "gears: {g: {mesh: [b, d], teeth: [20, 20], carrier: c}}\n"
                                      "drives: {t1: 1}\nstart: {t2: 0.5, t3: 0.4, t4: -1}\n";
    check_each_failure(yk_model_load(YOKE_ROOT "/examples/non-grashof.yaml", NULL, NULL));
    check_each_failure(yk_model_load(YOKE_ROOT "/examples/doubled-guide.yaml", NULL, NULL));
    check_each_failure(yk_model_parse(geared, strlen(geared), "geared", NULL, NULL));
}

// The same while the dead points of a drive are added: what is told is the want of memory, and nothing else.
static void test_each_failure_of_dead_points_is_told(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(YOKE_ROOT "/examples/non-grashof.yaml", NULL, problems);
    const char *input = "theta4";
    YkMechanism *mech = yk_mechanism_compile(model, &(YkCompileOptions){.inputs = &input, .input_count = 1}, problems);
    YkState *state = yk_state_new(mech);
    assert_true(state && yk_state_set_time(state, 0, problems) >= 0 && yk_state_assemble(state) >= 0);
    long blocks = live;
    bool is_done = false;
    for (long allowed = 0; !is_done; allowed += 1 + allowed) {
        YkProblems *told = yk_problems_new();
        YkMap *map = yk_map_new(state, yk_input_coordinate(mech, 0), told);
        assert_non_null(map);
        has_failed = false;
        countdown = allowed;
        YkStatus status = yk_map_add_drives(map, state, told);
        countdown = -1;
        is_done = !has_failed;
        assert_true(is_done ? status == YK_OK : status < 0 && yk_problems_error_count(told) > 0);
        for (size_t k = 0; k < yk_problems_count(told); k++)
            assert_int_equal(yk_problems_get(told, k)->code, YK_CODE_OUT_OF_MEMORY);
        yk_map_free(map);
        yk_problems_free(told);
        assert_int_equal(live, blocks);
    }
    yk_state_free(state);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
}

// The same for a map over two freedoms, here of a machine whose point is carried, and for that machine.
static void test_each_failure_of_regions_is_told(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(YOKE_ROOT "/examples/five-bar.yaml", NULL, problems);
    const char *inputs[] = {"p_x", "p_y"};
    const double at[2] = {0, 0.3};
    YkCompileOptions options = yk_default_compile_options();
    options.inputs = inputs;
    options.input_count = 2;
    const YkRegionsOptions coarse = {.tolerance = 0.05};
    const YkTilePlane plane = {{-0.5, -0.5}, {0.5, 0.5}, 64, true};
    const uint32_t *words;
    size_t word_count;
    const YkRegionsPicture picture = {{"x", NULL}, {"m", NULL}, {1, 1}};
    long failures = 0, blocks = live;
    for (long allowed = 0;; allowed += 1 + allowed / 40) {
        countdown = allowed;
        has_failed = false;
        YkModel *carried = yk_model_carry_point(model, yk_model_find_point(model, "reachL.P"), "p_", at, NULL, NULL);
        YkMechanism *mech = carried ? yk_mechanism_compile(carried, &options, NULL) : NULL;
        YkState *state = mech ? yk_state_new(mech) : NULL;
        bool stands = state && yk_state_set_time(state, 0, NULL) >= 0 && yk_state_assemble(state) >= 0;
        YkRegions *regions =
            stands ? yk_regions_new(state, yk_input_coordinate(mech, 0), yk_input_coordinate(mech, 1), &coarse, NULL)
                   : NULL;
        const char *svg = regions ? yk_regions_picture(regions, &picture) : NULL;
        YkTiles *tiles =
            svg ? yk_tiles_new(state, yk_input_coordinate(mech, 0), yk_input_coordinate(mech, 1), NULL) : NULL;
        const bool has_tile = tiles && yk_tiles_compute(tiles, &plane, 1, &words, &word_count) == YK_OK;
        countdown = -1;
        bool done = !has_failed;
        assert_int_equal(done, has_tile);
        failures++;
        yk_tiles_free(tiles);
        yk_regions_free(regions);
        yk_state_free(state);
        yk_mechanism_free(mech);
        yk_model_free(carried);
        assert_int_equal(live, blocks);
        if (done) break;
    }
    assert_true(failures >= 50);
    yk_model_free(model);
    yk_problems_free(problems);
}

static void test_every_allocation_of_a_certifier_may_fail(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(YOKE_ROOT "/examples/double-butterfly.yaml", NULL, problems);
    YkMechanism *mech = yk_mechanism_compile(model, NULL, problems);
    long failures = 0, blocks = live;
    for (long allowed = 0;; allowed++) {
        countdown = allowed;
        has_failed = false;
        YkCertifier *certifier = yk_certifier_new(mech);
        countdown = -1;
        assert_true(has_failed == !certifier);
        yk_certifier_free(certifier);
        assert_int_equal(live, blocks);
        if (!has_failed) break;
        failures++;
    }
    assert_true(failures >= 10);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_each_failure_is_told),
                                       cmocka_unit_test(test_each_failure_of_dead_points_is_told),
                                       cmocka_unit_test(test_each_failure_of_regions_is_told),
                                       cmocka_unit_test(test_every_allocation_of_a_certifier_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
