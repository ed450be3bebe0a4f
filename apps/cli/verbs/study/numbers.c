// What the writers of a study share: names of its answers, moments, tolerances.
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

// Source: Welford 1962.
YkMoments yk_study_moments(const YkStudyAnswer *a, size_t k)
{
    YkMoments m = {0, 0, 0, INFINITY, -INFINITY};
    double square = 0;
    for (size_t d = 0; d < a->done; d++) {
        double x = yk_study_row(a, d)[yk_study_first(a) + k];
        if (isnan(x) || yk_study_status(a, d) < 0) continue;
        double off = x - m.mean;
        m.count++;
        m.mean += off / (double)m.count;
        square += off * (x - m.mean);
        m.least = fmin(m.least, x);
        m.largest = fmax(m.largest, x);
    }
    m.deviation = m.count > 1 ? sqrt(square / (double)(m.count - 1)) : 0;
    return m;
}

double yk_study_tolerance_of(const YkStudyAnswer *a, size_t axis)
{
    const YkAxis *x = &a->axes[axis];
    double nominal = yk_model_parameter(a->session->model, x->name);
    if (a->is_sample) return yk_distribution_tolerance(&x->distribution, nominal);
    return fmax(fabs(x->from - nominal), fabs(x->to - nominal));
}

YkTolerance yk_study_tolerance(const YkStudyAnswer *a, size_t column)
{
    YkTolerance t = {0, 0};
    for (size_t k = 0; k < a->axis_count; k++) {
        const YkAxis *x = &a->axes[k];
        double S = a->derivative[column * a->axis_count + k];
        double s = a->is_sample ? yk_distribution_deviation(&x->distribution) : fabs(x->to - x->from) / sqrt(12);
        t.worst += fabs(S) * yk_study_tolerance_of(a, k);
        t.root += (S * s) * (S * s);
    }
    t.root = sqrt(t.root);
    return t;
}

size_t yk_study_count(const YkStudyAnswer *a, YkStatus status)
{
    size_t count = 0;
    for (size_t d = 0; d < a->done; d++) count += yk_study_status(a, d) == status;
    return count;
}
