// Keeps the cells of strands.
#include "map/strand.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

YkStrand *yk_strand_new(YkTracer *tracer, size_t level, YkStrand *below)
{
    YkStrand *strand = calloc(1, sizeof *strand);
    if (strand)
        *strand = (YkStrand){.level = level, .below = below};
    else
        tracer->out_of_memory = true;
    return strand;
}

bool yk_strand_keep(YkTracer *tracer, YkStrand *strand)
{
    YkStrands *list = &tracer->levels[strand->level];
    if (!YK_ROOM(list->items, list->count, list->capacity)) {
        tracer->out_of_memory = true;
        return false;
    }
    strand->index = list->count;
    list->items[list->count++] = strand;
    return true;
}

void yk_strand_free(YkStrand *strand)
{
    if (!strand) return;
    yk_strand_shorten(strand, 0);
    free(strand->cells);
    free(strand);
}

bool yk_strand_add(YkTracer *tracer, YkStrand *strand, YkCell cell, const YkVec *x, const YkVec *rate)
{
    size_t n = strand->level == 0 ? 0 : tracer->pieces[strand->level - 1].shape.unknowns;
    cell.x = malloc((2 * n + 1) * sizeof *cell.x);
    if (!cell.x || !YK_ROOM(strand->cells, strand->count, strand->capacity)) {
        free(cell.x);
        tracer->out_of_memory = true;
        return false;
    }
    cell.rate = cell.x + n;
    if (n > 0) memcpy(cell.x, x, n * sizeof *x);
    if (n > 0) memcpy(cell.rate, rate, n * sizeof *rate);
    strand->cells[strand->count++] = cell;
    return true;
}

void yk_strand_shorten(YkStrand *strand, size_t count)
{
    while (strand->count > count) free(strand->cells[--strand->count].x);
}

void yk_strand_reverse(YkStrand *strand)
{
    for (size_t a = 0, b = strand->count; a + 1 < b; a++, b--) {
        YkCell swapped = strand->cells[a];
        strand->cells[a] = strand->cells[b - 1];
        strand->cells[b - 1] = swapped;
    }
}

// Returns the first cell that ends beyond `at`, or the last.
static size_t find(YkStrand *s, double at)
{
    size_t low = 0, high = s->count - 1;
    if (s->last < s->count && s->cells[s->last].from <= at && at < s->cells[s->last].to) return s->last;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (s->cells[middle].to > at)
            high = middle;
        else
            low = middle + 1;
    }
    return s->last = low;
}

const YkCell *yk_strand_cell(YkStrand *s, double from, double to)
{
    size_t k = find(s, from);
    if (from == to && k > 0 && from < s->cells[k].from) k--;
    return s->cells[k].from <= from && to <= s->cells[k].to ? &s->cells[k] : NULL;
}

double yk_strand_cell_end(YkStrand *s, double at, int direction)
{
    size_t k = find(s, at);
    if (direction > 0) return s->cells[k].to;
    if (at <= s->cells[k].from && k > 0) k--;
    return s->cells[k].from;
}

void yk_note_unproved(YkTracer *tracer, double at, size_t block)
{
    if (tracer->is_unproved) return;
    tracer->is_unproved = true;
    tracer->unproved_at = at;
    tracer->unproved_block = block;
}

bool yk_trace_tie(YkTracer *tracer, size_t level, YkTie tie)
{
    YkTies *list = &tracer->ties[level];
    if (!YK_ROOM(list->items, list->count, list->capacity)) {
        tracer->out_of_memory = true;
        return false;
    }
    list->items[list->count++] = tie;
    return true;
}
