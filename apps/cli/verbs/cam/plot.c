// Writes diagrams and outlines of a cam as files.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "picture/cam_picture.h"
#include "picture/plot.h"
#include "session.h"
#include "verbs/cam/cam.h"
#include "write/csv.h"

enum { POINTS = 1441, CURVES = 5 };
static const double full_turn = 6.28318530717958647692;

// Fills in s, v, a, j, then the pressure angle, of one law.
static void fill(const YkCamAnswer *answer, const YkCamDesign *design, double *values)
{
    YkQuantity lift = yk_cam_lift_quantity(answer);
    for (size_t i = 0; i < POINTS; i++) {
        // The end of the turn, not its start again.
        double angle = i + 1 < POINTS ? full_turn * (double)i / (POINTS - 1) : nextafter(full_turn, 0);
        YkCamPoint p = yk_cam_at(design, angle);
        for (size_t k = 0; k < 4; k++) values[k * POINTS + i] = yk_shown(answer->session, p.lift[k], lift);
        values[4 * POINTS + i] = yk_shown(answer->session, p.pressure_angle, YK_QUANTITY_ANGLE);
    }
}

typedef struct Diagram {
    double *values; // x, then CURVES for each law
    YkPlotColumn *columns;
    YkText names[CURVES * (YK_CAM_LAWS_MAX + 1)], units[CURVES];
} Diagram;

static void name_columns(const YkCamAnswer *answer, Diagram *diagram)
{
    static const char *const names[] = {"s", "v", "a", "j", "phi"};
    for (size_t k = 0; k < CURVES; k++) {
        const YkCamColumn column = {"", k == 4 ? YK_QUANTITY_ANGLE : yk_cam_lift_quantity(answer), k == 4 ? 0 : (int)k};
        if (k == 4) yk_text_puts(&diagram->units[k], "pressure angle, ");
        yk_cam_unit(answer, &column, &diagram->units[k]);
    }
    for (size_t l = 0; l <= answer->other_count; l++) {
        for (size_t k = 0; k < CURVES; k++) {
            YkText *name = &diagram->names[l * CURVES + k];
            yk_text_puts(name, names[k]);
            if (answer->other_count > 0)
                yk_text_format(name, " %s", l == 0 ? answer->size.law : answer->others[l - 1].law);
            diagram->columns[l * CURVES + k] = (YkPlotColumn){yk_text_get(name), yk_text_get(&diagram->units[k]),
                                                              diagram->values + (1 + l * CURVES + k) * POINTS};
        }
    }
}

static bool draw(const YkCamAnswer *answer, const Diagram *diagram, const char *path)
{
    YkSession *session = answer->session;
    YkText picture = {0}, title = {0};
    yk_text_format(&title, "%s: cam %s", yk_model_name(session->model), answer->size.name);
    YkPlot plot = {.title = yk_text_get(&title),
                   .x_name = "cam angle",
                   .x_unit = yk_unit_of(session, YK_QUANTITY_ANGLE),
                   .x = diagram->values,
                   .rows = POINTS,
                   .columns = diagram->columns,
                   .column_count = CURVES * (answer->other_count + 1)};
    bool good = yk_plot_draw(&plot, yk_file_kind(path), &picture, session->problems) &&
                yk_file_write(path, yk_text_get(&picture), picture.length, session->problems);
    yk_text_free(&picture);
    yk_text_free(&title);
    return good;
}

bool yk_cam_plot(const YkCamAnswer *answer, const char *path)
{
    size_t laws = answer->other_count + 1;
    bool good = false;
    Diagram *diagram = calloc(1, sizeof *diagram);
    if (diagram) {
        diagram->values = calloc((1 + CURVES * laws) * POINTS, sizeof *diagram->values);
        diagram->columns = calloc(CURVES * laws, sizeof *diagram->columns);
    }
    if (diagram && diagram->values && diagram->columns) {
        for (size_t i = 0; i < POINTS; i++)
            diagram->values[i] = yk_shown(answer->session, full_turn * (double)i / (POINTS - 1), YK_QUANTITY_ANGLE);
        for (size_t l = 0; l < laws; l++)
            fill(answer, l == 0 ? answer->design : answer->others[l - 1].design,
                 diagram->values + (1 + l * CURVES) * POINTS);
        name_columns(answer, diagram);
        good = draw(answer, diagram, path);
    } else {
        yk_session_refuse_for_memory(answer->session);
    }
    if (diagram) {
        for (size_t i = 0; i < CURVES * laws; i++) yk_text_free(&diagram->names[i]);
        for (size_t i = 0; i < CURVES; i++) yk_text_free(&diagram->units[i]);
        free(diagram->values);
        free(diagram->columns);
    }
    free(diagram);
    return good;
}

// Writes curve, x, y in m: the points of all curves.
static void add_csv(const YkCamPicture *picture, YkText *text)
{
    YkCsv csv = {.text = text};
    yk_csv_name(&csv, "curve");
    yk_csv_name(&csv, "x");
    yk_csv_name(&csv, "y");
    yk_csv_row(&csv);
    for (size_t i = 0; i < picture->count; i++) {
        for (size_t k = 0; k < picture->outlines[i].count; k++) {
            yk_csv_name(&csv, picture->outlines[i].layer);
            yk_csv_number(&csv, picture->outlines[i].points[k].x);
            yk_csv_number(&csv, picture->outlines[i].points[k].y);
            yk_csv_row(&csv);
        }
    }
}

bool yk_cam_write_profile(const YkCamAnswer *answer, const char *path)
{
    YkSession *session = answer->session;
    YkCamPicture picture;
    YkText text = {0};
    const char *ending = path + strlen(path) - 3;
    bool can = yk_cam_picture_take(&picture, answer->design, answer->tolerance, answer->cutter);
    if (picture.ran_out) return yk_session_refuse_for_memory(session);
    if (!can)
        return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "the profile cannot be made with this tolerance%s", "");
    if (strcmp(ending, "dxf") == 0) {
        yk_cam_picture_dxf(&picture, &text);
    } else if (strcmp(ending, "csv") == 0) {
        add_csv(&picture, &text);
    } else {
        yk_cam_picture_svg(&picture, &text);
    }
    yk_cam_picture_free(&picture);
    bool good = text.failed ? yk_session_refuse_for_memory(session)
                            : yk_file_write(path, yk_text_get(&text), text.length, session->problems);
    yk_text_free(&text);
    return good;
}
