// `yoke study --format csv`.
#include "verbs/study/study.h"
#include "write/csv.h"

// Writes design, parameters, status, poses, then the answers; SI and radians. Invalid answers are empty.
void yk_study_csv(YkStudyAnswer *a)
{
    YkCsv csv = {.text = &a->session->out};
    YkText name = {0};
    size_t first = yk_study_first(a);
    yk_csv_name(&csv, "design");
    for (size_t k = 0; k < a->axis_count; k++) yk_csv_name(&csv, a->axes[k].name);
    yk_csv_name(&csv, "status");
    yk_csv_name(&csv, "poses");
    for (size_t k = first; k < a->width; k++) {
        yk_study_name(a, k - first, &name);
        yk_csv_name(&csv, yk_text_get(&name));
    }
    yk_csv_row(&csv);
    for (size_t d = 0; d < a->done; d++) {
        const double *row = yk_study_row(a, d);
        yk_csv_number(&csv, (double)d);
        for (size_t k = 0; k < a->axis_count; k++) yk_csv_number(&csv, row[k]);
        yk_csv_name(&csv, yk_status_name(yk_row_status(a, row)));
        for (size_t k = first - 1; k < a->width; k++) yk_csv_number(&csv, row[k]);
        yk_csv_row(&csv);
        yk_study_flush(a, YK_STUDY_PIECE);
    }
    yk_text_free(&name);
}
