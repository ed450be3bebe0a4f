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

// Reads the angle at a share of the way from a row of a strand to `span` beyond. About its ends the way goes as the
// square of the share: at a limit the angle has a slope over the share, not over the input.
static double angle_on(Walk *w, size_t leaf, const double *row, double span, bool is_end, double share)
{
    double at = row[0] + span * (is_end ? share * share : share);
    return yk_map_read_row(w->map, w->map->leaves->items[leaf], at, row, w->row) ? w->row[w->column] : NAN;
}

// Returns the largest (sign 1) or smallest (-1) angle about a row, if it is there: the top of a parabola through three
// poses, which then close in on it; now and then a middle of two comes instead, since near change points the angle has
// a kink. About a row at an end of the strand these are the row, one all but there, and its neighbour: the angle may
// turn round between them, and the strand goes on beyond its end.
static double extreme(Walk *w, size_t leaf, size_t r, double sign)
{
    enum { STEPS_MAX = 60 };
    const double ASIDE = 1e-4, CLOSE = 1e-9;
    const YkMapRows *rows = &w->map->strand_rows[leaf];
    bool is_last = r + 1 == rows->count, is_end = r == 0 || is_last;
    const double *row = yk_map_row_at(w->map, rows, r), *after = yk_map_row_at(w->map, rows, is_last ? r - 1 : r + 1);
    const double *before = is_end ? row : yk_map_row_at(w->map, rows, r - 1);
    double own = row[w->column], span = is_end ? after[0] - row[0] : w->map->tracer.scale;
    double u[3] = {(before[0] - row[0]) / span, is_end ? ASIDE : 0, (after[0] - row[0]) / span};
    double y[3] = {sign * before[w->column], sign * own, sign * after[w->column]};
    if (y[0] > y[1] || y[2] > y[1]) return own;
    if (is_end) y[1] = sign * angle_on(w, leaf, row, span, true, ASIDE);
    if (is_end && !(y[1] > y[0])) return own;
    for (int step = 1; step <= STEPS_MAX; step++) {
        double p = (u[1] - u[0]) * (y[1] - y[2]), q = (u[1] - u[2]) * (y[1] - y[0]), under = 2 * (p - q);
        double at = u[1] - ((u[1] - u[0]) * p - (u[1] - u[2]) * q) / under;
        if (step % 4 == 0) at = 0.5 * (u[1] + (u[2] - u[1] > u[1] - u[0] ? u[2] : u[0]));
        if (!(at > u[0]) || !(at < u[2]) || fabs(at - u[1]) < CLOSE) break;
        double value = sign * angle_on(w, leaf, row, span, is_end, at);
        if (!isfinite(value)) break;
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
    return sign * y[1];
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
