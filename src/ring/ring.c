// The ring itself: its memory, its status and its limits.
#include "ring/ring.h"
#include <stdlib.h>
#include "ring/inside.h"

YkRing *yk_ring_new(void)
{
    YkRing *ring = calloc(1, sizeof *ring);
    if (!ring) return NULL;
    ring->limit = YK_RING_TERMS_MAX;
    ring->arena = yk_arena_new();
    ring->sheet = yk_arena_new();
    if (!ring->arena || !ring->sheet || !yk_powers_start(&ring->monomials) || !yk_powers_start(&ring->phases) ||
        !(ring->zero = yk_poisson_make(ring, NULL, 0, 1)) || !(ring->one = yk_poisson_term(ring, 0, 1, 1))) {
        yk_ring_free(ring);
        return NULL;
    }
    return ring;
}

void yk_ring_free(YkRing *ring)
{
    if (!ring) return;
    yk_ring_free_all_changes(ring);
    yk_gather_free(&ring->gather);
    yk_powers_free(&ring->monomials);
    yk_powers_free(&ring->phases);
    yk_names_free(&ring->names);
    yk_names_free(&ring->latex_names);
    yk_names_free(&ring->c_names);
    free(ring->symbols);
    free(ring->patterns);
    free(ring->marks.items);
    yk_arena_free(ring->sheet);
    yk_arena_free(ring->arena);
    free(ring);
}

const YkPoisson *yk_ring_fail(YkRing *ring, YkRingStatus status)
{
    bool is_for_good = status >= YK_RING_STOPPED && ring->status < status;
    if (ring->status == YK_RING_OK || is_for_good) ring->status = status;
    return NULL;
}

YkRingStatus yk_ring_status(const YkRing *ring)
{
    bool ran_out = yk_arena_failed(ring->arena) || yk_arena_failed(ring->sheet);
    return ran_out ? YK_RING_MEMORY : ring->status;
}

void yk_ring_clear(YkRing *ring)
{
    if (ring->status < YK_RING_STOPPED) ring->status = YK_RING_OK;
}

void yk_ring_set_pace(YkRing *ring, YkPace *pace)
{
    ring->pace = pace;
}

YkPace *yk_ring_pace(const YkRing *ring)
{
    return ring->pace;
}

bool yk_ring_spend(YkRing *ring, size_t work)
{
    return yk_pace_spend(ring->pace, work) || yk_ring_fail(ring, YK_RING_STOPPED) != NULL;
}

void yk_ring_set_limit(YkRing *ring, size_t terms)
{
    ring->limit = terms < 1 ? 1 : terms < UINT32_MAX / 4 ? terms : UINT32_MAX / 4;
}

const char *yk_ring_status_text(YkRingStatus status)
{
    switch (status) {
    case YK_RING_OK:
        return "all is well";
    case YK_RING_OVERFLOW:
        return "a coefficient is too large for exact arithmetic";
    case YK_RING_SIZE:
        return "the expression has too many terms to be expanded";
    case YK_RING_POWER:
        return "a power is too large or is not defined";
    case YK_RING_DIVISOR:
        return "only a single term other than zero can divide";
    case YK_RING_DERIVATIVE:
        return "a higher derivative of a function is needed than is known";
    case YK_RING_NAME:
        return "a symbol's name is malformed or taken";
    case YK_RING_NOT_REAL:
        return "a real expression is needed";
    case YK_RING_STOPPED:
        return "stopped before it was done, as the caller asked";
    case YK_RING_MEMORY:
        return "out of memory";
    }
    return "unknown";
}
