// Divides the plane of two inputs down to tiles, and each tile until every square has one number of configurations.
#include "map/workspace/tile.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

enum { COUNT_MAX = 60000, SMALLEST = 8, ALONG = 32, ALONG_LARGE = 64, LARGE = 2048 };

typedef struct Work {
    YkField *field;
    YkTile tile;
    YkTileRoom *room;
} Work;

void yk_tile_room_end(YkTileRoom *room)
{
    free(room->count);
    free(room->state);
    free(room->words);
    *room = (YkTileRoom){0};
}

static int count_square(YkField *f, size_t x, size_t y, size_t size)
{
    const size_t at[2] = {x, y};
    double low[2], high[2];
    for (int k = 0; k < 2; k++) {
        low[k] = f->low[k] + (double)at[k] * f->step[k];
        high[k] = f->low[k] + (double)(at[k] + size) * f->step[k];
    }
    int count = yk_box_count(&f->tracer, low, high, NULL);
    return count < COUNT_MAX ? count : COUNT_MAX;
}

// --- down to tiles

static void fill(YkField *f, size_t x, size_t y, size_t size, unsigned count, unsigned state)
{
    for (size_t row = y; row < y + size && f->count; row++)
        for (size_t k = row * f->n + x; k < row * f->n + x + size; k++) {
            f->count[k] = (uint16_t)count;
            f->state[k] = (unsigned char)state;
        }
    if (state & YK_CELL_PROVED) f->proved += size * size;
}

static bool plan(YkField *f, size_t x, size_t y, size_t size, size_t smallest)
{
    int count = count_square(f, x, y, size);
    if (yk_field_is_over(f)) return false;
    if (count >= 0) {
        fill(f, x, y, size, (unsigned)count, YK_CELL_PROVED);
    } else if (size <= smallest) {
        if (!YK_ROOM(f->tiles, f->tile_count, f->tile_capacity)) return false;
        f->tiles[f->tile_count++] = (YkTile){x, y, size, yk_box_near(&f->tracer)};
    } else {
        size_t half = size / 2;
        for (size_t k = 0; k < 4; k++)
            if (!plan(f, x + k % 2 * half, y + k / 2 * half, half, smallest)) return false;
    }
    return true;
}

// Takes note of how many solutions a piece was found to have, 0 if it was not solved. If that number is not the
// same everywhere, some solutions were not known somewhere.
static void expect(YkField *f, size_t piece, size_t count)
{
    if (count > 0 && f->most[piece] > 0 && count != f->most[piece]) yk_note_unproved(&f->tracer, 0, piece);
    if (count > f->most[piece]) f->most[piece] = count;
}

void yk_tiles_forget(YkField *f)
{
    for (size_t k = 0; k < f->tile_count; k++) yk_box_near_free(f->tiles[k].near, f->tracer.piece_count);
    f->tile_count = 0;
}

bool yk_tiles_plan(YkField *f)
{
    size_t along = f->n < LARGE ? ALONG : ALONG_LARGE, smallest = f->n / along;
    yk_tiles_forget(f);
    bool good = yk_box_recall(&f->tracer, &f->first, NULL) &&
                plan(f, 0, 0, f->n, smallest < SMALLEST ? SMALLEST : smallest) &&
                yk_box_remember(&f->tracer, &f->memory);
    for (size_t k = 0; good && k < f->tracer.piece_count; k++) expect(f, k, f->memory.expected[k]);
    if (!good && !yk_field_is_over(f)) f->tracer.out_of_memory = true;
    return good;
}

// --- a tile

static void add_word(Work *w, uint32_t word)
{
    YkTileRoom *room = w->room;
    if (YK_ROOM(room->words, room->word_count, room->word_capacity))
        room->words[room->word_count++] = word;
    else
        w->field->tracer.out_of_memory = true;
}

static uint32_t log2_of(size_t size)
{
    uint32_t log = 0;
    while (size > 1) {
        size /= 2;
        log++;
    }
    return log;
}

static void add_square(Work *w, size_t x, size_t y, size_t size, unsigned count, unsigned state)
{
    size_t left = x - w->tile.x, low = y - w->tile.y, side = w->tile.size;
    for (size_t row = low; row < low + size; row++)
        for (size_t k = row * side + left; k < row * side + left + size; k++) {
            w->room->count[k] = (uint16_t)count;
            w->room->state[k] = (unsigned char)state;
        }
    add_word(w, count | (uint32_t)state << 16 | log2_of(size) << 24);
    if (!w->field->tracer.out_of_memory) w->room->words[YK_TILE_SQUARES]++;
}

// Counts at the centre of a cell, or, where configurations meet just there, beside it.
static void sample(Work *w, size_t x, size_t y)
{
    static const double aside[][2] = {{0, 0}, {0.231, 0.117}, {-0.173, 0.219}, {-0.127, -0.259}, {0.287, -0.191}};
    YkField *f = w->field;
    for (size_t k = 0; k < sizeof aside / sizeof *aside && !yk_field_is_over(f); k++) {
        const double at[2] = {yk_field_center(f, 0, x) + aside[k][0] * f->step[0],
                              yk_field_center(f, 1, y) + aside[k][1] * f->step[1]};
        int count = yk_box_count(&f->tracer, at, at, NULL);
        if (count < 0) continue;
        add_square(w, x, y, 1, (unsigned)(count < COUNT_MAX ? count : COUNT_MAX), 0);
        return;
    }
    add_square(w, x, y, 1, 0, YK_CELL_LOST); // it takes the number of the cell on its left, perhaps of another tile
}

static void divide(Work *w, size_t x, size_t y, size_t size)
{
    size_t half = size / 2;
    for (size_t k = 0; k < 4 && !yk_field_is_over(w->field); k++) {
        size_t own[2] = {x + k % 2 * half, y + k / 2 * half};
        int count = count_square(w->field, own[0], own[1], half);
        if (count >= 0)
            add_square(w, own[0], own[1], half, (unsigned)count, YK_CELL_PROVED);
        else if (half == 1)
            sample(w, own[0], own[1]);
        else
            divide(w, own[0], own[1], half);
    }
}

// Finds the crossings between cells of the tile. Those to its neighbours are found by yk_field_crossing.
static void cross(Work *w)
{
    const YkTileRoom *room = w->room;
    YkField *f = w->field;
    size_t size = w->tile.size;
    for (size_t k = 0; k < size * size; k++)
        for (int axis = 0; axis < 2 && !yk_field_is_over(f); axis++) {
            size_t x = k % size, y = k / size, other = axis == 0 ? k + 1 : k + size;
            if ((axis == 0 ? x : y) + 1 == size || room->count[k] == room->count[other]) continue;
            if ((room->state[k] | room->state[other]) & YK_CELL_LOST) continue;
            YkCrossing c = yk_field_find_crossing(f, w->tile.x + x, w->tile.y + y, axis);
            uint32_t part;
            memcpy(&part, &c.part, sizeof part);
            add_word(w, c.key);
            add_word(w, part);
            add_word(w, (uint32_t)c.piece);
            if (!f->tracer.out_of_memory) w->room->words[YK_TILE_CROSSINGS]++;
        }
}

static bool make_room(YkTileRoom *room, size_t size)
{
    if (room->size == size) return true;
    free(room->count);
    free(room->state);
    room->count = malloc(size * size * sizeof *room->count);
    room->state = malloc(size * size * sizeof *room->state);
    room->size = room->count && room->state ? size : 0;
    return room->size == size;
}

bool yk_tile_compute(YkField *f, size_t tile, YkTileRoom *room)
{
    Work w = {f, f->tiles[tile], room};
    YkTracer *t = &f->tracer;
    bool was_unproved = t->is_unproved;
    size_t block = t->unproved_block;
    t->is_unproved = false;
    room->word_count = 0;
    if (!make_room(room, w.tile.size) || !yk_box_recall(t, &f->memory, w.tile.near)) t->out_of_memory = true;
    for (size_t k = 0; k < YK_TILE_HEAD + t->piece_count; k++) add_word(&w, 0);
    if (!yk_field_is_over(f)) divide(&w, w.tile.x, w.tile.y, w.tile.size);
    if (!yk_field_is_over(f) && f->has_curves) cross(&w);
    if (!yk_field_is_over(f)) {
        room->words[YK_TILE_IS_UNPROVED] = t->is_unproved;
        room->words[YK_TILE_UNPROVED] = t->is_unproved ? (uint32_t)t->unproved_block : 0;
        room->words[YK_TILE_PIECES] = (uint32_t)t->piece_count;
        for (size_t k = 0; k < t->piece_count; k++) room->words[YK_TILE_HEAD + k] = (uint32_t)t->expected[k];
    }
    t->is_unproved = was_unproved;
    t->unproved_block = block;
    return !yk_field_is_over(f);
}

// --- taking a tile

typedef struct Reader {
    YkField *field;
    const uint32_t *next, *end;
} Reader;

static void take_square(YkField *f, size_t x, size_t y, size_t size, uint32_t word)
{
    unsigned count = word & 0xffff, state = word >> 16 & 0xff;
    if (state & YK_CELL_LOST) {
        count = x > 0 ? f->count[y * f->n + x - 1] : 0;
        f->lost++;
    }
    fill(f, x, y, size, count, state);
}

static bool take_squares(Reader *r, size_t x, size_t y, size_t size)
{
    if (r->next == r->end) return false;
    uint32_t log = *r->next >> 24, state = *r->next >> 16 & 0xff;
    if (log > 16 || (state & ~(uint32_t)(YK_CELL_PROVED | YK_CELL_LOST)) != 0) return false;
    size_t own = (size_t)1 << log, half = size / 2;
    if (own > size) return false;
    if (own == size) {
        take_square(r->field, x, y, size, *r->next++);
        return true;
    }
    for (size_t k = 0; k < 4; k++)
        if (!take_squares(r, x + k % 2 * half, y + k / 2 * half, half)) return false;
    return true;
}

static bool take_crossing(YkField *f, const uint32_t *words)
{
    YkCrossing c = {.key = words[0], .piece = (int16_t)words[2]};
    memcpy(&c.part, &words[1], sizeof c.part);
    bool is_good = c.key > 0 && yk_crossing_cell(&c) < f->n * f->n && c.part >= 0 && c.part <= 1 &&
                   words[2] < f->tracer.piece_count && !yk_crossings_find(&f->crossings, c.key);
    if (!is_good) return false;
    if (yk_crossings_add(&f->crossings, c)) return true;
    f->tracer.out_of_memory = true;
    return false;
}

bool yk_tile_take(YkField *f, size_t tile, const uint32_t *words, size_t count)
{
    size_t pieces = f->tracer.piece_count, before = YK_TILE_HEAD + pieces;
    if (count < before || words[YK_TILE_PIECES] != pieces) return false;
    size_t squares = words[YK_TILE_SQUARES], crossings = words[YK_TILE_CROSSINGS];
    if (squares > count || crossings > count || before + squares + 3 * crossings != count) return false;
    Reader r = {f, words + before, words + before + squares};
    if (!take_squares(&r, f->tiles[tile].x, f->tiles[tile].y, f->tiles[tile].size) || r.next != r.end) return false;
    for (size_t k = 0; k < crossings; k++)
        if (!take_crossing(f, r.end + 3 * k)) return false;
    if (words[YK_TILE_IS_UNPROVED] && words[YK_TILE_UNPROVED] < f->tracer.piece_count)
        yk_note_unproved(&f->tracer, 0, words[YK_TILE_UNPROVED]);
    for (size_t k = 0; k < pieces; k++) expect(f, k, words[YK_TILE_HEAD + k]);
    return true;
}
