// The ring itself: its memory.
#include "ring/ring.h"
#include <stdlib.h>
#include "ring/inside.h"

YkRing *yk_ring_new(void)
{
    YkRing *ring = calloc(1, sizeof *ring);
    if (!ring) return NULL;
    ring->limit = YK_RING_TERMS_MAX;
    ring->arena = ring->elements = yk_arena_new();
    ring->sheet = yk_arena_new();
    if (!ring->arena || !ring->sheet || !yk_powers_start(&ring->monomials) || !yk_powers_start(&ring->phases) ||
        !(ring->zero = yk_poisson_make(ring, NULL, 0, 1)) || !(ring->one = yk_poisson_term(ring, 0, 1, 1))) {
        yk_ring_free(ring);
        return NULL;
    }
    return ring;
}

void yk_ring_reserve(YkRing *ring, size_t bytes)
{
    ring->arena->chunk_size = bytes;
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
    free(ring->typeset);
    free(ring->patterns);
    free(ring->marks.items);
    yk_arena_free(ring->sheet);
    yk_arena_free(ring->passing);
    yk_arena_free(ring->arena);
    free(ring);
}
