// Reads poses of strands as rows of numbers.
#include <stdlib.h>
#include <string.h>
#include "map/map.h"
#include "solve/gap.h"

#define FAR_ENOUGH 0.03 // rad, or lengths over the size: poses nearer than this to the last row are left out

double *yk_map_add_row(YkMap *map, YkMapRows *rows)
{
    if (!YK_ROW_ROOM(rows->numbers, map->width, rows->count, rows->capacity)) {
        map->tracer.out_of_memory = true;
        return NULL;
    }
    return yk_map_row_at(map, rows, rows->count++);
}

static double angle_of(const YkDiscs *d, YkJointAngle joint)
{
    YkVec turn = yk_mul(d->slots[joint.b].at.at, yk_conj(d->slots[joint.a].at.at));
    return (joint.a == joint.b ? 0 : yk_atan2(turn.y, turn.x)) + joint.offset;
}

// Returns the sum of inputs that an angle is.
static double sum_of_inputs(const YkDiscs *d, const YkTreeCoordinate *c, double at)
{
    double sum = c->sum_offset;
    for (uint32_t k = c->first_source; k < c->first_source + c->source_count; k++) {
        const YkRelationSource *s = &d->mech->sources[k];
        sum += s->factor * (s->index == d->mapped ? at : d->others[s->index]);
    }
    return sum;
}

static double coordinate_of(const YkMap *map, const YkTreeCoordinate *c, double at, const double *before)
{
    const YkDiscs *d = &map->tracer.discs;
    if (c->input != YK_NONE) return c->input == d->mapped ? at : d->others[c->input];
    if (c->is_distance) return d->distances[c->distance].at.at.x;
    double angle = angle_of(d, c->angle);
    if (c->is_sum) return yk_nearest_turn(angle, sum_of_inputs(d, c, at));
    return before ? yk_nearest_turn(angle, before[1 + (c - map->mech->coordinates)]) : yk_nearest_turn(angle, 0);
}

static YkVec point_of(const YkMap *map, size_t point)
{
    const YkMechanism *mech = map->mech;
    const YkPoint *p = &mech->model->points[point];
    YkTerm term = yk_body_term(mech, p->body, p->at);
    YkVec origin = yk_discs_sum(&map->tracer.discs, &mech->bodies[p->body].origin).at.at;
    return yk_add(origin, yk_mul(map->tracer.discs.slots[term.slot].at.at, term.v));
}

bool yk_map_read_row(YkMap *map, YkStrand *strand, double at, const double *before, double *row)
{
    const YkMechanism *mech = map->mech;
    if (!yk_trace_place(&map->tracer, strand, at)) return false;
    row[0] = at;
    for (size_t c = 0; c < mech->coordinate_count; c++)
        row[1 + c] = coordinate_of(map, &mech->coordinates[c], at, before);
    for (size_t j = 0; j < map->joints; j++) {
        size_t column = yk_map_joint_column(map, j);
        double angle = angle_of(&map->tracer.discs, yk_joint_angle(mech, (int32_t)j));
        row[column] = yk_nearest_turn(angle, before ? before[column] : 0);
    }
    for (size_t p = 0; p < map->points; p++) {
        YkVec place = point_of(map, p);
        row[yk_map_point_column(map, p)] = place.x;
        row[yk_map_point_column(map, p) + 1] = place.y;
    }
    return true;
}

double yk_map_apart(const YkMap *map, const double *a, const double *b)
{
    double most = 0;
    for (size_t c = 0; c < map->mech->coordinate_count; c++) {
        const YkTreeCoordinate *info = &map->mech->coordinates[c];
        double off = a[1 + c] - b[1 + c];
        if (c == map->coordinate && !info->is_distance && map->tracer.period > 7) // several turns differ
            off = off * 2 * YK_PI / map->tracer.period;
        most = fmax(most, yk_gap(map->mech, info->is_distance, off));
    }
    for (size_t j = yk_map_joint_column(map, 0); j < yk_map_joint_column(map, map->joints); j++)
        most = fmax(most, yk_gap(map->mech, false, a[j] - b[j]));
    return most;
}

// Reads the rows of a strand: the ends of its cells, as far as they are apart.
static bool read_strand(YkMap *map, YkStrand *strand, YkMapRows *rows)
{
    double *row = calloc(map->width, sizeof *row);
    bool ok = row != NULL;
    for (size_t k = 0; ok && k <= strand->count; k++) {
        double at = k == 0 ? strand->cells[0].from : strand->cells[k - 1].to;
        const double *last = rows->count > 0 ? yk_map_row_at(map, rows, rows->count - 1) : NULL;
        if (!yk_map_read_row(map, strand, at, last, row)) {
            yk_note_unproved(&map->tracer, at, strand->level - 1);
            continue;
        }
        bool is_end = k == 0 || k == strand->count;
        if (last && !is_end && yk_map_apart(map, last, row) < FAR_ENOUGH) continue;
        double *kept = yk_map_add_row(map, rows);
        ok = kept != NULL;
        if (ok) memcpy(kept, row, map->width * sizeof *row);
    }
    free(row);
    map->tracer.out_of_memory |= !ok;
    return ok;
}

bool yk_map_read_rows(YkMap *map)
{
    map->strand_rows = calloc(map->leaves->count + 1, sizeof *map->strand_rows);
    if (!map->strand_rows) return false;
    for (size_t k = 0; k < map->leaves->count; k++)
        if (!read_strand(map, map->leaves->items[k], &map->strand_rows[k])) return false;
    return true;
}
