// `yoke sweep --format csv`.
#include "verbs/sweep/sweep.h"
#include "write/csv.h"

void yk_sweep_csv(const YkSweepAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    yk_csv_name(&csv, answer->over.name);
    for (size_t c = 0; c < answer->column_count; c++) yk_csv_name(&csv, answer->columns[c].name);
    yk_csv_row(&csv);
    for (size_t row = 0; answer->sweep && row < yk_sweep_row_count(answer->sweep); row++) {
        yk_csv_number(&csv, yk_sweep_at(answer->sweep, row));
        for (size_t c = 0; c < answer->column_count; c++) yk_csv_number(&csv, yk_sweep_cell(answer, row, c));
        yk_csv_row(&csv);
    }
}
