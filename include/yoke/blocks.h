// Studies in blocks, for programs that distribute them over processes, machines or nights: designs by their numbers,
// the rows of a block of designs, and a file of blocks that goes on where it ended.
//
// A row is a design: the values of its parameters, its status (yoke/status.h), its number of valid poses, then its
// answers: the channels at one pose; or least, largest, mean and range of each channel over all poses. Values that are
// not valid are NaN, beside a status that says why. A row depends only on the study and its number.
#ifndef YOKE_BLOCKS_H
#define YOKE_BLOCKS_H

#include <yoke/study.h>

#ifdef __cplusplus
extern "C" {
#endif

// A parameter that varies: an axis of a grid or, in a sample, a distribution.
typedef struct YkDesignAxis {
    const char *name;
    double from, to; // of a grid, SI: both ends included
    size_t count;    // at least 1
    YkDistribution distribution;
} YkDesignAxis;
typedef struct YkDesigns {
    const YkDesignAxis *axes; // in the order of the study's parameters
    size_t axis_count;
    bool is_sample;
    uint64_t seed; // of a sample
} YkDesigns;
// Finds the values of a design, values[axis]: in a grid the last axis varies fastest.
YK_API void yk_designs_at(const YkDesigns *designs, uint64_t design, double *values);

typedef struct YkRowCase {
    const YkDesigns *designs;
    const double *const *inputs; // [3 * input + k][pose], as in YkStudyCase
    size_t pose_count;
    const double *times; // [pose], s; NULL: the state's
    bool is_reduced;     // otherwise there is one pose
} YkRowCase;
// Returns how many numbers a row has; 0 for a NULL argument.
YK_API size_t yk_study_row_width(const YkStudy *study, const YkRowCase *asked);
// Computes the rows of designs [from, from + count): rows[design - from][column]. Returns YK_OK, or YK_STOPPED,
// YK_NO_MEMORY or YK_BAD_ARGUMENT, after which `rows` has no valid rows. Cost: that of yk_study_run or yk_study_reduce.
YK_API YkStatus yk_study_rows(YkStudy *study, const YkRowCase *asked, uint64_t from, size_t count, double *rows);

// A file that keeps the rows of a study, block after block in the order of the designs, each block with a checksum. It
// holds doubles as this machine stores them: another kind of processor cannot read it. One process at a time may open
// it.
typedef struct YkBlocks YkBlocks;
typedef struct YkBlocksOptions {
    uint64_t signature; // a hash of everything on which the rows depend; it identifies the study
    uint64_t design_count;
    size_t width;  // numbers a row
    bool is_fresh; // start anew, whatever the file has
} YkBlocksOptions;
// Opens or makes the file. It goes on after the last whole block. A damaged block gives a warning, and the rows from it
// on are lost. Returns NULL with a problem added if the file is another study's, open elsewhere, or not writable.
YK_API YkBlocks *yk_blocks_open(const char *path, const YkBlocksOptions *options, YkProblems *problems);
// Returns how many designs the file has.
YK_API uint64_t yk_blocks_done(const YkBlocks *blocks);
// Adds a block: rows of the next `count` designs. Returns false with a problem added: the disk is full, or the file was
// removed. Whole blocks stay as they are; nothing more can be added.
YK_API bool yk_blocks_add(YkBlocks *blocks, const double *rows, size_t count, YkProblems *problems);
// Returns the row of a design, valid until the next call; NULL if it cannot be read. Only one block is in memory: rows
// in ascending order cost one reading of the file.
YK_API const double *yk_blocks_row(YkBlocks *blocks, uint64_t design);
// Returns whether a row could not be read for lack of memory.
YK_API bool yk_blocks_ran_out(const YkBlocks *blocks);
// Closes the file; removes it if it has served its purpose.
YK_API void yk_blocks_close(YkBlocks *blocks, bool is_finished);

#ifdef __cplusplus
}
#endif

#endif
