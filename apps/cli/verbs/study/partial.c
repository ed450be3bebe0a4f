// Keeps what an interrupted study has done: OUTPUT.partial, a file of blocks (yoke/blocks.h). The same study continues
// after the last whole block; from a damaged block on, it computes its designs again.
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "session.h"
#include "verbs/study/study.h"

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

uint64_t yk_study_signature(const YkStudyAnswer *answer)
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

// --- the file

void yk_partial_tell(const YkStudyAnswer *answer)
{
    if (!answer->partial[0] || access(answer->partial, F_OK) != 0) return;
    yk_problem_hint(answer->session->problems, "the results so far are in %q: the same command continues from there",
                    answer->partial);
}

bool yk_partial_is_kept(const YkRequest *request)
{
    const char *output = request->output;
    return output && strcmp(output, "-") != 0 && strncmp(output, "/dev/", 5) != 0 && strcmp(request->file, "-") != 0 &&
           strlen(output) + 9 < YK_PARTIAL_PATH;
}

bool yk_partial_open(YkStudyAnswer *answer)
{
    const YkRequest *request = answer->session->request;
    if (!yk_partial_is_kept(request)) return true;
    YkBlocksOptions options = {yk_study_signature(answer), answer->design_count, answer->width, request->fresh};
    if (answer->session->ran_out) return false;
    snprintf(answer->partial, sizeof answer->partial, "%s.partial", request->output);
    answer->blocks = yk_blocks_open(answer->partial, &options, answer->session->problems);
    if (!answer->blocks) answer->partial[0] = '\0'; // what stands there is not told: it is not ours
    answer->done = (size_t)yk_blocks_done(answer->blocks);
    return answer->blocks != NULL;
}

bool yk_partial_add(YkStudyAnswer *answer, const double *rows, size_t count)
{
    if (!answer->blocks || yk_blocks_add(answer->blocks, rows, count, answer->session->problems)) return true;
    yk_partial_tell(answer);
    return false;
}

void yk_partial_close(YkStudyAnswer *answer, bool is_finished)
{
    yk_blocks_close(answer->blocks, is_finished);
    answer->blocks = NULL;
}
