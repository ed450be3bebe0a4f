// Four-bars through positions: the published six, machines found again, and every candidate driven in another way.
#include "synthesis/answer.h"
#include "../check_vec.h"
#include "synthesis/synthesis.h"

static const char five[] =
    "synthesis: motion\n"
    "positions: [{at: [0, 0], angle: 0}, {at: [.5, 1], angle: 20 deg}, {at: [1.5, 1.5], angle: 35 deg},\n"
    "  {at: [2.5, 1.25], angle: 40 deg}, {at: [3, .5], angle: 30 deg}]\n";

// Follows the file's own drive in small steps of time. Every position must be met, in order, within a second (a swing's
// way, a crank's turn); between steps the machine cannot go to another branch without a jump.
static void check_passes(const char *model, const YkPose *pose, size_t count, bool in_order)
{
    enum { STEPS = 1500 };
    Standing s = standing(model);
    size_t P = yk_model_find_point(s.model, "coupler.P"), Q = yk_model_find_point(s.model, "coupler.Q");
    double nearest[8], at[8], last_x = 0, last_y = 0, size = yk_mechanism_size(s.mech), step = 0;
    for (size_t k = 0; k < count; k++) nearest[k] = INFINITY;
    for (int i = 0; i <= STEPS; i++) {
        double t = (double)i / STEPS;
        assert_int_equal(yk_state_set_time(s.state, t, NULL), YK_OK);
        if (yk_state_solve(s.state) < 0) break; // past the last position a crank may meet what it likes
        YkPointMotion p = yk_state_point(s.state, P), q = yk_state_point(s.state, Q);
        double x = p.position[0], y = p.position[1];
        if (i > 0) step = hypot(x - last_x, y - last_y);
        last_x = x;
        last_y = y;
        double angle = atan2(q.position[1] - y, q.position[0] - x);
        for (size_t k = 0; k < count; k++) {
            double off =
                hypot(x - pose[k].at.x, y - pose[k].at.y) + size * fabs(remainder(angle - pose[k].angle, 2 * YK_PI));
            if (off + 1e-6 * size >= nearest[k]) continue;
            nearest[k] = off;
            at[k] = t;
        }
        assert_true(step < 0.1 * size);
    }
    for (size_t k = 0; k < count; k++) {
        CHECK_NEAR(nearest[k], 0, 0.05 * size);
        if (k > 0 && in_order) assert_true(at[k] > at[k - 1]);
    }
    standing_free(&s);
}

static void the_published_positions_have_six_four_bars_and_three_pass(void **state)
{
    (void)state;
    static const YkPose pose[5] = {{.at = {0, 0}, .angle = 0},
                                   {.at = {.5, 1}, .angle = 20 * YK_PI / 180},
                                   {.at = {1.5, 1.5}, .angle = 35 * YK_PI / 180},
                                   {.at = {2.5, 1.25}, .angle = 40 * YK_PI / 180},
                                   {.at = {3, .5}, .angle = 30 * YK_PI / 180}};
    Answer a = answer_to(five);
    size_t complex_count, real_count;
    assert_true(yk_synthesis_solutions(a.synthesis, &complex_count, &real_count));
    assert_int_equal(complex_count, 4);
    assert_int_equal(real_count, 4);
    assert_true(yk_synthesis_is_complete(a.synthesis));
    assert_int_equal(yk_synthesis_count(a.synthesis) + yk_synthesis_defect_count(a.synthesis), 6);
    assert_int_equal(yk_synthesis_count(a.synthesis), 3);
    assert_int_equal(yk_synthesis_left_out(a.synthesis, YK_DEFECT_BRANCH), 3);
    for (size_t k = 0; k < 3; k++) {
        YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
        assert_true(c.error < 1e-18 && c.worst < 1e-9);
        check_passes(c.model, pose, 5, true);
    }
    answer_free(&a);
}

static void write_task(char *text, size_t size, const YkPose *pose, size_t count)
{
    size_t at = (size_t)snprintf(text, size, "synthesis: motion\nbest: 1000\npositions:\n");
    for (size_t k = 0; k < count; k++)
        at += (size_t)snprintf(text + at, size - at, "  - {at: [%.17g, %.17g], angle: %.17g}\n", pose[k].at.x,
                               pose[k].at.y, pose[k].angle);
}

// Positions of a crank-rocker's coupler on its way.
static void crank_rocker_poses(YkPose *pose, size_t count, double lengths[4], uint64_t *seed)
{
    double a = check_uniform(seed, .2, .5), g = 2, b = check_uniform(seed, 1.6, 2.2), c = check_uniform(seed, 1.2, 1.8);
    if (g + a > b + c || a + b > g + c || a + c > g + b) c = b = 2; // not Grashof
    YkVec P = check_vec(seed, -1, 2, -1, 1);
    double from = check_uniform(seed, -3, 3), step = check_uniform(seed, .3, 1);
    for (size_t k = 0; k < count; k++) {
        YkVec A = yk_scale(a, yk_unit(from + step * (double)k)), AF = yk_sub(yk_vec(g, 0), A);
        double f = yk_norm(AF), angle = yk_atan2(AF.y, AF.x) + yk_acos((b * b + f * f - c * c) / (2 * b * f));
        pose[k].angle = angle + .3;
        pose[k].at = yk_add(A, yk_mul(yk_unit(angle), P));
    }
    memcpy(lengths, (double[]){g, a, b, c}, 4 * sizeof *lengths);
}

static void a_crank_rocker_is_found_again_among_the_candidates(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (uint64_t round = 0; round < check_cases(20); round++) {
        YkPose pose[5] = {{.angle = 0}};
        double lengths[4], nearest = INFINITY;
        char text[2000];
        crank_rocker_poses(pose, 5, lengths, &seed);
        write_task(text, sizeof text, pose, 5);
        Answer a = answer_to(text);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            double off = fabs(c.lengths[0] - lengths[0]) + fabs(c.lengths[2] - lengths[2]);
            off += fmin(fabs(c.lengths[1] - lengths[1]) + fabs(c.lengths[3] - lengths[3]),
                        fabs(c.lengths[3] - lengths[1]) + fabs(c.lengths[1] - lengths[3]));
            nearest = fmin(nearest, off);
            check_passes(c.model, pose, 5, true);
        }
        if (!(nearest < 1e-4)) print_error("round %d\n%s", (int)round, text);
        CHECK_NEAR(nearest, 0, 1e-4);
        answer_free(&a);
    }
}

// What the signs leave out for branch or circuit, the engine cannot drive either, whichever way it goes.
static void signs_agree_with_the_engine(uint64_t seed, int rounds, size_t count, const char *more)
{
    size_t tried = 0;
    for (int round = 0; round < rounds; round++) {
        YkPose pose[5] = {{.angle = 0}};
        char text[2000];
        for (size_t k = 0; k < count; k++) {
            pose[k].at = check_vec(&seed, -1, 1, -1, 1);
            pose[k].angle = check_uniform(&seed, -1, 1);
        }
        write_task(text, sizeof text, pose, count);
        strcat(text, more);
        Answer a = answer_to(text);
        for (size_t k = 0; k < a.synthesis->defects.count; k++) {
            const YkFound *found = &a.synthesis->defects.items[k];
            if (found->defect != YK_DEFECT_BRANCH && found->defect != YK_DEFECT_CIRCUIT) continue;
            for (int sense = -1; sense <= 1; sense++) {
                double input[5], angle[3];
                YkVerdict verdict;
                YkText model = {0};
                YkJourney journey = {.task = a.task, .input = input, .count = count, .pose = pose, .exact = true};
                for (size_t i = 0; i < count; i++) {
                    yk_design_angles(&found->design, pose[i], angle);
                    input[i] = i == 0 ? angle[0] : input[i - 1] + yk_remainder(angle[0] - input[i - 1], 2 * YK_PI);
                    if (i > 0 && sense * (input[i] - input[i - 1]) < 0) input[i] += sense * 2 * YK_PI;
                }
                yk_design_write(&found->design, &journey, &model);
                assert_int_equal(yk_design_judge(yk_text_get(&model), &found->design, &journey, &verdict), YK_OK);
                assert_int_not_equal(verdict.defect, YK_DEFECT_NONE);
                yk_text_free(&model);
                tried++;
            }
        }
        answer_free(&a);
    }
    assert_true(tried > check_cases(100));
}

static void what_the_signs_leave_out_the_engine_cannot_drive(void **state)
{
    (void)state;
    signs_agree_with_the_engine(12, (int)check_cases(40), 5, "");
    signs_agree_with_the_engine(16, 2, 4, "mechanisms: [slider-crank]\n");
    signs_agree_with_the_engine(21, 2, 4, "mechanisms: [inverted-slider-crank]\n");
}

static void three_positions_with_pivots_have_one_machine_or_a_reason(void **state)
{
    (void)state;
    static const YkPose pose[3] = {{.at = {0, 0}, .angle = 0},
                                   {.at = {.5, 1}, .angle = 20 * YK_PI / 180},
                                   {.at = {1.5, 1.5}, .angle = 35 * YK_PI / 180}};
    Answer a = answer_to(
        "synthesis: motion\nfix: {input_pivot: [0, -1], output_pivot: [2, 0]}\npositions:\n"
        "  - {at: [0, 0], angle: 0}\n  - {at: [.5, 1], angle: 20 deg}\n  - {at: [1.5, 1.5], angle: 35 deg}\n");
    assert_int_equal(yk_synthesis_count(a.synthesis), 1);
    assert_true(yk_synthesis_is_complete(a.synthesis));
    YkCandidate c = yk_synthesis_candidate(a.synthesis, 0);
    CHECK_NEAR(c.pivots[0][1], -1, 1e-12);
    CHECK_NEAR(c.pivots[1][0], 2, 1e-12);
    check_passes(c.model, pose, 3, true);
    answer_free(&a);
}

static void two_and_four_positions_are_sampled_and_every_candidate_passes(void **state)
{
    (void)state;
    check_without_sanitizers();
    uint64_t seed = 13;
    for (size_t count = 2; count <= 4; count += 2) {
        YkPose pose[5] = {{.angle = 0}};
        double lengths[4];
        char text[2000];
        crank_rocker_poses(pose, count, lengths, &seed);
        write_task(text, sizeof text, pose, count);
        YkSynthesisOptions options = yk_default_synthesis_options();
        options.best = 12;
        Answer a = answer_with(text, &options), b = answer_with(text, &options);
        assert_false(yk_synthesis_is_complete(a.synthesis));
        assert_true(yk_synthesis_count(a.synthesis) >= 3);
        assert_int_equal(yk_synthesis_count(a.synthesis), yk_synthesis_count(b.synthesis));
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            check_passes(c.model, pose, count, true);
            assert_string_equal(c.model,
                                yk_synthesis_candidate(b.synthesis, k).model); // the same seed, the same answer
            if (k > 0) assert_true(c.transmission[0] <= yk_synthesis_candidate(a.synthesis, k - 1).transmission[0]);
        }
        answer_free(&a);
        answer_free(&b);
    }
}

// Positions of a slider-crank's coupler; `line` is the direction of its slider's line.
static void slider_crank_poses(YkPose *pose, size_t count, double *line, uint64_t *seed)
{
    double a = check_uniform(seed, .4, .8), b = check_uniform(seed, 1.2, 2), offset = check_uniform(seed, -.3, .3);
    double from = check_uniform(seed, -3, 3), step = check_uniform(seed, .3, 1);
    YkVec P = check_vec(seed, -1, 2, -1, 1), at = yk_vec(.3, -.2);
    *line = check_uniform(seed, -1.5, 1.5);
    for (size_t k = 0; k < count; k++) {
        YkVec A = yk_scale(a, yk_unit(from + step * (double)k)), out = yk_unit(*line);
        double angle = yk_asin((offset - A.y) / b);
        pose[k].angle = angle + *line + .3;
        pose[k].at = yk_add(at, yk_mul(out, yk_add(A, yk_mul(yk_unit(angle), P))));
    }
}

static void four_positions_of_a_slider_crank_give_its_line(void **state)
{
    (void)state;
    uint64_t seed = 14;
    size_t passed = 0;
    for (size_t round = 0; round < check_cases(12); round++) {
        YkPose pose[4] = {{.angle = 0}};
        double line, nearest = INFINITY;
        char text[2000];
        slider_crank_poses(pose, 4, &line, &seed);
        write_task(text, sizeof text, pose, 4);
        strcat(text, "mechanisms: [slider-crank]\n");
        Answer a = answer_to(text);
        for (size_t k = 0; k < yk_synthesis_dyad_count(a.synthesis); k++) {
            YkDyad d = yk_synthesis_dyad(a.synthesis, k);
            if (d.kind == YK_DYAD_PR) nearest = fmin(nearest, fabs(yk_sin(d.direction - line)));
        }
        CHECK_NEAR(nearest, 0, 1e-9);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            assert_string_equal(c.mechanism, "slider-crank");
            check_passes(c.model, pose, 4, true);
            passed++;
        }
        answer_free(&a);
    }
    assert_true(passed > 10);
}

static void two_and_three_positions_have_slider_cranks_that_pass(void **state)
{
    (void)state;
    uint64_t seed = 15;
    for (size_t count = 2; count <= 3; count++) {
        YkPose pose[4] = {{.angle = 0}};
        double line;
        char text[2000];
        slider_crank_poses(pose, count, &line, &seed);
        write_task(text, sizeof text, pose, count);
        strcat(text, "mechanisms: [slider-crank]\n");
        YkSynthesisOptions options = yk_default_synthesis_options();
        options.best = 12;
        Answer a = answer_with(text, &options);
        assert_true(yk_synthesis_count(a.synthesis) >= 3);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            assert_string_equal(c.mechanism, "slider-crank");
            check_passes(c.model, pose, count, true);
        }
        answer_free(&a);
    }
}

// Positions of the coupler of an inverted slider-crank whose crank turns through; it slides through a block at (2, 0).
static void inverted_poses(YkPose *pose, size_t count, uint64_t *seed)
{
    double a = check_uniform(seed, .4, .9), e = check_uniform(seed, -.3, .3), turn = check_uniform(seed, -3, 3);
    double px = check_uniform(seed, -1, 2), py = check_uniform(seed, -1, 1);
    YkVec P = yk_vec(px, py);
    double from = check_uniform(seed, -3, 3), step = check_uniform(seed, .5, 1.2);
    for (size_t k = 0; k < count; k++) {
        YkVec A = yk_scale(a, yk_unit(from + step * (double)k)), D = yk_sub(yk_vec(2, 0), A);
        double angle = yk_atan2(D.y, D.x) - yk_asin(e / yk_norm(D));
        pose[k] = (YkPose){.at = yk_add(A, yk_mul(yk_unit(angle), P)), .angle = angle + turn};
    }
}

static void four_positions_of_an_inverted_slider_crank_give_its_block(void **state)
{
    (void)state;
    uint64_t seed = 8;
    for (uint64_t round = 0; round < check_cases(6); round++) {
        YkPose pose[4] = {{.angle = 0}};
        char text[2000];
        size_t blocks = 0;
        inverted_poses(pose, 4, &seed);
        write_task(text, sizeof text, pose, 4);
        strcat(text, "mechanisms: [inverted-slider-crank]\n");
        Answer a = answer_to(text);
        for (size_t k = 0; k < yk_synthesis_dyad_count(a.synthesis); k++) {
            YkDyad d = yk_synthesis_dyad(a.synthesis, k);
            if (d.kind != YK_DYAD_RP) continue;
            CHECK_NEAR(d.fixed[0], 2, 1e-7);
            CHECK_NEAR(d.fixed[1], 0, 1e-7);
            blocks++;
        }
        assert_int_equal(blocks, 1);
        assert_true(yk_synthesis_count(a.synthesis) > 0);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis) && k < 4; k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            assert_string_equal(c.mechanism, "inverted-slider-crank");
            assert_true(c.error < 1e-16 && c.transmission[0] > 0);
            check_passes(c.model, pose, 4, true);
        }
        answer_free(&a);
    }
}

static void two_and_three_positions_have_inverted_slider_cranks_that_pass(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (size_t count = 2; count <= 3; count++) {
        YkPose pose[3] = {{.angle = 0}};
        char text[2000];
        inverted_poses(pose, count, &seed);
        write_task(text, sizeof text, pose, count);
        strcat(text, "mechanisms: [inverted-slider-crank]\n");
        Answer a = answer_to(text);
        assert_true(yk_synthesis_count(a.synthesis) > 1);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis) && k < 5; k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            assert_true(c.error < 1e-16);
            check_passes(c.model, pose, count, true);
        }
        answer_free(&a);
    }
}

// The coupler of a crank-rocker with ground 2, crank .4, coupler 1.9, output 1.5 at a crank's angle.
static YkPose crank_rocker_at(YkVec P, double crank)
{
    YkVec A = yk_scale(.4, yk_unit(crank)), AF = yk_sub(yk_vec(2, 0), A);
    double f = yk_norm(AF), angle = yk_atan2(AF.y, AF.x) + yk_acos((1.9 * 1.9 + f * f - 1.5 * 1.5) / (2 * 1.9 * f));
    return (YkPose){.at = yk_add(A, yk_mul(yk_unit(angle), P)), .angle = angle + .3};
}

// Its velocity and rate there, from four neighbours.
static YkPose crank_rocker_rate(YkVec P, double crank)
{
    static const double weight[] = {1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12}, offset[] = {-2, -1, 1, 2};
    YkPose rate = crank_rocker_at(P, crank);
    rate.is_rate = true;
    for (int i = 0; i < 4; i++) {
        YkPose near = crank_rocker_at(P, crank + 1e-3 * offset[i]);
        rate.velocity = yk_add(rate.velocity, yk_scale(weight[i] / 1e-3, near.at));
        rate.rate += weight[i] / 1e-3 * near.angle;
    }
    return rate;
}

// Positions and rates of a crank-rocker give its two dyads again: two positions with a rate and given pivots, or three
// with two.
static void rates_are_limits_of_positions(void **state)
{
    (void)state;
    uint64_t seed = 31;
    for (uint64_t round = 0; round < 2 * check_cases(4); round++) {
        YkPose pose[3], rate[2];
        char text[2000];
        double from = check_uniform(&seed, -3, 3), step = check_uniform(&seed, .4, .9);
        double px = check_uniform(&seed, -1, 2), py = check_uniform(&seed, -1, 1);
        YkVec P = yk_vec(px, py);
        bool has_pivots = round % 2;
        size_t count = has_pivots ? 2 : 3, rates = has_pivots ? 1 : 2, hits = 0, good = 0;
        for (size_t k = 0; k < count; k++) pose[k] = crank_rocker_at(P, from + step * (double)k);
        for (size_t k = 0; k < rates; k++) rate[k] = crank_rocker_rate(P, from + step * (double)(k * (count - 1)));
        write_task(text, sizeof text, pose, count);
        strcat(text, has_pivots ? "fix: {input_pivot: [0, 0], output_pivot: [2, 0]}\nrates:\n" : "rates:\n");
        for (size_t k = 0; k < rates; k++) { // up to a factor
            size_t at = strlen(text);
            snprintf(text + at, sizeof text - at, "  - {position: %d, velocity: [%.17g, %.17g], rate: %.17g}\n",
                     (int)(1 + k * (count - 1)), 3 * rate[k].velocity.x, 3 * rate[k].velocity.y, 3 * rate[k].rate);
        }
        Answer a = answer_to(text);
        for (size_t k = 0; k < yk_synthesis_dyad_count(a.synthesis); k++) {
            YkDyad d = yk_synthesis_dyad(a.synthesis, k);
            hits += d.kind == YK_DYAD_RR && hypot(d.fixed[0], d.fixed[1]) < 1e-6 && fabs(d.length - .4) < 1e-6;
            hits += d.kind == YK_DYAD_RR && hypot(d.fixed[0] - 2, d.fixed[1]) < 1e-6 && fabs(d.length - 1.5) < 1e-6;
        }
        assert_int_equal(hits, 2);
        for (size_t k = 0; k < yk_synthesis_count(a.synthesis); k++) {
            YkCandidate c = yk_synthesis_candidate(a.synthesis, k);
            good += fabs(c.lengths[0] - 2) < 1e-5 && fabs(c.lengths[2] - 1.9) < 1e-5;
            check_passes(c.model, pose, count, true);
        }
        assert_true(good >= 1);
        assert_true(yk_synthesis_is_complete(a.synthesis));
        answer_free(&a);
    }
}

static void bounds_and_requirements_leave_out_what_breaks_them(void **state)
{
    (void)state;
    char text[2000];
    snprintf(text, sizeof text, "%srequire: {transmission: 50 deg}\n", five);
    Answer a = answer_to(text);
    assert_int_equal(yk_synthesis_count(a.synthesis), 1);
    assert_int_equal(yk_synthesis_left_out(a.synthesis, YK_DEFECT_TRANSMISSION), 2);
    answer_free(&a);
    snprintf(text, sizeof text, "%srequire: {input: turns}\n", five);
    a = answer_to(text);
    assert_int_equal(yk_synthesis_count(a.synthesis), 2);
    for (size_t k = 0; k < 2; k++) assert_string_equal(yk_synthesis_candidate(a.synthesis, k).type, "crank-rocker");
    assert_true(yk_synthesis_left_out(a.synthesis, YK_DEFECT_INPUT) >= 1);
    answer_free(&a);
    snprintf(text, sizeof text, "%sbounds: {lengths: [1, 5]}\n", five);
    a = answer_to(text);
    assert_int_equal(yk_synthesis_count(a.synthesis), 1);
    answer_free(&a);
    snprintf(text, sizeof text, "%srequire: {size_ratio: 2}\n", five);
    a = answer_to(text);
    assert_int_equal(yk_synthesis_count(a.synthesis), 0);
    assert_true(yk_synthesis_left_out(a.synthesis, YK_DEFECT_SIZE) > 0);
    assert_null(yk_synthesis_candidate(a.synthesis, 0).model);
    answer_free(&a);
}

static size_t dyads_of(const char *positions, const char *mechanisms, YkDyadKind kind)
{
    char text[600];
    size_t count = 0;
    snprintf(text, sizeof text, "synthesis: motion\nmechanisms: [%s]\n%s", mechanisms, positions);
    Answer a = answer_to(text);
    for (size_t k = 0; k < yk_synthesis_dyad_count(a.synthesis); k++)
        count += yk_synthesis_dyad(a.synthesis, k).kind == kind;
    answer_free(&a);
    return count;
}

// A pair has one slide: where four-bars are not sought there are more of them, so that as many pairs are tried.
static void machines_with_slides_alone_get_a_fair_sample(void **state)
{
    (void)state;
    check_without_sanitizers();
    static const char three[] =
        "positions: [{at: [0, 0], angle: 0}, {at: [60, 45], angle: 15 deg}, {at: [140, 50], angle: -10 deg}]\n";
    static const char four[] =
        "positions: [{at: [0, 0], angle: 0 deg}, {at: [30, 10], angle: 20 deg}, {at: [60, 12], angle: 45 deg},\n"
        "            {at: [80, 0], angle: 80 deg}]\n";
    size_t few = dyads_of(three, "four-bar, slider-crank", YK_DYAD_PR),
           more = dyads_of(three, "slider-crank", YK_DYAD_PR);
    assert_true(few > 4 && more > 3 * few);
    more = dyads_of(three, "inverted-slider-crank", YK_DYAD_RP);
    assert_true(more > 3 * dyads_of(three, "four-bar, inverted-slider-crank", YK_DYAD_RP));
    few = dyads_of(four, "four-bar", YK_DYAD_RR);
    more = dyads_of(four, "slider-crank", YK_DYAD_RR);
    assert_true(few > 40 && more > 7 * few);
}

static bool stop_at_once(void *context, double part)
{
    (void)part;
    return ++*(int *)context < 3;
}

static void a_search_that_is_stopped_keeps_what_it_has(void **state)
{
    (void)state;
    int asked = 0;
    YkSynthesisOptions options = yk_default_synthesis_options();
    options.progress = (YkProgress){stop_at_once, &asked};
    Answer a =
        answer_with("synthesis: motion\npositions: [{at: [0, 0], angle: 0}, {at: [1, 0], angle: 50 deg}]\n", &options);
    assert_true(yk_synthesis_was_stopped(a.synthesis));
    assert_false(yk_synthesis_is_complete(a.synthesis));
    answer_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_published_positions_have_six_four_bars_and_three_pass),
        cmocka_unit_test(a_crank_rocker_is_found_again_among_the_candidates),
        cmocka_unit_test(what_the_signs_leave_out_the_engine_cannot_drive),
        cmocka_unit_test(three_positions_with_pivots_have_one_machine_or_a_reason),
        cmocka_unit_test(two_and_four_positions_are_sampled_and_every_candidate_passes),
        cmocka_unit_test(four_positions_of_a_slider_crank_give_its_line),
        cmocka_unit_test(two_and_three_positions_have_slider_cranks_that_pass),
        cmocka_unit_test(four_positions_of_an_inverted_slider_crank_give_its_block),
        cmocka_unit_test(two_and_three_positions_have_inverted_slider_cranks_that_pass),
        cmocka_unit_test(machines_with_slides_alone_get_a_fair_sample),
        cmocka_unit_test(rates_are_limits_of_positions),
        cmocka_unit_test(bounds_and_requirements_leave_out_what_breaks_them),
        cmocka_unit_test(a_search_that_is_stopped_keeps_what_it_has),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
