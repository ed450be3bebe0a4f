// Keeps what an interrupted study has done: OUTPUT.partial, a line that identifies the study, then blocks of rows in
// the order of their computation: number of rows, a checksum, the rows as doubles. The same study continues after the
// last whole block; from a damaged block on, it computes its designs again.
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "base/mix.h"
#include "session.h"
#include "verbs/study/study.h"
#include "write/file.h"

enum { HEAD = 64 };
typedef struct BlockHead {
    uint64_t rows, checksum;
} BlockHead;
static struct {
    char path[4096];
    FILE *file;
    uint64_t signature;
} partial;

// --- identity of the study: FNV-1a over all that decides its rows

static uint64_t add_bytes(uint64_t hash, const void *bytes, size_t length)
{
    const unsigned char *at = bytes;
    for (size_t k = 0; k < length; k++) hash = (hash ^ at[k]) * 0x100000001b3u;
    return (hash ^ 0xff) * 0x100000001b3u;
}

static uint64_t add_word(uint64_t hash, const char *word)
{
    return add_bytes(hash, word ? word : "\001", word ? strlen(word) : 1);
}

static uint64_t add_pairs(uint64_t hash, const YkAssignments *pairs)
{
    hash = add_bytes(hash, &pairs->count, sizeof pairs->count);
    for (size_t k = 0; k < pairs->count; k++)
        hash = add_word(add_word(hash, pairs->items[k].name), pairs->items[k].value);
    return hash;
}

static uint64_t add_file(YkSession *session, uint64_t hash, const char *path)
{
    FILE *file = path ? fopen(path, "rb") : NULL;
    if (path && !file && errno == ENOMEM) session->ran_out = true;
    char block[8192];
    size_t length;
    while (file && (length = fread(block, 1, sizeof block, file)) > 0)
        for (size_t k = 0; k < length; k++) hash = (hash ^ (unsigned char)block[k]) * 0x100000001b3u;
    if (file) fclose(file);
    return add_word(hash, "|");
}

static uint64_t signature(const YkStudyAnswer *answer)
{
    const YkRequest *r = answer->session->request;
    uint64_t hash = add_word(add_word(0xcbf29ce484222325u, yk_version()), "blocks with checksums");
    const char *const words[] = {r->over, r->steps, r->of, r->time, r->lock};
    const YkAssignments *const pairs[] = {&r->at, &r->rate, &r->accel, &r->param};
    hash = add_file(answer->session, add_file(answer->session, hash, r->file), r->sample);
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) hash = add_word(hash, words[k]);
    for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++) hash = add_pairs(hash, pairs[k]);
    for (size_t k = 0; k < r->vary.count; k++) hash = add_word(hash, r->vary.items[k]);
    hash = add_bytes(hash, &answer->seed, sizeof answer->seed);
    hash = add_bytes(hash, &answer->design_count, sizeof answer->design_count);
    return add_bytes(hash, &answer->width, sizeof answer->width);
}

static void write_head(const YkStudyAnswer *answer, char *head)
{
    partial.signature = signature(answer);
    memset(head, ' ', HEAD);
    int length = snprintf(head, HEAD, "yoke study, partial: %016llx", (unsigned long long)partial.signature);
    head[length] = ' ';
    head[HEAD - 1] = '\n';
}

// --- the file

// Returns the checksum of the study, of the block's place in it, and of every bit of its rows.
static uint64_t checksum_of(const YkStudyAnswer *answer, size_t from, size_t rows)
{
    uint64_t sum = yk_mix(partial.signature + YK_MIX_STEP * (from + 1)) + rows, bits;
    const double *row = yk_study_row(answer, from);
    for (size_t k = 0; k < rows * answer->width; k++) {
        memcpy(&bits, &row[k], sizeof bits);
        sum = yk_mix((sum ^ bits) + YK_MIX_STEP);
    }
    return sum;
}

void yk_partial_tell(YkProblems *problems)
{
    if (!partial.path[0] || access(partial.path, F_OK) != 0) return;
    yk_problem_hint(problems, "the results so far are in %q: the same command continues from there", partial.path);
}

// Rows already written stay: with more room the study continues from them.
static bool fail(const YkStudyAnswer *answer)
{
    int error = errno;
    bool is_ours = partial.file != NULL;
    if (is_ours) fclose(partial.file);
    partial.file = NULL;
    if (is_ours && answer->done == 0) remove(partial.path);
    yk_file_fail(partial.path, error, answer->session->problems);
    if (is_ours) yk_partial_tell(answer->session->problems);
    return false;
}

// Returns whether the output is a regular place; otherwise nothing is kept.
static bool is_kept(const char *output, const char *model)
{
    return output && strcmp(output, "-") != 0 && strncmp(output, "/dev/", 5) != 0 && strcmp(model, "-") != 0 &&
           strlen(output) + 9 < sizeof partial.path;
}

static bool start(const YkStudyAnswer *answer, const char *head)
{
    partial.file = fopen(partial.path, "wb");
    if (!partial.file || fwrite(head, 1, HEAD, partial.file) != HEAD || fflush(partial.file) != 0) return fail(answer);
    return true;
}

// Reads the next block into its rows. Returns false at the file's end, for an incomplete block, or for a damaged one
// (is_damaged).
static bool read_block(YkStudyAnswer *answer, bool *is_damaged)
{
    BlockHead head;
    if (answer->done == answer->design_count || fread(&head, sizeof head, 1, partial.file) != 1) return false;
    *is_damaged = head.rows == 0 || head.rows > answer->design_count - answer->done;
    if (*is_damaged) return false;
    size_t rows = (size_t)head.rows, count = rows * answer->width;
    if (fread(yk_study_row(answer, answer->done), sizeof(double), count, partial.file) != count) return false;
    *is_damaged = head.checksum != checksum_of(answer, answer->done, rows);
    if (!*is_damaged) answer->done += rows;
    return !*is_damaged;
}

static bool read_blocks(YkStudyAnswer *answer)
{
    bool is_damaged = false;
    long end = ftell(partial.file);
    while (read_block(answer, &is_damaged)) end = ftell(partial.file);
    if (is_damaged)
        yk_problem(answer->session->problems, YK_CODE_STUDY_DAMAGED, (YkPlace){0},
                   "%q is damaged: designs from the %z-th on are computed again", partial.path, answer->done + 1);
    return end >= 0 && fseek(partial.file, end, SEEK_SET) == 0 && ftruncate(fileno(partial.file), end) == 0;
}

bool yk_partial_open(YkStudyAnswer *answer)
{
    const YkRequest *request = answer->session->request;
    char head[HEAD], found[HEAD];
    if (!is_kept(request->output, request->file)) return true;
    snprintf(partial.path, sizeof partial.path, "%s.partial", request->output);
    write_head(answer, head);
    if (answer->session->ran_out) return false;
    partial.file = request->fresh ? NULL : fopen(partial.path, "r+b");
    if (!partial.file && !request->fresh && errno == ENOMEM) return fail(answer); // what stands there stays
    if (!partial.file) return start(answer, head);
    size_t got = fread(found, 1, HEAD, partial.file);
    if (got < HEAD && (got == 0 || memcmp(found, head, got < 20 ? got : 20) == 0)) {
        fclose(partial.file);
        return start(answer, head); // killed before its first line was complete
    }
    if (memcmp(found, head, HEAD) != 0) {
        fclose(partial.file);
        partial.file = NULL;
        yk_session_refuse(answer->session, YK_CODE_STUDY_CHANGED, "%q is part of another study", partial.path);
        yk_problem_hint(answer->session->problems, "--fresh starts anew");
        return false;
    }
    return read_blocks(answer) || fail(answer);
}

bool yk_partial_add(YkStudyAnswer *answer, size_t from, size_t to)
{
    if (!partial.file) return true;
    size_t count = (to - from) * answer->width;
    const BlockHead head = {to - from, checksum_of(answer, from, to - from)};
    bool good = fwrite(&head, sizeof head, 1, partial.file) == 1 &&
                fwrite(yk_study_row(answer, from), sizeof(double), count, partial.file) == count &&
                fflush(partial.file) == 0;
    return good || fail(answer);
}

void yk_partial_close(bool is_finished)
{
    if (partial.file) fclose(partial.file);
    partial.file = NULL;
    if (is_finished && partial.path[0]) remove(partial.path);
}
