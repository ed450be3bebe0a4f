// `yoke study --format jsonl`: one object a line, for programs that read row by row.
#include "verbs/study/study.h"
#include "write/json.h"

// Writes what a row of csv has; what is not valid is null.
void yk_study_jsonl(YkStudyAnswer *a)
{
    YkText name = {0};
    size_t first = yk_study_first(a);
    for (size_t d = 0; d < a->done; d++) {
        const double *row = yk_study_row(a, d);
        YkJson json = {.text = &a->session->out};
        yk_json_object(&json, NULL, YK_JSON_INLINE);
        yk_json_integer(&json, "design", (long long)d);
        for (size_t k = 0; k < a->axis_count; k++) yk_json_number(&json, a->axes[k].name, row[k]);
        yk_json_string(&json, "status", yk_status_name(yk_row_status(a, row)));
        yk_json_number(&json, "poses", row[first - 1]);
        for (size_t k = first; k < a->width; k++) {
            yk_study_name(a, k - first, &name);
            yk_json_number(&json, yk_text_get(&name), row[k]);
        }
        yk_json_end(&json);
        yk_study_flush(a, YK_STUDY_PIECE);
    }
    yk_text_free(&name);
}
