// An angle or a slider that follows an angle: machines through three, four or five pairs.
//
// Seen from the input, the output is a body in motion, and the coupler is a dyad that takes it through its positions.
// The ground is another one. Five pairs thus have the four dyads of five positions, one of them the ground: at most
// three four-bars. Four pairs leave the phase of one angle free, three the phases of both; these are sampled unless
// given.
// A slider is such a body, too: it has no turn but the input's, and the ground is the dyad of its line. So five pairs
// have at most three slider-cranks, too.
// Source: Freudenstein 1955; the inversion: Hartenberg & Denavit 1964, ch. 10.
#include <math.h>
#include <string.h>
#include "base/mix.h"
#include "num/dense.h"
#include "synthesis/even.h"
#include "synthesis/synthesis.h"

enum { RAYS = 720, PHASES = 40, STOPS = YK_PAIRS_MAX + 2 };

// The positions of one side's link seen from the other (held), with the ground from (0, 0) to (1, 0).
static void relative_poses(const YkFunctionTask *f, size_t held, YkPose *pose)
{
    for (size_t k = 0; k < f->count; k++) {
        if (f->is_slider) {
            double turned = held == 0 ? -f->pair[k][0] : 0;
            YkVec at = yk_vec(held == 0 ? f->pair[k][1] : -f->pair[k][1], 0);
            pose[k] = (YkPose){.at = yk_mul(yk_unit(turned), at), .angle = held == 0 ? turned : f->pair[k][0]};
            continue;
        }
        double turned = f->pair[k][held], other = f->pair[k][1 - held];
        YkVec at = yk_mul(yk_unit(-turned), yk_vec(held == 0 ? 1 : -1, 0));
        pose[k] = (YkPose){.at = at, .angle = other - turned};
    }
}

// The slider-crank whose crank ends at A where both begin, and whose slider's pin is then at B.
static YkDesign make_slider(YkVec A, YkVec B, double coupler)
{
    YkVec across = yk_sub(B, A);
    YkDesign design = {.kind = YK_DESIGN_SLIDER_CRANK, .dyad = {-1, -1}, .length = {0, yk_norm(A), coupler, 0}};
    design.pivot[1] = yk_vec(0, B.y);
    design.angle[0] = yk_atan2(A.y, A.x);
    design.angle[1] = yk_atan2(across.y, across.x);
    design.angle[2] = B.x;
    return design;
}

// The four-bar whose links end at A, seen from the input, and B, seen from the output, where both angles begin. There
// the coupler closes only nearly, unless the range begins at a pair.
static YkDesign make(const YkFunctionTask *f, YkVec A, YkVec B, double coupler)
{
    if (f->is_slider) return make_slider(A, B, coupler);
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
    if (f->is_slider) B = yk_vec(angle[2], 0);
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
static double structural_error(const YkTask *task, const YkFunctionTask *f, const YkDesign *design, YkVerdict *verdict)
{
    double at_start = 0, at_end = 1, worst = 0;
    yk_task_function(task, f->range.low, &at_start);
    yk_task_function(task, f->range.high, &at_end);
    for (size_t r = 0; r < verdict->rows; r++) {
        double *row = &verdict->curve[2 * r], turned = row[0] - design->angle[0], value = NAN;
        yk_task_function(task, f->range.low + turned / f->input * (f->range.high - f->range.low), &value);
        double wanted = (value - at_start) / (at_end - at_start) * f->output;
        row[0] = turned;
        row[1] -= design->angle[2] + wanted;
        if (!f->is_slider) row[1] = yk_remainder(row[1], 2 * YK_PI);
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
    if (defect == YK_DEFECT_NONE && f->of) verdict.worst = structural_error(task, f, design, &verdict);
    if (defect == YK_DEFECT_NONE)
        found = yk_synthesis_keep(s, design, &text, &verdict,
                                  f->of ? -verdict.worst / fabs(f->output) : verdict.transmission[0]);
    else
        yk_synthesis_leave(s, design, defect, &verdict);
    yk_text_free(&text);
    return found;
}

// Takes the machine nearby with the least largest error, which meets five other points of the function. Returns false
// if there is none.
static bool take_evened(YkSynthesis *s, const YkFunctionTask *own, const YkDesign *design)
{
    YkFunctionTask f = *own;
    const double *length = design->length;
    double scale = f.is_slider ? 1 : length[0], output = f.is_slider ? design->pivot[1].y : length[3];
    YkGenerator bar = {length[1] / scale, length[2] / scale, output / scale, design->angle[0], design->angle[2]};
    double before = NAN, errors[2 * YK_EVEN_ROWS];
    if (!f.evened || !yk_even_out(s->task, &f, &bar, &before, errors)) return false;
    YkVec A = yk_scale(bar.input, yk_unit(bar.phi)), B = yk_scale(bar.output, yk_unit(bar.psi));
    if (f.is_slider) B = yk_vec(bar.psi, bar.output);
    YkDesign even = make(&f, A, B, bar.coupler);
    YkFound *found = take(s, &f, &even);
    if (!found) return true;
    double *kept = YK_NEW(s->arena, double, 2 * YK_EVEN_ROWS);
    if (kept) memcpy(kept, errors, sizeof errors);
    found->before = kept;
    found->interpolating = before;
    return true;
}

// --- five and four pairs: dyads

// Takes a dyad of the link seen from `held` as a coupler; not the ground, which joins the two fixed pivots.
static bool take_dyad(YkSynthesis *s, const YkFunctionTask *f, const YkDyad *dyad, size_t held)
{
    YkVec fixed = yk_vec(dyad->fixed[0], dyad->fixed[1]), moving = yk_vec(dyad->moving[0], dyad->moving[1]);
    double small = 1e-6 * (f->is_slider ? fabs(f->output) : 1);
    bool has_output = f->is_slider || yk_norm(held == 0 ? moving : fixed) >= small;
    if (dyad->kind != YK_DYAD_RR || (!f->is_slider && yk_norm(fixed) + yk_norm(moving) < small)) return false;
    if (yk_norm(held == 0 ? fixed : moving) < small || !has_output || dyad->length < small) return true;
    YkDesign design = make(f, held == 0 ? fixed : moving, held == 0 ? moving : fixed, dyad->length);
    if (!take_evened(s, f, &design)) take(s, f, &design);
    return true;
}

static bool take_five(YkSynthesis *s, const YkFunctionTask *f, YkProblems *problems)
{
    YkPose pose[YK_POSES_MAX];
    YkFivePoses five;
    relative_poses(f, 0, pose);
    yk_five_poses(pose, &five);
    if (five.is_special) {
        yk_problem(problems, YK_CODE_TASK_SPECIAL, f->place,
                   "these five pairs are special: infinitely many machines, or simpler ones, meet all of them");
        yk_problem_hint(problems, f->is_slider ? "a rack and pinion gives travel in proportion to the input"
                                               : "a gear pair or a parallelogram gives output in proportion to input");
        return false;
    }
    s->has_solutions = true;
    size_t ground = f->is_slider ? 0 : 1; // one of them; of a slider it is a line
    s->complex_count += five.complex_count > ground ? five.complex_count - ground : 0;
    for (size_t k = 0; k < five.count; k++)
        if (yk_synthesis_goes_on(s, 1)) s->real_count += take_dyad(s, f, &five.dyad[k], 0);
    return true;
}

// The curve of moving pivots goes through the other side's fixed pivot, so rays from there are its phases.
static bool take_four(YkSynthesis *s, const YkFunctionTask *f)
{
    // The phase of the other side is that of the ray; a slider has none.
    size_t held = f->phase[0].is_given || f->is_slider ? 1 : 0;
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
        for (size_t i = 0; i < count; i++) take_dyad(s, f, &dyad[i], held);
        yk_pace_reach(&s->pace, (double)k / RAYS);
        if (!yk_synthesis_goes_on(s, 20)) return false;
    }
    return phase->is_given;
}

// --- three pairs: Freudenstein's equation K1 cos psi - K2 cos phi + K3 = cos(phi - psi), linear in K; that of a slider
// at s is K1 s cos phi + K2 sin phi - K3 = s^2, K = (2 a, 2 a e, a^2 + e^2 - b^2)

static void add_equation(const YkFunctionTask *f, double input, double output, double A[3], double *right)
{
    A[0] = f->is_slider ? output * yk_cos(input) : yk_cos(output);
    A[1] = f->is_slider ? yk_sin(input) : -yk_cos(input);
    A[2] = f->is_slider ? -1 : 1;
    *right = f->is_slider ? output * output : yk_cos(input - output);
}

static void take_phases(YkSynthesis *s, const YkFunctionTask *f, double phi, double psi)
{
    double A[9], K[3], scale[3], size = f->is_slider ? fabs(f->output) : 1;
    int pivot[3];
    for (size_t k = 0; k < 3; k++) add_equation(f, phi + f->pair[k][0], psi + f->pair[k][1], &A[3 * k], &K[k]);
    if (fabs(yk_lu_factor(3, A, pivot, scale)) < 1e-10 * size) return;
    yk_lu_solve(3, A, pivot, K);
    if (fabs(K[0]) < 1e-6 * size || (!f->is_slider && fabs(K[1]) < 1e-6)) return; // a link without end, or none
    double a = f->is_slider ? K[0] / 2 : 1 / K[0], c = f->is_slider ? K[1] / K[0] : 1 / K[1];
    double b2 = f->is_slider ? a * a + c * c - K[2] : a * a + c * c + 1 - 2 * a * c * K[2];
    // A negative length is a link half a turn ahead.
    YkVec B = f->is_slider ? yk_vec(psi, c) : yk_scale(c, yk_unit(psi));
    YkDesign design = make(f, yk_scale(a, yk_unit(phi)), B, sqrt(fmax(b2, 0)));
    if (!(b2 > 1e-12 * size * size))
        yk_synthesis_leave(s, &design, YK_DEFECT_ASSEMBLY, &(YkVerdict){.defect = YK_DEFECT_ASSEMBLY});
    else
        take(s, f, &design);
}

// Samples what is free: angles over half a turn (the other half repeats them); a slider's place within some travels.
static bool take_three(YkSynthesis *s, const YkFunctionTask *f)
{
    static const double travels = 4;
    uint64_t seed = s->options.seed;
    double from[2] = {yk_mix_unit(&seed), 0};
    from[1] = yk_mix_unit(&seed);
    size_t count[2];
    for (size_t i = 0; i < 2; i++) count[i] = f->phase[i].is_given ? 1 : PHASES;
    for (size_t i = 0; i < count[0]; i++)
        for (size_t k = 0; k < count[1]; k++) {
            double part = ((double)k + from[1]) / PHASES;
            double phi = f->phase[0].is_given ? f->phase[0].value : YK_PI * ((double)i + from[0]) / PHASES;
            double psi = f->phase[1].is_given ? f->phase[1].value
                         : f->is_slider       ? travels * fabs(f->output) * (2 * part - 1)
                                              : YK_PI * part;
            take_phases(s, f, phi, psi);
            yk_pace_reach(&s->pace, (double)i / (double)count[0]);
            if (!yk_synthesis_goes_on(s, 5)) return false;
        }
    return f->phase[0].is_given && f->phase[1].is_given;
}

// Seeks machines of one kind. Returns false with a problem where the pairs are special.
static bool take_kind(YkSynthesis *s, const YkFunctionTask *f, YkProblems *problems)
{
    if (f->count == 5) return take_five(s, f, problems);
    bool is_whole = f->count == 4 ? take_four(s, f) : take_three(s, f);
    s->is_complete = s->is_complete && is_whole;
    return true;
}

// The task as slider-cranks have it: its outputs are lengths in proportion.
static YkFunctionTask for_sliders(const YkFunctionTask *f)
{
    YkFunctionTask own = *f;
    double largest = 0;
    own.is_slider = true;
    if (!f->is_slider) {
        own.output = f->travel.is_given ? f->travel.value : 1;
        for (size_t k = 0; k < f->count; k++) own.pair[k][1] = f->pair[k][1] / f->output * own.output;
        own.phase[1].is_given = false;
    }
    for (size_t k = 0; k < f->count; k++) largest = fmax(largest, fabs(own.pair[k][1] - own.pair[0][1]));
    if (!own.of) own.output = largest;
    return own;
}

bool yk_synthesise_function(YkSynthesis *s, YkProblems *problems)
{
    const YkFunctionTask *f = &s->task->function;
    const YkFunctionTask sliders = for_sliders(f);
    s->is_complete = true;
    if (s->task->has_four_bar && !take_kind(s, f, problems)) return false;
    return !s->task->has_slider || take_kind(s, &sliders, problems);
}
