// Tiles: the squares into which a field is divided first. Each is divided further by itself: the result depends on the
// plane and on the tile alone, so it does not matter who computes it, or when.
#ifndef MAP_TILE_H
#define MAP_TILE_H
#include "map/workspace/field.h"

// The result of a tile, as words: five of its head, the counts that were expected of each piece, its squares in the
// order in which they were divided, its crossings.
enum { YK_TILE_SQUARES, YK_TILE_CROSSINGS, YK_TILE_IS_UNPROVED, YK_TILE_UNPROVED, YK_TILE_PIECES, YK_TILE_HEAD };

// Room for one tile.
typedef struct YkTileRoom {
    uint16_t *count; // [size][size]
    unsigned char *state;
    size_t size;
    uint32_t *words;
    size_t word_count, word_capacity;
} YkTileRoom;

void yk_tile_room_end(YkTileRoom *room);
// Divides the whole field down to tiles: fills the squares that are proved before, if the field has cells, and lists
// the tiles that are not. n, low, high and step are set. Returns false when out of memory or stopped.
bool yk_tiles_plan(YkField *field);
void yk_tiles_forget(YkField *field); // the list is empty
// Divides a tile. Cells of the field are not touched. Returns false when out of memory or stopped.
bool yk_tile_compute(YkField *field, size_t tile, YkTileRoom *room);
// Fills a tile of the field from words; tiles are taken in their order. Returns false for words that no tile has, or
// when out of memory.
bool yk_tile_take(YkField *field, size_t tile, const uint32_t *words, size_t count);

#endif
