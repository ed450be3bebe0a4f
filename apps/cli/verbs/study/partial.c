// Keeps the results of an interrupted study: OUTPUT.partial, a file of blocks (yoke/blocks.h). The same study continues
// after the last whole block; from a damaged block on, it computes its designs again.
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "signature.h"
#include "verbs/study/study.h"

uint64_t yk_study_signature(const YkStudyAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *r = session->request;
    uint64_t hash = yk_signature_word(yk_signature_begin(), "blocks with checksums");
    const char *const words[] = {r->over, r->steps, r->of, r->time, r->lock};
    const YkAssignments *const pairs[] = {&r->at, &r->rate, &r->accel, &r->param};
    hash = yk_signature_file(session, yk_signature_file(session, hash, r->file), r->sample);
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) hash = yk_signature_word(hash, words[k]);
    for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++) hash = yk_signature_pairs(hash, pairs[k]);
    for (size_t k = 0; k < r->vary.count; k++) hash = yk_signature_word(hash, r->vary.items[k]);
    hash = yk_signature_bytes(hash, &answer->seed, sizeof answer->seed);
    hash = yk_signature_bytes(hash, &answer->design_count, sizeof answer->design_count);
    return yk_signature_bytes(hash, &answer->width, sizeof answer->width);
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
    if (!answer->blocks) answer->partial[0] = '\0'; // the file there is not ours: do not mention it
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
