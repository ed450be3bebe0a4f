// Maps over the drives, whose limits are their dead points on the machine's map.
#include <stdlib.h>
#include <yoke/move.h>
#include "base/problems.h"
#include "map/map.h"
#include "solve/state.h"

// Makes the mechanism with another input in place of the mapped one, at the same pose, and adds the limits of its map.
static YkStatus add_drive(YkMap *map, const YkState *start, size_t drive, YkProblems *problems)
{
    const YkMechanism *mech = map->mech;
    size_t count = yk_input_count(mech);
    const char **names = calloc(count + 1, sizeof *names);
    for (size_t k = 0; names && k < count; k++) {
        size_t c = yk_input_coordinate(mech, k);
        names[k] = yk_coordinate_info(mech, c == map->coordinate ? drive : c).name;
    }
    YkCompileOptions options = yk_default_compile_options();
    options.inputs = names;
    options.input_count = count;
    YkMechanism *other = names ? yk_mechanism_compile(mech->model, &options, problems) : NULL;
    YkState *state = other ? yk_state_new(other) : NULL;
    YkMap *own = NULL;
    YkStatus status = state             ? yk_state_adopt(state, start)
                      : names && !other ? YK_BAD_ARGUMENT // a problem of its own
                                        : YK_NO_MEMORY;
    size_t coordinate = other ? yk_coordinate_find(other, yk_coordinate_info(mech, drive).name) : 0;
    if (status >= 0) status = yk_state_set_progress(state, start->progress);
    if (status >= 0) own = yk_map_new(state, coordinate, problems);
    if (status >= 0) status = own ? yk_map_add_dead_points(map, own) : YK_BAD_ARGUMENT;
    yk_map_free(own);
    yk_state_free(state);
    yk_mechanism_free(other);
    free(names);
    return status;
}

YkStatus yk_map_add_drives(YkMap *map, const YkState *start, YkProblems *problems)
{
    if (!map || !start || yk_state_mechanism(start) != map->mech) return YK_BAD_ARGUMENT;
    for (size_t c = 0; c < yk_coordinate_count(map->mech); c++) {
        YkCoordinateInfo info = yk_coordinate_info(map->mech, c);
        if (!info.has_drive || info.input >= 0 || c == map->coordinate) continue;
        YkStatus status = add_drive(map, start, c, problems);
        if (status >= 0) continue;
        if (problems && yk_problems_error_count(problems) == 0)
            yk_problem(problems, status == YK_NO_MEMORY ? YK_CODE_OUT_OF_MEMORY : YK_CODE_NO_MAP, (YkPlace){0},
                       "the dead points of the drive %q could not be found", info.name);
        return status;
    }
    return YK_OK;
}
