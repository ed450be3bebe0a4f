// Every allocation of a cam's design fails once: the k-th, for every k. The sources are compiled in with our own
// allocator; whatever fails, nothing leaks and nothing crashes.
#include "allocations.h"
#include "check.h"

#define malloc try_malloc
#define realloc try_realloc
#define free count_free
#include "../../src/base/memory.c"
#include "../../src/design/cams/cam_design.c"
#include "../../src/design/cams/cam_samples.c"
#define JUMPS_MAX LAW_JUMPS_MAX
#define lift_at lift_of_law
#include "../../src/design/cams/cam_law.c"
#undef lift_at
#define DEPTH_MAX PROFILE_DEPTH_MAX
#include "../../src/design/cams/cam_profile.c"
#undef malloc
#undef realloc
#undef free
#include "design/cam_check.h"

static const char text[] = LIFT
    "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 40 mm, roller: 9 mm}}\n" SLIDE "efforts: {s: -3 N}\n";

// Runs until nothing fails any more; returns how many allocations there were. What is built by law/ is freed there, out
// of our count: the leak sanitizer watches it.
static long run(bool (*works)(const YkModel *model, const YkCamDesign *design), bool counts_all)
{
    YkModel *model = fixture_load(text);
    YkCamDesign *design = yk_cam_design_new(model, 0);
    assert_non_null(design);
    long before = live, k = 0;
    bool done = false;
    for (; !done; k++) {
        countdown = k;
        done = works(model, design);
        bool is_used_up = countdown < 0;
        countdown = -1;
        if (counts_all) assert_int_equal(live, before);
        assert_int_equal(done, !is_used_up);
        assert_true(k < 1000);
    }
    yk_cam_design_free(design);
    yk_model_free(model);
    return k - 1;
}

static bool makes_a_design(const YkModel *model, const YkCamDesign *design)
{
    (void)design;
    YkCamDesign *own = yk_cam_design_new(model, 0);
    yk_cam_design_free(own);
    return own != NULL;
}

static bool makes_another(const YkModel *model, const YkCamDesign *design)
{
    (void)model;
    YkCamDesign *own = yk_cam_design_with(design, "3-4-5");
    yk_cam_design_free(own);
    return own != NULL;
}

static bool makes_a_profile(const YkModel *model, const YkCamDesign *design)
{
    (void)model;
    YkCamVertex *vertices = NULL;
    size_t count;
    YkStatus status = yk_cam_profile(design, YK_CAM_CURVE_SURFACE, 1e-5, 0, &vertices, &count);
    assert_true(status == YK_OK || status == YK_NO_MEMORY);
    assert_int_equal(status == YK_OK, vertices != NULL);
    yk_cam_vertices_free(vertices);
    return status == YK_OK;
}

static bool finds_factors(const YkModel *model, const YkCamDesign *design)
{
    (void)model;
    (void)design;
    YkCamFactors factors;
    return yk_cam_law_factors("cycloidal", &factors) == YK_OK;
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    assert_true(run(makes_a_design, true) >= 2);
    assert_true(run(makes_another, false) >= 2);
    assert_true(run(makes_a_profile, true) >= 3);
    assert_true(run(finds_factors, false) >= 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
