// The tabular method: finds the turns of wheels on one moving carrier while the carrier stands.
#include "design/trains/train.h"

static bool is_on(const YkTrainMesh *mesh, int32_t carrier)
{
    return mesh->kind != YK_TRAIN_KIND_RACK && (int32_t)mesh->carrier == carrier;
}

static int32_t find(const YkTrainGroup *group, size_t body)
{
    for (int32_t k = 0; k < group->count; k++)
        if (group->body[k] == body) return k;
    return -1;
}

static bool is_in_a_group(const YkTrain *train, int32_t carrier, size_t body)
{
    for (size_t g = 0; g < train->group_count; g++)
        if (train->groups[g].carrier == carrier && find(&train->groups[g], body) >= 0) return true;
    return false;
}

// Returns the turn of the wheel on the other side of a mesh.
static YkFraction across(const YkTrain *train, int32_t mesh, int from, const YkFraction *turn, YkOverflow *overflow)
{
    const YkTrainRow *row = yk_train_mesh_row(&train->net, mesh);
    YkFraction by = yk_train_coefficient(&train->net, row, from), on = yk_train_coefficient(&train->net, row, 1 - from);
    YkFraction ratio = yk_fraction_divide(&by, &on, overflow);
    ratio = yk_fraction_negative(&ratio);
    return yk_fraction_multiply(turn, &ratio, overflow);
}

static void add(YkTrainGroup *group, size_t body, YkFraction turn, struct YkTrainStep step)
{
    group->body[group->count] = body;
    group->step[group->count] = step;
    group->turn[group->count++] = turn;
}

// Grows the group from its first wheel over all meshes on its carrier.
static void grow(const YkTrain *train, YkTrainGroup *group, YkOverflow *overflow)
{
    for (bool grows = true; grows;) {
        grows = false;
        for (int32_t m = 0; m < train->net.mesh_count; m++) {
            YkTrainMesh mesh = yk_train_mesh(train, (size_t)m);
            if (!is_on(&mesh, group->carrier)) continue;
            for (int k = 0; k < 2; k++) {
                int32_t from = find(group, mesh.body[k]);
                if (from < 0 || find(group, mesh.body[1 - k]) >= 0) continue;
                add(group, mesh.body[1 - k], across(train, m, k, &group->turn[from], overflow),
                    (struct YkTrainStep){from, m, k});
                grows = true;
            }
        }
    }
}

static YkTrainBody speed_of(const YkTrain *train, size_t body)
{
    if (body == 0) return (YkTrainBody){.is_determined = true, .exact = "0 rpm"}; // a ring of the ground
    return train->bodies[train->net.column_of[body] - 1];
}

static YkFraction share_of(const YkTrain *train, size_t body, int32_t input)
{
    return body == 0 ? yk_fraction(0, 1) : *yk_train_case_share(&train->motion, train->net.column_of[body], input);
}

// Solves for x, the speed of the first wheel against the carrier, and y, the speed of the carrier.
static void solve(YkTrain *train, YkTrainGroup *group)
{
    YkFraction shares[8];
    YkTrainBody first = speed_of(train, group->body[0]), carrier = speed_of(train, (size_t)group->carrier);
    YkOverflow overflow = false;
    if (!first.is_determined || !carrier.is_determined || train->drive_count == 0) return;
    group->has_speeds = true;
    group->y = carrier.speed;
    group->x = first.speed - carrier.speed;
    group->exact_y = carrier.exact;
    if (train->drive_count > 8) return;
    for (int32_t k = 0; k < train->drive_count; k++) {
        YkFraction of_carrier = share_of(train, (size_t)group->carrier, k),
                   of_first = share_of(train, group->body[0], k);
        of_carrier = yk_fraction_negative(&of_carrier);
        shares[k] = yk_fraction_add(&of_first, &of_carrier, &overflow);
    }
    if (!overflow) group->exact_x = yk_train_exact_speed(train, shares, train->drive_count, false);
}

static bool write(YkTrain *train, YkTrainGroup *group)
{
    group->turns = YK_NEW(train->arena, const char *, (size_t)group->count);
    group->turns_value = YK_NEW(train->arena, double, (size_t)group->count);
    for (int32_t k = 0; group->turns && group->turns_value && k < group->count; k++) {
        YkText text = {0};
        yk_fraction_write(&group->turn[k], &text);
        group->turns[k] = yk_train_keep(train->arena, &text);
        group->turns_value[k] = yk_fraction_value(&group->turn[k]);
    }
    return !yk_arena_failed(train->arena);
}

bool yk_train_tables(YkTrain *train)
{
    size_t meshes = (size_t)train->net.mesh_count;
    train->groups = YK_NEW(train->arena, YkTrainGroup, meshes + 1);
    for (size_t m = 0; train->groups && m < meshes; m++) {
        YkTrainMesh mesh = yk_train_mesh(train, m);
        if (mesh.kind == YK_TRAIN_KIND_RACK || mesh.carrier == 0) continue;
        if (is_in_a_group(train, (int32_t)mesh.carrier, mesh.body[0])) continue;
        YkTrainGroup *group = &train->groups[train->group_count];
        *group = (YkTrainGroup){.carrier = (int32_t)mesh.carrier,
                                .body = YK_NEW(train->arena, size_t, 2 * meshes),
                                .turn = YK_NEW(train->arena, YkFraction, 2 * meshes),
                                .step = YK_NEW(train->arena, struct YkTrainStep, 2 * meshes)};
        if (!group->body || !group->turn || !group->step) return false;
        YkOverflow overflow = false;
        add(group, mesh.body[0], yk_fraction(1, 1), (struct YkTrainStep){-1, -1, 0});
        grow(train, group, &overflow);
        if (overflow || !write(train, group)) return !yk_arena_failed(train->arena);
        solve(train, group);
        train->group_count++;
    }
    return train->groups != NULL;
}
