// Assembles sparse systems entry by entry.
#include <stdlib.h>
#include "free_bodies/inside.h"

bool yk_body_system_start(YkBodySystem *s, size_t n, size_t most)
{
    *s = (YkBodySystem){.n = n, .capacity = most};
    s->row = malloc((most + 1) * sizeof *s->row);
    s->column = malloc((most + 1) * sizeof *s->column);
    if (s->row && s->column) return true;
    yk_body_system_end(s);
    return false;
}

// Sorts the emitted entries by columns; s->column gets the place of each.
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

// The effect of a mesh on its bodies: a force and a moment over the size. A body with two roles, as when a slide
// follows its neighbour, appears once.
typedef struct Share {
    int32_t body;
    YkVec force;
    double moment;
} Share;

static size_t shares_of(const YkWrenchColumn *c, Share shares[4])
{
    const Share all[] = {{c->body[0], yk_scale(-1, c->force), c->moment[0]},
                         {c->body[1], c->force, c->moment[1]},
                         {c->third, c->other, c->third_moment},
                         {c->fourth, yk_scale(-1, c->other), c->fourth_moment}};
    size_t count = 0;
    for (size_t k = 0; k < 4; k++) {
        size_t at = 0;
        if (all[k].body == 0) continue;
        while (at < count && shares[at].body != all[k].body) at++;
        if (at == count) shares[count++] = (Share){.body = all[k].body};
        shares[at].force = yk_add(shares[at].force, all[k].force);
        shares[at].moment += all[k].moment;
    }
    return count;
}

static void emit_mesh(const YkFreeBodies *f, YkBodySystem *s, const YkWrenchColumn *c, size_t column, double sign,
                      bool transposed)
{
    Share shares[4];
    size_t count = shares_of(c, shares);
    for (size_t k = 0; k < count; k++) {
        size_t row = (size_t)f->body_row[shares[k].body];
        emit(s, row, column, sign * shares[k].force.x, transposed);
        emit(s, row + 1, column, sign * shares[k].force.y, transposed);
        emit(s, row + 2, column, sign * shares[k].moment, transposed);
    }
}

void yk_body_system_wrench(const YkFreeBodies *f, YkBodySystem *s, const YkWrenchColumn *c, size_t column, double sign,
                           bool transposed)
{
    if (c->kind == YK_WRENCH_MESH) {
        emit_mesh(f, s, c, column, sign, transposed);
        return;
    }
    for (int k = 0; k < 2; k++) {
        if (c->body[k] == 0) continue;
        size_t row = (size_t)f->body_row[c->body[k]];
        double along = k ? sign : -sign;
        bool is_couple = c->kind == YK_WRENCH_COUPLE;
        if (!is_couple && c->kind != YK_WRENCH_Y) emit(s, row, column, along * c->force.x, transposed);
        if (!is_couple && c->kind != YK_WRENCH_X) emit(s, row + 1, column, along * c->force.y, transposed);
        emit(s, row + 2, column, sign * c->moment[k], transposed);
    }
}
