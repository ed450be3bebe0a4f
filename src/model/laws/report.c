// Reports what does not fit in a law whose values are known.
#include <math.h>
#include "model/laws/read.h"

static const char *const order_names[] = {"s", "v", "a", "j", "p"};

void yk_load_law_report(const YkLawWork *work, YkCode code, YkPlace place, const char *what)
{
    yk_problem(work->loader->problems, code, place, "law %q: %s", work->law->name, what);
}

static YkAmount amount_at(const YkLawWork *work, double x)
{
    return yk_load_law_place(work->loader->model, work->law, x);
}

static YkAmount end_so_far(const YkLawWork *work)
{
    return amount_at(work, yk_law_builder_at(work->builder));
}

// Reports a condition that is at fault.
static void report_condition(const YkLawWork *work, YkLawFault fault)
{
    YkProblems *problems = work->loader->problems;
    size_t culprit = yk_law_builder_culprit(work->builder);
    if (culprit >= work->count) culprit = 0;
    const YkLawCondition *condition = &work->conditions[culprit];
    YkPlace place = work->places[culprit];
    YkAmount at = amount_at(work, condition->at);
    const char *what = order_names[condition->order], *law = work->law->name;
    if (fault == YK_LAW_REPEATED) {
        yk_problem(problems, YK_CODE_LAW_CONDITIONS, place, "law %q: %s at %s is given a second time", law, what,
                   at.text);
    } else if (fault == YK_LAW_CONTRADICTION) {
        yk_problem(problems, YK_CODE_LAW_CONTRADICTION, place, "law %q: %s at %s contradicts the other conditions", law,
                   what, at.text);
        yk_problem_hint(problems, "leave it out, or give another condition instead");
    } else {
        yk_problem(problems, YK_CODE_LAW_UNDETERMINED, place,
                   "law %q: %s at %s follows from the other conditions, which leaves the motion undetermined", law,
                   what, at.text);
        yk_problem_hint(problems, "give another condition instead of it");
    }
}

static void report_joint(const YkLawWork *work, bool is_gap)
{
    double from = INFINITY;
    for (size_t i = 0; i < work->count; i++) from = fmin(from, work->conditions[i].at);
    YkAmount here = amount_at(work, from), before = end_so_far(work);
    yk_problem(work->loader->problems, YK_CODE_LAW_ORDER, work->part->place,
               is_gap ? "law %q: a segment begins at %s, but the one before it ends earlier, at %s"
                      : "law %q: a segment begins at %s, but the one before it ends later, at %s",
               work->law->name, here.text, before.text);
    if (is_gap) yk_problem_hint(work->loader->problems, "perhaps there is a {dwell: {to: %s}} between", here.text);
}

static void report_shape(const YkLawWork *work)
{
    const YkLawPart *part = work->part;
    bool is_negative = !(part->by.value >= 0), has_half = part->rise.half != YK_RISE_WHOLE;
    const YkLawNumber *number = &part->blend;
    const char *what = "`blend` is a part of the time, between 0 and 0.5";
    if (part->kind != YK_LAW_SPLINE && is_negative) {
        number = &part->by;
        what = "`by` is how far it goes, not negative";
    } else if (part->kind == YK_LAW_SPLINE || (part->is_spline && !has_half)) {
        number = &part->degree;
        what = "the degree of a spline is a whole number from 1 to 9";
    } else if (part->is_spline) {
        number = &part->to;
        what = "a spline has no halves";
    } else if (part->rise.law == YK_RISE_SCCA) {
        number = &part->b;
        what = "the parts b, c and d of `scca` lie between 0 and 1 and add up to 1";
    }
    yk_load_law_report(work, YK_CODE_LAW_SHAPE, number->place, what);
}

// Reports where a formula has no value, with the reason and its place in the formula; or that it is too rough.
static void report_formula(const YkLawWork *work, YkLawFault fault)
{
    const YkLawPart *part = work->part;
    const YkModel *model = work->loader->model;
    double x = yk_law_builder_trouble(work->builder);
    const char *why = "its value or a derivative is not finite";
    YkJet jet;
    const YkExpr *culprit = yk_load_eval_of(model, part->formula, part->argument, x, &jet, &why);
    YkAmount at = amount_at(work, x);
    if (fault == YK_LAW_NO_VALUE) {
        yk_problem(work->loader->problems, YK_CODE_LAW_FORMULA, (culprit ? culprit : part->formula)->place,
                   "law %q has no value or no derivative at %s: %s", work->law->name, at.text, why);
    } else {
        yk_problem(work->loader->problems, YK_CODE_LAW_FORMULA, part->formula->place,
                   "law %q: near %s the formula is not smooth anywhere", work->law->name, at.text);
    }
}

void yk_load_law_report_part(const YkLawWork *work, YkLawFault fault)
{
    const YkLawPart *part = work->part;
    bool is_polynomial = part->kind == YK_LAW_POLYNOMIAL;
    switch (fault) {
    case YK_LAW_BACKWARD:
        yk_problem(work->loader->problems, YK_CODE_LAW_ORDER, part->to.place,
                   "law %q: this segment begins at %s and must end after that", work->law->name, end_so_far(work).text);
        break;
    case YK_LAW_GAP:
    case YK_LAW_OVERLAP:
        report_joint(work, fault == YK_LAW_GAP);
        break;
    case YK_LAW_TOO_FEW:
        yk_load_law_report(work, YK_CODE_LAW_CONDITIONS, part->place,
                           is_polynomial ? "a polynomial needs conditions at two places at least"
                                         : "too few conditions for a spline of this degree");
        break;
    case YK_LAW_TOO_MANY:
        yk_load_law_report(work, YK_CODE_LAW_CONDITIONS, part->place, "a segment takes up to 200 conditions");
        break;
    case YK_LAW_REPEATED:
    case YK_LAW_CONTRADICTION:
    case YK_LAW_UNDETERMINED:
        report_condition(work, fault);
        break;
    case YK_LAW_NO_VALUE:
    case YK_LAW_ROUGH:
        report_formula(work, fault);
        break;
    case YK_LAW_SHAPE:
        report_shape(work);
        break;
    default:
        yk_load_law_report(work, YK_CODE_VALUE_RANGE, part->place, "a segment's values are beyond all bounds");
        break;
    }
}

void yk_load_law_report_table(const YkLawWork *work, YkLawFault fault)
{
    const YkLawSource *source = work->source;
    size_t culprit = yk_law_builder_culprit(work->builder);
    YkPlace place = work->law->place;
    if (fault == YK_LAW_TOO_FEW) {
        yk_load_law_report(work, YK_CODE_LAW_CONDITIONS, place, "a table has two points at least");
    } else if (fault == YK_LAW_UNORDERED) {
        const YkLawNumber *x = &source->points[culprit][0];
        yk_problem(work->loader->problems, YK_CODE_LAW_ORDER, x->place,
                   "law %q: the arguments of a table ascend; %s follows %s", work->law->name,
                   amount_at(work, x->value).text, amount_at(work, source->points[culprit - 1][0].value).text);
        yk_problem_hint(work->loader->problems, "a step is written as two points near each other");
    } else if (fault == YK_LAW_OVERFILLED) {
        yk_load_law_report(work, YK_CODE_LAW_PERIOD, source->period.place,
                           "the points of a table lie within one period");
    } else {
        yk_load_law_report(work, YK_CODE_VALUE_RANGE, place, "its values are beyond all bounds");
    }
}

void yk_load_law_report_period(const YkLawWork *work, YkLawFault fault)
{
    bool is_short = fault == YK_LAW_NOT_FILLED;
    YkAmount period = amount_at(work, work->source->period.value), end = end_so_far(work);
    yk_problem(work->loader->problems, YK_CODE_LAW_PERIOD, work->source->period.place,
               is_short ? "law %q: the segments end at %s, before the period of %s is over"
                        : "law %q: the segments continue to %s, beyond the period of %s",
               work->law->name, end.text, period.text);
    if (is_short) yk_problem_hint(work->loader->problems, "add a dwell to the end of the period");
}
