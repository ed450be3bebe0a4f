// Allocates and copies the space in which steps run.
#include "solve/space.h"
#include <stdlib.h>
#include <string.h>

size_t yk_space_number_count(const YkSpace *s)
{
    return s->stride * (4 * s->slots + 3 * s->distances + 6 * (s->nodes + YK_SCRATCH_COUNT) + 2 + s->relations +
                        (s->block_margin ? s->blocks : 0));
}

static size_t plane_count(const YkSpace *s)
{
    return 1 + s->nodes + YK_SCRATCH_COUNT;
}

static void point_at_lanes(YkSpace *s)
{
    size_t n = s->stride;
    double *p = s->data + 4 * n;
    for (size_t k = 1; k < s->slots; k++, p += 4 * n) s->turn[k] = (YkTurn){p, p + n, p + 2 * n, p + 3 * n};
    p = s->data + 4 * n * s->slots;
    for (size_t k = 0; k < s->distances; k++, p += 3 * n) s->slide[k] = (YkSlide){p, p + n, p + 2 * n};
    for (size_t k = 1; k < plane_count(s); k++, p += 6 * n)
        s->plane[k] = (YkPlane){p, p + n, p + 2 * n, p + 3 * n, p + 4 * n, p + 5 * n};
}

bool yk_space_start(YkSpace *space, const YkMechanism *mech, size_t stride, bool with_margins)
{
    double dummy;
    *space = (YkSpace){.stride = stride,
                       .slots = mech->slot_count,
                       .distances = mech->distance_count,
                       .nodes = mech->node_count,
                       .blocks = mech->block_count,
                       .relations = mech->relation_count + mech->derived_count,
                       .block_margin = with_margins ? &dummy : NULL};
    size_t numbers = yk_space_number_count(space) * sizeof(double), turns = space->slots * sizeof *space->turn;
    size_t slides = space->distances * sizeof *space->slide, planes = plane_count(space) * sizeof *space->plane;
    space->memory = calloc(1, 64 + numbers + turns + slides + planes);
    if (!space->memory) {
        *space = (YkSpace){0};
        return false;
    }
    space->data = (double *)(((uintptr_t)space->memory + 63) & ~(uintptr_t)63);
    unsigned char *behind = (unsigned char *)space->data + numbers;
    space->turn = (YkTurn *)(void *)behind;
    space->slide = (YkSlide *)(void *)(behind + turns);
    space->plane = (YkPlane *)(void *)(behind + turns + slides);
    space->slides = space->data + stride * 4 * space->slots;
    space->planes = space->slides + stride * 3 * space->distances;
    space->margin = space->planes + stride * 6 * (space->nodes + YK_SCRATCH_COUNT);
    space->gap = space->margin + stride;
    space->gain = space->gap + stride;
    space->block_margin = with_margins ? space->gain + stride * space->relations : NULL;
    point_at_lanes(space);
    for (size_t k = 0; k < stride; k++) space->data[k] = 1; // slot 0, if it is read: the ground's unit vector
    return true;
}

void yk_space_end(YkSpace *space)
{
    free(space->memory);
    *space = (YkSpace){0};
}

void yk_space_copy(YkSpace *to, const YkSpace *from)
{
    memcpy(to->data, from->data, yk_space_number_count(from) * sizeof(double));
}
