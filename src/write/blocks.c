// Keeps the rows of a study in a file: a line that identifies the study, then blocks of rows in the order of the
// designs: number of rows, a checksum, the rows as doubles. From a damaged block on, the file is cut off.
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <yoke/blocks.h>
#include "base/mix.h"
#include "base/problems.h"
#include "write/file.h"

enum { HEAD = 64, OPEN_TRIES = 10 };
typedef struct BlockHead {
    uint64_t rows, checksum;
} BlockHead;

struct YkBlocks {
    char *path;
    FILE *file;
    uint64_t signature, design_count, done;
    size_t width;
    struct stat place; // of the file that is open
    // The block in memory: designs [from, from + count), and where the file goes on behind it.
    double *rows;
    uint64_t from;
    size_t count, room;
    off_t next, end; // end: behind the last whole block
    bool ran_out;    // a row could not be read for lack of memory
};

// --- opening

// Locks the file for this process. Returns 0, or the error: EAGAIN or EACCES if another process has it.
static int lock(int descriptor)
{
#ifdef F_SETLK
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (fcntl(descriptor, F_SETLK, &whole) < 0 && errno != ENOLCK && errno != EINVAL && errno != ENOSYS) return errno;
#else
    (void)descriptor;
#endif
    return 0;
}

static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

// Opens the file and locks it; again if the run that had it removed it in between. Returns 0 or the error.
static int open_locked(YkBlocks *blocks, int *descriptor)
{
    struct stat found;
    int error = EAGAIN;
    for (int i = 0; i < OPEN_TRIES; i++) {
        *descriptor = open(blocks->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (*descriptor < 0) return errno;
        error = lock(*descriptor);
        if (error == 0 && fstat(*descriptor, &blocks->place) < 0) error = errno;
        if (error == 0 && stat(blocks->path, &found) == 0 && is_same(&found, &blocks->place)) return 0;
        close(*descriptor);
        if (error != 0) return error;
        error = EAGAIN;
    }
    return error;
}

static bool refuse_busy(const char *path, YkProblems *problems)
{
    yk_problem(problems, YK_CODE_STUDY_BUSY, (YkPlace){0}, "another run is writing to %q", path);
    yk_problem_hint(problems, "wait until it ends, or name another output");
    return false;
}

static bool refuse_other(const char *path, YkProblems *problems)
{
    yk_problem(problems, YK_CODE_STUDY_CHANGED, (YkPlace){0}, "%q is part of another study", path);
    yk_problem_hint(problems, "--fresh starts anew");
    return false;
}

// --- blocks

// Returns the checksum of the study, of the block's place in it, and of every bit of its rows.
static uint64_t checksum_of(const YkBlocks *blocks, uint64_t from, const double *rows, size_t count)
{
    uint64_t sum = yk_mix(blocks->signature + YK_MIX_STEP * (from + 1)) + count, bits;
    for (size_t k = 0; k < count * blocks->width; k++) {
        memcpy(&bits, &rows[k], sizeof bits);
        sum = yk_mix((sum ^ bits) + YK_MIX_STEP);
    }
    return sum;
}

static bool make_room(YkBlocks *blocks, size_t count)
{
    if (count <= blocks->room) return true;
    free(blocks->rows);
    blocks->room = blocks->count = 0;
    blocks->rows = calloc(count * blocks->width + 1, sizeof *blocks->rows);
    if (blocks->rows) blocks->room = count;
    return blocks->rows != NULL;
}

typedef enum Reading { READ_WHOLE, READ_END, READ_DAMAGED, READ_NO_MEMORY } Reading;

// Reads the block at the file's position, whose first design is `from`, into memory. `left`: bytes left in the file.
static Reading read_block(YkBlocks *blocks, uint64_t from, uint64_t left)
{
    BlockHead head;
    size_t bytes = blocks->width * sizeof(double);
    blocks->count = 0;
    if (from == blocks->design_count || fread(&head, sizeof head, 1, blocks->file) != 1) return READ_END;
    if (head.rows == 0 || head.rows > blocks->design_count - from) return READ_DAMAGED;
    if (head.rows > left / bytes) return READ_END; // a half one
    size_t count = (size_t)head.rows;
    if (!make_room(blocks, count)) return READ_NO_MEMORY;
    if (fread(blocks->rows, bytes, count, blocks->file) != count) return READ_END;
    if (head.checksum != checksum_of(blocks, from, blocks->rows, count)) return READ_DAMAGED;
    blocks->from = from;
    blocks->count = count;
    blocks->next = ftello(blocks->file);
    return READ_WHOLE;
}

// Finds how far the file is whole, and cuts off the rest.
static bool read_all(YkBlocks *blocks, YkProblems *problems)
{
    Reading reading;
    uint64_t size = (uint64_t)blocks->place.st_size;
    blocks->end = HEAD;
    while ((reading = read_block(blocks, blocks->done, size - (uint64_t)blocks->end)) == READ_WHOLE) {
        blocks->done += blocks->count;
        blocks->end = blocks->next;
    }
    if (reading == READ_NO_MEMORY) return yk_file_fail(blocks->path, ENOMEM, problems);
    if (reading == READ_DAMAGED)
        yk_problem(problems, YK_CODE_STUDY_DAMAGED, (YkPlace){0},
                   "%q is damaged: designs from the %z-th on are computed again", blocks->path,
                   (size_t)blocks->done + 1);
    bool good = fseeko(blocks->file, blocks->end, SEEK_SET) == 0 && ftruncate(fileno(blocks->file), blocks->end) == 0;
    return good || yk_file_fail(blocks->path, errno, problems);
}

static bool start_anew(YkBlocks *blocks, const char *head, YkProblems *problems)
{
    blocks->end = HEAD;
    rewind(blocks->file);
    if (ftruncate(fileno(blocks->file), 0) == 0 && fwrite(head, 1, HEAD, blocks->file) == HEAD &&
        fflush(blocks->file) == 0)
        return true;
    int error = errno;
    remove(blocks->path);
    return yk_file_fail(blocks->path, error, problems);
}

static void write_head(uint64_t signature, char *head)
{
    static const char name[] = "yoke study, partial: ";
    memset(head, ' ', HEAD);
    memcpy(head, name, sizeof name - 1);
    for (int digit = 0; digit < 16; digit++)
        head[sizeof name - 1 + (size_t)digit] = "0123456789abcdef"[signature >> (60 - 4 * digit) & 15];
    head[HEAD - 1] = '\n';
}

static bool start(YkBlocks *blocks, bool is_fresh, YkProblems *problems)
{
    char head[HEAD], found[HEAD];
    int descriptor, error = open_locked(blocks, &descriptor);
    if (error == EAGAIN || error == EACCES) {
        bool is_there = access(blocks->path, W_OK) == 0;
        return is_there ? refuse_busy(blocks->path, problems) : yk_file_fail(blocks->path, error, problems);
    }
    if (error != 0) return yk_file_fail(blocks->path, error, problems);
    blocks->file = fdopen(descriptor, "r+b");
    if (!blocks->file) {
        error = errno;
        close(descriptor);
        return yk_file_fail(blocks->path, error, problems);
    }
    write_head(blocks->signature, head);
    size_t got = fread(found, 1, HEAD, blocks->file);
    bool is_ours = got == HEAD ? memcmp(found, head, HEAD) == 0
                               : memcmp(found, head, got < 20 ? got : 20) == 0; // killed before its first line
    if (is_fresh || (got < HEAD && is_ours)) return start_anew(blocks, head, problems);
    return is_ours ? read_all(blocks, problems) : refuse_other(blocks->path, problems);
}

YkBlocks *yk_blocks_open(const char *path, const YkBlocksOptions *options, YkProblems *problems)
{
    if (!path || !options || options->width == 0) return NULL;
    YkBlocks *blocks = calloc(1, sizeof *blocks);
    char *copy = malloc(strlen(path) + 1);
    if (!blocks || !copy) {
        free(blocks);
        free(copy);
        yk_file_fail(path, ENOMEM, problems);
        return NULL;
    }
    strcpy(copy, path);
    *blocks = (YkBlocks){
        .path = copy, .signature = options->signature, .design_count = options->design_count, .width = options->width};
    if (start(blocks, options->is_fresh, problems)) return blocks;
    yk_blocks_close(blocks, false);
    return NULL;
}

// --- the door

uint64_t yk_blocks_done(const YkBlocks *blocks)
{
    return blocks ? blocks->done : 0;
}

static bool fail(YkBlocks *blocks, int error, YkProblems *problems)
{
    fclose(blocks->file); // the lock goes with it, and so does what was not written
    blocks->file = NULL;
    if (blocks->done == 0) remove(blocks->path);
    return yk_file_fail(blocks->path, error, problems);
}

// Returns false, with a problem added, if the file is not in its place any more: what is written to it would be lost.
static bool is_in_place(YkBlocks *blocks, YkProblems *problems)
{
    struct stat found;
    if (stat(blocks->path, &found) == 0 && is_same(&found, &blocks->place)) return true;
    fclose(blocks->file);
    blocks->file = NULL;
    yk_problem(problems, YK_CODE_OUTPUT_FAILED, (YkPlace){0},
               "cannot write %q: another program has removed or replaced it, or its folder", blocks->path);
    return false;
}

bool yk_blocks_add(YkBlocks *blocks, const double *rows, size_t count, YkProblems *problems)
{
    if (!blocks || !blocks->file || !rows || count > blocks->design_count - blocks->done) return false;
    if (count == 0) return true;
    const BlockHead head = {count, checksum_of(blocks, blocks->done, rows, count)};
    bool good = fseeko(blocks->file, blocks->end, SEEK_SET) == 0 && fwrite(&head, sizeof head, 1, blocks->file) == 1 &&
                fwrite(rows, blocks->width * sizeof *rows, count, blocks->file) == count && fflush(blocks->file) == 0;
    if (!good) return fail(blocks, errno, problems);
    blocks->done += count;
    blocks->end += (off_t)(sizeof head + count * blocks->width * sizeof *rows);
    return is_in_place(blocks, problems);
}

const double *yk_blocks_row(YkBlocks *blocks, uint64_t design)
{
    if (!blocks || !blocks->file || design >= blocks->done) return NULL;
    bool has_block = blocks->count > 0 && blocks->from <= design;
    if (!has_block) blocks->count = 0;
    while (blocks->count == 0 || design >= blocks->from + blocks->count) {
        uint64_t from = blocks->count == 0 ? 0 : blocks->from + blocks->count;
        off_t place = blocks->count == 0 ? HEAD : blocks->next;
        if (fseeko(blocks->file, place, SEEK_SET) != 0) return NULL;
        Reading reading = read_block(blocks, from, (uint64_t)(blocks->end - place));
        blocks->ran_out |= reading == READ_NO_MEMORY;
        if (reading != READ_WHOLE) return NULL;
    }
    return blocks->rows + (size_t)(design - blocks->from) * blocks->width;
}

bool yk_blocks_ran_out(const YkBlocks *blocks)
{
    return blocks && blocks->ran_out;
}

void yk_blocks_close(YkBlocks *blocks, bool is_finished)
{
    if (!blocks) return;
    if (is_finished) remove(blocks->path); // before the lock goes
    if (blocks->file) fclose(blocks->file);
    free(blocks->path);
    free(blocks->rows);
    free(blocks);
}
