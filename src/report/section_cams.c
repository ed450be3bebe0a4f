// Writes the section on cams: each outline to scale, with lift and pressure angle over a turn.
#include <math.h>
#include "picture/cam_picture.h"
#include "report/html.h"
#include "report/report.h"
#include "write/amount.h"

enum { DIGITS = 6, ROWS = 24 };
static const double outline_tolerance = 1e-3; // of the base circle

static void add_outline(const YkCamDesign *design, const YkCamSize *size, YkText *html)
{
    YkCamPicture picture;
    YkText svg = {0}, told = {0};
    if (!yk_cam_picture_take(&picture, design, outline_tolerance * fmax(size->base, 1e-6), 0)) {
        if (picture.ran_out) yk_text_fail(html);
        return;
    }
    yk_cam_picture_svg(&picture, &svg);
    yk_cam_picture_free(&picture);
    yk_text_format(&told, "Outline of the cam %s to scale, with its base circle and its follower at cam angle 0",
                   size->name);
    yk_html_image(html, yk_text_get(&svg), svg.length, yk_text_get(&told), "");
    html->failed |= svg.failed || told.failed;
    yk_text_free(&svg);
    yk_text_free(&told);
}

static void add_fact(const YkReportPage *report, YkTable *table, const char *what, YkCamExtreme extreme,
                     YkQuantity quantity)
{
    YkText value = {0}, at = {0};
    if (!isfinite(extreme.value)) return;
    yk_report_amount(report, &value, extreme.value, quantity);
    yk_report_amount(report, &at, extreme.angle, YK_QUANTITY_ANGLE);
    yk_table_word(table, what);
    yk_table_word(table, yk_text_get(&value));
    yk_table_word(table, yk_text_get(&at));
    yk_text_free(&value);
    yk_text_free(&at);
}

static void add_facts(const YkReportPage *report, const YkCamDesign *design, const YkCamSize *size, YkText *html)
{
    YkCamSummary s = yk_cam_summary(design);
    YkQuantity lift = size->oscillates ? YK_QUANTITY_ANGLE : YK_QUANTITY_LENGTH;
    YkTable *table = yk_table_new(3);
    yk_table_head(table, "what", NULL);
    yk_table_head(table, "value", NULL);
    yk_table_head(table, "at cam angle", NULL);
    add_fact(report, table, "least lift", s.lift_low, lift);
    add_fact(report, table, "largest lift", s.lift_high, lift);
    if (size->face != YK_CAM_FACE_FLAT)
        add_fact(report, table, "largest pressure angle", s.pressure, YK_QUANTITY_ANGLE);
    add_fact(report, table, "smallest convex radius of the surface", s.surface_convex, YK_QUANTITY_LENGTH);
    add_fact(report, table, "smallest hollow radius of the surface", s.surface_hollow, YK_QUANTITY_LENGTH);
    YkText caption = {0};
    yk_text_format(&caption, "The cam %s: law %s, %s follower", size->name, size->law, yk_cam_face_name(size->face));
    yk_html_table(html, table, yk_text_get(&caption));
    yk_text_free(&caption);
}

static void add_program(const YkReportPage *report, const YkCamDesign *design, const YkCamSize *size, YkText *html)
{
    static const char *const heads[] = {"s", "v = ds/dtheta", "a = dv/dtheta", "j = da/dtheta"};
    YkQuantity lift = size->oscillates ? YK_QUANTITY_ANGLE : YK_QUANTITY_LENGTH;
    const char *angle = yk_model_shown_unit(report->model, YK_QUANTITY_ANGLE, NULL);
    YkTable *table = yk_table_new(6);
    yk_table_head(table, "cam angle", angle);
    for (int i = 0; i < 4; i++) {
        YkText unit = {0};
        yk_text_puts(&unit, yk_model_shown_unit(report->model, lift, NULL));
        if (i == 1) yk_text_puts(&unit, "/rad");
        if (i > 1) yk_text_format(&unit, "/rad^%d", i);
        yk_table_head(table, heads[i], yk_text_get(&unit));
        yk_text_free(&unit);
    }
    yk_table_head(table, "pressure angle", angle);
    for (int row = 0; row <= ROWS; row++) {
        YkCamPoint p = yk_cam_at(design, size->period * row / ROWS);
        yk_table_number(table, yk_amount_in_unit(report->model, NULL, size->period * row / ROWS, YK_QUANTITY_ANGLE),
                        DIGITS);
        for (int i = 0; i < 4; i++)
            yk_table_number(table, yk_amount_in_unit(report->model, NULL, p.lift[i], lift), DIGITS);
        yk_table_number(table, yk_amount_in_unit(report->model, NULL, p.pressure_angle, YK_QUANTITY_ANGLE), DIGITS);
    }
    yk_html_table(html, table, "Its motion program");
}

void yk_section_cams(YkReportPage *report, YkText *html, YkProblems *problems)
{
    (void)problems;
    for (size_t cam = 0; cam < report->model->cam_count; cam++) {
        YkCamDesign *design = yk_cam_design_new(report->model, cam);
        html->failed |= !design;
        if (!design) return;
        YkCamSize size = yk_cam_size(design);
        yk_html_element(html, "h3", size.name);
        add_outline(design, &size, html);
        add_facts(report, design, &size, html);
        add_program(report, design, &size, html);
        yk_cam_design_free(design);
    }
}
