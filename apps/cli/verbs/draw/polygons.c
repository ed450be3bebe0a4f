// yoke draw --polygon: the polygon of the pose in place of the machine.
#include "verbs/draw/polygons.h"
#include <string.h>
#include "session.h"
#include "verbs/solve/solve.h"

// Writes a picture; NULL: out of memory.
static bool convert(YkSession *session, const char *svg, YkFileKind kind)
{
    if (!svg) return yk_session_refuse_for_memory(session);
    return yk_convert_svg(svg, kind, &session->out, session->problems);
}

static bool draw_forces(YkSession *session, YkFileKind kind)
{
    YkForcePolygons *polygons = yk_force_polygons_of(session, session->dynamics, session->forces_message);
    bool good = polygons && convert(session, yk_force_polygons_svg(polygons), kind);
    yk_force_polygons_free(polygons);
    return good;
}

static bool draw_motion(YkSession *session, YkFileKind kind)
{
    YkPolygon *polygon = yk_polygon_of(session, session->state);
    bool good = polygon && convert(session, yk_polygon_svg(polygon), kind);
    yk_polygon_free(polygon);
    return good;
}

bool yk_draw_polygon(YkSession *session, YkFileKind kind)
{
    YkDynamics *dynamics = session->dynamics;
    bool needs_forces = strcmp(session->request->polygon, "velocity") != 0;
    YkStatus status = needs_forces ? yk_solve_forces(session, dynamics, YK_METHOD_REDUCED, session->state) : YK_OK;
    bool good = status != YK_NO_MEMORY;
    if (!good) yk_session_refuse_for_memory(session);
    good = good && (yk_wants_force_polygons(session) ? draw_forces(session, kind) : draw_motion(session, kind));
    session->dynamics = dynamics; // the session frees it
    return good;
}
