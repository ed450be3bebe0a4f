// Finds which cells of a field belong together.
#include "map/workspace/runs.h"
#include <stdlib.h>
#include "base/memory.h"
#include "base/sets.h"

void yk_runs_end(YkRuns *runs)
{
    free(runs->items);
    free(runs->first);
    *runs = (YkRuns){0};
}

static bool read_row(YkRuns *r, const uint16_t *count)
{
    for (size_t x = 0; x < r->n; x++) {
        if (x > 0 && count[x] == count[x - 1]) continue;
        if (!YK_ROOM(r->items, r->count, r->capacity)) return false;
        r->items[r->count++] = (YkCellRun){.from = (uint32_t)x};
    }
    return true;
}

static size_t end_of(const YkRuns *r, size_t row, size_t run)
{
    return run + 1 < r->first[row + 1] ? r->items[run + 1].from : r->n;
}

// Joins the runs of a row with those of the row before that have the same number.
static void join_rows(const YkRuns *r, const YkField *field, size_t row, int32_t *parent)
{
    const uint16_t *below = field->count + (row - 1) * r->n, *own = field->count + row * r->n;
    size_t a = r->first[row - 1], b = r->first[row];
    while (a < r->first[row] && b < r->first[row + 1]) {
        if (below[r->items[a].from] == own[r->items[b].from]) yk_sets_join(parent, (int32_t)a, (int32_t)b);
        size_t a_end = end_of(r, row - 1, a), b_end = end_of(r, row, b);
        if (a_end <= b_end) a++;
        if (b_end <= a_end) b++;
    }
}

static void number(YkRuns *r, const YkField *field, int32_t *parent)
{
    for (size_t row = 0; row < r->n; row++)
        for (size_t k = r->first[row]; k < r->first[row + 1]; k++) {
            size_t root = (size_t)yk_root_of(parent, (int32_t)k);
            if (field->count[row * r->n + r->items[k].from] == 0) continue;
            r->items[k].part = root == k ? (uint32_t)++r->part_count : r->items[root].part;
        }
}

bool yk_runs_find(YkRuns *r, const YkField *field)
{
    *r = (YkRuns){.n = field->n, .first = calloc(field->n + 1, sizeof *r->first)};
    bool good = r->first != NULL;
    for (size_t row = 0; good && row < r->n; row++) {
        good = read_row(r, field->count + row * r->n);
        r->first[row + 1] = r->count;
    }
    int32_t *parent = good ? malloc((r->count + 1) * sizeof *parent) : NULL;
    if (!parent) return false;
    yk_sets_begin(parent, r->count);
    for (size_t row = 1; row < r->n; row++) join_rows(r, field, row, parent);
    number(r, field, parent);
    free(parent);
    return true;
}

uint32_t yk_runs_part(const YkRuns *r, size_t x, size_t y)
{
    size_t low = r->first[y], high = r->first[y + 1];
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        *(r->items[middle].from <= x ? &low : &high) = middle;
    }
    return r->items[low].part;
}
