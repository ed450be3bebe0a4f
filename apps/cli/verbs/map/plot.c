// Draws the map that `yoke map --plot` asks for.
#include "session.h"
#include "verbs/map/map.h"
#include "picture/convert.h"

// Returns the coordinate of --of, or the first that is not mapped; declared ones first.
static bool read_vertical(const YkMapAnswer *answer, size_t *coordinate)
{
    YkSession *session = answer->session;
    if (session->request->of) return yk_session_coordinate(session, session->request->of, coordinate);
    size_t mapped = yk_map_coordinate(answer->map), count = yk_coordinate_count(session->mech);
    *coordinate = mapped;
    for (size_t pass = 0; pass < 2 && *coordinate == mapped; pass++)
        for (size_t c = 0; c < count && *coordinate == mapped; c++)
            if (c != mapped && (pass == 1 || yk_coordinate_info(session->mech, c).is_declared)) *coordinate = c;
    return true;
}

bool yk_map_plan(YkMapAnswer *answer)
{
    YkSession *session = answer->session;
    size_t count = session->request->trace.count;
    if (!session->request->plot) return true;
    answer->points = yk_session_alloc(answer->session, count + 1, sizeof *answer->points);
    if (!answer->points) return yk_session_refuse_for_memory(session);
    return read_vertical(answer, &answer->vertical) &&
           (count == 0 || yk_session_points(session, &session->request->trace, answer->points));
}

bool yk_map_plot(const YkMapAnswer *answer, const char *path)
{
    YkSession *session = answer->session;
    YkText picture = {0};
    YkMapPicture options = {.coordinate = answer->vertical,
                            .points = answer->points,
                            .point_count = session->request->trace.count,
                            .angle_unit = yk_unit_of(session, YK_QUANTITY_ANGLE),
                            .length_unit = yk_unit_of(session, YK_QUANTITY_LENGTH),
                            .angle = yk_shown(session, 1, YK_QUANTITY_ANGLE),
                            .length = yk_shown(session, 1, YK_QUANTITY_LENGTH)};
    const char *svg = yk_map_picture(answer->map, &options);
    bool good = svg || yk_session_refuse_for_memory(session);
    good = good && yk_convert_svg(svg, yk_file_kind(path), &picture, session->problems) &&
           yk_file_write(path, yk_text_get(&picture), picture.length, session->problems);
    yk_text_free(&picture);
    return good;
}
