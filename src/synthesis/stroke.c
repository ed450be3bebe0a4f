// A swing or a stroke with its time ratio: crank-rockers and slider-cranks by their two dead centres.
//
// At the dead centres crank and coupler lie in one line, extended and folded, so that the crank's pivot A0 sees the
// chord from B1 to B2 under the angle alpha = pi (Q - 1) / (Q + 1): it lies on one of two circles through B1 and B2
// (for Q = 1 on their line). There, a = (|A0 B2| - |A0 B1|) / 2 and b = (|A0 B2| + |A0 B1|) / 2. One angle is left:
// that with the best transmission. Source: Alt 1925; VDI 2130; Brodell & Soni 1970.
#include <math.h>
#include "synthesis/synthesis.h"

enum { SAMPLES = 1440, NARROWED = 60 };

static const double longest =
    20; // over the shortest, unless the task says otherwise: some families are best without a crank

typedef struct Family {
    const YkStrokeTask *task;
    YkVec B[2];    // ends of the coupler's path; B0 is the origin for a rocker, the line y = 0 for a slider
    YkVec center;  // of the circle of A0, or a point of its line
    double radius; // 0: a line
    double ratio;  // largest of two lengths
    double alpha;
} Family;

static YkVec pivot_at(const Family *family, double u)
{
    if (family->radius > 0) return yk_add(family->center, yk_scale(family->radius, yk_unit(u)));
    YkVec along = yk_sub(family->B[1], family->B[0]); // the whole line, u over a turn
    return yk_add(family->center, yk_scale(yk_tan(u / 2), along));
}

// Returns whether there is a design with the crank's pivot at `u`, in units of the rocker's length or of the stroke.
static bool design_at(const Family *family, double u, YkDesign *design)
{
    YkVec A0 = pivot_at(family, u), p = yk_sub(family->B[0], A0), q = yk_sub(family->B[1], A0);
    double near_end = yk_norm(p), far_end = yk_norm(q), angle = fabs(yk_atan2(yk_cross(p, q), yk_dot(p, q)));
    if (fabs(angle - family->alpha) > 1e-9) return false; // the other arc
    double a = fabs(far_end - near_end) / 2, b = (far_end + near_end) / 2;
    YkVec extended = far_end > near_end ? q : p, B = yk_add(A0, extended);
    *design = (YkDesign){.kind = YK_DESIGN_FOUR_BAR, .dyad = {-1, -1}};
    design->pivot[0] = A0;
    design->length[1] = a;
    design->length[2] = b;
    design->angle[0] = design->angle[1] = yk_atan2(extended.y, extended.x);
    if (!(a > 1e-6) || b > family->ratio * a) return false;
    if (family->task->is_slider) {
        design->kind = YK_DESIGN_SLIDER_CRANK;
        design->angle[2] = B.x;
        return p.x * q.x > 0 && yk_design_turns(design); // both ends on one side of A0, or there are two assemblies
    }
    design->length[0] = yk_norm(A0);
    design->length[3] = 1;
    design->angle[2] = yk_atan2(B.y, B.x);
    // B stays on one side of the line of the fixed pivots, or the two ends would need two assemblies.
    bool is_one = yk_cross(A0, family->B[0]) * yk_cross(A0, family->B[1]) > 0;
    return is_one && yk_design_class(design) == YK_FOUR_BAR_CRANK_ROCKER;
}

// Returns the least transmission angle over a turn, rad; -1 where there is no machine.
static double transmission(const Family *family, double u)
{
    YkDesign d;
    if (!design_at(family, u, &d)) return -1;
    double a = d.length[1], b = d.length[2];
    if (family->task->is_slider) return yk_acos(fmin((a + fabs(d.pivot[0].y)) / b, 1));
    double g = d.length[0], c = d.length[3], least = INFINITY;
    for (int end = -1; end <= 1; end += 2) { // crank in line with the ground
        double across = g + end * a, cosine = (b * b + c * c - across * across) / (2 * b * c);
        least = fmin(least, yk_acos(fmin(fabs(cosine), 1)));
    }
    return least;
}

// Finds the best angle within a sample of `u` by golden sections.
static double narrow(const Family *family, double u, double step)
{
    static const double golden = 0.61803398874989485;
    double low = u - step, high = u + step;
    for (int k = 0; k < NARROWED; k++) {
        double p = high - golden * (high - low), q = low + golden * (high - low);
        if (transmission(family, p) < transmission(family, q))
            low = p;
        else
            high = q;
    }
    double middle = (low + high) / 2;
    return transmission(family, middle) >= transmission(family, u) ? middle : u;
}

static double size_of(const YkStrokeTask *task, const YkDesign *design)
{
    const YkGiven *given[4] = {&task->ground, &task->input, &task->coupler, &task->output};
    if (task->is_slider) return task->stroke;
    for (size_t k = 0; k < 4; k++)
        if (given[k]->is_given) return given[k]->value / design->length[k];
    return 1 / design->length[0];
}

// Puts the machine where files like it: the crank's pivot at the origin, the rocker's (or the slider's line) beside it.
static void place(const YkStrokeTask *task, YkDesign *design)
{
    double scale = size_of(task, design);
    YkVec A0 = design->pivot[0], ground = yk_sub(design->pivot[1], A0);
    double turned = task->is_slider ? 0 : yk_atan2(ground.y, ground.x);
    design->pivot[0] = yk_vec(0, 0);
    design->pivot[1] = task->is_slider ? yk_vec(0, -scale * A0.y) : yk_vec(scale * design->length[0], 0);
    for (size_t k = 0; k < 4; k++) design->length[k] *= scale;
    if (task->is_slider) {
        design->angle[2] = scale * (design->angle[2] - A0.x);
        return;
    }
    for (size_t k = 0; k < 3; k++) design->angle[k] -= turned;
}

// Compares what the engine measured with what was asked.
static YkDefect compare(const YkStrokeTask *task, YkVerdict *verdict)
{
    double swept = verdict->high - verdict->low,
           between = fabs(yk_remainder(verdict->high_at - verdict->low_at, 2 * YK_PI));
    double ratio = (2 * YK_PI - between) / between;
    double off = fabs(swept - task->stroke), scale = task->is_slider ? task->stroke : 1;
    verdict->worst = off;
    verdict->error = off * off;
    return off <= 1e-6 * scale && fabs(ratio - task->ratio) <= 1e-5 ? YK_DEFECT_NONE : YK_DEFECT_ASSEMBLY;
}

static void take(YkSynthesis *s, YkDesign *design)
{
    const YkStrokeTask *task = &s->task->stroke;
    place(task, design);
    double input[2] = {design->angle[0], design->angle[0] + 1e-9};
    YkJourney journey = {.task = s->task, .input = input, .count = 2, .turns = true};
    YkVerdict verdict = {.defect = YK_DEFECT_NONE};
    YkText text = {0};
    YkDefect defect = yk_design_bounds(design, s->task);
    if (defect == YK_DEFECT_NONE) defect = yk_synthesis_try(s, design, &journey, &text, &verdict);
    if (defect == YK_DEFECT_NONE) defect = compare(task, &verdict);
    if (defect == YK_DEFECT_NONE)
        yk_synthesis_keep(s, design, &text, &verdict, verdict.transmission[0]);
    else
        yk_synthesis_leave(s, design, defect, &verdict);
    yk_text_free(&text);
}

// Takes the best machine of one circle (or line).
static bool take_family(YkSynthesis *s, const Family *family)
{
    double best = 0, at = 0, step = 2 * YK_PI / SAMPLES;
    for (size_t k = 0; k < SAMPLES; k++) {
        double u = -YK_PI + ((double)k + 0.5) * step, angle = transmission(family, u);
        if (angle <= best) continue;
        best = angle;
        at = u;
    }
    YkDesign design;
    if (!(best > 0) || !design_at(family, narrow(family, at, step), &design)) return false;
    take(s, &design);
    return true;
}

static Family family_of(const YkTask *all, int side)
{
    const YkStrokeTask *task = &all->stroke;
    Family f = {.task = task, .ratio = all->size_ratio.is_given ? all->size_ratio.value : longest};
    f.alpha = YK_PI * (task->ratio - 1) / (task->ratio + 1);
    double half = task->is_slider ? 0.5 : yk_sin(task->stroke / 2),
           height = task->is_slider ? 0 : yk_cos(task->stroke / 2);
    f.B[0] = yk_vec(-half, height);
    f.B[1] = yk_vec(half, height);
    f.center = yk_vec(0, height);
    if (f.alpha < 1e-9) {
        f.alpha = 0;
        return f;
    }
    f.radius = half / yk_sin(f.alpha);
    f.center.y += side * half / yk_tan(f.alpha);
    return f;
}

// In line with its guide, a slider-crank is the better the longer its coupler: as long as the bounds allow.
static bool take_central(YkSynthesis *s, YkProblems *problems)
{
    const YkStrokeTask *task = &s->task->stroke;
    const YkBound *lengths = &s->task->lengths;
    if (!lengths->is_given) {
        yk_problem(problems, YK_CODE_TASK_FUNCTION, task->place,
                   "with the time ratio 1 the transmission angle of a slider-crank grows with its coupler without end");
        yk_problem_hint(problems, "bound the lengths: `bounds: {lengths: [10 mm, 200 mm]}`");
        return false;
    }
    double a = 0.5, b = fmax(lengths->high / task->stroke, 0);
    YkDesign design = {
        .kind = YK_DESIGN_SLIDER_CRANK, .length = {0, a, b, 0}, .angle = {0, 0, a + b}, .dyad = {-1, -1}};
    if (b > a) take(s, &design);
    return true;
}

bool yk_synthesise_stroke(YkSynthesis *s, YkProblems *problems)
{
    const YkStrokeTask *task = &s->task->stroke;
    s->is_complete = true;
    if (task->is_slider && task->ratio == 1) return take_central(s, problems);
    for (int side = -1; side <= 1; side += 2) {
        Family family = family_of(s->task, side);
        take_family(s, &family);
        if (family.radius == 0 || task->is_slider) break; // the two circles of a slider are mirror images
    }
    return true;
}
