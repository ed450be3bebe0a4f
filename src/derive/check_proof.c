// Is an equation true on the machine's own motion, for all dimensions? Asked at random points over the prime field.
#include "derive/blocks.h"
#include "derive/check_inside.h"
#include "derive/equation.h"
#include "derive/free_bodies.h"

enum { POSES_ASKED = 4 };

// Points of another assembly say nothing of this machine.
static bool is_of_machine(YkCheck *check, int rank)
{
    bool is = false;
    for (size_t k = 0; k < check->kept_count && k < POSES_ASKED && !is; k++)
        is = yk_loop_is_assembly(check->d, check->bonds, rank, check->kept[k]);
    return is;
}

static void try_point(YkCheck *check, bool has_roots, size_t most)
{
    bool is_possible;
    int rank;
    YkFieldPoint *point =
        yk_derive_assembly_point(check->d, check->bonds, ++check->points_tried * 7919, &rank, &is_possible);
    if (point && check->ground == YK_GROUND_UNTRIED)
        check->ground = is_of_machine(check, rank) ? YK_GROUND_FIRM : YK_GROUND_NONE;
    if (point) check->points[check->point_count++] = point;
    if (!point && !has_roots) check->points_tried = most;
    if (check->ground == YK_GROUND_NONE) yk_check_free_points(check);
}

// Angles and roots of the equation's own, omega t, are free at the points.
static bool has_own(const YkDerivation *d, const YkForm *form)
{
    const YkPoisson *a = yk_form_element(form);
    for (size_t k = 0; !a && k < yk_form_part_count(form); k++)
        if (has_own(d, yk_form_part(form, k))) return true;
    return a && yk_equation_has_own(d, a);
}

// Gears bind angles at the points of the field, but not their unit vectors; and that numbers of teeth must fit, so that
// centres meet, is not known there: a planetary set with Zr = Zs + 2 Zp obeys equations that others do not.
static bool can_refute(YkCheck *check, const YkForm *form)
{
    return check->d->tie_count == 0 && !has_own(check->d, form);
}

// The next point of the machine's motion; NULL where no more can be had. New symbols: the old points are of no use.
static YkFieldPoint *next_point(YkCheck *check, size_t index)
{
    const YkDeriveForces *forces = yk_derive_forces(check->d);
    bool has_roots = forces && forces->length_count > 0; // then only some seeds lead to a point
    size_t most = has_roots ? YK_CHECK_POINTS_TRIED : YK_CHECK_POINTS_TRIED / 10;
    if (check->points_symbols != yk_ring_symbol_count(check->d->ring)) yk_check_free_points(check);
    while (check->ground != YK_GROUND_NONE && check->point_count <= index && check->points_tried < most)
        try_point(check, has_roots, most);
    if (check->points_tried == most && check->point_count == 0) check->ground = YK_GROUND_NONE;
    check->points_symbols = yk_ring_symbol_count(check->d->ring);
    return index < check->point_count ? check->points[index] : NULL;
}

void yk_check_free_points(YkCheck *check)
{
    for (size_t k = 0; k < check->point_count; k++) yk_field_point_free(check->points[k]);
    check->point_count = check->points_tried = 0;
}

void yk_check_bind(YkCheck *check, const YkLoopBonds *bonds)
{
    yk_check_free_points(check);
    check->bonds = bonds;
    check->ground = YK_GROUND_UNTRIED;
}

static int points_wanted(YkCheck *check)
{
    const YkDeriveForces *forces = yk_derive_forces(check->d);
    return forces && forces->length_count > 0 ? YK_CHECK_POINTS_OF_ROOTS : YK_CHECK_POINTS;
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
