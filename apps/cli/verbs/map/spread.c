// A map over two freedoms on all ranks of mpirun: rank 0 gives out the tiles of each plane and takes them in order.
#include <stdlib.h>
#include "hand_out.h"
#include "session.h"
#include "signature.h"
#include "stop.h"
#include "verbs/map/map.h"

struct YkMapSpread {
    YkTiles *own;
    YkHandOut *hand_out;
};

static YkStatus compute(void *context, YkSpreadWork work, const void **bytes, size_t *size)
{
    const YkMapSpread *s = context;
    const uint32_t *words;
    size_t count;
    YkStatus status = yk_tiles_compute(s->own, &work.plane, (size_t)work.from, &words, &count);
    *bytes = words;
    *size = count * sizeof *words;
    return status;
}

static YkStatus get(void *context, const YkTilePlane *plane, size_t tile, size_t count, const uint32_t **words,
                    size_t *word_count)
{
    YkMapSpread *s = context;
    const void *bytes;
    size_t size;
    if (tile == 0 && !yk_hand_out_begin(s->hand_out, (YkSpreadWork){.plane = *plane}, count, count))
        return YK_NO_MEMORY;
    YkStatus status = yk_hand_out_get(s->hand_out, tile, &bytes, &size);
    if (status < 0) return status;
    *words = bytes; // of malloc: at an address for words
    *word_count = size / sizeof **words;
    return YK_OK;
}

static uint64_t signature_of(const YkRegionsAnswer *answer)
{
    YkSession *session = answer->session;
    const YkRequest *r = session->request;
    const char *const words[] = {r->over, r->time, r->lock, r->assembly, r->tolerance};
    uint64_t hash = yk_signature_file(session, yk_signature_word(yk_signature_begin(), "tiles"), r->file);
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) hash = yk_signature_word(hash, words[k]);
    return yk_signature_pairs(yk_signature_pairs(hash, &r->at), &r->param);
}

static YkHandOutOptions hand_out_of(YkMapSpread *s, const YkRegionsAnswer *answer)
{
    return (YkHandOutOptions){.session = answer->session,
                              .progress = yk_stop_progress(answer->session),
                              .signature = signature_of(answer),
                              .what = "model",
                              .files = "model file",
                              .compute = compute,
                              .context = s};
}

static bool prepare(YkMapSpread *s, const YkRegionsAnswer *answer)
{
    s->own = yk_tiles_new(answer->state, answer->coordinate[0], answer->coordinate[1], answer->session->problems);
    return s->own != NULL;
}

YkMapSpread *yk_map_spread(const YkRegionsAnswer *answer, YkRegionsOptions *options)
{
    YkMapSpread *s = calloc(1, sizeof *s);
    if (!s) {
        yk_session_refuse_for_memory(answer->session);
        return NULL;
    }
    const YkHandOutOptions own = hand_out_of(s, answer);
    if (prepare(s, answer)) s->hand_out = yk_hand_out_new(&own);
    if (s->hand_out) {
        options->tiles = (YkTileSource){get, s};
        return s;
    }
    yk_map_gather(s);
    return NULL;
}

void yk_map_gather(YkMapSpread *s)
{
    if (!s) return;
    yk_hand_out_free(s->hand_out);
    yk_tiles_free(s->own);
    free(s);
}

void yk_map_serve(const YkRegionsAnswer *answer)
{
    YkMapSpread s = {NULL, NULL};
    bool is_read = prepare(&s, answer);
    const YkHandOutOptions own = hand_out_of(&s, answer);
    yk_hand_out_serve(&own, is_read);
    yk_tiles_free(s.own);
}
