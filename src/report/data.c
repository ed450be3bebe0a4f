// Writes the script's data: numbers of every row, positions of the bodies, what can be shown. Values are in the page's
// units, places in pixels of the drawing.
#include <math.h>
#include "base/number.h"
#include "elementary/elementary.h"
#include "report/panels.h"
#include "report/report.h"
#include "write/json.h"

enum { DIGITS = 7 }; // a page does not show more

// Rows of numbers are most of the data, so they are written without blanks; null unless finite.
typedef struct List {
    YkJson *json;
    bool has_some;
} List;

static List open_list(YkJson *json, const char *key)
{
    yk_json_list(json, key, YK_JSON_INLINE);
    return (List){.json = json};
}

static void add(List *list, double value)
{
    char number[YK_NUMBER_SIZE];
    YkText *text = list->json->text;
    if (list->has_some) yk_text_puts(text, ",");
    list->has_some = true;
    if (isfinite(value))
        yk_text_add(text, number, yk_number_write_digits(value == 0 ? 0.0 : value, DIGITS, number));
    else
        yk_text_puts(text, "null");
}

static double pixel(double value)
{
    return 0.01 * rint(100 * value);
}

static void add_axis(const YkReportPage *report, YkJson *json)
{
    YkQuantity quantity = yk_report_axis_quantity(report);
    yk_json_number(json, "seconds", yk_report_seconds(report));
    yk_json_bool(json, "goes_back", yk_report_goes_back(report));
    double span = report->motion.to - report->motion.from, now = report->motion.from;
    bool is_sweep = report->motion.kind == YK_REPORT_TURN || report->motion.kind == YK_REPORT_RANGE;
    if (is_sweep) now = yk_state_coordinate(report->start, (size_t)report->motion.coordinate).position;
    yk_json_number(json, "start", (double)report->motion.steps * (now - report->motion.from) / span); // a row
    yk_json_object(json, "axis", YK_JSON_INLINE);
    yk_json_string(json, "name", yk_report_axis(report));
    yk_json_string(json, "unit", yk_report_unit(report, quantity, NULL));
    List list = open_list(json, "values");
    for (size_t row = 0; row < report->row_count; row++)
        add(&list, yk_report_in_unit(report, report->at[row], quantity));
    yk_json_end(json);
    yk_json_end(json);
}

static void add_columns(const YkReportPage *report, YkJson *json)
{
    yk_json_list(json, "columns", YK_JSON_LINES);
    for (size_t c = 0; c < report->column_count; c++) {
        const YkReportColumn *column = &report->columns[c];
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", column->name);
        yk_json_string(json, "unit", yk_report_unit(report, column->channel.quantity, NULL));
        List list = open_list(json, "values");
        for (size_t row = 0; row < report->row_count; row++)
            add(&list, yk_report_in_unit(report, yk_report_value(report, row, c), column->channel.quantity));
        yk_json_end(json);
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_panels(const YkReportPage *report, YkJson *json)
{
    YkPanel panels[YK_PANELS_MAX];
    size_t count = yk_report_panels(report, panels, YK_PANELS_MAX);
    yk_json_list(json, "panels", YK_JSON_LINES);
    for (size_t k = 0; k < count; k++) {
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "id", panels[k].id);
        yk_json_string(json, "unit", yk_report_unit(report, panels[k].quantity, NULL));
        List list = open_list(json, "columns");
        for (size_t i = 0; i < panels[k].count; i++) add(&list, (double)panels[k].columns[i]);
        yk_json_end(json);
        yk_json_end(json);
    }
    yk_json_end(json);
}

// Writes the columns of position, rate and acceleration of each coordinate.
static void add_readout(const YkReportPage *report, YkJson *json)
{
    yk_json_list(json, "readout", YK_JSON_INLINE);
    for (size_t c = 0; c < yk_coordinate_count(report->mech); c++) {
        if (yk_report_column(report, YK_ROLE_COORDINATE, c, 0) < 0) continue;
        List list = open_list(json, NULL);
        for (int order = 0; order < 3; order++) add(&list, yk_report_column(report, YK_ROLE_COORDINATE, c, order));
        yk_json_end(json);
    }
    yk_json_end(json);
}

// --- The drawing

// Writes for every body the place of its origin at the drawn pose and, for every row, shift and turn (deg, cumulative).
static void add_bodies(const YkReportPage *report, YkJson *json)
{
    yk_json_list(json, "bodies", YK_JSON_LINES);
    for (size_t b = 0; b < yk_model_body_count(report->model); b++) {
        YkShift drawn = yk_drawing_shift(report->drawing, b, yk_drawing_reference(report->drawing));
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", report->model->bodies[b].name);
        List center = open_list(json, "center");
        add(&center, pixel(drawn.center.x));
        add(&center, pixel(drawn.center.y));
        yk_json_end(json);
        for (int axis = 0; axis < 2; axis++) {
            List list = open_list(json, axis == 0 ? "x" : "y");
            for (size_t row = 0; row < report->posed; row++) {
                YkShift shift = yk_drawing_shift(report->drawing, b, row);
                add(&list, pixel(axis == 0 ? shift.by.x : shift.by.y));
            }
            yk_json_end(json);
        }
        List turns = open_list(json, "turn");
        double turn = 0;
        for (size_t row = 0; row < report->posed; row++) {
            YkShift shift = yk_drawing_shift(report->drawing, b, row);
            turn = row == 0 ? shift.turn : turn + yk_remainder(shift.turn - turn, 2 * YK_PI);
            add(&turns, 1e-4 * rint(1e4 * turn * 180 / YK_PI));
        }
        yk_json_end(json);
        yk_json_end(json);
    }
    yk_json_end(json);
}

// Writes a place on a body, which the label there follows.
static void add_place(const YkReportPage *report, YkJson *json, size_t body, YkVec at)
{
    YkVec place = yk_drawing_pixel(report->drawing, at);
    yk_json_integer(json, "body", (long long)body);
    List list = open_list(json, "at");
    add(&list, pixel(place.x));
    add(&list, pixel(place.y));
    yk_json_end(json);
}

static void add_columns_of(const YkReportPage *report, YkJson *json, YkReportRole role, size_t of)
{
    List list = open_list(json, "columns");
    for (size_t c = 0; c < report->column_count; c++)
        if (report->columns[c].role == role && report->columns[c].of == of) add(&list, (double)c);
    yk_json_end(json);
}

static void add_joints(const YkReportPage *report, YkJson *json)
{
    const YkFrame *frames = yk_drawing_frames(report->drawing, yk_drawing_reference(report->drawing));
    yk_json_list(json, "joints", YK_JSON_LINES);
    for (size_t j = 0; j < yk_model_joint_count(report->model); j++) {
        const YkJoint *joint = &report->model->joints[j];
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", joint->name);
        add_place(report, json, (size_t)joint->body[1], yk_drawing_joint(report->drawing, frames, joint, 1));
        add_columns_of(report, json, YK_ROLE_FORCE, j);
        yk_json_end(json);
    }
    yk_json_end(json);
    yk_json_list(json, "middles", YK_JSON_LINES); // of bodies: where their names hang
    for (size_t b = 0; b < yk_model_body_count(report->model); b++) {
        yk_json_object(json, NULL, YK_JSON_INLINE);
        add_place(report, json, b, yk_drawing_middle(report->drawing, frames, b));
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_points(const YkReportPage *report, YkJson *json)
{
    const YkFrame *frames = yk_drawing_frames(report->drawing, yk_drawing_reference(report->drawing));
    yk_json_list(json, "points", YK_JSON_LINES);
    for (size_t i = 0; i < report->traced_count; i++) {
        const YkPoint *point = &report->model->points[report->traced[i]];
        YkText name = {0};
        yk_text_format(&name, "%s.%s", report->model->bodies[point->body].name, point->name);
        yk_json_object(json, NULL, YK_JSON_INLINE);
        yk_json_string(json, "name", yk_text_get(&name));
        yk_json_integer(json, "point", (long long)report->traced[i]);
        yk_json_bool(json, "shown", i < report->traced_shown);
        add_place(report, json, (size_t)point->body, yk_frame_apply(frames[point->body], point->at));
        yk_json_number(json, "turned", -yk_drawing_follower_turn(report->drawing, (size_t)point->body));
        add_columns_of(report, json, YK_ROLE_VELOCITY, report->traced[i]);
        yk_json_end(json);
        json->text->failed |= name.failed;
        yk_text_free(&name);
    }
    yk_json_end(json);
}

void yk_report_data(YkReportPage *report, YkText *text)
{
    YkJson json = {.text = text};
    yk_json_object(&json, NULL, YK_JSON_LINES);
    add_axis(report, &json);
    add_columns(report, &json);
    add_panels(report, &json);
    add_readout(report, &json);
    if (report->drawing && report->posed == report->row_count && report->posed > 1) {
        add_bodies(report, &json);
        add_joints(report, &json);
        add_points(report, &json);
    }
    yk_json_end(&json);
}
