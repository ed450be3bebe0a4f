// `yoke cam` for people, in the file's units.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "cam.h"
#include "out/table.h"
#include "out/words.h"

enum { WIDTH = 37 };
static const double to_rpm = 9.5492965855137201, to_degrees = 57.295779513082321;

static void add_number(YkText *text, double value)
{
    char digits[YK_NUMBER_SIZE];
    yk_text_add(text, digits, yk_number_write_digits(value, YK_DIGITS, digits));
}

static void value(const YkCamAnswer *answer, double of, YkQuantity quantity)
{
    yk_add_value(answer->session, &answer->session->out, of, quantity, YK_DIGITS);
}

static void at_angle(const YkCamAnswer *answer, double angle)
{
    yk_text_puts(&answer->session->out, " at ");
    value(answer, angle, YK_QUANTITY_ANGLE);
}

static void add_speed(const YkCamAnswer *answer, double speed)
{
    YkText *out = &answer->session->out;
    add_number(out, speed * to_rpm);
    yk_text_puts(out, " rpm (");
    value(answer, speed, YK_QUANTITY_ANGLE_RATE);
    yk_text_puts(out, ")");
}

static void write_table(YkText *out, YkTable *table)
{
    if (!yk_table_write(table, 2, out)) out->failed = true;
    yk_table_free(table);
}

static void add_head(const YkCamAnswer *answer)
{
    const YkCamSize *size = &answer->size;
    YkText *out = &answer->session->out;
    yk_text_format(out, "%s: cam %s\n\n", yk_model_name(answer->session->model), size->name);
    yk_text_format(out, "  follower      %s, %s on %s, ", size->follower, size->oscillates ? "turns" : "slides",
                   size->carrier);
    if (size->face == YK_CAM_ROLLER) {
        yk_text_puts(out, "roller of radius ");
        value(answer, size->roller, YK_QUANTITY_LENGTH);
    } else {
        yk_text_puts(out, size->face == YK_CAM_FLAT ? "flat face" : "knife edge");
    }
    yk_text_puts(out, size->is_groove ? ", in a groove\n" : size->is_conjugate ? ", with a second roller\n" : "\n");
    yk_text_puts(out, "  base circle   radius ");
    value(answer, size->base, YK_QUANTITY_LENGTH);
    if (size->oscillates) {
        yk_text_puts(out, ", centres apart ");
        value(answer, size->centers, YK_QUANTITY_LENGTH);
        if (size->face != YK_CAM_FLAT) {
            yk_text_puts(out, ", arm ");
            value(answer, size->arm, YK_QUANTITY_LENGTH);
        }
    } else {
        yk_text_puts(out, ", offset ");
        value(answer, size->offset, YK_QUANTITY_LENGTH);
    }
    yk_text_puts(out, "\n  speed         ");
    if (answer->speed != 0)
        add_speed(answer, answer->speed);
    else
        yk_text_puts(out, "not known: no drive at constant rate; --speed gives one");
    yk_text_puts(out, "\n");
}

// "s(120 deg) = 20 mm": a condition as one reads it.
static void add_condition(const YkCamAnswer *answer, YkCamCondition condition, YkText *text)
{
    static const char *const names[] = {"s", "v", "a", "j", "p"};
    const YkCamColumn column = {"", yk_cam_lift_quantity(answer), condition.order};
    double size = 1;
    bool is_rad = strcmp(yk_unit_of(answer->session, YK_QUANTITY_ANGLE), "rad") == 0; // then degrees, to be read
    yk_text_format(text, "%s(", names[condition.order]);
    add_number(text, is_rad ? condition.at * to_degrees : yk_shown(answer->session, condition.at, YK_QUANTITY_ANGLE));
    yk_text_format(text, " %s) = ", is_rad ? "deg" : yk_unit_of(answer->session, YK_QUANTITY_ANGLE));
    yk_model_unit(answer->session->model, column.quantity, &size);
    add_number(text, condition.value / size);
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
    write_table(out, table);
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
    write_table(out, table);
}

// A peak at the cam's speed, in m or rad and s: "0.3 m/s^2".
static void add_in_time(const YkCamAnswer *answer, double peak, int order, YkText *text)
{
    double rate = 1;
    for (int k = 0; k < order; k++) rate *= answer->speed;
    add_number(text, peak * rate);
    yk_text_puts(text, answer->size.oscillates ? " rad" : " m");
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
        yk_words_renew(&words);
        yk_cam_unit(answer, &column, &words);
        yk_table_word(table, yk_text_get(&words));
        yk_table_number(table, yk_shown(answer->session, peak.angle, YK_QUANTITY_ANGLE), YK_DIGITS);
        yk_words_renew(&words);
        if (answer->speed != 0) add_in_time(answer, peak.value, k, &words);
        yk_table_word(table, yk_text_get(&words));
    }
    out->failed |= words.failed;
    yk_text_free(&words);
    yk_text_puts(out, "\n");
    write_table(out, table);
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
        add_number(out, jumps[i].size / size);
        yk_text_puts(out, " ");
        yk_cam_unit(answer, &column, out);
        at_angle(answer, jumps[i].angle);
        yk_text_puts(out, "\n");
    }
}

static void add_extreme(const YkCamAnswer *answer, const char *what, YkCamExtreme extreme, YkQuantity quantity)
{
    YkText *out = &answer->session->out;
    yk_text_format(out, "  %s", what);
    yk_text_repeat(out, ' ', strlen(what) < WIDTH ? WIDTH - strlen(what) : 1);
    if (!isfinite(extreme.value)) {
        yk_text_puts(out, "none\n");
        return;
    }
    value(answer, extreme.value, quantity);
    at_angle(answer, extreme.angle);
    yk_text_puts(out, "\n");
}

static void add_undercut(const YkCamAnswer *answer, const char *of, const YkCamRange *ranges, size_t count)
{
    YkText *out = &answer->session->out;
    for (size_t i = 0; i < count && i < YK_CAM_RANGES_MAX; i++) {
        yk_text_format(out, "  %s is undercut from ", of);
        value(answer, ranges[i].from, YK_QUANTITY_ANGLE);
        yk_text_puts(out, " to ");
        value(answer, ranges[i].to, YK_QUANTITY_ANGLE);
        yk_text_puts(out, "\n");
    }
}

static void add_geometry(const YkCamAnswer *answer, const YkCamSummary *s, const char *title)
{
    YkText *out = &answer->session->out;
    bool is_flat = answer->size.face == YK_CAM_FLAT;
    yk_text_format(out, "\n%s\n", title);
    add_extreme(answer, "largest pressure angle", s->pressure, YK_QUANTITY_ANGLE);
    if (answer->size.face == YK_CAM_ROLLER) {
        add_extreme(answer, "pitch curve, sharpest convex radius", s->pitch_convex, YK_QUANTITY_LENGTH);
        add_extreme(answer, "pitch curve, sharpest hollow", s->pitch_hollow, YK_QUANTITY_LENGTH);
    }
    add_extreme(answer, "surface, sharpest convex radius", s->surface_convex, YK_QUANTITY_LENGTH);
    if (!is_flat) add_extreme(answer, "surface, sharpest hollow", s->surface_hollow, YK_QUANTITY_LENGTH);
    if (is_flat) {
        yk_text_puts(out, "  face width                           ");
        value(answer, s->reach_high.value - s->reach_low.value, YK_QUANTITY_LENGTH);
        yk_text_puts(out, ": from ");
        value(answer, s->reach_low.value, YK_QUANTITY_LENGTH);
        yk_text_puts(out, " to ");
        value(answer, s->reach_high.value, YK_QUANTITY_LENGTH);
        yk_text_puts(out, "\n");
    }
    add_extreme(answer, "largest radius of the cam", s->far, YK_QUANTITY_LENGTH);
    add_undercut(answer, "the surface", s->undercut, s->undercut_count);
    if (answer->size.is_groove) add_undercut(answer, "the outer wall", s->outer_undercut, s->outer_undercut_count);
}

static void add_base(const YkCamAnswer *answer)
{
    YkText *out = &answer->session->out;
    yk_text_puts(out, "  smallest base circle                 ");
    if (answer->base_status == YK_OK) {
        value(answer, answer->base.base, YK_QUANTITY_LENGTH);
    } else {
        yk_text_puts(out, "none");
    }
    yk_text_puts(out, " for a pressure angle up to ");
    value(answer, answer->limits.pressure, YK_QUANTITY_ANGLE);
    if (answer->limits.curvature > 0) {
        yk_text_puts(out, " and convex radii from ");
        value(answer, answer->limits.curvature, YK_QUANTITY_LENGTH);
    } else {
        yk_text_puts(out, " without undercut");
    }
    if (answer->base_status == YK_OK) {
        yk_text_format(out, "; %s decides", answer->base.by_pressure ? "the pressure angle" : "the curvature");
        at_angle(answer, answer->base.angle);
    }
    yk_text_puts(out, "\n");
}

static void add_forces(const YkCamAnswer *answer)
{
    YkText *out = &answer->session->out;
    const YkCamForceSummary *f = &answer->forces;
    YkQuantity effort = answer->size.oscillates ? YK_QUANTITY_TORQUE : YK_QUANTITY_FORCE;
    if (!answer->has_forces) return;
    yk_text_puts(out, "\nForces");
    yk_text_puts(out, answer->loads.is_partial ? " (of what acts along the follower's coordinate only)\n" : "\n");
    add_extreme(answer, "contact force, lowest", f->contact_low, YK_QUANTITY_FORCE);
    add_extreme(answer, "contact force, highest", f->contact_high, YK_QUANTITY_FORCE);
    add_extreme(answer, "camshaft torque, lowest", f->torque_low, YK_QUANTITY_TORQUE);
    add_extreme(answer, "camshaft torque, highest", f->torque_high, YK_QUANTITY_TORQUE);
    yk_text_puts(out, "  camshaft torque, mean                ");
    value(answer, fabs(f->torque_mean) < 1e-9 * fabs(f->torque_high.value) ? 0 : f->torque_mean, YK_QUANTITY_TORQUE);
    yk_text_puts(out, "\n");
    if (answer->size.is_groove || answer->size.is_conjugate) return;
    yk_text_puts(out, "  the follower leaves the cam          ");
    if (isfinite(f->jump_speed) && f->jump_speed > 0) {
        yk_text_puts(out, "from ");
        add_speed(answer, f->jump_speed);
        at_angle(answer, f->jump_angle);
    } else {
        yk_text_puts(out, isfinite(f->jump_speed) ? "at any speed: nothing holds it" : "at no speed");
    }
    yk_text_puts(out, "\n  preload                              ");
    value(answer, answer->loads.preload, effort);
    yk_text_puts(out, "; needed at this speed ");
    value(answer, f->preload_needed, effort);
    yk_text_puts(out, "\n");
}

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

static void add_others(const YkCamAnswer *answer)
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
        yk_words_renew(&unit);
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
    write_table(out, table);
    out->failed |= unit.failed;
    yk_text_free(&unit);
}

static void add_rows(const YkCamAnswer *answer)
{
    YkCamColumn columns[YK_CAM_COLUMNS_MAX];
    double values[YK_CAM_COLUMNS_MAX];
    size_t count = yk_cam_columns(answer, columns);
    YkText *out = &answer->session->out, unit = {0};
    if (answer->steps == 0) return;
    YkTable *table = yk_table_new(count);
    for (size_t c = 0; c < count; c++) {
        yk_words_renew(&unit);
        yk_cam_unit(answer, &columns[c], &unit);
        yk_table_head(table, columns[c].name, yk_text_get(&unit));
    }
    for (size_t row = 0; row <= answer->steps; row++) {
        yk_cam_row(answer, yk_cam_row_angle(answer, row), values);
        for (size_t c = 0; c < count; c++)
            yk_table_number(table, yk_shown(answer->session, values[c], columns[c].quantity), YK_DIGITS);
    }
    yk_text_puts(out, "\n");
    write_table(out, table);
    out->failed |= unit.failed;
    yk_text_free(&unit);
}

void yk_cam_text(const YkCamAnswer *answer)
{
    add_head(answer);
    add_program(answer);
    add_strokes(answer);
    add_peaks(answer);
    add_jumps(answer);
    add_geometry(answer, &answer->summary, "Geometry");
    add_base(answer);
    if (answer->size.is_conjugate) add_geometry(answer, &answer->second, "The second cam");
    add_forces(answer);
    add_others(answer);
    add_rows(answer);
}
