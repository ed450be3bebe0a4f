// `yoke study` for people.
#include <math.h>
#include "verbs/study/study.h"
#include "write/table.h"

enum { ROWS_SHOWN = 60 };

static double shown_parameter(const YkStudyAnswer *a, size_t axis, double value)
{
    return value / yk_model_parameter_unit(a->session->model, a->axes[axis].name);
}

// Scales by what one design has: beside its limit another may have numbers of any size. The inputs count too, since all
// that a design has may be noise.
static void scale_by_row(YkStudyAnswer *a, const double *row)
{
    yk_scale_begin(a->session);
    yk_scale_add_inputs(a->session, a->session->state);
    for (size_t k = yk_study_first(a); k < a->width; k++)
        yk_scale_add(a->session, row[k], yk_study_quantity(a, k - yk_study_first(a)));
}

// Scales by the design with the least.
static void scale_by_least(YkStudyAnswer *a)
{
    YkScale least = a->session->scale, *scale = &a->session->scale;
    double sum, least_sum = HUGE_VAL;
    for (size_t d = 0; d < a->done; d++) {
        scale_by_row(a, yk_study_row(a, d));
        sum = scale->rate + scale->acceleration + scale->force + scale->energy;
        if (sum > 0 && sum < least_sum) least = *scale, least_sum = sum;
    }
    *scale = least;
}

// Writes the designs one by one if there are few.
static void add_rows(YkStudyAnswer *a)
{
    if (a->done > ROWS_SHOWN) return;
    size_t first = yk_study_first(a);
    YkTable *table = yk_table_new(a->axis_count + 1 + a->width - first);
    YkText name = {0};
    for (size_t k = 0; k < a->axis_count; k++) yk_table_head(table, a->axes[k].name, NULL);
    yk_table_head(table, "status", NULL);
    for (size_t k = first; k < a->width; k++) {
        yk_study_name(a, k - first, &name);
        yk_table_head(table, yk_text_get(&name), yk_unit_of(a->session, yk_study_quantity(a, k - first)));
    }
    for (size_t d = 0; d < a->done; d++) {
        const double *row = yk_study_row(a, d);
        scale_by_row(a, row);
        for (size_t k = 0; k < a->axis_count; k++) yk_table_number(table, shown_parameter(a, k, row[k]), YK_DIGITS);
        yk_table_word(table, yk_status_name(yk_row_status(a, row)));
        for (size_t k = first; k < a->width; k++)
            yk_table_number(table, yk_shown(a->session, row[k], yk_study_quantity(a, k - first)), YK_DIGITS);
    }
    yk_text_free(&name);
    yk_table_show(table, NULL, &a->session->out);
}

static void add_moments(const YkStudyAnswer *a)
{
    YkTable *table = yk_table_new(6);
    YkText name = {0};
    static const char *const heads[] = {"answer", "", "mean", "deviation", "least", "largest"};
    for (size_t k = 0; k < 6; k++) yk_table_head(table, heads[k], NULL);
    for (size_t k = 0; k < a->width - yk_study_first(a); k++) {
        YkMoments m = yk_study_moments(a, k);
        YkQuantity quantity = yk_study_quantity(a, k);
        yk_study_name(a, k, &name);
        yk_table_word(table, yk_text_get(&name));
        yk_table_word(table, yk_unit_of(a->session, quantity));
        const double values[] = {m.mean, m.deviation, m.least, m.largest};
        for (size_t v = 0; v < 4; v++)
            yk_table_number(table, m.count ? yk_shown(a->session, values[v], quantity) : NAN, YK_DIGITS);
    }
    yk_text_free(&name);
    yk_table_show(table, NULL, &a->session->out);
}

// Writes the change of the answer per unit of the parameter, and what each contributes to the worst case.
static void add_sensitivities(const YkStudyAnswer *a, size_t column)
{
    YkText *out = &a->session->out;
    YkQuantity quantity = a->columns[column].channel.quantity;
    const char *unit = yk_unit_of(a->session, quantity);
    double size = 1 / yk_shown(a->session, 1, quantity); // SI, of the unit that is shown
    YkTable *table = yk_table_new(5);
    yk_table_head(table, "parameter", NULL);
    yk_table_head(table, "derivative", NULL);
    yk_table_head(table, "by difference", NULL);
    yk_table_head(table, "tolerance", NULL);
    yk_table_head(table, "contributes", unit);
    for (size_t k = 0; k < a->axis_count; k++) {
        double scale = yk_model_parameter_unit(a->session->model, a->axes[k].name) / size,
               tolerance = yk_study_tolerance_of(a, k);
        yk_table_word(table, a->axes[k].name);
        yk_table_number(table, a->derivative[column * a->axis_count + k] * scale, YK_DIGITS);
        yk_table_number(table, a->difference[column * a->axis_count + k] * scale, YK_DIGITS);
        yk_table_number(table, shown_parameter(a, k, tolerance), YK_DIGITS);
        yk_table_number(table, fabs(yk_study_slope(a, column, k)) * tolerance / size, YK_DIGITS);
    }
    YkTolerance t = yk_study_tolerance(a, column);
    yk_text_format(out, "\n%s at the file's values and pose: ", a->columns[column].name);
    if (isnan(t.worst))
        yk_text_puts(out, "not determined, nor are its derivatives\n");
    else
        yk_text_format(out, "worst case +- %e %s, standard deviation %e %s\n", t.worst / size, unit, t.root / size,
                       unit);
    yk_table_show(table, NULL, out);
}

void yk_study_text(YkStudyAnswer *a)
{
    YkText *out = &a->session->out;
    yk_text_format(out, "%s: %z designs", yk_model_name(a->session->model), a->done);
    if (a->over.name) yk_text_format(out, ", %z poses each over %s", a->pose_count, a->over.name);
    if (a->is_sample) yk_text_format(out, ", seed %z", (size_t)a->seed);
    yk_text_puts(out, "\n");
    for (int status = YK_SINGULAR; status >= YK_NO_MEMORY; status--) {
        size_t count = yk_study_count(a, (YkStatus)status);
        if (status != YK_OK && count > 0) yk_text_format(out, "%s: %z\n", yk_status_name((YkStatus)status), count);
    }
    add_rows(a);
    scale_by_least(a);
    add_moments(a);
    for (size_t c = 0; a->derivative && a->sensitivity_status >= 0 && c < a->column_count; c++) add_sensitivities(a, c);
}
