// Builds a law: segments follow one another, each from where the last one ended.
#ifndef LAW_BUILD_H
#define LAW_BUILD_H
#include "base/memory.h"
#include "law/law.h"

// The most conditions of one polynomial or spline, and the highest degree of a spline.
enum { YK_LAW_CONDITIONS_MAX = 200, YK_LAW_DEGREE_MAX = 9 };

typedef enum YkLawFault {
    YK_LAW_OK = 0,
    YK_LAW_NO_MEMORY,
    YK_LAW_EMPTY,         // no segment
    YK_LAW_BACKWARD,      // a segment that ends where it starts, or before
    YK_LAW_GAP,           // conditions that begin after the end of the previous segment
    YK_LAW_OVERLAP,       // conditions that begin before that end
    YK_LAW_TOO_FEW,       // conditions at one place only; fewer than degree + 1 for a spline; a table of one point
    YK_LAW_TOO_MANY,      // too many conditions
    YK_LAW_REPEATED,      // the same condition twice
    YK_LAW_CONTRADICTION, // a condition that cannot hold with the others
    YK_LAW_UNDETERMINED,  // a condition that follows from the others, which leaves the rest open
    YK_LAW_SHAPE,         // parameters of a rise out of range
    YK_LAW_UNORDERED,     // points of a table whose x do not ascend
    YK_LAW_NOT_FILLED,    // the segments end before the period
    YK_LAW_OVERFILLED,    // the segments continue beyond the period
    YK_LAW_NOT_FINITE,    // values so large, or a segment so short, that the law overflows
    YK_LAW_NO_VALUE,      // a function without a finite value or derivative at one place
    YK_LAW_ROUGH          // a function that no row of smooth pieces follows
} YkLawFault;

typedef struct YkLawBuilder YkLawBuilder;

// Starts at x = from with this value. Returns NULL when out of memory.
YkLawBuilder *yk_law_builder_new(double from, double value);
void yk_law_builder_free(YkLawBuilder *builder);
// Return where the next segment starts, and the value there.
double yk_law_builder_at(const YkLawBuilder *builder);
double yk_law_builder_value(const YkLawBuilder *builder);
// Return the index, in the list that was given, of the condition or point at fault in the last fault.
size_t yk_law_builder_culprit(const YkLawBuilder *builder);
// Returns where a function had no value, or was too rough, in the last fault.
double yk_law_builder_trouble(const YkLawBuilder *builder);

// Segments. After a fault the builder is unchanged.
YkLawFault yk_law_add_dwell(YkLawBuilder *builder, double to);
YkLawFault yk_law_add_velocity(YkLawBuilder *builder, double to, double v);

// Adds the polynomial of degree count - 1 that meets the conditions (in any order). It runs from the first of their
// places, which is where the builder stands, to the last. The conditions give the value at the start. Solved in
// Chebyshev polynomials of the segment scaled to [-1, 1], with refinement by residuals in twice the precision. Cost
// O(count^3). Source: Hermite-Birkhoff interpolation, Lorentz, Jetter & Riemenschneider 1983; basis: Trefethen 2013,
// ch. 14.
YkLawFault yk_law_add_polynomial(YkLawBuilder *builder, const YkLawCondition *conditions, size_t count);
// Adds a spline of this degree in as many B-splines as conditions. Its inner knots are averages of `degree` places, so
// that the conditions determine it; at most `degree` conditions at one place. Source: de Boor 2001, ch. XIII; for cams:
// Norton 2009, ch. 5; Rothbart 2004, ch. 5.
YkLawFault yk_law_add_spline(YkLawBuilder *builder, const YkLawCondition *conditions, size_t count, int degree);

// Computes a value and its four derivatives at x, at a kink those just after it; returns false if it has none.
typedef bool (*YkLawFunction)(const void *context, double x, double d[YK_LAW_ORDER + 1]);
// Follows a function until `to`, by as many polynomial pieces as it takes to agree with it to rounding: relative to the
// largest in the segment, 1e-13 in the value, 1e-12, 1e-11, 1e-10 and 1e-8 in the derivatives, or its own rounding,
// compared at 49 places of each piece. Kinks and steps become joints of pieces, located to 4e-13 of the segment;
// something narrower than a 48th of a piece may be missed. Cost about 120 evaluations a piece. Source: Trefethen 2013,
// ch. 3 and 19.
YkLawFault yk_law_add_function(YkLawBuilder *builder, double to, YkLawKind kind, YkLawFunction function,
                               const void *context);

// The library of rises. Sources: Norton 2009, Cam Design and Manufacturing Handbook, ch. 3-4; Rothbart 2004, Cam Design
// Handbook, ch. 2-3; modified trapezoid and modified sine: Neklutin 1952, Freudenstein 1960.
typedef enum YkRiseLaw {
    YK_RISE_HARMONIC,           // a half cosine
    YK_RISE_DOUBLE_HARMONIC,    // dwell at the foot only: unsymmetrical
    YK_RISE_CYCLOIDAL,          // full-sine acceleration
    YK_RISE_MODIFIED_TRAPEZOID, // scca 1/4, 1/2, 1/4
    YK_RISE_MODIFIED_SINE,      // scca 1/4, 0, 3/4
    YK_RISE_SCCA,               // sine - constant - cosine acceleration, with b + c + d = 1
    YK_RISE_3_4_5,
    YK_RISE_4_5_6_7,
    YK_RISE_PARABOLIC,        // constant acceleration, then constant deceleration
    YK_RISE_CONSTANT_VELOCITY // between two blends of constant acceleration
} YkRiseLaw;

typedef enum YkRiseHalf { YK_RISE_WHOLE, YK_RISE_FIRST_HALF, YK_RISE_SECOND_HALF } YkRiseHalf;

typedef struct YkRise {
    YkRiseLaw law;
    YkRiseHalf half; // half of the motion, stretched to the whole segment and lift, to join it to another law
    double b, c, d;  // SCCA: the total shares of the time with sine, constant and cosine acceleration
    double blend;    // CONSTANT_VELOCITY: the part of the time that each of the two blends takes, 0 to 1/2
} YkRise;

// Rises by `by` until `to`.
YkLawFault yk_law_add_rise(YkLawBuilder *builder, double to, double by, const YkRise *rise);
// Falls: the rise mirrored in time, from the top to the foot.
YkLawFault yk_law_add_fall(YkLawBuilder *builder, double to, double by, const YkRise *rise);
// Return the name of a law in the library, and the law of a name.
const char *yk_rise_name(YkRiseLaw law); // "modified-trapezoid"; NULL past the last one
bool yk_rise_find(const char *name, YkRiseLaw *law);

// A table: points x[count], y[count] with ascending x; starts at x[0], whatever the builder holds.
typedef enum YkTableShape {
    YK_TABLE_LINEAR,  // straight lines
    YK_TABLE_CUBIC,   // cubic spline, continuous to the second derivative, which is 0 at the ends (periodic: the same)
    YK_TABLE_MONOTONE // cubic pieces, continuous to the first derivative, that rise and fall only where the points do.
                      // Fritsch & Carlson 1980; slopes: Fritsch & Butland 1984
} YkTableShape;
// Adds a table. period 0: none. Otherwise the points lie within one period; if the last one does not end the period,
// the first one follows again. Cost linear.
YkLawFault yk_law_add_table(YkLawBuilder *builder, const double *x, const double *y, size_t count, YkTableShape shape,
                            double period);

// Makes the law in the arena; the builder still has to be freed. With a period (> 0) the segments must fill it. *law is
// NULL after a fault.
YkLawFault yk_law_finish(YkLawBuilder *builder, double period, YkArena *arena, YkLaw **law);

#endif
