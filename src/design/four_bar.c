// Four-bars inside a machine and their Grashof class. Source: Grashof 1883; names as in Norton, Design of Machinery,
// ch. 2.
#include <yoke/design.h>
#include "base/vec.h"
#include "compile/mechanism.h"

// Grashof: shortest + longest against the other two; which link is the shortest decides the inversion.
static YkFourBarClass classify(const double length[4])
{
    size_t shortest = 0, longest = 0;
    double sum = 0;
    for (size_t k = 0; k < 4; k++) {
        sum += length[k];
        if (length[k] < length[shortest]) shortest = k;
        if (length[k] > length[longest]) longest = k;
    }
    double excess = 2 * (length[shortest] + length[longest]) - sum; // of s + l over p + q
    if (fabs(excess) <= 1e-12 * sum) return YK_CHANGE_POINT_FOUR_BAR;
    if (excess > 0) return YK_TRIPLE_ROCKER;
    static const YkFourBarClass inversions[] = {YK_DRAG_LINK, YK_CRANK_ROCKER, YK_DOUBLE_ROCKER_GRASHOF,
                                                YK_ROCKER_CRANK};
    return inversions[shortest];
}

const char *yk_four_bar_name(YkFourBarClass kind)
{
    static const char *const names[] = {
        "crank-rocker (Grashof)",  "rocker-crank (Grashof)", "drag link (Grashof double crank)",
        "double rocker (Grashof)", "change-point four-bar",  "triple rocker (non-Grashof)"};
    return names[kind];
}

// The pins of each body.
typedef struct Pins {
    const YkMechanism *mech;
    uint32_t *first;
    int32_t *joint;
} Pins;

static bool gather(Pins *pins, YkArena *arena)
{
    const YkModel *model = pins->mech->model;
    pins->first = YK_NEW(arena, uint32_t, model->body_count + 2);
    pins->joint = YK_NEW(arena, int32_t, 2 * model->joint_count + 1);
    if (yk_arena_failed(arena)) return false;
    for (size_t j = 0; j < model->joint_count; j++)
        for (int end = 0; end < 2 && model->joints[j].kind == YK_PIN; end++)
            pins->first[model->joints[j].body[end] + 2]++;
    for (size_t b = 0; b < model->body_count; b++) pins->first[b + 2] += pins->first[b + 1];
    for (size_t j = 0; j < model->joint_count; j++)
        for (int end = 0; end < 2 && model->joints[j].kind == YK_PIN; end++)
            pins->joint[pins->first[model->joints[j].body[end] + 1]++] = (int32_t)j;
    return true;
}

static int32_t beyond(const Pins *pins, int32_t joint, int32_t body)
{
    const YkJoint *j = &pins->mech->model->joints[joint];
    return j->body[0] == body ? j->body[1] : j->body[0];
}

static YkVec place_on(const Pins *pins, int32_t joint, int32_t body)
{
    const YkJoint *j = &pins->mech->model->joints[joint];
    return j->at[j->body[0] == body ? 0 : 1];
}

static bool is_input(const Pins *pins, int32_t joint)
{
    int32_t c = yk_tree_coordinate(pins->mech, joint, false);
    return c != YK_NONE && pins->mech->coordinates[c].input != YK_NONE;
}

// Ring: frame - a - coupler - b - frame, over joints j[0..3]; the driven side becomes body[1].
static YkFourBar make(const Pins *pins, const int32_t body[4], const int32_t joint[4])
{
    YkFourBar f;
    bool turned = is_input(pins, joint[3]) && !is_input(pins, joint[0]);
    for (size_t k = 0; k < 4; k++) {
        f.body[k] = (size_t)body[turned ? (4 - k) % 4 : k];
        f.joint[k] = (size_t)joint[turned ? 3 - k : k];
    }
    for (size_t k = 0; k < 4; k++) {
        int32_t b = (int32_t)f.body[k];
        f.length[k] =
            yk_norm(yk_sub(place_on(pins, (int32_t)f.joint[k], b), place_on(pins, (int32_t)f.joint[(k + 3) % 4], b)));
    }
    f.kind = classify(f.length);
    return f;
}

typedef struct Found {
    YkFourBar *items;
    size_t count, capacity;
} Found;

// All rings through a frame, the first body of its ring, in which the two sides meet the frame at joints j0 < j3 (each
// ring once).
static void search_from(const Pins *pins, int32_t frame, Found *found)
{
    for (uint32_t a = pins->first[frame]; a < pins->first[frame + 1]; a++) {
        int32_t j0 = pins->joint[a], A = beyond(pins, j0, frame);
        for (uint32_t c = pins->first[A]; c < pins->first[A + 1]; c++) {
            int32_t j1 = pins->joint[c], C = beyond(pins, j1, A);
            if (j1 == j0 || A <= frame || C <= frame) continue;
            for (uint32_t b = pins->first[C]; b < pins->first[C + 1]; b++) {
                int32_t j2 = pins->joint[b], B = beyond(pins, j2, C);
                if (j2 == j1 || B == A || B <= frame) continue;
                for (uint32_t e = pins->first[B]; e < pins->first[B + 1]; e++) {
                    int32_t j3 = pins->joint[e];
                    if (j3 <= j0 || j3 == j2 || beyond(pins, j3, B) != frame) continue;
                    if (found->count < found->capacity)
                        found->items[found->count] =
                            make(pins, (int32_t[]){frame, A, C, B}, (int32_t[]){j0, j1, j2, j3});
                    found->count++;
                }
            }
        }
    }
}

size_t yk_four_bars(const YkMechanism *mech, YkFourBar *four_bars, size_t capacity)
{
    Pins pins = {.mech = mech};
    Found found = {four_bars, 0, capacity};
    YkArena *arena = yk_arena_new();
    bool ok = arena && gather(&pins, arena);
    if (ok) search_from(&pins, 0, &found);
    for (size_t frame = 1; ok && found.count == 0 && frame < mech->model->body_count; frame++)
        search_from(&pins, (int32_t)frame, &found);
    yk_arena_free(arena);
    return found.count;
}
