// Joins leaf strands to branches and circuits.
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/sets.h"
#include "map/map.h"

static bool goes_on(const YkTie *tie) // as the same branch
{
    return tie->kind == YK_TIE_ROUND || tie->kind == YK_TIE_PASS;
}

// Returns the tie by which a branch goes on at an end of a leaf, or NULL.
static const YkTie *going_on_at(const YkMap *map, const YkStrand *leaf, int end, YkStrand **other)
{
    const YkTies *ties = &map->tracer.ties[map->tracer.piece_count];
    for (size_t k = 0; k < ties->count; k++) {
        const YkTie *tie = &ties->items[k];
        if (!goes_on(tie)) continue;
        for (int side = 0; side < 2; side++)
            if (tie->strand[side] == leaf && tie->end[side] == end) {
                *other = tie->strand[1 - side];
                return tie;
            }
    }
    return NULL;
}

// Returns the tie in which a leaf's end stands where branches meet, or NULL.
static const YkTie *event_at(const YkMap *map, const YkStrand *leaf, int end)
{
    const YkTies *ties = &map->tracer.ties[map->tracer.piece_count];
    for (size_t k = 0; k < ties->count; k++) {
        const YkTie *tie = &ties->items[k];
        for (int side = 0; tie->kind != YK_TIE_ROUND && side < 2; side++)
            if (tie->strand[side] == leaf && tie->end[side] == end) return tie;
    }
    return NULL;
}

// --- branches

// Puts the pose half way between two ends that meet at an event at the end of a branch: it is the event's.
static bool add_meeting(YkMap *map, YkMapRows *rows, const YkStrand *leaf, int end, double shift)
{
    const YkTie *tie = event_at(map, leaf, end);
    if (!tie || (tie->kind == YK_TIE_PASS && end == 0)) return true; // there the strand before has put it
    const YkMapRows *of[2];
    const double *from[2];
    double *row = yk_map_add_row(map, rows);
    if (!row) return false;
    for (int side = 0; side < 2; side++) {
        of[side] = &map->strand_rows[tie->strand[side]->index];
        from[side] = yk_map_row_at(map, of[side], tie->end[side] == 1 ? of[side]->count - 1 : 0);
    }
    const YkMapRows *own = &map->strand_rows[leaf->index];
    const double *mine = yk_map_row_at(map, own, end == 1 ? own->count - 1 : 0);
    for (size_t c = 0; c < map->width; c++) {
        bool is_angle = (c >= 1 && c < 1 + map->mech->coordinate_count && !map->mech->coordinates[c - 1].is_distance) ||
                        (c >= yk_map_joint_column(map, 0) && c < yk_map_joint_column(map, map->joints));
        double off = from[1][c] - from[0][c];
        row[c] = from[0][c] + 0.5 * (is_angle ? yk_nearest_turn(off, 0) : off);
        if (is_angle) row[c] = yk_nearest_turn(row[c], mine[c]);
    }
    row[0] = tie->at + shift;
    row[1 + map->coordinate] = row[0];
    return true;
}

// Makes the angles of the rows from `first` on go on from those before.
static void make_continuous(const YkMap *map, YkMapRows *rows, size_t first)
{
    if (first == 0) return;
    for (size_t r = first; r < rows->count; r++) {
        const double *before = yk_map_row_at(map, rows, r - 1);
        double *row = yk_map_row_at(map, rows, r);
        for (size_t c = 0; c < map->mech->coordinate_count; c++)
            if (c != map->coordinate && !map->mech->coordinates[c].is_distance)
                row[1 + c] = yk_nearest_turn(row[1 + c], before[1 + c]);
        for (size_t j = yk_map_joint_column(map, 0); j < yk_map_joint_column(map, map->joints); j++)
            row[j] = yk_nearest_turn(row[j], before[j]);
    }
}

static bool add_strand(YkMap *map, YkMapRows *rows, const YkStrand *leaf, double shift)
{
    const YkMapRows *own = &map->strand_rows[leaf->index];
    size_t first = rows->count;
    if (!add_meeting(map, rows, leaf, 0, shift)) return false;
    for (size_t r = first > 0 ? 1 : 0; r < own->count; r++) { // the end of the strand before is the beginning of this
        double *row = yk_map_add_row(map, rows);
        if (!row) return false;
        memcpy(row, yk_map_row_at(map, own, r), map->width * sizeof *row);
        row[0] += shift;
        row[1 + map->coordinate] = row[0];
    }
    if (!add_meeting(map, rows, leaf, 1, shift)) return false;
    make_continuous(map, rows, first);
    return true;
}

// Returns the leaf at which the branch of a leaf begins: goes back as long as it goes on.
static YkStrand *first_of(const YkMap *map, YkStrand *leaf)
{
    YkStrand *other, *at = leaf;
    while (going_on_at(map, at, 0, &other) && other != leaf) at = other;
    return at;
}

static bool add_line(YkMap *map, YkStrand *leaf)
{
    YkStrand *at = first_of(map, leaf), *first = at, *other;
    double shift = 0;
    if (!YK_ROOM(map->lines, map->line_count, map->line_capacity)) return false;
    size_t index = map->line_count++;
    map->lines[index] = (YkMapLine){0};
    for (;;) {
        if (!add_strand(map, &map->lines[index].rows, at, shift)) return false;
        map->branch_of[at->index] = index;
        const YkTie *tie = going_on_at(map, at, 1, &other);
        if (!tie) break;
        if (tie->kind == YK_TIE_ROUND) shift += map->tracer.period;
        map->lines[index].is_closed = other == first;
        if (other == first || map->branch_of[other->index] != YK_NOT_FOUND) break;
        at = other;
    }
    return true;
}

// --- ranges

static int compare_ranges(const void *a, const void *b)
{
    const YkRange *p = a, *q = b;
    return p->from < q->from ? -1 : p->from > q->from;
}

static bool add_span(YkMap *map, size_t circuit, YkRange range)
{
    if (!YK_ROOM(map->spans, map->span_count, map->span_capacity)) return false;
    double turns = map->tracer.is_angle ? rint((yk_map_shown(map, range.from) - range.from) / (2 * YK_PI)) : 0;
    range.from += turns * 2 * YK_PI;
    range.to += turns * 2 * YK_PI;
    map->spans[map->span_count++] = (YkMapSpan){circuit, range};
    return true;
}

static bool find_ranges(YkMap *map, size_t circuit, YkRange *ranges)
{
    const YkTracer *t = &map->tracer;
    size_t count = 0, merged = 0;
    double close = YK_MAP_CLOSE * t->scale;
    for (size_t k = 0; k < map->leaves->count; k++) {
        YkStrand *leaf = map->leaves->items[k];
        if (map->circuit_of[k] != circuit) continue;
        const YkTie *from = event_at(map, leaf, 0), *to = event_at(map, leaf, 1);
        ranges[count++] = (YkRange){from ? from->at : yk_strand_from(leaf), to ? to->at : yk_strand_to(leaf)};
    }
    qsort(ranges, count, sizeof *ranges, compare_ranges);
    for (size_t k = 0; k < count; k++) {
        if (merged > 0 && ranges[k].from <= ranges[merged - 1].to + close)
            ranges[merged - 1].to = fmax(ranges[merged - 1].to, ranges[k].to);
        else
            ranges[merged++] = ranges[k];
    }
    // Over the end of the domain an angle goes on at its beginning.
    if (t->is_angle && merged > 1 && ranges[0].from <= t->low && ranges[merged - 1].to >= t->high) {
        ranges[merged - 1].to = ranges[0].to + t->period;
        ranges[0] = ranges[--merged];
    }
    for (size_t k = 0; k < merged; k++)
        if (!add_span(map, circuit, ranges[k])) return false;
    return true;
}

bool yk_map_find_circuits(YkMap *map)
{
    const YkTies *ties = &map->tracer.ties[map->tracer.piece_count];
    size_t n = map->leaves->count;
    int32_t *parent = malloc((n + 1) * sizeof *parent);
    size_t *number = malloc((n + 1) * sizeof *number);
    YkRange *ranges = malloc((n + 1) * sizeof *ranges);
    map->circuit_of = malloc((n + 1) * sizeof *map->circuit_of);
    map->branch_of = malloc((n + 1) * sizeof *map->branch_of);
    bool ok = parent && number && ranges && map->circuit_of && map->branch_of;
    if (ok) yk_sets_begin(parent, n);
    for (size_t k = 0; ok && k < ties->count; k++)
        yk_sets_join(parent, (int32_t)ties->items[k].strand[0]->index, (int32_t)ties->items[k].strand[1]->index);
    for (size_t k = 0; ok && k < n; k++) number[k] = map->branch_of[k] = YK_NOT_FOUND;
    if (ok && map->start_leaf != YK_NOT_FOUND) { // its circuit comes first
        number[yk_root_of(parent, (int32_t)map->start_leaf)] = map->circuit_count++;
        map->has_start = true;
    }
    for (size_t k = 0; ok && k < n; k++) {
        size_t root = (size_t)yk_root_of(parent, (int32_t)k);
        if (number[root] == YK_NOT_FOUND) number[root] = map->circuit_count++;
        map->circuit_of[k] = number[root];
    }
    for (size_t k = 0; ok && k < n; k++)
        if (map->branch_of[k] == YK_NOT_FOUND) {
            ok = add_line(map, map->leaves->items[k]);
            if (ok) map->lines[map->branch_of[k]].circuit = map->circuit_of[k];
        }
    for (size_t c = 0; ok && c < map->circuit_count; c++) ok = find_ranges(map, c, ranges);
    free(parent);
    free(number);
    free(ranges);
    return ok;
}
