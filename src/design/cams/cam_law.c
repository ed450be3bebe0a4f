// The motion program: its segments and jumps, the library's laws, and the same cam with other laws.
#include <math.h>
#include "design/cams/cam.h"
#include "law/build.h"

size_t yk_cam_segment_count(const YkCamDesign *design)
{
    return yk_law_segment_count(design->law->law);
}

YkCamSegment yk_cam_segment(const YkCamDesign *design, size_t segment)
{
    if (segment >= yk_cam_segment_count(design)) return (YkCamSegment){.from = (double)NAN, .to = (double)NAN};
    static const char *const kinds[] = {"polynomial",        "spline", "dwell",   "rise", "fall",
                                        "constant-velocity", "table",  "formula", "arc"};
    YkLawSegment s = yk_law_segment(design->law->law, segment);
    return (YkCamSegment){.kind = kinds[s.kind],
                          .from = s.from,
                          .to = s.to,
                          .condition_count = s.condition_count,
                          .condition_number = s.condition_count > 0 ? s.condition_number : 0};
}

YkCamCondition yk_cam_condition(const YkCamDesign *design, size_t segment, size_t condition)
{
    if (condition >= yk_cam_segment(design, segment).condition_count)
        return (YkCamCondition){.at = (double)NAN, .value = (double)NAN};
    YkLawCondition c = yk_law_segment(design->law->law, segment).conditions[condition];
    return (YkCamCondition){c.at, c.order, c.value};
}

enum { JUMPS_MAX = 200 };

size_t yk_cam_jumps(const YkCamDesign *design, YkCamJump *jumps, size_t capacity)
{
    YkLawJump found[JUMPS_MAX];
    size_t count = yk_law_jumps(design->law->law, found, JUMPS_MAX);
    for (size_t i = 0; i < count && i < JUMPS_MAX && i < capacity; i++)
        jumps[i] = (YkCamJump){found[i].x, found[i].order, found[i].size};
    return count;
}

const char *yk_cam_law_name(size_t index)
{
    // scca is a family: it has no factors without its b, c, d
    if (index >= YK_RISE_SCCA) index++;
    return index <= YK_RISE_CONSTANT_VELOCITY ? yk_rise_name((YkRiseLaw)index) : NULL;
}

static bool find_rise(const char *name, YkRise *rise)
{
    *rise = (YkRise){.half = YK_RISE_WHOLE};
    return yk_rise_find(name, &rise->law) && rise->law != YK_RISE_SCCA;
}

YkStatus yk_cam_law_factors(const char *law, YkCamFactors *factors)
{
    YkRise rise;
    YkLaw *unit = NULL;
    if (!find_rise(law, &rise)) return YK_BAD_ARGUMENT;
    YkArena *arena = yk_arena_new();
    YkLawBuilder *builder = yk_law_builder_new(0, 0);
    if (arena && builder && yk_law_add_rise(builder, 1, 1, &rise) == YK_LAW_OK) yk_law_finish(builder, 0, arena, &unit);
    if (unit) {
        *factors = (YkCamFactors){fabs(yk_law_peak(unit, 1).value), fabs(yk_law_peak(unit, 2).value),
                                  fabs(yk_law_peak(unit, 3).value)};
        yk_cam_count_jumps(unit, 0, 1, 0, factors);
    }
    yk_law_builder_free(builder);
    yk_arena_free(arena);
    return unit ? YK_OK : YK_NO_MEMORY;
}

enum { STROKES_MAX = 64 };

double yk_cam_law_lift(const YkLaw *law, double angle)
{
    double d[YK_LAW_ORDER + 1];
    yk_law_eval(law, angle, d);
    return d[0];
}

// Builds a law in which every stroke follows `rise`, with dwells between.
static YkLaw *build_with(const YkCamDesign *design, const YkRise *rise, YkArena *arena)
{
    YkCamStroke strokes[STROKES_MAX];
    YkLaw *law = NULL;
    size_t count = yk_cam_strokes(design, strokes, STROKES_MAX);
    if (count == 0 || count > STROKES_MAX) return NULL;
    YkLawRange range = yk_law_range(design->law->law);
    double from = fmin(range.from, strokes[0].from), end = from + range.period, close = 1e-12 * range.period;
    YkLawBuilder *builder = yk_law_builder_new(from, yk_cam_law_lift(design->law->law, from));
    YkLawFault fault = builder ? YK_LAW_OK : YK_LAW_NO_MEMORY;
    for (size_t i = 0; i < count && fault == YK_LAW_OK; i++) {
        const YkCamStroke *stroke = &strokes[i];
        if (stroke->from > yk_law_builder_at(builder) + close) fault = yk_law_add_dwell(builder, stroke->from);
        if (fault != YK_LAW_OK) break;
        fault = stroke->lift > 0 ? yk_law_add_rise(builder, stroke->to, stroke->lift, rise)
                                 : yk_law_add_fall(builder, stroke->to, -stroke->lift, rise);
    }
    if (fault == YK_LAW_OK && yk_law_builder_at(builder) < end - close) fault = yk_law_add_dwell(builder, end);
    if (fault == YK_LAW_OK) yk_law_finish(builder, range.period, arena, &law);
    yk_law_builder_free(builder);
    return law;
}

YkCamDesign *yk_cam_design_with(const YkCamDesign *design, const char *law)
{
    YkRise rise;
    if (!find_rise(law, &rise)) return NULL;
    YkArena *arena = yk_arena_new();
    YkCamDesign *other = arena ? YK_NEW(arena, YkCamDesign, 1) : NULL;
    YkModelLaw *own = arena ? YK_NEW(arena, YkModelLaw, 1) : NULL;
    if (other && own) {
        *other = *design;
        *own = *design->law;
        own->name = yk_rise_name(rise.law);
        own->source = NULL;
        own->law = build_with(design, &rise, arena);
        other->law = own;
        other->arena = arena;
        if (own->law && yk_cam_samples_take(&other->samples, own->law, arena) && yk_cam_gather_loads(other))
            return other;
    }
    yk_arena_free(arena);
    return NULL;
}
