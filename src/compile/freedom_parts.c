// Divides a machine into parts which share only the ground, by what ties variables together.
#include "compile/freedom_parts.h"
#include "base/sets.h"
#include "compile/closure.h"

static void join_terms(const YkMechanism *mech, const YkSum *sum, int32_t *up)
{
    int32_t o = (int32_t)mech->orientation_count - 1, last = YK_NONE;
    for (uint32_t k = 0; k < sum->count; k++) {
        YkTerm t = mech->terms[sum->first + k];
        int32_t both[2] = {t.slot - 1, t.distance == YK_NONE ? YK_NONE : o + t.distance};
        for (int i = 0; i < 2; i++) {
            if (both[i] < 0) continue;
            if (last != YK_NONE) up[yk_root_of(up, last)] = yk_root_of(up, both[i]);
            last = both[i];
        }
    }
}

static int32_t term_variable(const YkMechanism *mech, YkRelationTerm term)
{
    return (term.is_distance ? (int32_t)mech->orientation_count : 0) + term.index - 1;
}

static void join_relation(const YkMechanism *mech, const YkRelation *r, int32_t *up)
{
    const YkRelationTerm *terms = mech->relation_terms + r->first_term; // the terms of its argument follow
    for (uint32_t k = 1; k < r->term_count + r->argument_count; k++)
        up[yk_root_of(up, term_variable(mech, terms[k]))] = yk_root_of(up, term_variable(mech, terms[0]));
}

// Returns a variable of a relation, or YK_NONE if it ties nothing that moves.
static int32_t relation_variable(const YkMechanism *mech, const YkRelation *r)
{
    bool has_any = r->term_count + r->argument_count > 0;
    return has_any ? term_variable(mech, mech->relation_terms[r->first_term]) : YK_NONE;
}

static int32_t loop_variable(const YkMechanism *mech, size_t loop)
{
    const YkSum *sum = &mech->loops[loop].sum;
    if (sum->count == 0) return YK_NONE;
    YkTerm t = mech->terms[sum->first];
    return t.slot > 0 ? t.slot - 1 : (int32_t)mech->orientation_count - 1 + t.distance;
}

int32_t yk_coordinate_variable(const YkMechanism *mech, int32_t coordinate)
{
    const YkTreeCoordinate *c = &mech->coordinates[coordinate];
    if (c->is_distance) return (int32_t)mech->orientation_count - 1 + c->distance;
    YkJointAngle angle = yk_joint_angle(mech, c->joint);
    return angle.a == angle.b ? YK_NONE : (angle.a > 0 ? angle.a : angle.b) - 1;
}

// Sorts items by part: items[i] belongs to part key[i] (or to none); keeps the order within a part.
static void sort_by_part(const int32_t *key, size_t count, size_t parts, uint32_t *first, int32_t *items)
{
    for (size_t i = 0; i < count; i++)
        if (key[i] >= 0) first[key[i] + 2]++;
    for (size_t p = 0; p < parts; p++) first[p + 2] += first[p + 1];
    for (size_t i = 0; i < count; i++)
        if (key[i] >= 0) items[first[key[i] + 1]++] = (int32_t)i;
}

static int32_t part_of(const YkFreedomParts *p, int32_t variable)
{
    return variable == YK_NONE ? YK_NONE : p->of_variable[variable];
}

// Finds the parts: loops and relations tie their variables together, and an angle of the tree ties its two
// orientations.
static void find_parts(YkFreedomParts *p, const YkMechanism *mech, int32_t *up)
{
    size_t n = yk_variable_count(mech);
    for (size_t v = 0; v < n; v++) up[v] = (int32_t)v;
    for (size_t l = 0; l < mech->loop_count; l++) join_terms(mech, &mech->loops[l].sum, up);
    for (size_t r = 0; r < mech->relation_count; r++) join_relation(mech, &mech->relations[r], up);
    for (size_t k = 0; k < mech->coordinate_count; k++) {
        YkJointAngle angle = yk_joint_angle(mech, mech->coordinates[k].joint);
        if (angle.a > 0 && angle.b > 0) up[yk_root_of(up, angle.a - 1)] = yk_root_of(up, angle.b - 1);
    }
    for (size_t v = 0; v < n; v++)
        if (yk_root_of(up, (int32_t)v) == (int32_t)v) p->of_variable[v] = (int32_t)p->count++;
    for (size_t v = 0; v < n; v++) p->of_variable[v] = p->of_variable[yk_root_of(up, (int32_t)v)];
}

bool yk_freedom_parts_sort(YkFreedomParts *p, const YkMechanism *mech, const int32_t *candidates, size_t count,
                           YkArena *arena)
{
    size_t n = yk_variable_count(mech), most = n + mech->loop_count + mech->relation_count + count + 1;
    int32_t *key = YK_NEW(arena, int32_t, most);
    p->of_variable = YK_NEW(arena, int32_t, n + 1);
    p->column = YK_NEW(arena, int32_t, n + 1);
    p->variables = YK_NEW(arena, int32_t, n + 1);
    p->loops = YK_NEW(arena, int32_t, mech->loop_count + 1);
    p->relations = YK_NEW(arena, int32_t, mech->relation_count + 1);
    p->candidates = YK_NEW(arena, int32_t, count + 1);
    if (yk_arena_failed(arena)) return false;
    find_parts(p, mech, key);
    p->variable_first = YK_NEW(arena, uint32_t, p->count + 2);
    p->loop_first = YK_NEW(arena, uint32_t, p->count + 2);
    p->relation_first = YK_NEW(arena, uint32_t, p->count + 2);
    p->candidate_first = YK_NEW(arena, uint32_t, p->count + 2);
    if (yk_arena_failed(arena)) return false;
    sort_by_part(p->of_variable, n, p->count, p->variable_first, p->variables);
    for (size_t v = 0; v < n; v++)
        p->column[p->variables[v]] = (int32_t)v - (int32_t)p->variable_first[p->of_variable[p->variables[v]]];
    for (size_t l = 0; l < mech->loop_count; l++) key[l] = part_of(p, loop_variable(mech, l));
    sort_by_part(key, mech->loop_count, p->count, p->loop_first, p->loops);
    for (size_t r = 0; r < mech->relation_count; r++) key[r] = part_of(p, relation_variable(mech, &mech->relations[r]));
    sort_by_part(key, mech->relation_count, p->count, p->relation_first, p->relations);
    for (size_t k = 0; k < count; k++) key[k] = part_of(p, yk_coordinate_variable(mech, candidates[k]));
    sort_by_part(key, count, p->count, p->candidate_first, p->candidates);
    return true;
}
