// Sparse systems put together entry by entry.
#include <stdlib.h>
#include <string.h>
#include "dynamics/free_bodies_inside.h"

bool yk_body_system_start(YkBodySystem *s, size_t n, size_t most)
{
    *s = (YkBodySystem){.n = n, .capacity = most};
    s->row = malloc((most + 1) * sizeof *s->row);
    s->column = malloc((most + 1) * sizeof *s->column);
    if (s->row && s->column) return true;
    yk_body_system_end(s);
    return false;
}

// Sorts what was emitted by columns, in place of s->column: where each entry goes.
static void sort(YkBodySystem *s, int32_t *start, int32_t *row)
{
    for (size_t k = 0; k < s->count; k++) start[s->column[k] + 1]++;
    for (size_t j = 0; j < s->n; j++) start[j + 1] += start[j];
    for (size_t k = 0; k < s->count; k++) {
        int32_t place = start[s->column[k]]++;
        row[place] = s->row[k];
        s->place[k] = place;
    }
    for (size_t j = s->n; j > 0; j--) start[j] = start[j - 1];
    start[0] = 0;
}

bool yk_body_system_finish(YkBodySystem *s)
{
    int32_t *start = calloc(s->n + 2, sizeof *start), *row = malloc((s->count + 1) * sizeof *row);
    s->place = malloc((s->count + 1) * sizeof *s->place);
    s->value = calloc(s->count + 1, sizeof *s->value);
    if (start && row && s->place && s->value) {
        sort(s, start, row);
        s->sparse = yk_sparse_new(s->n, start, row);
    }
    free(start);
    free(row);
    free(s->row);
    free(s->column);
    s->row = s->column = NULL;
    if (s->sparse) return true;
    yk_body_system_end(s);
    return false;
}

void yk_body_system_end(YkBodySystem *s)
{
    yk_sparse_free(s->sparse);
    free(s->row);
    free(s->column);
    free(s->place);
    free(s->value);
    *s = (YkBodySystem){0};
}

void yk_body_system_begin(YkBodySystem *s)
{
    s->count = 0;
}

static void emit(YkBodySystem *s, size_t row, size_t column, double value, bool transposed)
{
    yk_body_system_emit(s, transposed ? column : row, transposed ? row : column, value);
}

void yk_body_system_wrench(const YkFreeBodies *f, YkBodySystem *s, const YkWrenchColumn *c, size_t column, double sign,
                           bool transposed)
{
    for (int k = 0; k < 2; k++) {
        if (c->body[k] == 0) continue;
        size_t row = (size_t)f->body_row[c->body[k]];
        double along = k ? sign : -sign;
        bool is_couple = c->kind == YK_WRENCH_COUPLE;
        if (!is_couple && c->kind != YK_WRENCH_Y) emit(s, row, column, along * c->force.x, transposed);
        if (!is_couple && c->kind != YK_WRENCH_X) emit(s, row + 1, column, along * c->force.y, transposed);
        emit(s, row + 2, column, sign * c->moment[k], transposed);
    }
    if (c->fourth != 0) emit(s, (size_t)f->body_row[c->fourth] + 2, column, sign * c->fourth_moment, transposed);
    if (c->third != 0) emit(s, (size_t)f->body_row[c->third] + 2, column, sign * c->third_moment, transposed);
}
