// The second pass over laws: with all values known, builds them, and reports what does not fit at its place.
#include <math.h>
#include <stdlib.h>
#include "model/laws/read.h"

static void add_condition(YkLawWork *work, double at, int order, double value, YkPlace place)
{
    if (!YK_ROOM(work->conditions, work->count, work->capacity) ||
        !YK_ROOM(work->places, work->count, work->place_capacity)) {
        work->failed = true;
        return;
    }
    work->conditions[work->count] = (YkLawCondition){at, order, value};
    work->places[work->count++] = place;
}

static void add_given(YkLawWork *work)
{
    for (size_t i = 0; i < work->part->given_count; i++) {
        const YkLawGiven *given = &work->part->given[i];
        for (int order = 0; order <= YK_LAW_ORDER; order++) {
            const YkLawNumber *number = &given->d[order];
            if (number->expr) add_condition(work, given->at.value, order, number->value, number->place);
        }
    }
}

// Adds conditions of rest at both ends.
static void add_ends(YkLawWork *work)
{
    const YkLawPart *part = work->part;
    double from = yk_law_builder_at(work->builder), value = yk_law_builder_value(work->builder);
    double by = part->kind == YK_LAW_RISE ? part->by.value : -part->by.value;
    for (int order = 0; order <= 2; order++) {
        add_condition(work, from, order, order == 0 ? value : 0, part->place);
        add_condition(work, part->to.value, order, order == 0 ? value + by : 0, part->place);
    }
}

enum { DEGREE = 5 };

// Returns the degree of a spline, whole degrees only; the builder refuses 0.
static int degree_of(const YkLawPart *part)
{
    double degree = part->degree.expr ? part->degree.value : DEGREE;
    return degree >= 1 && degree <= YK_LAW_DEGREE_MAX && degree == rint(degree) ? (int)degree : 0;
}

static YkLawFault add_rise(YkLawWork *work)
{
    const YkLawPart *part = work->part;
    YkRise rise = part->rise;
    rise.b = part->b.value;
    rise.c = part->c.value;
    rise.d = part->d.value;
    rise.blend = part->blend.value;
    if (!(part->by.value >= 0)) return YK_LAW_SHAPE;
    if (part->is_spline) {
        if (rise.half != YK_RISE_WHOLE) return YK_LAW_SHAPE;
        add_ends(work);
        add_given(work);
        return work->failed ? YK_LAW_NO_MEMORY
                            : yk_law_add_spline(work->builder, work->conditions, work->count, degree_of(part));
    }
    return part->kind == YK_LAW_RISE ? yk_law_add_rise(work->builder, part->to.value, part->by.value, &rise)
                                     : yk_law_add_fall(work->builder, part->to.value, part->by.value, &rise);
}

typedef struct Formula {
    const YkModel *model;
    const YkLawPart *part;
} Formula;

static bool formula_at(const void *context, double x, double d[YK_LAW_ORDER + 1])
{
    const Formula *formula = context;
    YkJet jet;
    const char *why;
    if (yk_load_eval_of(formula->model, formula->part->formula, formula->part->argument, x, &jet, &why)) return false;
    for (int m = 0; m <= YK_LAW_ORDER; m++) d[m] = jet.d[m];
    return true;
}

static YkLawFault add_part(YkLawWork *work)
{
    const YkLawPart *part = work->part;
    work->count = 0;
    switch (part->kind) {
    case YK_LAW_POLYNOMIAL:
    case YK_LAW_SPLINE:
        add_given(work);
        if (work->failed) return YK_LAW_NO_MEMORY;
        if (part->kind == YK_LAW_SPLINE)
            return yk_law_add_spline(work->builder, work->conditions, work->count, degree_of(part));
        return yk_law_add_polynomial(work->builder, work->conditions, work->count);
    case YK_LAW_DWELL:
        return yk_law_add_dwell(work->builder, part->to.value);
    case YK_LAW_CONSTANT_VELOCITY:
        return yk_law_add_velocity(work->builder, part->to.value, part->v.value);
    case YK_LAW_FORMULA:
        return yk_law_add_function(work->builder, part->to.value, YK_LAW_FORMULA, formula_at,
                                   &(Formula){work->loader->model, part});
    default:
        return add_rise(work);
    }
}

static bool add_parts(YkLawWork *work)
{
    for (size_t i = 0; i < work->source->part_count; i++) {
        work->part = &work->source->parts[i];
        YkLawFault fault = add_part(work);
        work->failed |= fault == YK_LAW_NO_MEMORY;
        if (fault == YK_LAW_OK) continue;
        if (!work->failed) yk_load_law_report_part(work, fault);
        return false;
    }
    return true;
}

static bool add_table(YkLawWork *work)
{
    const YkLawSource *source = work->source;
    size_t count = source->point_count;
    double *x = malloc((2 * count + 1) * sizeof *x), *y = x + count;
    if (!x) {
        work->failed = true;
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        x[i] = source->points[i][0].value;
        y[i] = source->points[i][1].value;
    }
    double period = source->period.expr ? source->period.value : 0;
    YkLawFault fault = yk_law_add_table(work->builder, x, y, count, source->between, period);
    free(x);
    work->failed |= fault == YK_LAW_NO_MEMORY;
    if (fault != YK_LAW_OK && !work->failed) yk_load_law_report_table(work, fault);
    return fault == YK_LAW_OK;
}

// Finishes the law, which must fill its period.
static YkLaw *finish(YkLawWork *work)
{
    const YkLawSource *source = work->source;
    YkLaw *law;
    double period = source->period.expr ? source->period.value : 0;
    YkLawFault fault = yk_law_finish(work->builder, period, work->loader->arena, &law);
    if (fault == YK_LAW_NO_MEMORY) work->failed = true;
    if (fault == YK_LAW_NOT_FILLED || fault == YK_LAW_OVERFILLED) yk_load_law_report_period(work, fault);
    return law;
}

// Returns where the law begins: `from`, or the first place of its first conditions, or 0.
static double start_of(const YkLawSource *source)
{
    if (source->from.expr || source->part_count == 0) return source->from.expr ? source->from.value : 0;
    const YkLawPart *part = &source->parts[0];
    bool has_conditions = part->kind == YK_LAW_POLYNOMIAL || part->kind == YK_LAW_SPLINE;
    double from = INFINITY;
    for (size_t i = 0; has_conditions && i < part->given_count; i++) from = fmin(from, part->given[i].at.value);
    return isfinite(from) ? from : 0;
}

// Returns whether every value is known. Missing ones have been reported.
static bool are_known(const YkLawNumber *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (numbers[i].expr && isnan(numbers[i].value)) return false;
    }
    return true;
}

static bool is_known(const YkLawSource *source)
{
    if (source->is_bad || !are_known(&source->from, 1) || !are_known(&source->period, 1)) return false;
    for (size_t i = 0; i < source->part_count; i++) {
        const YkLawPart *part = &source->parts[i];
        const YkLawNumber numbers[] = {part->to, part->by, part->v, part->blend,
                                       part->b,  part->c,  part->d, part->degree};
        if (!are_known(numbers, sizeof numbers / sizeof *numbers)) return false;
        for (size_t k = 0; k < part->given_count; k++) {
            const YkLawGiven *given = &part->given[k];
            if (!are_known(&given->at, 1) || !are_known(given->d, YK_LAW_ORDER + 1)) return false;
        }
    }
    for (size_t i = 0; i < source->point_count; i++) {
        if (!are_known(source->points[i], 2)) return false;
    }
    return true;
}

static bool is_sound(const YkLawWork *work)
{
    const YkLawSource *source = work->source;
    if (!is_known(source)) return false;
    if (source->period.expr && !(source->period.value > 0)) {
        yk_load_law_report(work, YK_CODE_LAW_PERIOD, source->period.place, "a period must be positive");
        return false;
    }
    const YkLawNumber *from = &source->from;
    if (source->points && from->expr && source->point_count > 0 && from->value != source->points[0][0].value) {
        yk_load_law_report(work, YK_CODE_LAW_ORDER, from->place, "`from` is not where the table begins; leave it out");
        return false;
    }
    return true;
}

static void build(YkLoader *loader, YkModelLaw *law)
{
    YkLawWork work = {.loader = loader, .law = law, .source = law->source};
    if (law->source->is_made || !is_sound(&work)) return;
    work.builder = yk_law_builder_new(start_of(law->source), 0);
    work.failed = !work.builder;
    if (!work.failed && (law->source->points ? add_table(&work) : add_parts(&work))) law->law = finish(&work);
    loader->failed |= work.failed;
    yk_law_builder_free(work.builder);
    free(work.conditions);
    free(work.places);
    if (law->law) yk_load_law_report_jumps(loader, law);
}

void yk_load_finish_laws(YkLoader *loader)
{
    for (size_t i = 0; i < loader->model->law_count; i++) build(loader, &loader->model->laws[i]);
}
