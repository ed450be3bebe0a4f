// An angle that follows another: four-bars through three, four or five pairs of angles.
//
// Seen from the input, the output is a body in motion, and the coupler is a dyad that takes it through its positions. The
// ground is another one. Five pairs thus have the four dyads of five positions, one of them the ground: at most three
// four-bars. Four pairs leave the phase of one angle free, three the phases of both; these are sampled unless given.
// Source: Freudenstein 1955; the inversion: Hartenberg & Denavit 1964, ch. 10.
#include <math.h>
#include "base/mix.h"
#include "num/dense.h"
#include "synthesis/even.h"
#include "synthesis/synthesis.h"

enum { RAYS = 720, PHASES = 40, STOPS = YK_PAIRS_MAX + 2 };

// The positions of one side's link seen from the other (held), with the ground from (0, 0) to (1, 0).
static void relative_poses(const YkFunctionTask *f, size_t held, YkPose *pose)
{
    for (size_t k = 0; k < f->count; k++) {
        double turned = f->pair[k][held], other = f->pair[k][1 - held];
        YkVec at = yk_mul(yk_unit(-turned), yk_vec(held == 0 ? 1 : -1, 0));
        pose[k] = (YkPose){.at = at, .angle = other - turned};
    }
}

// The four-bar whose links end at A, seen from the input, and B, seen from the output, where both angles begin. There the
// coupler closes only nearly, unless the range begins at a pair.
static YkDesign make(const YkFunctionTask *f, YkVec A, YkVec B, double coupler)
{
    double scale = f->ground.is_given ? f->ground.value : 1;
    YkVec across = yk_sub(yk_add(yk_vec(1, 0), B), A);
    YkDesign design = {.kind = YK_DESIGN_FOUR_BAR, .dyad = {-1, -1}};
    double length[4] = {1, yk_norm(A), coupler, yk_norm(B)};
    for (size_t k = 0; k < 4; k++) design.length[k] = scale * length[k];
    design.pivot[1] = yk_vec(scale, 0);
    design.angle[0] = yk_atan2(A.y, A.x);
    design.angle[1] = yk_atan2(across.y, across.x);
    design.angle[2] = yk_atan2(B.y, B.x);
    return design;
}

// Angles of the four-bar at pair k.
static void angles_at(const YkFunctionTask *f, const YkDesign *design, size_t k, double angle[3])
{
    angle[0] = design->angle[0] + f->pair[k][0];
    angle[2] = design->angle[2] + f->pair[k][1];
    YkVec A = yk_scale(design->length[1], yk_unit(angle[0])), B = yk_scale(design->length[3], yk_unit(angle[2]));
    YkVec across = yk_sub(yk_add(design->pivot[1], B), A);
    angle[1] = yk_atan2(across.y, across.x);
}

// The size of a peak near a row: that of the polynomial through five rows about it.
static double peak_near(const YkVerdict *verdict, size_t r)
{
    size_t middle = r < 2 ? 2 : r + 3 > verdict->rows ? verdict->rows - 3 : r;
    const double *y = &verdict->curve[2 * middle + 1];
    double a = y[-4], b = y[-2], c = y[0], d = y[2], e = y[4], x = (double)r - (double)middle;
    double c1 = (a - 8 * b + 8 * d - e) / 12, c2 = (-a + 16 * b - 30 * c + 16 * d - e) / 24;
    double c3 = (-a + 2 * b - 2 * d + e) / 12, c4 = (a - 4 * b + 6 * c - 4 * d + e) / 24, start = x;
    for (int k = 0; k < 4; k++) {
        double bend = 2 * c2 + x * (6 * c3 + 12 * x * c4);
        double to = x - (c1 + x * (2 * c2 + x * (3 * c3 + 4 * x * c4))) / bend;
        if (!(fabs(to - start) <= 1)) break; // no peak between the rows beside it
        x = to;
    }
    return fabs(c + x * (c1 + x * (c2 + x * (c3 + x * c4))));
}

// Replaces the curve's outputs by their errors, and returns the largest, between the rows as well.
static double structural_error(const YkTask *task, const YkDesign *design, YkVerdict *verdict)
{
    const YkFunctionTask *f = &task->function;
    double at_start = 0, at_end = 1, worst = 0;
    yk_task_function(task, f->range.low, &at_start);
    yk_task_function(task, f->range.high, &at_end);
    for (size_t r = 0; r < verdict->rows; r++) {
        double *row = &verdict->curve[2 * r], turned = row[0] - design->angle[0], value = NAN;
        yk_task_function(task, f->range.low + turned / f->input * (f->range.high - f->range.low), &value);
        double wanted = (value - at_start) / (at_end - at_start) * f->output;
        row[0] = turned;
        row[1] = yk_remainder(row[1] - design->angle[2] - wanted, 2 * YK_PI);
        if (isnan(row[1])) return INFINITY;
    }
    for (size_t r = 0; r < verdict->rows; r++) {
        double here = verdict->curve[2 * r + 1];
        worst = fmax(worst, fabs(here));
        if (r == 0 || r + 1 == verdict->rows || verdict->rows < 5) continue;
        double before = verdict->curve[2 * r - 1], after = verdict->curve[2 * r + 3];
        if (fabs(here) >= fabs(before) && fabs(here) >= fabs(after)) worst = fmax(worst, peak_near(verdict, r));
    }
    return worst;
}

// Judges a four-bar over the range, or from the first pair to the last. Returns it if it passes, NULL otherwise.
static YkFound *take(YkSynthesis *s, const YkFunctionTask *f, const YkDesign *design)
{
    const YkTask *task = s->task;
    YkFound *found = NULL;
    double input[STOPS], output[STOPS], angle[YK_PAIRS_MAX][3];
    YkJourney journey = {.task = task, .input = input, .output = output, .exact = true, .turns = task->turns};
    YkVerdict verdict = {.defect = YK_DEFECT_NONE};
    YkText text = {0};
    if (f->of) {
        output[journey.count] = NAN;
        input[journey.count++] = design->angle[0];
    }
    for (size_t k = 0; k < f->count; k++) {
        angles_at(f, design, k, angle[k]);
        input[journey.count] = angle[k][0];
        output[journey.count++] = angle[k][2];
    }
    if (f->of) {
        output[journey.count] = NAN;
        input[journey.count++] = design->angle[0] + f->input;
    }
    YkDefect defect = yk_design_bounds(design, task);
    if (defect == YK_DEFECT_NONE) defect = yk_design_signs(design, angle, f->count);
    if (defect == YK_DEFECT_NONE && task->turns && !yk_design_turns(design)) defect = YK_DEFECT_INPUT;
    if (defect == YK_DEFECT_NONE) defect = yk_synthesis_try(s, design, &journey, &text, &verdict);
    if (defect == YK_DEFECT_NONE && f->of) verdict.worst = structural_error(task, design, &verdict);
    if (defect == YK_DEFECT_NONE)
        found = yk_synthesis_keep(s, design, &text, &verdict, f->of ? -verdict.worst : verdict.transmission[0]);
    else
        yk_synthesis_leave(s, design, defect, &verdict);
    yk_text_free(&text);
    return found;
}

// Takes the four-bar nearby with the least largest error, which meets five other points of the function. Returns false if
// there is none.
static bool take_evened(YkSynthesis *s, const YkDesign *design)
{
    YkFunctionTask f = s->task->function;
    const double *length = design->length;
    YkGenerator bar = {length[1] / length[0], length[2] / length[0], length[3] / length[0], design->angle[0],
                       design->angle[2]};
    double before = NAN;
    if (!f.evened || !yk_even_out(s->task, &bar, f.pair, &before)) return false;
    YkVec A = yk_scale(bar.input, yk_unit(bar.phi)), B = yk_scale(bar.output, yk_unit(bar.psi));
    YkDesign even = make(&f, A, B, bar.coupler);
    YkFound *found = take(s, &f, &even);
    if (found) found->interpolating = before;
    return true;
}

// --- five and four pairs: dyads

// Takes a dyad of the link seen from `held` as a coupler; not the ground, which joins the two fixed pivots.
static bool take_dyad(YkSynthesis *s, const YkDyad *dyad, size_t held)
{
    YkVec fixed = yk_vec(dyad->fixed[0], dyad->fixed[1]), moving = yk_vec(dyad->moving[0], dyad->moving[1]);
    if (dyad->kind != YK_DYAD_RR || yk_norm(fixed) + yk_norm(moving) < 1e-6) return false;
    if (yk_norm(fixed) < 1e-6 || yk_norm(moving) < 1e-6 || dyad->length < 1e-6) return true;
    YkDesign design = make(&s->task->function, held == 0 ? fixed : moving, held == 0 ? moving : fixed, dyad->length);
    if (!take_evened(s, &design)) take(s, &s->task->function, &design);
    return true;
}

static bool take_five(YkSynthesis *s, YkProblems *problems)
{
    YkPose pose[YK_POSES_MAX];
    YkFivePoses five;
    relative_poses(&s->task->function, 0, pose);
    yk_five_poses(pose, &five);
    if (five.is_special) {
        yk_problem(problems, YK_CODE_TASK_SPECIAL, s->task->function.place,
                   "these five pairs are special: infinitely many four-bars, or simpler machines, meet all of them");
        yk_problem_hint(problems, "a gear pair or a parallelogram gives output in proportion to input");
        return false;
    }
    s->has_solutions = s->is_complete = true;
    s->complex_count = five.complex_count > 0 ? five.complex_count - 1 : 0; // one of them is the ground
    for (size_t k = 0; k < five.count; k++)
        if (yk_synthesis_goes_on(s, 1)) s->real_count += take_dyad(s, &five.dyad[k], 0);
    return true;
}

// The curve of moving pivots goes through the other side's fixed pivot, so rays from there are its phases.
static void take_four(YkSynthesis *s)
{
    const YkFunctionTask *f = &s->task->function;
    size_t held = f->phase[0].is_given ? 1 : 0; // the phase of the other side is that of the ray
    const YkGiven *phase = &f->phase[1 - held];
    uint64_t seed = s->options.seed;
    double from = yk_mix_unit(&seed);
    YkPose pose[YK_POSES_MAX];
    YkFourPoses four;
    YkDyad dyad[2];
    relative_poses(f, held, pose);
    yk_four_poses(pose, &four);
    four.pole = yk_vec(0, 0);
    for (size_t k = 0; k < (phase->is_given ? 1 : RAYS); k++) {
        double angle = phase->is_given ? phase->value : YK_PI * ((double)k + from) / RAYS;
        size_t count = yk_four_poses_ray(&four, angle, dyad);
        for (size_t i = 0; i < count; i++) take_dyad(s, &dyad[i], held);
        yk_pace_reach(&s->pace, (double)k / RAYS);
        if (!yk_synthesis_goes_on(s, 20)) return;
    }
    s->is_complete = phase->is_given;
}

// --- three pairs: Freudenstein's equation K1 cos psi - K2 cos phi + K3 = cos(phi - psi), linear in K

static void take_phases(YkSynthesis *s, double phi, double psi)
{
    const YkFunctionTask *f = &s->task->function;
    double A[9], K[3], scale[3];
    int pivot[3];
    for (size_t k = 0; k < 3; k++) {
        double input = phi + f->pair[k][0], output = psi + f->pair[k][1];
        A[3 * k] = yk_cos(output);
        A[3 * k + 1] = -yk_cos(input);
        A[3 * k + 2] = 1;
        K[k] = yk_cos(input - output);
    }
    if (fabs(yk_lu_factor(3, A, pivot, scale)) < 1e-10) return;
    yk_lu_solve(3, A, pivot, K);
    if (fabs(K[0]) < 1e-6 || fabs(K[1]) < 1e-6) return; // a link without end
    double a = 1 / K[0], c = 1 / K[1], b2 = a * a + c * c + 1 - 2 * a * c * K[2];
    // A negative length is a link half a turn ahead.
    YkDesign design = make(f, yk_scale(a, yk_unit(phi)), yk_scale(c, yk_unit(psi)), sqrt(fmax(b2, 0)));
    if (!(b2 > 1e-12))
        yk_synthesis_leave(s, &design, YK_DEFECT_ASSEMBLY, &(YkVerdict){.defect = YK_DEFECT_ASSEMBLY});
    else
        take(s, f, &design);
}

static void take_three(YkSynthesis *s)
{
    const YkFunctionTask *f = &s->task->function;
    uint64_t seed = s->options.seed;
    double from[2] = {yk_mix_unit(&seed), 0};
    from[1] = yk_mix_unit(&seed);
    size_t count[2];
    for (size_t i = 0; i < 2; i++) count[i] = f->phase[i].is_given ? 1 : PHASES;
    for (size_t i = 0; i < count[0]; i++)
        for (size_t k = 0; k < count[1]; k++) {
            double phi = f->phase[0].is_given ? f->phase[0].value : YK_PI * ((double)i + from[0]) / PHASES;
            double psi = f->phase[1].is_given ? f->phase[1].value : YK_PI * ((double)k + from[1]) / PHASES;
            take_phases(s, phi, psi);
            yk_pace_reach(&s->pace, (double)i / (double)count[0]);
            if (!yk_synthesis_goes_on(s, 5)) return;
        }
    s->is_complete = f->phase[0].is_given && f->phase[1].is_given;
}

bool yk_synthesise_function(YkSynthesis *s, YkProblems *problems)
{
    const YkFunctionTask *f = &s->task->function;
    if (f->count == 5) return take_five(s, problems);
    if (f->count == 4)
        take_four(s);
    else
        take_three(s);
    return true;
}
