// Finds the four-bars inside a machine and their Grashof class. Source: Grashof 1883; names as in Norton, Design of
// Machinery, ch. 2.
#include <yoke/design.h>
#include "base/vec.h"
#include "compile/mechanism.h"

#define PLACED 0x80000000u
enum { FEW = 64, LOOKS_MAX = 20000000 };

// Grashof: shortest + longest against the other two; the place of the shortest link decides the inversion.
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
    if (fabs(excess) <= 1e-12 * sum) return YK_FOUR_BAR_CHANGE_POINT;
    if (excess > 0) return YK_FOUR_BAR_TRIPLE_ROCKER;
    static const YkFourBarClass inversions[] = {YK_FOUR_BAR_DRAG_LINK, YK_FOUR_BAR_CRANK_ROCKER,
                                                YK_FOUR_BAR_DOUBLE_ROCKER, YK_FOUR_BAR_ROCKER_CRANK};
    return inversions[shortest];
}

const char *yk_four_bar_name(YkFourBarClass kind)
{
    static const char *const names[] = {
        "crank-rocker (Grashof)",  "rocker-crank (Grashof)", "drag link (Grashof double crank)",
        "double rocker (Grashof)", "change-point four-bar",  "triple rocker (non-Grashof)"};
    return names[kind];
}

// The pins of each body, in the file's order; if there are many, those to the same other body stand together.
typedef struct Pins {
    const YkMechanism *mech;
    uint32_t *first;
    int32_t *joint;
    uint32_t *next;    // of each pin: the next one that leads to another body than it and those between
    size_t looks_left; // the search ends at 0
} Pins;

static int32_t beyond(const Pins *pins, int32_t joint, int32_t body)
{
    const YkJoint *j = &pins->mech->model->joints[joint];
    return j->body[0] == body ? j->body[1] : j->body[0];
}

// Sorts the pins of one body by the bodies to which they lead (counting sort, stable; `count` is all 0 before and
// after).
static void sort_pins(Pins *pins, int32_t body, uint32_t *count, int32_t *sorted)
{
    uint32_t from = pins->first[body], to = pins->first[body + 1], place = 0;
    for (uint32_t k = from; k < to; k++) count[beyond(pins, pins->joint[k], body)]++;
    for (uint32_t k = from; k < to; k++) { // bodies in order of first appearance
        uint32_t *own = &count[beyond(pins, pins->joint[k], body)], many = *own;
        if (many & PLACED) continue;
        *own = place | PLACED;
        place += many;
    }
    for (uint32_t k = from; k < to; k++) {
        uint32_t *own = &count[beyond(pins, pins->joint[k], body)];
        sorted[(*own)++ & ~PLACED] = pins->joint[k];
    }
    for (uint32_t k = from; k < to; k++) {
        count[beyond(pins, pins->joint[k], body)] = 0;
        pins->joint[k] = sorted[k - from];
    }
}

static bool put_together(Pins *pins, YkArena *arena)
{
    const YkModel *model = pins->mech->model;
    uint32_t *count = YK_NEW(arena, uint32_t, model->body_count + 1);
    int32_t *sorted = YK_NEW(arena, int32_t, 2 * model->joint_count + 1);
    pins->next = YK_NEW(arena, uint32_t, 2 * model->joint_count + 1);
    if (yk_arena_failed(arena)) return false;
    for (size_t b = 0; b < model->body_count; b++) {
        uint32_t from = pins->first[b], to = pins->first[b + 1];
        if (to - from > FEW) sort_pins(pins, (int32_t)b, count, sorted);
        for (uint32_t k = to; k-- > from;) {
            bool same =
                k + 1 < to && beyond(pins, pins->joint[k], (int32_t)b) == beyond(pins, pins->joint[k + 1], (int32_t)b);
            pins->next[k] = same ? pins->next[k + 1] : k + 1;
        }
    }
    return true;
}

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
    return put_together(pins, arena);
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

static bool look(Pins *pins)
{
    return pins->looks_left > 0 && pins->looks_left-- > 0;
}

// Finds the rings that close over the pins from B to the frame.
static void close_rings(Pins *pins, const int32_t body[4], const int32_t joint[3], Found *found)
{
    int32_t frame = body[0], B = body[3];
    for (uint32_t e = pins->first[B]; e < pins->first[B + 1] && look(pins);) {
        int32_t j3 = pins->joint[e];
        bool is_home = beyond(pins, j3, B) == frame;
        e = is_home ? e + 1 : pins->next[e];
        if (!is_home || j3 <= joint[0] || j3 == joint[2]) continue;
        if (found->count < found->capacity)
            found->items[found->count] = make(pins, body, (int32_t[]){joint[0], joint[1], joint[2], j3});
        found->count++;
    }
}

// Finds all rings through a frame, the first body of its ring, in which the two sides meet the frame at joints
// j0 < j3 (so that each ring is found once).
static void search_from(Pins *pins, int32_t frame, Found *found)
{
    for (uint32_t a = pins->first[frame]; a < pins->first[frame + 1] && look(pins);) {
        int32_t j0 = pins->joint[a], A = beyond(pins, j0, frame);
        a = A <= frame ? pins->next[a] : a + 1;
        for (uint32_t c = pins->first[A]; A > frame && c < pins->first[A + 1] && look(pins);) {
            int32_t j1 = pins->joint[c], C = beyond(pins, j1, A);
            c = C <= frame ? pins->next[c] : c + 1;
            if (C <= frame) continue;
            for (uint32_t b = pins->first[C]; b < pins->first[C + 1] && look(pins);) {
                int32_t j2 = pins->joint[b], B = beyond(pins, j2, C);
                bool is_back = B == A || B <= frame;
                b = is_back ? pins->next[b] : b + 1;
                if (!is_back) close_rings(pins, (int32_t[]){frame, A, C, B}, (int32_t[]){j0, j1, j2}, found);
            }
        }
    }
}

size_t yk_four_bars(const YkMechanism *mech, YkFourBar *four_bars, size_t capacity)
{
    Pins pins = {.mech = mech, .looks_left = LOOKS_MAX};
    Found found = {four_bars, 0, capacity};
    YkArena *arena = yk_arena_new();
    bool ok = arena && gather(&pins, arena);
    if (ok) search_from(&pins, 0, &found);
    for (size_t frame = 1; ok && found.count == 0 && frame < mech->model->body_count; frame++)
        search_from(&pins, (int32_t)frame, &found);
    yk_arena_free(arena);
    return ok ? found.count : YK_NOT_FOUND;
}
