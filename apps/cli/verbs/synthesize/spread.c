// A search on all ranks of mpirun. Rank 0 gives out its pieces by demand, computes some itself and takes them in their
// order: the consequences of a piece - which machine is kept, when the search ends - are decided as in one process.
#include <stdlib.h>
#include <string.h>
#include "hand_out.h"
#include "session.h"
#include "stop.h"
#include "verbs/synthesize/synthesize.h"

struct YkSynthesisSpread {
    YkPieces *own;
    YkHandOut *hand_out;
    double *numbers;
    size_t width;
};

static YkStatus compute(void *context, YkSpreadWork work, const void **bytes, size_t *size)
{
    const YkSynthesisSpread *s = context;
    *bytes = s->numbers;
    *size = s->width * sizeof *s->numbers;
    return yk_pieces_compute(s->own, (size_t)work.from, s->numbers);
}

static YkStatus get(void *context, size_t piece, double *numbers)
{
    YkSynthesisSpread *s = context;
    const void *bytes;
    size_t size;
    YkStatus status = yk_hand_out_get(s->hand_out, piece, &bytes, &size);
    if (status < 0) return status;
    if (size != s->width * sizeof *numbers) yk_ranks()->abort(YK_EXIT_WRONG);
    memcpy(numbers, bytes, size);
    return YK_OK;
}

// Prepares to compute pieces on this rank. Returns false with a problem.
static bool prepare(YkSynthesisSpread *s, YkSynthesisAnswer *a, const YkSynthesisOptions *options, YkProblems *problems)
{
    s->own = yk_pieces_new(a->task, options, problems);
    s->width = yk_pieces_width(s->own);
    s->numbers = calloc(s->width + 1, sizeof *s->numbers);
    if (!s->numbers) yk_session_refuse_for_memory(a->session);
    return s->own && s->numbers;
}

static YkHandOutOptions hand_out_of(YkSynthesisSpread *s, const YkSynthesisAnswer *a, YkProgress progress)
{
    return (YkHandOutOptions){.session = a->session,
                              .progress = progress,
                              .signature = yk_pieces_signature(s->own),
                              .what = "task",
                              .files = "task, model file",
                              .compute = compute,
                              .context = s};
}

YkSynthesisSpread *yk_synthesis_spread(YkSynthesisAnswer *a, YkSynthesisOptions *options, YkProblems *problems)
{
    YkSynthesisSpread *s = calloc(1, sizeof *s);
    if (!s) {
        yk_session_refuse_for_memory(a->session);
        return NULL;
    }
    if (prepare(s, a, options, problems)) {
        const YkHandOutOptions own = hand_out_of(s, a, options->progress);
        s->hand_out = yk_hand_out_new(&own);
    }
    if (s->hand_out && yk_hand_out_begin(s->hand_out, (YkSpreadWork){.from = 0}, yk_pieces_count(s->own), 0)) {
        if (s->width > 0) options->pieces = (YkPieceSource){get, s};
        return s;
    }
    yk_synthesis_gather(s);
    return NULL;
}

void yk_synthesis_gather(YkSynthesisSpread *s)
{
    if (!s) return;
    yk_hand_out_free(s->hand_out);
    yk_pieces_free(s->own);
    free(s->numbers);
    free(s);
}

int yk_synthesis_serve(YkSynthesisAnswer *a, bool is_read)
{
    YkSynthesisOptions options = yk_default_synthesis_options();
    YkSynthesisSpread s = {0};
    options.seed = a->seed;
    options.progress = yk_stop_progress(a->session);
    is_read = is_read && prepare(&s, a, &options, a->session->problems);
    const YkHandOutOptions own = hand_out_of(&s, a, options.progress);
    yk_hand_out_serve(&own, is_read);
    yk_pieces_free(s.own);
    free(s.numbers);
    return YK_EXIT_DONE; // rank 0 gives the exit code of the run
}
