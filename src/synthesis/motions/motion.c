// A body through positions: all dyads that reach them, and every pair of these as a four-bar or a slider-crank.
#include <math.h>
#include "base/mix.h"
#include "synthesis/synthesis.h"

enum { RAYS = 48, PIVOTS = 48, LINES = 12 };

// Where four-bars are not sought a pair has one slide, and there are few of them: with more rays, or lines, as many
// pairs are tried as four-bars have.
static size_t rays_of(const YkTask *task)
{
    return task->has_four_bar ? RAYS : 8 * RAYS;
}
static size_t lines_of(const YkTask *task)
{
    return task->has_four_bar ? LINES : 4 * LINES; // of half the directions the pivot is near
}

// --- dyads

static bool add_five(YkSynthesis *s, YkProblems *problems)
{
    const YkMotionTask *motion = &s->task->motion;
    YkFivePoses five;
    yk_five_poses(motion->pose, &five);
    if (five.is_special) {
        yk_problem(problems, YK_CODE_TASK_SPECIAL, motion->place[0],
                   "these five positions are special: infinitely many dyads reach all of them");
        yk_problem_hint(problems, "change one of them a little, or leave one out");
        return false;
    }
    for (size_t k = 0; k < five.count; k++) yk_synthesis_add_dyad(s, &five.dyad[k], 3);
    s->has_solutions = s->is_complete = true;
    s->complex_count = five.complex_count;
    for (size_t k = 0; k < five.count; k++) s->real_count += five.dyad[k].kind == YK_DYAD_RR;
    return true;
}

// Rays through the circle-point curve, evenly spaced from an angle that the seed gives.
static void add_four(YkSynthesis *s)
{
    uint64_t seed = s->options.seed;
    double from = yk_mix_unit(&seed);
    YkFourPoses four;
    YkDyad dyad[2];
    yk_four_poses(s->task->motion.pose, &four);
    size_t rays = rays_of(s->task);
    for (size_t k = 0; k < rays; k++) {
        size_t count = yk_four_poses_ray(&four, YK_PI * ((double)k + from) / (double)rays, dyad);
        for (size_t i = 0; i < count; i++) yk_synthesis_add_dyad(s, &dyad[i], 3);
    }
    size_t slides = yk_four_poses_slides(s->task->motion.pose, dyad);
    for (size_t i = 0; i < slides; i++) yk_synthesis_add_dyad(s, &dyad[i], 3);
}

// The region in which free pivots are sought: the task's, or the positions with their extent around them.
static void find_region(const YkTask *task, YkVec *low, YkVec *high)
{
    const YkMotionTask *motion = &task->motion;
    *low = *high = motion->pose[0].at;
    for (size_t k = 1; k < motion->count; k++) {
        YkVec at = motion->pose[k].at;
        *low = yk_vec(fmin(low->x, at.x), fmin(low->y, at.y));
        *high = yk_vec(fmax(high->x, at.x), fmax(high->y, at.y));
    }
    double reach = yk_norm(yk_sub(*high, *low));
    if (!(reach > 0)) reach = 1;
    *low = yk_sub(*low, yk_vec(reach, reach));
    *high = yk_add(*high, yk_vec(reach, reach));
    if (task->pivots[0].is_given) {
        *low = yk_vec(task->pivots[0].low, task->pivots[1].low);
        *high = yk_vec(task->pivots[0].high, task->pivots[1].high);
    }
}

// Returns number k of a sequence that fills the unit cube evenly. Source: Roberts 2018, the generalised golden ratio.
static double filled(double from, size_t k, int dimension)
{
    static const double step[3] = {0.8191725133961644, 0.6710436067037893, 0.5497004779019702};
    double x = from + step[dimension] * (double)(k + 1);
    return x - floor(x);
}

// Two or three positions leave the fixed pivots free, two also the moving pivots on a line.
static void add_few(YkSynthesis *s)
{
    const YkMotionTask *motion = &s->task->motion;
    uint64_t seed = s->options.seed;
    double from[3];
    YkVec low, high;
    YkDyad dyad;
    for (size_t i = 0; i < 3; i++) from[i] = yk_mix_unit(&seed);
    find_region(s->task, &low, &high);
    bool has_both = motion->pivot[0].is_given && motion->pivot[1].is_given;
    for (unsigned side = 0; side < YK_SIDES; side++) {
        size_t choices = motion->conditions == 2 ? PIVOTS : 1;
        for (size_t k = 0; k < choices && motion->pivot[side].is_given; k++)
            if (yk_pose_pivot(motion->pose, motion->conditions, motion->pivot[side].at, 4 * filled(from[2], k, 2) - 2,
                              &dyad))
                yk_synthesis_add_dyad(s, &dyad, 1u << side);
    }
    unsigned open = (motion->pivot[0].is_given ? 0u : 1u) | (motion->pivot[1].is_given ? 0u : 2u);
    for (size_t k = 0; k < PIVOTS && !has_both; k++) {
        YkVec F =
            yk_vec(low.x + (high.x - low.x) * filled(from[0], k, 0), low.y + (high.y - low.y) * filled(from[1], k, 1));
        if (yk_pose_pivot(motion->pose, motion->conditions, F, 4 * filled(from[2], k, 2) - 2, &dyad))
            yk_synthesis_add_dyad(s, &dyad, open);
    }
    s->is_complete = has_both && motion->conditions == 3;
}

// Two or three positions have slides in every direction; they are the output's where its pivot is not given.
static void add_lines(YkSynthesis *s)
{
    const YkMotionTask *motion = &s->task->motion;
    uint64_t seed = s->options.seed;
    double from = yk_mix_unit(&seed);
    size_t lines = lines_of(s->task);
    YkDyad dyad;
    for (size_t k = 0; k < lines && !motion->pivot[1].is_given; k++)
        if (yk_pose_slide(motion->pose, motion->conditions, YK_PI * ((double)k + from) / (double)lines,
                          4 * filled(from, k, 2) - 2, &dyad))
            yk_synthesis_add_dyad(s, &dyad, 2);
}

// The same for blocks that turn about a point of the ground, through which a line of the body goes.
static void add_blocks(YkSynthesis *s)
{
    const YkMotionTask *motion = &s->task->motion;
    uint64_t seed = s->options.seed + 1;
    double from = yk_mix_unit(&seed);
    size_t lines = lines_of(s->task);
    YkDyad dyad;
    for (size_t k = 0; k < lines && !motion->pivot[1].is_given; k++)
        if (yk_pose_block(motion->pose, motion->conditions, YK_PI * ((double)k + from) / (double)lines,
                          4 * filled(from, k, 2) - 2, &dyad))
            yk_synthesis_add_dyad(s, &dyad, 2);
}

// --- pairs

// Takes a pair of dyads, driven from either side that may be the input: a link of the ground, not a slide.
static void take_pair(YkSynthesis *s, size_t i, size_t k)
{
    const YkMotionTask *motion = &s->task->motion;
    const size_t index[YK_SIDES] = {i, k};
    YkPair pair = {.pose = motion->pose, .count = motion->count, .is_motion = true};
    for (size_t side = 0; side < YK_SIDES; side++) {
        size_t other = index[1 - side];
        pair.dyad[side] = s->dyads[index[side]];
        pair.index[side] = (int)index[side];
        pair.may_drive[side] =
            (s->sides[index[side]] & 1) && (s->sides[other] & 2) && pair.dyad[side].kind == YK_DYAD_RR;
    }
    yk_synthesis_take_pair(s, &pair);
}

// Returns whether two kinds of dyads make a machine that the task seeks.
static bool is_sought(const YkSynthesis *s, YkDyadKind a, YkDyadKind b)
{
    if (a == YK_DYAD_RR && b == YK_DYAD_RR) return s->task->has_four_bar;
    if (a != YK_DYAD_RR && b != YK_DYAD_RR) return false;
    YkDyadKind other = a == YK_DYAD_RR ? b : a;
    return s->task->kinds >> (other == YK_DYAD_PR ? YK_DESIGN_SLIDER_CRANK : YK_DESIGN_INVERTED) & 1;
}

bool yk_synthesise_motion(YkSynthesis *s, YkProblems *problems)
{
    size_t count = s->task->motion.conditions;
    if (count == 5 && !add_five(s, problems)) return false;
    if (count == 4) add_four(s);
    if (count < 4) add_few(s);
    if (count < 4 && s->task->has_slider) add_lines(s);
    if (count < 4 && s->task->kinds >> YK_DESIGN_INVERTED & 1) add_blocks(s);
    size_t dyads = s->dyad_count;
    for (size_t i = 0; i < dyads; i++) {
        yk_pace_reach(&s->pace, (double)i * (2 * (double)dyads - (double)i) / ((double)dyads * (double)dyads + 1));
        for (size_t k = i + 1; k < dyads; k++) {
            if (!is_sought(s, s->dyads[i].kind, s->dyads[k].kind)) continue;
            if (!yk_synthesis_goes_on(s, 1)) return true;
            take_pair(s, i, k);
        }
    }
    return true;
}
