// Finds how far every joint turns on every circuit.
#include <stdlib.h>
#include "map/map.h"

// A walk over the strands of all circuits, with the whole turns by which each continues the one before.
typedef struct Walk {
    YkMap *map;
    size_t column, joint;
    double *shift; // [leaf], NaN if not reached
    size_t *queue;
    double *row; // scratch
} Walk;

static double end_value(const Walk *w, const YkStrand *leaf, int end)
{
    const YkMapRows *rows = &w->map->strand_rows[leaf->index];
    return yk_map_row_at(w->map, rows, end == 1 ? rows->count - 1 : 0)[w->column];
}

// Reads the angle of a strand at an input, near the one of a row.
static double angle_at(Walk *w, size_t leaf, double at, const double *near)
{
    return yk_map_read_row(w->map, w->map->leaves->items[leaf], at, near, w->row) ? w->row[w->column] : NAN;
}

// Returns the largest (sign 1) or smallest (-1) angle about a row, if it is there: the top of a parabola through three
// poses, which then close in on it. About a row at an end of the strand these are the row, one all but there, and its
// neighbour: the angle may turn round between them, and the strand goes on beyond its end.
static double extreme(Walk *w, size_t leaf, size_t r, double sign)
{
    const double ASIDE = 1e-3;
    const YkMapRows *rows = &w->map->strand_rows[leaf];
    const double *row = yk_map_row_at(w->map, rows, r);
    double u[3], y[3], own = row[w->column];
    bool is_last = r + 1 == rows->count, is_end = r == 0 || is_last;
    for (size_t k = 0; k < 3; k++) {
        size_t beside = is_end ? (is_last ? r - (k < 2) : k == 2) : r + k - 1;
        u[k] = yk_map_row_at(w->map, rows, beside)[0];
        y[k] = sign * yk_map_row_at(w->map, rows, beside)[w->column];
        if (y[k] > sign * own) return own;
    }
    if (is_end) {
        u[1] = row[0] + ASIDE * (u[is_last ? 0 : 2] - row[0]);
        y[1] = sign * angle_at(w, leaf, u[1], row);
        if (!(y[1] > sign * own)) return own;
    }
    double best = y[1];
    for (int step = 0; step < 12; step++) {
        double p = (u[1] - u[0]) * (y[1] - y[2]), q = (u[1] - u[2]) * (y[1] - y[0]), under = 2 * (p - q);
        double at = u[1] - ((u[1] - u[0]) * p - (u[1] - u[2]) * q) / under;
        if (!(at > u[0]) || !(at < u[2]) || fabs(at - u[1]) < 1e-9 * w->map->tracer.scale) break;
        double value = sign * angle_at(w, leaf, at, row);
        if (!isfinite(value)) break;
        best = fmax(best, value);
        size_t side = at > u[1] ? 2 : 0; // which of the outer ones is on the side of the new one
        if (value > y[1]) {
            u[2 - side] = u[1];
            y[2 - side] = y[1];
            u[1] = at;
            y[1] = value;
        } else {
            u[side] = at;
            y[side] = value;
        }
    }
    return sign * best;
}

static void visit(Walk *w, size_t leaf, YkMapTurn *turn)
{
    const YkMapRows *rows = &w->map->strand_rows[leaf];
    for (size_t r = 0; r < rows->count; r++) {
        double value = yk_map_row_at(w->map, rows, r)[w->column], low = value, high = value;
        if (rows->count > 1) {
            low = extreme(w, leaf, r, -1);
            high = extreme(w, leaf, r, 1);
        }
        turn->range.from = fmin(turn->range.from, low + w->shift[leaf]);
        turn->range.to = fmax(turn->range.to, high + w->shift[leaf]);
    }
}

// Takes the ties at a leaf: reaches the other strands, or finds that a way round adds a turn.
static void go_on(Walk *w, YkStrand *leaf, size_t *tail, YkMapTurn *turn)
{
    const YkTies *ties = &w->map->tracer.ties[w->map->tracer.piece_count];
    for (size_t k = 0; k < ties->count; k++) {
        const YkTie *tie = &ties->items[k];
        for (int side = 0; side < 2; side++) {
            YkStrand *other = tie->strand[1 - side];
            if (tie->strand[side] != leaf) continue;
            double here = end_value(w, leaf, tie->end[side]) + w->shift[leaf->index];
            double there = end_value(w, other, tie->end[1 - side]);
            double shift = 2 * YK_PI * rint((here - there) / (2 * YK_PI));
            if (isnan(w->shift[other->index])) {
                w->shift[other->index] = shift;
                w->queue[(*tail)++] = other->index;
            } else if (fabs(w->shift[other->index] - shift) > 1) {
                turn->is_full = true;
            }
        }
    }
}

static void walk(Walk *w)
{
    YkMap *map = w->map;
    for (size_t k = 0; k < map->leaves->count; k++) w->shift[k] = NAN;
    for (size_t k = 0; k < map->leaves->count; k++) {
        if (!isnan(w->shift[k])) continue;
        YkMapTurn *turn = &map->turns[map->circuit_of[k] * (map->joints + 1) + w->joint];
        size_t head = 0, tail = 0;
        w->shift[k] = 0;
        w->queue[tail++] = k;
        *turn = (YkMapTurn){false, {INFINITY, -INFINITY}};
        for (; head < tail; head++) {
            visit(w, w->queue[head], turn);
            go_on(w, map->leaves->items[w->queue[head]], &tail, turn);
        }
        double back = yk_nearest_turn(turn->range.from, 0) - turn->range.from;
        turn->range.from += back;
        turn->range.to += back;
        if (turn->is_full) turn->range.to = turn->range.from + 2 * YK_PI;
    }
}

bool yk_map_find_turns(YkMap *map)
{
    size_t n = map->leaves->count;
    Walk w = {.map = map, .shift = malloc((n + 1) * sizeof *w.shift), .queue = malloc((n + 1) * sizeof *w.queue)};
    map->turns = calloc((map->circuit_count + 1) * (map->joints + 1), sizeof *map->turns);
    w.row = calloc(map->width, sizeof *w.row);
    bool ok = w.shift && w.queue && w.row && map->turns;
    for (size_t j = 0; ok && j < map->joints; j++) {
        YkJointAngle angle = yk_joint_angle(map->mech, (int32_t)j);
        w.joint = j;
        w.column = yk_map_joint_column(map, j);
        if (angle.a != angle.b) walk(&w);
    }
    free(w.shift);
    free(w.queue);
    free(w.row);
    return ok;
}
