// Memory of a sparse matrix and its factors.
#include "num/sparse.h"
#include <stdlib.h>
#include <string.h>
#include "num/sparse_inside.h"

static bool triangle_start(YkTriangle *triangle, size_t capacity)
{
    triangle->capacity = capacity;
    triangle->row = malloc(capacity * sizeof *triangle->row);
    triangle->value = malloc(capacity * sizeof *triangle->value);
    return triangle->row && triangle->value;
}

static void triangle_end(YkTriangle *triangle)
{
    free(triangle->row);
    free(triangle->value);
}

// Allocates all arrays of fixed size in one block, the widest types first.
static bool allocate(YkSparse *s, size_t n, size_t entries)
{
    size_t bytes =
        (entries + 3 * n) * sizeof(double) + (3 * n + 2) * sizeof(size_t) + (entries + 7 * n + 1) * sizeof(int32_t);
    s->memory = calloc(1, bytes);
    if (!s->memory) return false;
    double *d = s->memory;
    s->value = d;
    s->diagonal = d + entries;
    s->x = s->diagonal + n;
    s->b = s->x + n;
    size_t *z = (size_t *)(void *)(s->b + n);
    s->L.start = z;
    s->U.start = z + n + 1;
    s->cursor = s->U.start + n + 1;
    int32_t *i = (int32_t *)(void *)(s->cursor + n);
    int32_t **arrays[] = {&s->order, &s->position, &s->pivot_row, &s->stack, &s->reach, &s->mark};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++, i += n) *arrays[k] = i;
    s->start = i;
    s->row = i + n + 1;
    return triangle_start(&s->L, 2 * entries + n + 1) && triangle_start(&s->U, 2 * entries + n + 1);
}

YkSparse *yk_sparse_new(size_t n, const int32_t *start, const int32_t *row)
{
    YkSparse *s = calloc(1, sizeof *s);
    if (!s) return NULL;
    s->n = n;
    size_t entries = (size_t)start[n];
    if (!allocate(s, n, entries)) {
        yk_sparse_free(s);
        return NULL;
    }
    memcpy(s->start, start, (n + 1) * sizeof *start);
    if (entries > 0) memcpy(s->row, row, entries * sizeof *row);
    if (!yk_sparse_order(n, s->start, s->row, s->order) || !yk_sparse_postorder(n, s->start, s->row, s->order)) {
        yk_sparse_free(s);
        return NULL;
    }
    return s;
}

void yk_sparse_free(YkSparse *s)
{
    if (!s) return;
    triangle_end(&s->L);
    triangle_end(&s->U);
    free(s->memory);
    free(s);
}
