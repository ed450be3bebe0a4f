// yoke draw --polygon: the polygon of the pose in place of the machine.
#include "verbs/draw/polygons.h"
#include "verbs/solve/solve.h"

static bool draw_forces(YkSession *session, YkFileKind kind)
{
    bool has_rates = yk_state_has_rates(session->state);
    YkStatus status = has_rates ? yk_dynamics_solve(session->dynamics, session->state, YK_METHOD_REDUCED) : YK_SINGULAR;
    if (status == YK_NO_MEMORY) return yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    if (status != YK_OK && status != YK_REDUNDANT)
        return yk_session_refuse(session, YK_CODE_NO_POLYGON, "there is no force polygon: %s",
                                 has_rates ? yk_dynamics_report(session->dynamics)->message
                                           : "the rates are not determined at this pose");
    YkForcePolygons *polygons = yk_force_polygons_of(session);
    if (!polygons) return false;
    const char *svg = yk_force_polygons_svg(polygons);
    bool good = svg ? yk_convert_svg(svg, kind, &session->out, session->problems)
                    : yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    yk_force_polygons_free(polygons);
    return good;
}

bool yk_draw_polygon(YkSession *session, YkFileKind kind)
{
    YkPolygonKind what;
    if (yk_wants_force_polygons(session)) return draw_forces(session, kind);
    if (!yk_polygon_read(session, &what)) return false;
    YkPolygon *polygon = yk_polygon_new(session->state, what, session->problems);
    if (!polygon) return false;
    const char *svg = yk_polygon_svg(polygon);
    bool good = svg ? yk_convert_svg(svg, kind, &session->out, session->problems)
                    : yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    yk_polygon_free(polygon);
    return good;
}
