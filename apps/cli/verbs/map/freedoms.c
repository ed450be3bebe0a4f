// Checks that the machine has as many freedoms as the map has coordinates.
#include "session.h"
#include "verbs/map/map.h"

// Returns the freedoms that are neither mapped nor held by --at.
size_t yk_map_free_inputs(const YkSession *session)
{
    size_t held = 0, count = yk_input_count(session->mech);
    for (size_t k = 0; k < session->hold_count; k++) held += session->holds[k].order == 0;
    return count > held ? count - held : 0;
}

bool yk_map_has_freedoms(YkSession *session, size_t wanted)
{
    size_t count = yk_input_count(session->mech), left = yk_map_free_inputs(session);
    if (left == wanted) return true;
    YkText count_word = {0};
    yk_text_format(&count_word, "%z", left);
    yk_session_refuse(session, YK_CODE_NO_MAP, "a map is made over one freedom or two, and this machine has %s",
                      yk_text_get(&count_word));
    yk_text_free(&count_word);
    if (count == 0)
        yk_problem_hint(session->problems, "`yoke solve --all` lists the configurations of a machine without freedom");
    else if (left > 2)
        yk_problem_hint(session->problems,
                        "hold all inputs but one or two for a section of the whole map, as in `--at %s=VALUE`",
                        yk_coordinate_info(session->mech, yk_input_coordinate(session->mech, count - 1)).name);
    else if (left == 2)
        yk_problem_hint(session->problems, "map it over two coordinates, as in `--over %s,%s`, or hold one by --at",
                        yk_coordinate_info(session->mech, yk_input_coordinate(session->mech, 0)).name,
                        yk_coordinate_info(session->mech, yk_input_coordinate(session->mech, 1)).name);
    return false;
}
