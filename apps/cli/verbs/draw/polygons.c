// yoke draw --polygon: the polygon of the pose in place of the machine.
#include "verbs/draw/polygons.h"
#include "verbs/solve/solve.h"

// Writes a picture; NULL: out of memory.
static bool convert(YkSession *session, const char *svg, YkFileKind kind)
{
    if (!svg) return yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    return yk_convert_svg(svg, kind, &session->out, session->problems);
}

static bool draw_forces(YkSession *session, YkFileKind kind)
{
    bool has_rates = yk_state_has_rates(session->state);
    YkStatus status = has_rates ? yk_dynamics_solve(session->dynamics, session->state, YK_METHOD_REDUCED) : YK_SINGULAR;
    if (status == YK_NO_MEMORY) return yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    bool has_forces = status == YK_OK || status == YK_REDUNDANT;
    YkForcePolygons *polygons = yk_force_polygons_of(session, has_forces ? session->dynamics : NULL,
                                                     has_rates ? yk_dynamics_report(session->dynamics)->message
                                                               : "the rates are not determined");
    bool good = polygons && convert(session, yk_force_polygons_svg(polygons), kind);
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
    bool good = convert(session, yk_polygon_svg(polygon), kind);
    yk_polygon_free(polygon);
    return good;
}
