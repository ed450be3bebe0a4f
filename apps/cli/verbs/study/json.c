// `yoke study --format json`.
#include <math.h>
#include "verbs/study/study.h"

static void add_parameters(const YkStudyAnswer *a, YkJson *json)
{
    yk_json_object(json, "parameters", YK_JSON_LINES);
    for (size_t k = 0; k < a->axis_count; k++) {
        const YkAxis *axis = &a->axes[k];
        yk_json_object(json, axis->name, YK_JSON_INLINE);
        yk_json_number(json, "nominal", yk_model_parameter(a->session->model, axis->name));
        if (a->is_sample) {
            yk_json_number(json, "mean", yk_distribution_mean(&axis->distribution));
            yk_json_number(json, "deviation", yk_distribution_deviation(&axis->distribution));
        } else {
            yk_json_number(json, "from", axis->from);
            yk_json_number(json, "to", axis->to);
            yk_json_integer(json, "count", (long long)axis->count);
        }
        yk_json_number(json, "tolerance", yk_study_tolerance_of(a, k));
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_statuses(const YkStudyAnswer *a, YkJson *json)
{
    yk_json_object(json, "statuses", YK_JSON_INLINE);
    for (int status = YK_NO_MEMORY; status <= YK_SINGULAR; status++) {
        size_t count = yk_study_count(a, (YkStatus)status);
        if (count > 0) yk_json_integer(json, yk_status_name((YkStatus)status), (long long)count);
    }
    yk_json_end(json);
}

static void add_answers(const YkStudyAnswer *a, YkJson *json)
{
    YkText name = {0};
    yk_json_object(json, "answers", YK_JSON_LINES);
    for (size_t k = 0; k < a->width - yk_study_first(a); k++) {
        YkMoments m = yk_study_moments(a, k);
        yk_study_name(a, k, &name);
        yk_json_object(json, yk_text_get(&name), YK_JSON_INLINE);
        yk_json_integer(json, "count", (long long)m.count);
        yk_json_number(json, "mean", m.count ? m.mean : NAN);
        yk_json_number(json, "deviation", m.count ? m.deviation : NAN);
        yk_json_number(json, "least", m.least);
        yk_json_number(json, "largest", m.largest);
        yk_json_end(json);
    }
    yk_json_end(json);
    yk_text_free(&name);
}

static void add_sensitivities(const YkStudyAnswer *a, YkJson *json)
{
    yk_json_object(json, "sensitivities", YK_JSON_LINES);
    for (size_t c = 0; c < a->column_count; c++) {
        yk_json_object(json, a->columns[c].name, YK_JSON_LINES);
        for (size_t k = 0; k < a->axis_count; k++) {
            yk_json_object(json, a->axes[k].name, YK_JSON_INLINE);
            yk_json_number(json, "derivative", a->derivative[c * a->axis_count + k]);
            yk_json_number(json, "difference", a->difference[c * a->axis_count + k]);
            yk_json_end(json);
        }
        YkTolerance t = yk_study_tolerance(a, c);
        yk_json_number(json, "worst", t.worst);
        yk_json_number(json, "root", t.root);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_rows(YkStudyAnswer *a, YkJson *json)
{
    yk_json_list(json, "rows", YK_JSON_LINES);
    for (size_t d = 0; d < a->done; d++) {
        const double *row = yk_study_row(a, d);
        yk_json_list(json, NULL, YK_JSON_INLINE);
        for (size_t k = 0; k < a->axis_count; k++) yk_json_number(json, NULL, row[k]);
        yk_json_string(json, NULL, yk_status_name(yk_row_status(a, row)));
        for (size_t k = a->axis_count + 1; k < a->width; k++) yk_json_number(json, NULL, row[k]);
        yk_json_end(json);
        yk_study_flush(a, YK_STUDY_PIECE);
    }
    yk_json_end(json);
}

static void add_columns(const YkStudyAnswer *a, YkJson *json)
{
    YkText name = {0};
    yk_json_list(json, "columns", YK_JSON_INLINE);
    for (size_t k = 0; k < a->axis_count; k++) yk_json_string(json, NULL, a->axes[k].name);
    yk_json_string(json, NULL, "status");
    yk_json_string(json, NULL, "poses");
    for (size_t k = 0; k < a->width - yk_study_first(a); k++) {
        yk_study_name(a, k, &name);
        yk_json_string(json, NULL, yk_text_get(&name));
    }
    yk_json_end(json);
    yk_text_free(&name);
}

void yk_study_json(YkStudyAnswer *a)
{
    YkJson json = {.text = &a->session->out};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    yk_json_string(&json, "model", yk_model_name(a->session->model));
    yk_json_string(&json, "status", "ok");
    yk_json_integer(&json, "designs", (long long)a->done);
    yk_json_integer(&json, "poses", (long long)a->pose_count);
    if (a->is_sample) yk_json_integer(&json, "seed", (long long)a->seed);
    add_parameters(a, &json);
    add_statuses(a, &json);
    add_answers(a, &json);
    if (a->derivative && a->sensitivity_status >= 0) add_sensitivities(a, &json);
    add_columns(a, &json);
    add_rows(a, &json);
    yk_json_end(&json);
}
