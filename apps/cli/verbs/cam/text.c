// `yoke cam` for people, in the file's units.
#include <math.h>
#include <string.h>
#include "verbs/cam/text.h"
#include "write/table.h"

static const double to_degrees = 57.295779513082321;

static void add_head(const YkCamAnswer *answer)
{
    const YkCamSize *size = &answer->size;
    YkText *out = &answer->session->out;
    yk_text_format(out, "%s: cam %s\n\n", yk_model_name(answer->session->model), size->name);
    yk_text_format(out, "  follower      %s, %s on %s, ", size->follower, size->oscillates ? "turns" : "slides",
                   size->carrier);
    if (size->face == YK_CAM_FACE_ROLLER) {
        yk_text_puts(out, "roller of radius ");
        yk_cam_value(answer, size->roller, YK_QUANTITY_LENGTH);
    } else {
        yk_text_puts(out, size->face == YK_CAM_FACE_FLAT ? "flat face" : "knife edge");
    }
    yk_text_puts(out, size->is_groove ? ", in a groove\n" : size->is_conjugate ? ", with a second roller\n" : "\n");
    yk_text_puts(out, "  base circle   radius ");
    yk_cam_value(answer, size->base, YK_QUANTITY_LENGTH);
    if (size->oscillates) {
        yk_text_puts(out, ", centres apart ");
        yk_cam_value(answer, size->centers, YK_QUANTITY_LENGTH);
        if (size->face != YK_CAM_FACE_FLAT) {
            yk_text_puts(out, ", arm ");
            yk_cam_value(answer, size->arm, YK_QUANTITY_LENGTH);
        }
    } else {
        yk_text_puts(out, ", offset ");
        yk_cam_value(answer, size->offset, YK_QUANTITY_LENGTH);
    }
    yk_text_puts(out, "\n  speed         ");
    if (answer->speed != 0)
        yk_cam_speed(answer, answer->speed);
    else
        yk_text_puts(out, "not known: no drive at constant rate; --speed gives one");
    yk_text_puts(out, "\n");
}

// Writes a condition as "s(120 deg) = 20 mm".
static void add_condition(const YkCamAnswer *answer, YkCamCondition condition, YkText *text)
{
    static const char *const names[] = {"s", "v", "a", "j", "p"};
    const YkCamColumn column = {"", yk_cam_lift_quantity(answer), condition.order};
    double size = 1;
    bool is_rad = strcmp(yk_unit_of(answer->session, YK_QUANTITY_ANGLE), "rad") == 0; // then degrees
    yk_text_format(text, "%s(", names[condition.order]);
    yk_cam_number(text,
                  is_rad ? condition.at * to_degrees : yk_shown(answer->session, condition.at, YK_QUANTITY_ANGLE));
    yk_text_format(text, " %s) = ", is_rad ? "deg" : yk_unit_of(answer->session, YK_QUANTITY_ANGLE));
    yk_model_unit(answer->session->model, column.quantity, &size);
    yk_cam_number(text, condition.value / size);
    if (condition.value == 0) return;
    yk_text_puts(text, " ");
    yk_cam_unit(answer, &column, text);
}

static void add_conditions(const YkCamAnswer *answer, size_t segment, size_t count)
{
    YkText *out = &answer->session->out;
    yk_text_format(out, "  conditions of segment %z: ", segment + 1);
    for (size_t i = 0; i < count; i++) {
        if (i > 0) yk_text_puts(out, i % 6 == 0 ? ",\n    " : ", ");
        add_condition(answer, yk_cam_condition(answer->design, segment, i), out);
    }
    yk_text_puts(out, "\n");
}

static void add_program(const YkCamAnswer *answer)
{
    YkText *out = &answer->session->out;
    const char *unit = yk_unit_of(answer->session, YK_QUANTITY_ANGLE);
    size_t count = yk_cam_segment_count(answer->design);
    YkTable *table = yk_table_new(5);
    yk_table_head(table, "segment", NULL);
    yk_table_head(table, "from", unit);
    yk_table_head(table, "to", unit);
    yk_table_head(table, "conditions", NULL);
    yk_table_head(table, "condition number", NULL);
    for (size_t i = 0; i < count; i++) {
        YkCamSegment segment = yk_cam_segment(answer->design, i);
        bool is_solved = segment.condition_count > 0;
        yk_table_word(table, segment.kind);
        yk_table_number(table, yk_shown(answer->session, segment.from, YK_QUANTITY_ANGLE), YK_DIGITS);
        yk_table_number(table, yk_shown(answer->session, segment.to, YK_QUANTITY_ANGLE), YK_DIGITS);
        yk_table_number(table, is_solved ? (double)segment.condition_count : (double)NAN, YK_DIGITS);
        yk_table_number(table, is_solved ? segment.condition_number : (double)NAN, 4);
    }
    yk_text_format(out, "\nMotion program: law %s\n", answer->size.law);
    yk_cam_table(out, table);
    for (size_t i = 0; i < count; i++) {
        size_t conditions = yk_cam_segment(answer->design, i).condition_count;
        if (conditions > 0) add_conditions(answer, i, conditions);
    }
}

static void add_strokes(const YkCamAnswer *answer)
{
    YkText *out = &answer->session->out;
    const char *unit = yk_unit_of(answer->session, YK_QUANTITY_ANGLE);
    YkTable *table = yk_table_new(6);
    yk_table_head(table, "from", unit);
    yk_table_head(table, "to", unit);
    yk_table_head(table, "lift h", yk_unit_of(answer->session, yk_cam_lift_quantity(answer)));
    yk_table_head(table, "Cv", NULL);
    yk_table_head(table, "Ca", NULL);
    yk_table_head(table, "Cj", NULL);
    for (size_t i = 0; i < answer->stroke_count; i++) {
        const YkCamStroke *s = &answer->strokes[i];
        yk_table_number(table, yk_shown(answer->session, s->from, YK_QUANTITY_ANGLE), YK_DIGITS);
        yk_table_number(table, yk_shown(answer->session, s->to, YK_QUANTITY_ANGLE), YK_DIGITS);
        yk_table_number(table, yk_shown(answer->session, s->lift, yk_cam_lift_quantity(answer)), YK_DIGITS);
        yk_table_number(table, s->factors.v, YK_DIGITS);
        yk_table_number(table, s->factors.a, YK_DIGITS);
        yk_table_number(table, s->factors.j, YK_DIGITS);
    }
    yk_text_puts(out, "\nStrokes, with peak factors (v = Cv h/beta, a = Ca h/beta^2, j = Cj h/beta^3)\n");
    yk_cam_table(out, table);
}

// Writes a peak at the cam's speed, in the file's unit of the lift, per second: "4860 mm/s^2".
static void add_in_time(const YkCamAnswer *answer, double peak, int order, YkText *text)
{
    double rate = 1, size = 1;
    const char *unit = yk_model_unit(answer->session->model, yk_cam_lift_quantity(answer), &size);
    for (int k = 0; k < order; k++) rate *= answer->speed;
    yk_cam_number(text, peak * rate / size);
    yk_text_format(text, " %s", unit);
    if (order > 0) yk_text_puts(text, "/s");
    if (order > 1) yk_text_format(text, "^%d", order);
}

static void add_peaks(const YkCamAnswer *answer)
{
    static const char *const names[] = {"s", "v", "a", "j", "p"};
    YkText *out = &answer->session->out;
    YkTable *table = yk_table_new(5);
    YkText words = {0};
    yk_table_head(table, "largest", NULL);
    yk_table_head(table, "", NULL);
    yk_table_head(table, "", NULL);
    yk_table_head(table, "at", yk_unit_of(answer->session, YK_QUANTITY_ANGLE));
    yk_table_head(table, answer->speed != 0 ? "at this speed" : "", NULL);
    for (int k = 0; k < 5; k++) {
        const YkCamColumn column = {names[k], yk_cam_lift_quantity(answer), k};
        YkCamExtreme peak = answer->summary.peak[k];
        double size = 1;
        yk_model_unit(answer->session->model, column.quantity, &size);
        yk_table_word(table, names[k]);
        yk_table_number(table, peak.value / size, YK_DIGITS);
        yk_text_clear(&words);
        yk_cam_unit(answer, &column, &words);
        yk_table_word(table, yk_text_get(&words));
        yk_table_number(table, yk_shown(answer->session, peak.angle, YK_QUANTITY_ANGLE), YK_DIGITS);
        yk_text_clear(&words);
        if (answer->speed != 0) add_in_time(answer, peak.value, k, &words);
        yk_table_word(table, yk_text_get(&words));
    }
    yk_text_free(&words);
    yk_text_puts(out, "\n");
    yk_cam_table(out, table);
}

static void add_jumps(const YkCamAnswer *answer)
{
    static const char *const names[] = {"s", "v", "a"};
    YkText *out = &answer->session->out;
    YkCamJump jumps[YK_CAM_JUMPS_MAX];
    size_t count = yk_cam_jumps(answer->design, jumps, YK_CAM_JUMPS_MAX);
    for (size_t i = 0; i < count && i < YK_CAM_JUMPS_MAX; i++) {
        const YkCamColumn column = {"", yk_cam_lift_quantity(answer), jumps[i].order};
        double size = 1;
        yk_model_unit(answer->session->model, column.quantity, &size);
        yk_text_format(out, "  %s jumps by ", names[jumps[i].order]);
        yk_cam_number(out, jumps[i].size / size);
        yk_text_puts(out, " ");
        yk_cam_unit(answer, &column, out);
        yk_cam_at_angle(answer, jumps[i].angle);
        yk_text_puts(out, "\n");
    }
}

void yk_cam_text(const YkCamAnswer *answer)
{
    yk_scale_begin(answer->session);
    add_head(answer);
    add_program(answer);
    add_strokes(answer);
    add_peaks(answer);
    add_jumps(answer);
    yk_cam_add_geometry(answer, &answer->summary, "Geometry");
    yk_cam_add_base(answer);
    if (answer->size.is_conjugate) yk_cam_add_geometry(answer, &answer->second, "The second cam");
    yk_cam_add_forces(answer);
    yk_cam_add_others(answer);
    yk_cam_add_rows(answer);
}
