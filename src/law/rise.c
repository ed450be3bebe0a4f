// The library of rises: each is made over the unit interval, then cut, mirrored and stretched to its segment.
#include <math.h>
#include <string.h>
#include "base/vec.h"
#include "elementary/elementary.h"
#include "law/inside.h"

enum { ZONES_MAX = 5, NUMBERS_MAX = 9 };

typedef struct Zone {
    YkPiece frame;
    double numbers[NUMBERS_MAX];
} Zone;

// A rise being built: its zones over [0, 1], and its value and rates at the end of the last one.
typedef struct Motion {
    Zone zones[ZONES_MAX];
    size_t count;
    double at, s, v;
} Motion;

static void zone_eval(const Zone *zone, double x, double d[YK_LAW_ORDER + 1])
{
    yk_piece_eval(&zone->frame, zone->numbers, x, d);
}

// Appends a zone of this length; u = x less its start. Appends nothing for length 0.
static void append(Motion *motion, double length, uint16_t terms, uint16_t waves, const double *numbers)
{
    if (!(length > 0)) return;
    Zone *zone = &motion->zones[motion->count++];
    zone->frame = (YkPiece){.from = motion->at,
                            .to = motion->at + length,
                            .middle = motion->at,
                            .scale = 1,
                            .terms = terms,
                            .waves = waves};
    memcpy(zone->numbers, numbers, (terms + 3u * waves) * sizeof *numbers);
    double d[YK_LAW_ORDER + 1];
    zone_eval(zone, zone->frame.to, d);
    motion->at = zone->frame.to;
    motion->s = d[0];
    motion->v = d[1];
}

// Appends constant acceleration a: s + v u + a u^2 / 2, with u^2 = (T_2 + T_0) / 2.
static void accelerate(Motion *motion, double length, double a)
{
    const double numbers[3] = {motion->s + a / 4, motion->v, a / 4};
    append(motion, length, 3, 0, numbers);
}

// Appends the acceleration cos(frequency u + phase), integrated twice.
static void swing(Motion *motion, double length, double frequency, double phase)
{
    double a = 1 / frequency, b = a * a;
    const double numbers[5] = {motion->s + b * yk_cos(phase), motion->v - a * yk_sin(phase), -b, frequency, phase};
    append(motion, length, 2, 1, numbers);
}

// Builds sine - constant - cosine - constant - sine acceleration of unit amplitude. Source: Norton 2009, ch. 3.
static void scca(Motion *motion, double b, double c, double d)
{
    swing(motion, b / 2, b > 0 ? YK_PI / b : 1, -YK_PI / 2);
    accelerate(motion, c / 2, 1);
    swing(motion, d, d > 0 ? YK_PI / d : 1, 0);
    accelerate(motion, c / 2, -1);
    swing(motion, b / 2, b > 0 ? YK_PI / b : 1, YK_PI);
}

// Builds a trapezoidal velocity.
static void constant_velocity(Motion *motion, double blend)
{
    if (blend == 0) motion->v = 1;
    accelerate(motion, blend, 1);
    accelerate(motion, 1 - 2 * blend, 0);
    accelerate(motion, blend, -1);
}

static void one_zone(Motion *motion, double middle, double scale, uint16_t terms, uint16_t waves, const double *numbers)
{
    append(motion, 1, terms, waves, numbers);
    motion->zones[0].frame.middle = middle;
    motion->zones[0].frame.scale = scale;
}

// 10 x^3 - 15 x^4 + 6 x^5 and 35 x^4 - 84 x^5 + 70 x^6 - 20 x^7 in Chebyshev polynomials of u = 2 x - 1; and
// 1/2 (1 - cos pi x) - 1/8 (1 - cos 2 pi x).
static const double poly_3_4_5[] = {0.5, 9.375 / 16, 0, -1.5625 / 16, 0, 0.1875 / 16};
static const double poly_4_5_6_7[] = {0.5, 19.140625 / 32, 0, -3.828125 / 32, 0, 0.765625 / 32, 0, -0.078125 / 32};
static const double double_harmonic[] = {0.375, -0.5, YK_PI, 0, 0.125, 2 * YK_PI, 0};

static void make(Motion *motion, const YkRise *rise)
{
    switch (rise->law) {
    case YK_RISE_HARMONIC:
        scca(motion, 0, 0, 1);
        break;
    case YK_RISE_DOUBLE_HARMONIC:
        one_zone(motion, 0, 1, 1, 2, double_harmonic);
        break;
    case YK_RISE_CYCLOIDAL:
        scca(motion, 0.5, 0, 0.5);
        break;
    case YK_RISE_MODIFIED_TRAPEZOID:
        scca(motion, 0.25, 0.5, 0.25);
        break;
    case YK_RISE_MODIFIED_SINE:
        scca(motion, 0.25, 0, 0.75);
        break;
    case YK_RISE_SCCA:
        scca(motion, rise->b, rise->c, rise->d);
        break;
    case YK_RISE_3_4_5:
        one_zone(motion, 0.5, 2, 6, 0, poly_3_4_5);
        break;
    case YK_RISE_4_5_6_7:
        one_zone(motion, 0.5, 2, 8, 0, poly_4_5_6_7);
        break;
    case YK_RISE_PARABOLIC:
        scca(motion, 0, 1, 0);
        break;
    case YK_RISE_CONSTANT_VELOCITY:
        constant_velocity(motion, rise->blend);
        break;
    }
    motion->zones[motion->count - 1].frame.to = 1;
}

// Turns f(x) into f(1 - x).
static void mirror(Motion *motion)
{
    Motion old = *motion;
    for (size_t i = 0; i < old.count; i++) {
        Zone *zone = &motion->zones[i];
        *zone = old.zones[old.count - 1 - i];
        const YkPiece frame = zone->frame;
        zone->frame.from = 1 - frame.to;
        zone->frame.to = 1 - frame.from;
        zone->frame.middle = 1 - frame.middle;
        zone->frame.scale = -frame.scale;
    }
}

// Keeps what lies in [low, high], except slivers of rounding size.
static void cut(Motion *motion, double low, double high)
{
    size_t kept = 0;
    for (size_t i = 0; i < motion->count; i++) {
        Zone zone = motion->zones[i];
        zone.frame.from = fmax(zone.frame.from, low);
        zone.frame.to = fmin(zone.frame.to, high);
        if (zone.frame.to - zone.frame.from > 1e-12) motion->zones[kept++] = zone;
    }
    motion->count = kept;
}

// Adds factor * f + shift over [at, to], stretched along x.
static bool add_zone(YkLawBuilder *builder, const Motion *motion, size_t index, double to, double factor, double shift)
{
    Zone zone = motion->zones[index];
    double low = motion->zones[0].frame.from, high = motion->zones[motion->count - 1].frame.to;
    double at = builder->at, stretch = (to - at) / (high - low);
    bool is_last = index + 1 == motion->count;
    zone.frame.from = index == 0 ? at : at + (zone.frame.from - low) * stretch;
    zone.frame.to = is_last ? to : at + (zone.frame.to - low) * stretch;
    zone.frame.middle = at + (zone.frame.middle - low) * stretch;
    zone.frame.scale /= stretch;
    for (size_t k = 0; k < zone.frame.terms; k++) zone.numbers[k] *= factor;
    for (size_t k = 0; k < zone.frame.waves; k++) zone.numbers[zone.frame.terms + 3 * k] *= factor;
    zone.numbers[0] += shift;
    return yk_law_add_piece(builder, &zone.frame, zone.numbers);
}

// Adds the motion, from its start to its end, as one from the builder's value by `by`.
static bool add_motion(YkLawBuilder *builder, const Motion *motion, double to, double by)
{
    double d0[YK_LAW_ORDER + 1], d1[YK_LAW_ORDER + 1];
    const Zone *last = &motion->zones[motion->count - 1];
    zone_eval(&motion->zones[0], motion->zones[0].frame.from, d0);
    zone_eval(last, last->frame.to, d1);
    double factor = by / (d1[0] - d0[0]), shift = builder->value - factor * d0[0];
    for (size_t i = 0; i < motion->count; i++) {
        if (!add_zone(builder, motion, i, to, factor, shift)) return false;
    }
    return true;
}

static bool is_part(double part)
{
    return part >= 0 && part <= 1;
}

static bool has_shape(const YkRise *rise)
{
    if (rise->law == YK_RISE_SCCA) {
        return is_part(rise->b) && is_part(rise->c) && is_part(rise->d) && fabs(rise->b + rise->c + rise->d - 1) < 1e-9;
    }
    return rise->law != YK_RISE_CONSTANT_VELOCITY || (rise->blend >= 0 && rise->blend <= 0.5);
}

static YkLawFault add(YkLawBuilder *builder, double to, double by, const YkRise *rise, bool falls)
{
    Motion motion = {.count = 0};
    if (!(to > builder->at)) return YK_LAW_BACKWARD;
    if (!has_shape(rise)) return YK_LAW_SHAPE;
    make(&motion, rise);
    if (falls) mirror(&motion);
    if (rise->half == YK_RISE_FIRST_HALF) cut(&motion, 0, 0.5);
    if (rise->half == YK_RISE_SECOND_HALF) cut(&motion, 0.5, 1);
    size_t first = builder->piece_count;
    double value = builder->value + (falls ? -by : by);
    if (!add_motion(builder, &motion, to, falls ? -by : by)) {
        yk_law_take_back(builder, first, 0);
        return YK_LAW_NO_MEMORY;
    }
    YkLawFault fault = yk_law_end_segment(builder, falls ? YK_LAW_FALL : YK_LAW_RISE, first, 0, 1);
    if (fault == YK_LAW_OK) builder->value = value; // removes the rounding on the way
    return fault;
}

YkLawFault yk_law_add_rise(YkLawBuilder *builder, double to, double by, const YkRise *rise)
{
    return add(builder, to, by, rise, false);
}

YkLawFault yk_law_add_fall(YkLawBuilder *builder, double to, double by, const YkRise *rise)
{
    return add(builder, to, by, rise, true);
}

static const char *const names[] = {
    [YK_RISE_HARMONIC] = "harmonic",
    [YK_RISE_DOUBLE_HARMONIC] = "double-harmonic",
    [YK_RISE_CYCLOIDAL] = "cycloidal",
    [YK_RISE_MODIFIED_TRAPEZOID] = "modified-trapezoid",
    [YK_RISE_MODIFIED_SINE] = "modified-sine",
    [YK_RISE_SCCA] = "scca",
    [YK_RISE_3_4_5] = "3-4-5",
    [YK_RISE_4_5_6_7] = "4-5-6-7",
    [YK_RISE_PARABOLIC] = "parabolic",
    [YK_RISE_CONSTANT_VELOCITY] = "constant-velocity",
};
enum { NAME_COUNT = sizeof names / sizeof *names };

const char *yk_rise_name(YkRiseLaw law)
{
    return (size_t)law < NAME_COUNT ? names[law] : NULL;
}

bool yk_rise_find(const char *name, YkRiseLaw *law)
{
    for (int i = 0; i < NAME_COUNT; i++) {
        if (strcmp(names[i], name) != 0) continue;
        *law = (YkRiseLaw)i;
        return true;
    }
    return false;
}
