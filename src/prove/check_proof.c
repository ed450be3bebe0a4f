// Proves an equation on the machine's own motion for all dimensions, at random points over the prime field.
#include <string.h>
#include "derive/blocks.h"
#include "derive/forces/free_bodies.h"
#include "prove/check_inside.h"
#include "prove/equation.h"

enum { POSES_ASKED = 4, OPEN_MAX = 8 };

// Points of another assembly prove nothing about this machine.
static bool is_of_machine(YkCheck *check, int rank)
{
    const YkCheckPose *pose;
    bool is = false;
    for (size_t k = 0; k < POSES_ASKED && !is && (pose = yk_check_pose(check, &check->shared->poses, k, POSES_ASKED));
         k++)
        is = yk_loop_is_assembly(check->d, check->points->bonds, rank, pose->values);
    return is;
}

static void forget_points(YkCheckPoints *points)
{
    for (size_t k = 0; k < points->count; k++) yk_field_point_free(points->point[k]);
    points->count = points->tried = points->open = 0;
}

void yk_check_free_points(YkCheckPoints *points)
{
    forget_points(points);
    *points = (YkCheckPoints){0};
}

// With roots only some seeds lead to a point, and other symbols may; loops that do not close at several points never
// will.
static void try_point(YkCheck *check, bool has_roots, size_t most)
{
    YkCheckPoints *points = check->points;
    bool is_possible;
    int rank;
    YkFieldPoint *point =
        yk_derive_assembly_point(check->d, points->bonds, ++points->tried * 7919, &rank, &is_possible);
    points->open += !point && rank < 0;
    if (point && points->ground == YK_GROUND_UNTRIED)
        points->ground = is_of_machine(check, rank) ? YK_GROUND_FIRM : YK_GROUND_NONE;
    if (point) points->point[points->count++] = point;
    if (!point && !has_roots) points->tried = most;
    bool is_hopeless = points->open == OPEN_MAX || !has_roots;
    if (points->count == 0 && (is_hopeless || points->tried == most)) {
        points->ground = YK_GROUND_NONE;
        points->is_exhausted = !is_hopeless;
    }
    if (points->ground == YK_GROUND_NONE) forget_points(points);
}

// The equation's own angles and roots, omega t, are free at the points.
static bool has_own(const YkDerivation *d, const YkForm *form)
{
    const YkPoisson *a = yk_form_element(form);
    for (size_t k = 0; !a && k < yk_form_part_count(form); k++)
        if (has_own(d, yk_form_part(form, k))) return true;
    return a && yk_equation_has_own(d, a);
}

// Gears bind angles at the points of the field, but not their unit vectors; and the field does not know that numbers
// of teeth must fit so that centres meet: a planetary set with Zr = Zs + 2 Zp obeys equations that others do not.
static bool can_refute(YkCheck *check, const YkForm *form)
{
    return check->d->tie_count == 0 && !has_own(check->d, form);
}

// With roots only some seeds lead to a point.
static bool has_roots(const YkCheck *check)
{
    const YkDeriveForces *forces = yk_derive_forces(check->d);
    return forces && forces->length_count > 0;
}

static void begin_again(YkCheckPoints *points)
{
    forget_points(points);
    if (points->is_exhausted) points->ground = YK_GROUND_UNTRIED;
    points->is_exhausted = false;
}

// Returns the next point of the machine's motion; NULL after the last one. New symbols make the old points useless.
static YkFieldPoint *next_point(YkCheck *check, size_t index)
{
    YkCheckPoints *points = check->points;
    if (yk_loop_is_large(check->d)) points->ground = YK_GROUND_NONE;
    bool rooted = has_roots(check);
    size_t most = rooted ? YK_CHECK_POINTS_TRIED : YK_CHECK_POINTS_TRIED / 10;
    if (points->symbols != yk_ring_symbol_count(check->d->ring)) begin_again(points);
    while (points->ground != YK_GROUND_NONE && points->count <= index && points->tried < most)
        try_point(check, rooted, most);
    points->symbols = yk_ring_symbol_count(check->d->ring);
    return index < points->count ? points->point[index] : NULL;
}

static bool is_same_bond(const YkLoopBond *a, const YkLoopBond *b, size_t coordinates)
{
    return a->pivot == b->pivot && a->turns == b->turns &&
           memcmp(a->factor, b->factor, coordinates * sizeof *a->factor) == 0;
}

static bool are_same_bonds(const YkLoopBonds *a, const YkLoopBonds *b, size_t coordinates)
{
    bool are = a && b && a->count == b->count;
    for (size_t k = 0; are && k < a->count; k++) are = is_same_bond(&a->bond[k], &b->bond[k], coordinates);
    return are;
}

void yk_check_bind(YkCheck *check, const YkLoopBonds *bonds)
{
    check->points = &check->shared->bound;
    if (are_same_bonds(check->points->bonds, bonds, check->d->tree_count)) return;
    yk_check_free_points(check->points);
    check->points->bonds = bonds;
}

static int points_wanted(YkCheck *check)
{
    return has_roots(check) ? YK_CHECK_POINTS_OF_ROOTS : YK_CHECK_POINTS;
}

YkProof yk_check_prove(YkCheck *check, const YkForm *zero)
{
    int points = 0, wanted = points_wanted(check);
    YkFieldPoint *point;
    for (size_t k = 0; points < wanted && (point = next_point(check, k)) != NULL; k++) {
        uint64_t value;
        if (!yk_form_field(check->d->ring, zero, point, &value)) continue; // a division by zero
        if (value != 0 && !yk_field_point_is_loose(point) && can_refute(check, zero)) return YK_REFUTED;
        if (value != 0) return YK_NO_PROOF;
        points++;
    }
    return points == wanted ? YK_PROVED : YK_NO_PROOF;
}
