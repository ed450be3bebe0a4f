// Shared by the writers of a study: names of its answers, moments, tolerances.
#include <math.h>
#include "verbs/study/study.h"

void yk_study_name(const YkStudyAnswer *a, size_t k, YkText *name)
{
    static const char *const words[YK_REDUCTIONS] = {".min", ".max", ".mean", ".range"};
    size_t kinds = yk_study_kinds(a);
    yk_text_clear(name);
    yk_text_puts(name, a->columns[k / kinds].name);
    if (kinds > 1) yk_text_puts(name, words[k % kinds]);
}

YkQuantity yk_study_quantity(const YkStudyAnswer *a, size_t k)
{
    return a->columns[k / yk_study_kinds(a)].channel.quantity;
}

const double *yk_study_row(YkStudyAnswer *a, size_t design)
{
    if (a->rows) return a->rows + design * a->width;
    const double *row = yk_blocks_row(a->blocks, design);
    a->has_missing |= !row;
    return row ? row : a->missing;
}

// Source: Welford 1962.
static void add_number(YkMoments *m, double x)
{
    double off = x - m->mean;
    m->count++;
    m->mean += off / (double)m->count;
    m->deviation += off * (x - m->mean);
    m->least = fmin(m->least, x);
    m->largest = fmax(m->largest, x);
}

void yk_study_note(YkStudyAnswer *a, size_t design, const double *row)
{
    YkStudySum *sum = &a->sum;
    YkStatus status = yk_row_status(a, row);
    size_t first = yk_study_first(a);
    yk_note_status(a->session, status);
    if (status >= YK_NO_MEMORY && status <= YK_SINGULAR) sum->statuses[status - YK_NO_MEMORY]++;
    sum->without += row[a->axis_count + 1] == 0;
    if (status == YK_BAD_MODEL && sum->bad == YK_NOT_FOUND) sum->bad = design;
    for (size_t k = first; status >= 0 && k < a->width; k++)
        if (!isnan(row[k])) add_number(&sum->moments[k - first], row[k]);
}

YkMoments yk_study_moments(const YkStudyAnswer *a, size_t k)
{
    YkMoments m = a->sum.moments[k];
    m.deviation = m.count > 1 ? sqrt(m.deviation / (double)(m.count - 1)) : 0;
    return m;
}

double yk_study_tolerance_of(const YkStudyAnswer *a, size_t axis)
{
    const YkAxis *x = &a->axes[axis];
    double nominal = yk_model_parameter(a->session->model, x->name);
    if (a->is_sample) return yk_distribution_tolerance(&x->distribution, nominal);
    return fmax(fabs(x->from - nominal), fabs(x->to - nominal));
}

double yk_study_slope(const YkStudyAnswer *a, size_t column, size_t axis)
{
    double slope = a->derivative[column * a->axis_count + axis];
    return isnan(slope) ? a->difference[column * a->axis_count + axis] : slope;
}

YkTolerance yk_study_tolerance(const YkStudyAnswer *a, size_t column)
{
    YkTolerance t = {0, 0};
    for (size_t k = 0; k < a->axis_count; k++) {
        const YkAxis *x = &a->axes[k];
        double S = yk_study_slope(a, column, k);
        double s = a->is_sample ? yk_distribution_deviation(&x->distribution) : fabs(x->to - x->from) / sqrt(12);
        t.worst += fabs(S) * yk_study_tolerance_of(a, k);
        t.root += (S * s) * (S * s);
    }
    t.root = sqrt(t.root);
    return t;
}

size_t yk_study_count(const YkStudyAnswer *a, YkStatus status)
{
    return a->sum.statuses[status - YK_NO_MEMORY];
}
