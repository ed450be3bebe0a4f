// `yoke cam --format csv`.
#include "verbs/cam/cam.h"
#include "write/csv.h"

void yk_cam_csv(const YkCamAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    YkCamColumn columns[YK_CAM_COLUMNS_MAX];
    double values[YK_CAM_COLUMNS_MAX];
    size_t count = yk_cam_columns(answer, columns);
    for (size_t c = 0; c < count; c++) yk_csv_name(&csv, columns[c].name);
    yk_csv_row(&csv);
    for (size_t row = 0; row <= answer->steps && answer->steps > 0; row++) {
        yk_cam_row(answer, yk_cam_row_angle(answer, row), values);
        for (size_t c = 0; c < count; c++) yk_csv_number(&csv, values[c]);
        yk_csv_row(&csv);
    }
}
