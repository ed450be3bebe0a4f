// Names of orientations and distances, and the values that bear them.
#include "program/program.h"

const char *yk_program_slot_name(YkProgram *p, int32_t slot)
{
    if (slot < (int32_t)p->mech->orientation_count) return p->model->bodies[p->mech->orientation_body[slot]].name;
    for (size_t o = 0; o < p->mech->orientation_count; o++)
        if (p->mech->relative_slot[o] == slot)
            return yk_graph_text(&p->graph, "%s_relative", yk_program_slot_name(p, (int32_t)o));
    return "turned";
}

const char *yk_program_distance_name(YkProgram *p, int32_t distance)
{
    for (size_t k = 0; k < p->mech->coordinate_count; k++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[k];
        if (c->is_distance && c->distance == distance) return c->name;
    }
    for (size_t j = 0; j < p->model->joint_count; j++)
        if (p->mech->joint_distance[j] == distance)
            return yk_graph_text(&p->graph, "%s_distance", p->model->joints[j].name);
    return "d";
}

void yk_program_set_unit(YkProgram *p, int32_t slot, YkRefVec e)
{
    const char *name = yk_program_slot_name(p, slot);
    p->unit[slot] = e;
    yk_graph_name(&p->graph, e.x, "%s_c", name);
    yk_graph_name(&p->graph, e.y, "%s_s", name);
}

void yk_program_set_distance(YkProgram *p, int32_t distance, YkRef d)
{
    p->distance[distance] = yk_graph_name(&p->graph, d, "%s", yk_program_distance_name(p, distance));
}
