// The positions of blocks: dyads in closed form, groups by Newton's method, blocks that repeat constraints.
#ifndef PROGRAM_BLOCKS_H
#define PROGRAM_BLOCKS_H
#include "program/program.h"

// blocks.c: shared by all kinds.
YkRef yk_block_branch(YkProgram *program, size_t block); // +1 or -1
// Returns a unit vector: the block's present line `k`, along which `column` slides.
YkRefVec yk_block_line(YkProgram *program, const YkBlock *block, size_t column, size_t k);
void yk_block_name(YkProgram *program, YkRefVec vector, const char *block, const char *what);
// Keeps the least margin; NaN once a block is not finite.
void yk_block_keep_margin(YkProgram *program, YkRef margin, YkRef result);

// dyads.c
void yk_block_place_rrr(YkProgram *program, size_t block, YkPlaced *placed);
void yk_block_place_rrp(YkProgram *program, size_t block, YkPlaced *placed);
void yk_block_place_rpr(YkProgram *program, size_t block, YkPlaced *placed);
void yk_block_place_pp(YkProgram *program, size_t block, YkPlaced *placed);
// groups.c
void yk_block_place_group(YkProgram *program, size_t block, YkPlaced *placed);

#endif
