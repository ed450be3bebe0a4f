// Is an equation true on the machine's own motion, for all dimensions? Asked at random points over the prime field.
#include "derive/blocks.h"
#include "derive/check_inside.h"
#include "derive/free_bodies.h"
#include "derive/relations.h"

// Has it an e^(i angle) in it?
static bool has_turns(YkRing *ring, const YkForm *form)
{
    const YkPoisson *a = yk_form_element(form), *one = yk_ring_rational(ring, 1, 1);
    for (size_t k = 0; !a && k < yk_form_part_count(form); k++)
        if (has_turns(ring, yk_form_part(form, k))) return true;
    for (size_t s = 0; a && s < yk_ring_symbol_count(ring); s++) {
        if (!yk_ring_is_angle(ring, (int32_t)s) || !yk_ring_mentions(ring, a, (int32_t)s)) continue;
        const YkRingChange change = {(int32_t)s, NULL, one};
        if (!yk_ring_is_same(a, yk_ring_substitute(ring, a, &change, 1))) return true;
    }
    return false;
}

// Gears bind angles at the points of the field, but not their unit vectors: what speaks of rates alone is refuted
// there.
static bool can_refute(YkCheck *check, const YkForm *form)
{
    const YkDerivation *d = check->d;
    return d->tie_count == 0 || (d->loop_count == 0 && !has_turns(d->ring, form));
}

// The next point of the machine's motion; NULL where no more can be had. New symbols: the old points are of no use.
static YkFieldPoint *next_point(YkCheck *check, size_t index)
{
    const YkDeriveForces *forces = yk_derive_forces(check->d);
    bool has_roots = forces && forces->length_count > 0; // then only some seeds lead to a point
    size_t most = has_roots ? YK_CHECK_POINTS_TRIED : YK_CHECK_POINTS_TRIED / 10;
    if (check->points_symbols != yk_ring_symbol_count(check->d->ring)) yk_check_free_points(check);
    while (check->point_count <= index && check->points_tried < most) {
        bool is_possible;
        YkFieldPoint *point = yk_derive_loop_point(check->d, ++check->points_tried * 7919, &is_possible);
        if (point) check->points[check->point_count++] = point;
        if (!point && !has_roots) check->points_tried = most;
    }
    check->points_symbols = yk_ring_symbol_count(check->d->ring);
    return index < check->point_count ? check->points[index] : NULL;
}

void yk_check_free_points(YkCheck *check)
{
    for (size_t k = 0; k < check->point_count; k++) yk_field_point_free(check->points[k]);
    check->point_count = check->points_tried = 0;
}

YkProof yk_check_prove(YkCheck *check, const YkForm *zero)
{
    int points = 0;
    YkFieldPoint *point;
    for (size_t k = 0; points < YK_CHECK_POINTS && (point = next_point(check, k)) != NULL; k++) {
        uint64_t value;
        if (!yk_form_field(check->d->ring, zero, point, &value)) continue; // a division by zero
        if (value != 0) return can_refute(check, zero) ? YK_REFUTED : YK_NO_PROOF;
        points++;
    }
    return points == YK_CHECK_POINTS ? YK_PROVED : YK_NO_PROOF;
}
