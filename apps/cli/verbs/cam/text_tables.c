// Writes the tables of `yoke cam`: other laws side by side, rows over a turn.
#include <math.h>
#include "verbs/cam/text.h"

static void add_law(const YkCamAnswer *answer, YkTable *table, const char *law, const YkCamFactors *factors,
                    const YkCamSummary *s)
{
    YkQuantity lift = yk_cam_lift_quantity(answer);
    double size = 1;
    yk_model_unit(answer->session->model, lift, &size);
    yk_table_word(table, law);
    yk_table_number(table, factors ? factors->v : (double)NAN, YK_DIGITS);
    yk_table_number(table, factors ? factors->a : (double)NAN, YK_DIGITS);
    yk_table_number(table, factors ? factors->j : (double)NAN, YK_DIGITS);
    for (int k = 1; k <= 3; k++) yk_table_number(table, fabs(s->peak[k].value) / size, YK_DIGITS);
    yk_table_number(table, fabs(yk_shown(answer->session, s->pressure.value, YK_QUANTITY_ANGLE)), YK_DIGITS);
    yk_table_number(table, yk_shown(answer->session, s->surface_convex.value, YK_QUANTITY_LENGTH), YK_DIGITS);
}

void yk_cam_add_others(const YkCamAnswer *answer)
{
    static const char *const names[] = {"v", "a", "j"};
    YkText *out = &answer->session->out;
    YkText unit = {0};
    if (answer->other_count == 0) return;
    YkTable *table = yk_table_new(9);
    yk_table_head(table, "law", NULL);
    yk_table_head(table, "Cv", NULL);
    yk_table_head(table, "Ca", NULL);
    yk_table_head(table, "Cj", NULL);
    for (int k = 1; k <= 3; k++) {
        const YkCamColumn column = {"", yk_cam_lift_quantity(answer), k};
        yk_text_clear(&unit);
        yk_cam_unit(answer, &column, &unit);
        yk_table_head(table, names[k - 1], yk_text_get(&unit));
    }
    yk_table_head(table, "pressure", yk_unit_of(answer->session, YK_QUANTITY_ANGLE));
    yk_table_head(table, "convex", yk_unit_of(answer->session, YK_QUANTITY_LENGTH));
    add_law(answer, table, answer->size.law, NULL, &answer->summary);
    for (size_t i = 0; i < answer->other_count; i++)
        add_law(answer, table, answer->others[i].law, &answer->others[i].factors, &answer->others[i].summary);
    yk_text_puts(out,
                 "\nThe same strokes by other laws: peak factors, largest values, pressure angle, sharpest surface\n");
    yk_cam_table(out, table);
    yk_text_free(&unit);
}

void yk_cam_add_rows(const YkCamAnswer *answer)
{
    YkCamColumn columns[YK_CAM_COLUMNS_MAX];
    double values[YK_CAM_COLUMNS_MAX];
    size_t count = yk_cam_columns(answer, columns);
    YkText *out = &answer->session->out, unit = {0};
    if (answer->steps == 0) return;
    YkTable *table = yk_table_new(count);
    for (size_t c = 0; c < count; c++) {
        yk_text_clear(&unit);
        yk_cam_unit(answer, &columns[c], &unit);
        yk_table_head(table, columns[c].name, yk_text_get(&unit));
    }
    for (size_t row = 0; row <= answer->steps; row++) {
        yk_cam_row(answer, yk_cam_row_angle(answer, row), values);
        for (size_t c = 0; c < count; c++)
            yk_table_number(table, yk_shown(answer->session, values[c], columns[c].quantity), YK_DIGITS);
    }
    yk_text_puts(out, "\n");
    yk_cam_table(out, table);
    yk_text_free(&unit);
}
