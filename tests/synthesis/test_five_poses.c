// Dyads through five and four positions against published ones, and against dyads whose positions were made.
#include "check.h"
#include "../check_vec.h"
#include "synthesis/motions/poses.h"

#define DEG (YK_PI / 180)

static void the_published_five_positions_have_their_four_dyads(void **state)
{
    (void)state;
    static const YkPose pose[5] = {{.at = {0, 0}, .angle = 0},
                                   {.at = {.5, 1}, .angle = 20 * DEG},
                                   {.at = {1.5, 1.5}, .angle = 35 * DEG},
                                   {.at = {2.5, 1.25}, .angle = 40 * DEG},
                                   {.at = {3, .5}, .angle = 30 * DEG}};
    static const double published[4][5] = {{-3.7386221138, -5.4786830493, -2.8703249242, 1.0844317919, 6.6203033487},
                                           {-3.2563098637, 5.4744605353, -2.6385032210, 6.3798184430, 1.0960647740},
                                           {.8209033814, 6.8384267066, -.4048457180, 4.1219638916, 2.9802065499},
                                           {1.4141252581, .2303378546, -.0594153561, .2851166828, 1.4745584634}};
    YkFivePoses found;
    yk_five_poses(pose, &found);
    assert_int_equal(found.complex_count, 4);
    assert_int_equal(found.count, 4);
    for (size_t k = 0; k < 4; k++) {
        size_t hits = 0;
        for (size_t i = 0; i < 4; i++) {
            const YkDyad *d = &found.dyad[i];
            if (fabs(d->fixed[0] - published[k][0]) > 1e-3) continue;
            hits++;
            CHECK_NEAR(d->fixed[0], published[k][0], 1e-9);
            CHECK_NEAR(d->fixed[1], published[k][1], 1e-9);
            CHECK_NEAR(d->moving[0], published[k][2], 1e-9);
            CHECK_NEAR(d->moving[1], published[k][3], 1e-9);
            CHECK_NEAR(d->length, published[k][4], 1e-9);
        }
        assert_int_equal(hits, 1);
    }
}

static YkVec vector(const double v[2])
{
    return yk_vec(v[0], v[1]);
}

// Returns how far the pivots' distance changes over the positions, beside the length.
static double slack(const YkPose *pose, size_t count, const YkDyad *d)
{
    double worst = 0;
    for (size_t k = 0; k < count; k++) {
        double length = yk_norm(yk_sub(yk_pose_apply(pose[k], vector(d->moving)), vector(d->fixed)));
        worst = fmax(worst, fabs(length - d->length) / (d->length + 1));
    }
    return worst;
}

static void random_poses(YkPose *pose, size_t count, uint64_t *seed)
{
    for (size_t k = 0; k < count; k++) {
        pose[k].at.x = check_uniform(seed, -3, 3);
        pose[k].at.y = check_uniform(seed, -3, 3);
        pose[k].angle = check_uniform(seed, -1.5, 1.5);
    }
}

// Through two and three positions: a pivot of the body along a line of the ground, a line of the body through a point
// of the ground, and a link at a given pivot of the ground.
static void dyads_through_two_and_three_positions_hold_at_them(void **state)
{
    (void)state;
    uint64_t seed = 6;
    size_t found[3] = {0};
    for (int round = 0; round < 400; round++) {
        size_t count = 2 + (size_t)round % 2;
        YkPose pose[3] = {{.angle = 0}};
        random_poses(pose, count, &seed);
        double direction = check_uniform(&seed, -3, 3), along = check_uniform(&seed, -1, 1);
        YkVec pivot = yk_vec(check_uniform(&seed, -3, 3), check_uniform(&seed, -3, 3));
        YkDyad slide, block, link;
        bool is[3] = {yk_pose_slide(pose, count, direction, along, &slide),
                      yk_pose_block(pose, count, direction, along, &block),
                      yk_pose_pivot(pose, count, pivot, along, &link)};
        for (int k = 0; k < 3; k++) found[k] += is[k];
        for (size_t k = 0; k < count && is[0]; k++) {
            YkVec off = yk_sub(yk_pose_apply(pose[k], vector(slide.moving)), vector(slide.fixed));
            CHECK_NEAR(yk_cross(yk_unit(slide.direction), off), 0, 1e-9);
        }
        if (is[0]) CHECK_NEAR(yk_dot(vector(slide.fixed), yk_unit(slide.direction)), 0, 1e-9);
        if (is[0]) CHECK_NEAR(yk_cross(yk_unit(slide.direction), yk_unit(direction)), 0, 1e-12);
        for (size_t k = 0; k < count && is[1]; k++) {
            YkVec off = yk_sub(vector(block.fixed), yk_pose_apply(pose[k], vector(block.moving)));
            CHECK_NEAR(yk_cross(yk_unit(block.direction + pose[k].angle), off), 0, 1e-9);
        }
        if (is[1]) CHECK_NEAR(yk_dot(vector(block.moving), yk_unit(block.direction)), 0, 1e-9);
        if (is[2]) CHECK_NEAR(slack(pose, count, &link), 0, 1e-9);
        if (is[2]) CHECK_NEAR(hypot(link.fixed[0] - pivot.x, link.fixed[1] - pivot.y), 0, 1e-12);
    }
    for (int k = 0; k < 3; k++) assert_true(found[k] > 200);
}

static void random_positions_have_none_two_or_four_dyads(void **state)
{
    (void)state;
    uint64_t seed = 1;
    size_t seen[5] = {0};
    for (int round = 0; round < 2000; round++) {
        YkPose pose[5] = {{.angle = 0}};
        YkFivePoses found;
        random_poses(pose, 5, &seed);
        yk_five_poses(pose, &found);
        assert_false(found.is_special);
        assert_int_equal(found.complex_count, 4);
        if (found.count % 2 != 0) print_error("round %d: %zu\n", round, found.count);
        assert_true(found.count % 2 == 0);
        seen[found.count]++;
        for (size_t k = 0; k < found.count; k++) {
            assert_int_equal(found.dyad[k].kind, YK_DYAD_RR);
            CHECK_NEAR(slack(pose, 5, &found.dyad[k]), 0, 1e-9);
        }
    }
    assert_true(seen[0] > 100 && seen[2] > 100 && seen[4] > 10);
}

// Positions of a coupler between two cranks: their angles are chosen, the coupler closes between them.
static bool four_bar_poses(YkPose *pose, size_t count, YkVec F[2], YkVec z[2], uint64_t *seed)
{
    for (size_t i = 0; i < 2; i++) {
        F[i] = check_vec(seed, -2, 2, -2, 2);
        z[i] = check_vec(seed, -2, 2, -2, 2);
    }
    double a = check_uniform(seed, .5, 2), c = check_uniform(seed, .5, 2), from = check_uniform(seed, -3, 3);
    YkVec across = yk_sub(z[1], z[0]);
    double b = yk_norm(across);
    for (size_t k = 0; k < count; k++) {
        YkVec A = yk_add(F[0], yk_scale(a, yk_unit(from + .35 * (double)k))), AF = yk_sub(F[1], A);
        double f = yk_norm(AF), cosine = (b * b + f * f - c * c) / (2 * b * f);
        if (!(fabs(cosine) < .99)) return false;
        double angle = yk_atan2(AF.y, AF.x) + yk_acos(cosine) - yk_atan2(across.y, across.x);
        pose[k].angle = angle;
        pose[k].at = yk_sub(A, yk_mul(yk_unit(angle), z[0]));
    }
    return true;
}

static void a_four_bar_is_found_again_from_five_of_its_positions(void **state)
{
    (void)state;
    uint64_t seed = 7;
    int tried = 0;
    while (tried < 300) {
        YkPose pose[5] = {{.angle = 0}};
        YkVec F[2], z[2];
        YkFivePoses found;
        if (!four_bar_poses(pose, 5, F, z, &seed)) continue;
        tried++;
        yk_five_poses(pose, &found);
        for (size_t i = 0; i < 2; i++) {
            double nearest = 1e9;
            for (size_t k = 0; k < found.count; k++)
                nearest = fmin(nearest, yk_norm(yk_sub(vector(found.dyad[k].fixed), F[i])) +
                                            yk_norm(yk_sub(vector(found.dyad[k].moving), z[i])));
            CHECK_NEAR(nearest, 0, 1e-5);
        }
    }
}

static void a_body_moved_on_a_line_has_a_dyad_with_a_slide(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int round = 0; round < 50; round++) {
        YkPose pose[5] = {{.angle = 0}};
        YkVec z = check_vec(&seed, -1, 1, -1, 1), along = yk_unit(.3 + round);
        for (size_t k = 0; k < 5; k++) { // z on a line, and turned at will
            YkVec on_line = yk_add(yk_vec(.2, .7), yk_scale(check_uniform(&seed, -2, 2), along));
            pose[k].angle = check_uniform(&seed, -1, 1);
            pose[k].at = yk_sub(on_line, yk_mul(yk_unit(pose[k].angle), z));
        }
        YkFivePoses five;
        YkDyad four[2];
        size_t slides = yk_four_poses_slides(pose, four), hits = 0;
        assert_int_equal(slides, 2);
        CHECK_NEAR(yk_norm(yk_sub(vector(four[0].moving), z)), 0, 1e-9);
        CHECK_NEAR(yk_sin(four[0].direction - (.3 + round)), 0, 1e-9);
        yk_five_poses(pose, &five);
        for (size_t k = 0; k < five.count; k++) {
            if (five.dyad[k].kind != YK_DYAD_PR) continue;
            hits++;
            CHECK_NEAR(yk_norm(yk_sub(vector(five.dyad[k].moving), z)), 0, 1e-6);
        }
        assert_int_equal(hits, 1);
    }
}

static void a_fixed_point_in_a_line_of_the_body_is_a_dyad_with_a_slide(void **state)
{
    (void)state;
    uint64_t seed = 4;
    YkPose pose[4] = {{.angle = 0}};
    YkVec F = yk_vec(.4, -.3), along = yk_unit(.8), foot = yk_scale(.6, yk_quarter(along));
    for (size_t k = 0; k < 4; k++) {
        YkVec z = yk_add(foot, yk_scale(check_uniform(&seed, -2, 2), along));
        pose[k].angle = check_uniform(&seed, -1, 1);
        pose[k].at = yk_sub(F, yk_mul(yk_unit(pose[k].angle), z));
    }
    YkDyad slide[2];
    assert_int_equal(yk_four_poses_slides(pose, slide), 2);
    assert_int_equal(slide[1].kind, YK_DYAD_RP);
    CHECK_NEAR(yk_norm(yk_sub(vector(slide[1].fixed), F)), 0, 1e-12);
    CHECK_NEAR(yk_sin(slide[1].direction - .8), 0, 1e-12);
    CHECK_NEAR(yk_norm(yk_sub(vector(slide[1].moving), foot)), 0, 1e-12);
}

static void four_positions_have_dyads_on_every_ray_that_meets_the_curve(void **state)
{
    (void)state;
    uint64_t seed = 5;
    size_t dyads = 0;
    for (int round = 0; round < 200; round++) {
        YkPose pose[4] = {{.angle = 0}};
        YkFourPoses four;
        YkDyad d[2];
        random_poses(pose, 4, &seed);
        yk_four_poses(pose, &four);
        for (int k = 0; k < 36; k++) {
            size_t count = yk_four_poses_ray(&four, k * 5 * DEG, d);
            for (size_t i = 0; i < count; i++) CHECK_NEAR(slack(pose, 4, &d[i]), 0, 1e-8);
            dyads += count;
        }
    }
    assert_true(dyads > 3000);
}

// Every dyad of five positions is one of four of them: the ray to its moving pivot finds it.
static void dyads_of_five_positions_are_on_the_curve_of_four(void **state)
{
    (void)state;
    uint64_t seed = 6;
    for (int round = 0; round < 300; round++) {
        YkPose pose[5] = {{.angle = 0}};
        YkFivePoses five;
        YkFourPoses four;
        random_poses(pose, 5, &seed);
        yk_five_poses(pose, &five);
        yk_four_poses(pose, &four);
        for (size_t k = 0; k < five.count; k++) {
            const YkDyad *d = &five.dyad[k];
            if (fabs(d->fixed[0]) + fabs(d->fixed[1]) + d->length > 40) continue;
            YkVec ray = yk_sub(vector(d->moving), yk_scale(four.rows.scale, four.pole));
            YkDyad own[2];
            size_t count = yk_four_poses_ray(&four, yk_atan2(ray.y, ray.x), own);
            double nearest = 1e9;
            for (size_t i = 0; i < count; i++)
                nearest = fmin(nearest, yk_norm(yk_sub(vector(own[i].fixed), vector(d->fixed))));
            CHECK_NEAR(nearest, 0, 1e-5);
        }
    }
}

static void a_given_pivot_leaves_one_dyad_of_three_positions_and_a_line_of_two(void **state)
{
    (void)state;
    uint64_t seed = 8;
    for (int round = 0; round < 300; round++) {
        YkPose pose[3] = {{.angle = 0}};
        YkDyad d;
        YkVec F = check_vec(&seed, -3, 3, -3, 3);
        random_poses(pose, 3, &seed);
        assert_true(yk_pose_pivot(pose, 3, F, 0, &d));
        CHECK_NEAR(slack(pose, 3, &d), 0, 1e-9);
        CHECK_NEAR(yk_norm(yk_sub(vector(d.fixed), F)), 0, 1e-12);
        assert_true(yk_pose_pivot(pose, 2, F, check_uniform(&seed, -2, 2), &d));
        CHECK_NEAR(slack(pose, 2, &d), 0, 1e-11);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_published_five_positions_have_their_four_dyads),
        cmocka_unit_test(dyads_through_two_and_three_positions_hold_at_them),
        cmocka_unit_test(random_positions_have_none_two_or_four_dyads),
        cmocka_unit_test(a_four_bar_is_found_again_from_five_of_its_positions),
        cmocka_unit_test(a_body_moved_on_a_line_has_a_dyad_with_a_slide),
        cmocka_unit_test(a_fixed_point_in_a_line_of_the_body_is_a_dyad_with_a_slide),
        cmocka_unit_test(four_positions_have_dyads_on_every_ray_that_meets_the_curve),
        cmocka_unit_test(dyads_of_five_positions_are_on_the_curve_of_four),
        cmocka_unit_test(a_given_pivot_leaves_one_dyad_of_three_positions_and_a_line_of_two),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
