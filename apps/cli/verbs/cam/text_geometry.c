// Writes geometry and forces of a cam for people.
#include <math.h>
#include <string.h>
#include "verbs/cam/text.h"

enum { WIDTH = 37 };

static void add_extreme(const YkCamAnswer *answer, const char *what, YkCamExtreme extreme, YkQuantity quantity)
{
    YkText *out = &answer->session->out;
    yk_text_format(out, "  %s", what);
    yk_text_repeat(out, ' ', strlen(what) < WIDTH ? WIDTH - strlen(what) : 1);
    if (!isfinite(extreme.value)) {
        yk_text_puts(out, "none\n");
        return;
    }
    yk_cam_value(answer, extreme.value, quantity);
    yk_cam_at_angle(answer, extreme.angle);
    yk_text_puts(out, "\n");
}

static void add_undercut(const YkCamAnswer *answer, const char *of, const YkCamRange *ranges, size_t count)
{
    YkText *out = &answer->session->out;
    for (size_t i = 0; i < count && i < YK_CAM_RANGES_MAX; i++) {
        yk_text_format(out, "  %s is undercut from ", of);
        yk_cam_value(answer, ranges[i].from, YK_QUANTITY_ANGLE);
        yk_text_puts(out, " to ");
        yk_cam_value(answer, ranges[i].to, YK_QUANTITY_ANGLE);
        yk_text_puts(out, "\n");
    }
}

void yk_cam_add_geometry(const YkCamAnswer *answer, const YkCamSummary *s, const char *title)
{
    YkText *out = &answer->session->out;
    bool is_flat = answer->size.face == YK_CAM_FACE_FLAT;
    yk_text_format(out, "\n%s\n", title);
    add_extreme(answer, "largest pressure angle", s->pressure, YK_QUANTITY_ANGLE);
    if (answer->size.face == YK_CAM_FACE_ROLLER) {
        add_extreme(answer, "pitch curve, sharpest convex radius", s->pitch_convex, YK_QUANTITY_LENGTH);
        add_extreme(answer, "pitch curve, sharpest hollow", s->pitch_hollow, YK_QUANTITY_LENGTH);
    }
    add_extreme(answer, "surface, sharpest convex radius", s->surface_convex, YK_QUANTITY_LENGTH);
    if (!is_flat) add_extreme(answer, "surface, sharpest hollow", s->surface_hollow, YK_QUANTITY_LENGTH);
    if (is_flat) {
        yk_text_puts(out, "  face width                           ");
        yk_cam_value(answer, s->reach_high.value - s->reach_low.value, YK_QUANTITY_LENGTH);
        yk_text_puts(out, ": from ");
        yk_cam_value(answer, s->reach_low.value, YK_QUANTITY_LENGTH);
        yk_text_puts(out, " to ");
        yk_cam_value(answer, s->reach_high.value, YK_QUANTITY_LENGTH);
        yk_text_puts(out, "\n");
    }
    add_extreme(answer, "largest radius of the cam", s->far, YK_QUANTITY_LENGTH);
    add_undercut(answer, "the surface", s->undercut, s->undercut_count);
    if (answer->size.is_groove) add_undercut(answer, "the outer wall", s->outer_undercut, s->outer_undercut_count);
}

void yk_cam_add_base(const YkCamAnswer *answer)
{
    YkText *out = &answer->session->out;
    yk_text_puts(out, "  smallest base circle                 ");
    if (answer->base_status == YK_OK) {
        yk_cam_value(answer, answer->base.base, YK_QUANTITY_LENGTH);
    } else {
        yk_text_puts(out, "none");
    }
    yk_text_puts(out, " for a pressure angle up to ");
    yk_cam_value(answer, answer->limits.pressure, YK_QUANTITY_ANGLE);
    if (answer->limits.curvature > 0) {
        yk_text_puts(out, " and convex radii from ");
        yk_cam_value(answer, answer->limits.curvature, YK_QUANTITY_LENGTH);
    } else {
        yk_text_puts(out, " without undercut");
    }
    if (answer->base_status == YK_OK) {
        yk_text_format(out, "; %s decides", answer->base.by_pressure ? "the pressure angle" : "the curvature");
        yk_cam_at_angle(answer, answer->base.angle);
    }
    yk_text_puts(out, "\n");
}

void yk_cam_add_forces(const YkCamAnswer *answer)
{
    YkText *out = &answer->session->out;
    const YkCamForceSummary *f = &answer->forces;
    YkQuantity effort = answer->size.oscillates ? YK_QUANTITY_TORQUE : YK_QUANTITY_FORCE;
    if (!answer->has_forces) return;
    yk_scale_add(answer->session, f->contact_high.value, YK_QUANTITY_FORCE);
    yk_scale_add(answer->session, f->torque_high.value, YK_QUANTITY_TORQUE);
    yk_text_puts(out, "\nForces");
    yk_text_puts(out, answer->loads.is_partial ? " (of what acts along the follower's coordinate only)\n" : "\n");
    add_extreme(answer, "contact force, lowest", f->contact_low, YK_QUANTITY_FORCE);
    add_extreme(answer, "contact force, highest", f->contact_high, YK_QUANTITY_FORCE);
    add_extreme(answer, "camshaft torque, lowest", f->torque_low, YK_QUANTITY_TORQUE);
    add_extreme(answer, "camshaft torque, highest", f->torque_high, YK_QUANTITY_TORQUE);
    yk_text_puts(out, "  camshaft torque, mean                ");
    yk_cam_value(answer, fabs(f->torque_mean) < 1e-9 * fabs(f->torque_high.value) ? 0 : f->torque_mean,
                 YK_QUANTITY_TORQUE);
    yk_text_puts(out, "\n");
    if (answer->size.is_groove || answer->size.is_conjugate) return;
    yk_text_puts(out, "  the follower leaves the cam          ");
    if (isfinite(f->jump_speed) && f->jump_speed > 0) {
        yk_text_puts(out, "from ");
        yk_cam_speed(answer, f->jump_speed);
        yk_cam_at_angle(answer, f->jump_angle);
    } else {
        yk_text_puts(out, isfinite(f->jump_speed) ? "at any speed: nothing holds it" : "at no speed");
    }
    yk_text_puts(out, "\n  preload                              ");
    yk_cam_value(answer, answer->loads.preload, effort);
    yk_text_puts(out, "; needed at this speed ");
    yk_cam_value(answer, f->preload_needed, effort);
    yk_text_puts(out, "\n");
}
