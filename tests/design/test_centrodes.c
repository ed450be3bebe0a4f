// Centrodes: Cardan's circles, and rolling without slipping.
#include "assembled.h"
#include "base/codes.h"
#include "base/vec.h"

static YkVec on(const YkCentrodes *c, size_t index, size_t side)
{
    YkCentrodePoint p = yk_centrodes_point(c, index % yk_centrodes_count(c));
    return yk_vec(p.on[side][0], p.on[side][1]);
}

// A bar of length 0.3 whose ends slide along two axes: its centre runs on a circle of radius 0.3 about their crossing,
// and in the bar on a circle of this diameter about its middle.
static void a_trammel_has_cardans_circles(void **state)
{
    (void)state;
    Assembled m;
    assert_true(assembled_open(&m, YOKE_ROOT "/examples/elliptic-trammel.yaml", NULL, 0));
    YkCentrodes *c = yk_centrodes_new(m.state, 0, yk_model_find_body(m.model, "bar"), 90, NULL);
    assert_non_null(c);
    assert_true(yk_centrodes_are_closed(c));
    assert_int_equal(yk_centrodes_count(c), 90);
    size_t found = 0;
    for (size_t k = 0; k < 90; k++) {
        if (!yk_centrodes_point(c, k).exists) continue;
        CHECK_NEAR(yk_norm(on(c, k, 0)), 0.3, 1e-13);
        CHECK_NEAR(yk_norm(yk_sub(on(c, k, 1), yk_vec(0.15, 0))), 0.15, 1e-13);
        found++;
    }
    assert_true(found >= 88);
    yk_centrodes_free(c);
    assembled_close(&m);
}

// Sums the chords of both curves; returns by how much the sums ever differ.
static double slip(const Assembled *m, const char *first, const char *second, size_t steps, double *whole)
{
    const YkModel *model = m->model;
    size_t body[2] = {yk_model_find_body(model, first), yk_model_find_body(model, second)};
    YkCentrodes *c = yk_centrodes_new(m->state, body[0], body[1], steps, NULL);
    assert_non_null(c);
    double sum[2] = {0}, most = 0;
    for (size_t k = 0; k < yk_centrodes_count(c); k++) {
        assert_true(yk_centrodes_point(c, k).exists);
        for (size_t side = 0; side < 2; side++) sum[side] += yk_norm(yk_sub(on(c, k + 1, side), on(c, k, side)));
        most = fmax(most, fabs(sum[0] - sum[1]));
    }
    yk_centrodes_free(c);
    *whole = sum[0];
    return most;
}

// Arcs of both curves are equally long: their chords differ with the square of the step, and by nothing else.
static void centrodes_roll_without_slipping(void **state)
{
    (void)state;
    static const char *const cases[][3] = {{"/examples/four-bar.yaml", "crank", "rocker"},
                                           {"/examples/offset-slider-crank.yaml", "crank", "block"}};
    for (size_t k = 0; k < 2; k++) {
        char path[300];
        snprintf(path, sizeof path, "%s%s", YOKE_ROOT, cases[k][0]);
        Assembled m;
        assert_true(assembled_open(&m, path, NULL, 0));
        double whole, coarse = slip(&m, cases[k][1], cases[k][2], 400, &whole);
        double fine = slip(&m, cases[k][1], cases[k][2], 800, &whole);
        assert_true(fine < 1e-4 * whole);
        assert_true(fine < coarse / 3.8 && fine > coarse / 4.2);
        assembled_close(&m);
    }
}

// The centre of two bodies at a pose is the one that Kennedy's theorem finds there.
static void the_centre_is_kennedys(void **state)
{
    (void)state;
    Assembled m;
    assert_true(assembled_open(&m, YOKE_ROOT "/examples/four-bar.yaml", NULL, 0));
    YkCenters *centers = yk_centers_new(m.state, NULL);
    for (size_t k = 0; k < yk_centers_count(centers); k++) {
        YkCenter is = yk_centers_at(centers, k);
        YkCentrodes *c = yk_centrodes_new(m.state, is.body[0], is.body[1], 3, NULL);
        YkCentrodePoint p = yk_centrodes_point(c, 0);
        assert_true(p.exists && is.kind == YK_CENTER_POINT);
        for (size_t axis = 0; axis < 2; axis++) CHECK_NEAR(p.at[axis], is.at[axis], 1e-12);
        yk_centrodes_free(c);
    }
    yk_centers_free(centers);
    assembled_close(&m);
}

static void what_is_not_there_is_said(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    Assembled m;
    assert_true(assembled_open(&m, YOKE_ROOT "/examples/four-bar.yaml", NULL, 0));
    assert_null(yk_centrodes_new(m.state, 1, 1, 10, problems));
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_NO_CENTERS);
    assert_null(yk_centrodes_new(NULL, 0, 1, 10, problems));
    assert_null(yk_centrodes_new(m.state, 0, 1, 0, problems));
    assert_int_equal(yk_centrodes_count(NULL), 0);
    assert_false(yk_centrodes_are_closed(NULL));
    assert_int_equal(yk_centrodes_body(NULL, 0), YK_NOT_FOUND);
    assert_false(yk_centrodes_point(NULL, 0).exists);
    yk_centrodes_free(NULL);
    assembled_close(&m);
    assert_true(assembled_open(&m, YOKE_ROOT "/examples/double-pendulum.yaml", NULL, 0));
    assert_null(yk_centrodes_new(m.state, 0, 1, 10, problems));
    assert_int_equal(yk_problems_get(problems, 1)->code, YK_CODE_NO_CENTERS);
    assembled_close(&m);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_trammel_has_cardans_circles),
        cmocka_unit_test(centrodes_roll_without_slipping),
        cmocka_unit_test(the_centre_is_kennedys),
        cmocka_unit_test(what_is_not_there_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
