// Finds parts: bodies that joints connect other than through the ground.
#include "base/sets.h"
#include "free_bodies/inside.h"

// Numbers the parts in the order of their first bodies; the ground is in none.
static void find_parts(YkFreeBodies *f, int32_t *above)
{
    const YkModel *model = f->mech->model;
    for (size_t b = 0; b < model->body_count; b++) {
        above[b] = (int32_t)b;
        f->part_of[b] = YK_NONE;
    }
    for (size_t j = 0; j < model->joint_count; j++) {
        const int32_t *body = model->joints[j].body;
        if (body[0] == 0 || body[1] == 0) continue;
        above[yk_root_of(above, body[0])] = yk_root_of(above, body[1]);
    }
    for (size_t k = 0; k < f->column_count; k++) {
        const YkWrenchColumn *c = &f->columns[k];
        const int32_t bodies[] = {c->body[0], c->body[1], c->third, c->fourth};
        int32_t first = 0;
        for (int i = 0; i < 4 && c->kind == YK_WRENCH_MESH; i++) {
            if (bodies[i] != 0 && first != 0) above[yk_root_of(above, first)] = yk_root_of(above, bodies[i]);
            if (bodies[i] != 0) first = bodies[i];
        }
    }
    for (size_t b = 1; b < model->body_count; b++) {
        int32_t root = yk_root_of(above, (int32_t)b);
        if (f->part_of[root] == YK_NONE) f->part_of[root] = (int32_t)f->part_count++;
        f->part_of[b] = f->part_of[root];
    }
}

static int32_t part_of_column(const YkFreeBodies *f, size_t k)
{
    const YkWrenchColumn *c = &f->columns[k];
    return f->part_of[c->body[0] != 0 ? c->body[0] : c->body[1] != 0 ? c->body[1] : c->third];
}

static void measure_mass(const YkFreeBodies *f, YkBodyPart *part)
{
    for (size_t k = 0; k < part->body_count; k++) {
        const YkBody *b = &f->mech->model->bodies[part->bodies[k]];
        if (b->has_mass) part->mass = fmax(part->mass, fmax(b->mass, b->inertia / (f->size * f->size)));
    }
    if (!(part->mass > 0)) part->mass = 1;
}

static void fill_parts(YkFreeBodies *f)
{
    size_t body_at = 0, column_at = 0;
    for (size_t b = 1; b < f->mech->model->body_count; b++) f->parts[f->part_of[b]].body_count++;
    for (size_t k = 0; k < f->column_count; k++) f->parts[part_of_column(f, k)].column_count++;
    for (size_t p = 0; p < f->part_count; p++) {
        YkBodyPart *part = &f->parts[p];
        part->bodies = f->part_bodies + body_at;
        part->columns = f->part_columns + column_at;
        part->is_redundant = part->column_count > 3 * part->body_count;
        body_at += part->body_count;
        column_at += part->column_count;
        part->body_count = part->column_count = 0;
    }
    for (size_t b = 1; b < f->mech->model->body_count; b++) {
        YkBodyPart *part = &f->parts[f->part_of[b]];
        f->body_row[b] = (int32_t)(3 * part->body_count);
        f->part_bodies[(size_t)(part->bodies - f->part_bodies) + part->body_count++] = (int32_t)b;
    }
    for (size_t k = 0; k < f->column_count; k++) {
        YkBodyPart *part = &f->parts[part_of_column(f, k)];
        f->part_columns[(size_t)(part->columns - f->part_columns) + part->column_count++] = (int32_t)k;
    }
}

bool yk_parts_build(YkFreeBodies *f)
{
    size_t n = f->mech->model->body_count;
    int32_t *above = YK_NEW(f->arena, int32_t, n);
    f->part_of = YK_NEW(f->arena, int32_t, n);
    f->body_row = YK_NEW(f->arena, int32_t, n);
    f->part_bodies = YK_NEW(f->arena, int32_t, n);
    f->part_columns = YK_NEW(f->arena, int32_t, f->column_count + 1);
    if (yk_arena_failed(f->arena)) return false;
    find_parts(f, above);
    f->parts = YK_NEW(f->arena, YkBodyPart, f->part_count + 1);
    if (yk_arena_failed(f->arena)) return false;
    fill_parts(f);
    for (size_t p = 0; p < f->part_count; p++) measure_mass(f, &f->parts[p]);
    return true;
}

void yk_parts_end(YkFreeBodies *f)
{
    for (size_t p = 0; f->parts && p < f->part_count; p++) {
        yk_body_system_end(&f->parts[p].balance);
        yk_body_system_end(&f->parts[p].motion);
        yk_body_system_end(&f->parts[p].soft);
    }
}

void yk_part_clear(YkFreeBodies *f, const YkBodyPart *part)
{
    for (size_t k = 0; k < part->column_count; k++) {
        f->columns[part->columns[k]].share = 0;
        f->columns[part->columns[k]].freeness = 1;
    }
}
