// Names of the joint or coordinate to which an event of a map belongs.
#include "verbs/map/map.h"

const char *yk_map_event_of(const YkMapAnswer *answer, YkMapEvent event)
{
    const YkMechanism *mech = answer->session->mech;
    if (event.block >= 0) return yk_block_info(mech, (size_t)event.block).label;
    return event.coordinate == YK_NOT_FOUND ? NULL : yk_coordinate_info(mech, event.coordinate).name;
}
