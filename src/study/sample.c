// Draws values of designs from distributions.
#include "study/sample.h"
#include <math.h>
#include <stdint.h>
#include "base/mix.h"
#include "elementary/elementary.h"

// --- uniform numbers

// Returns a uniform number in (0, 1), never an end: counter-based, two rounds of splitmix64 (Steele, Lea & Flood 2014).
static double uniform(uint64_t seed, uint64_t design, uint64_t parameter)
{
    uint64_t stream = yk_mix(seed + YK_MIX_STEP * (2 * parameter + 1));
    uint64_t bits = yk_mix(yk_mix(stream + YK_MIX_STEP * (design + 1)) ^ stream);
    return ((double)(bits >> 12) + 0.5) * 0x1p-52;
}

// --- the normal distribution

double yk_normal_below(double x)
{
    return 0.5 * yk_erfc(-x * 0.70710678118654752440);
}

// Evaluates c[0] + c[1] x + ... + c[7] x^7.
static double polynomial(const double *c, double x)
{
    double sum = c[7];
    for (int k = 6; k >= 0; k--) sum = sum * x + c[k];
    return sum;
}

double yk_normal_quantile(double p)
{
    static const double a[2][8] = {
        {3.3871328727963666080, 133.14166789178437745, 1971.5909503065514427, 13731.693765509461125,
         45921.953931549871457, 67265.770927008700853, 33430.575583588128105, 2509.0809287301226727},
        {1.0, 42.313330701600911252, 687.18700749205790830, 5394.1960214247511077, 21213.794301586595867,
         39307.895800092710610, 28729.085735721942674, 5226.4952788528545610}};
    static const double b[2][8] = {
        {1.42343711074968357734, 4.63033784615654529590, 5.76949722146069140550, 3.64784832476320460504,
         1.27045825245236838258, 0.241780725177450611770, 0.0227238449892691845833, 7.74545014278341407640e-4},
        {1.0, 2.05319162663775882187, 1.67638483018380384940, 0.689767334985100004550, 0.148103976427480074590,
         0.0151986665636164571966, 5.47593808499534494600e-4, 1.05075007164441684324e-9}};
    static const double c[2][8] = {
        {6.65790464350110377720, 5.46378491116411436990, 1.78482653991729133580, 0.296560571828504891230,
         0.0265321895265761230930, 0.00124266094738807843860, 2.71155556874348757815e-5, 2.01033439929228813265e-7},
        {1.0, 0.599832206555887937690, 0.136929880922735805310, 0.0148753612908506148525, 7.86869131145613259100e-4,
         1.84631831751005468180e-5, 1.42151175831644588870e-7, 2.04426310338993978564e-15}};
    double q = p - 0.5;
    if (fabs(q) <= 0.425) {
        double r = 0.180625 - q * q;
        return q * polynomial(a[0], r) / polynomial(a[1], r);
    }
    double r = sqrt(-yk_log(q < 0 ? p : 1 - p));
    double x = r <= 5 ? polynomial(b[0], r - 1.6) / polynomial(b[1], r - 1.6)
                      : polynomial(c[0], r - 5) / polynomial(c[1], r - 5);
    return q < 0 ? -x : x;
}

// --- distributions

// Returns the part of a normal distribution below its lower end; `between` returns that between its ends.
static double below(const YkDistribution *d, double x)
{
    return yk_normal_below((x - d->center) / d->spread);
}

bool yk_distribution_is_valid(const YkDistribution *d)
{
    if (d->kind == YK_DISTRIBUTION_NORMAL)
        return isfinite(d->center) && isfinite(d->spread) && d->spread > 0 && d->low < d->high &&
               below(d, d->high) - below(d, d->low) > 1e-12;
    bool has_ends = isfinite(d->low) && isfinite(d->high) && d->low < d->high;
    return has_ends && (d->kind == YK_DISTRIBUTION_UNIFORM || (d->low <= d->center && d->center <= d->high));
}

// Returns the value below which a part p in (0, 1) of a distribution lies. Source (triangular): Evans et al. 2000.
static double quantile_of(const YkDistribution *d, double p)
{
    double width = d->high - d->low, low = d->center - d->low, x;
    switch (d->kind) {
    case YK_DISTRIBUTION_NORMAL: {
        double from = below(d, d->low), to = below(d, d->high);
        x = d->center + d->spread * yk_normal_quantile(from + p * (to - from));
        return fmin(fmax(x, d->low), d->high);
    }
    case YK_DISTRIBUTION_TRIANGULAR:
        if (p * width < low) return d->low + sqrt(p * width * low);
        return d->high - sqrt((1 - p) * width * (d->high - d->center));
    case YK_DISTRIBUTION_UNIFORM:
        break;
    }
    return d->low + p * width;
}

double yk_distribution_draw(const YkDistribution *d, uint64_t seed, uint64_t design, uint64_t parameter)
{
    return quantile_of(d, uniform(seed, design, parameter));
}

// A normal distribution cut off at a and b (in deviations): density at the ends over the part between them.
// Source: Johnson, Kotz & Balakrishnan 1994, ch. 13.
typedef struct Cut {
    double shift, a_part, b_part;
} Cut;

static Cut cut_of(const YkDistribution *d)
{
    double a = (d->low - d->center) / d->spread, b = (d->high - d->center) / d->spread;
    double part = yk_normal_below(b) - yk_normal_below(a), scale = 0.39894228040143267794 / part;
    double at_a = scale * yk_exp(-a * a / 2), at_b = scale * yk_exp(-b * b / 2);
    return (Cut){at_a - at_b, isfinite(a) ? a * at_a : 0, isfinite(b) ? b * at_b : 0};
}

double yk_distribution_mean(const YkDistribution *d)
{
    if (d->kind == YK_DISTRIBUTION_NORMAL) return d->center + d->spread * cut_of(d).shift;
    if (d->kind == YK_DISTRIBUTION_TRIANGULAR) return (d->low + d->center + d->high) / 3;
    return 0.5 * (d->low + d->high);
}

double yk_distribution_deviation(const YkDistribution *d)
{
    double a = d->low, b = d->high, c = d->center;
    if (d->kind == YK_DISTRIBUTION_NORMAL) {
        Cut cut = cut_of(d);
        return d->spread * sqrt(1 + cut.a_part - cut.b_part - cut.shift * cut.shift);
    }
    if (d->kind == YK_DISTRIBUTION_TRIANGULAR)
        return sqrt(((a - b) * (a - b) + (b - c) * (b - c) + (a - c) * (a - c)) / 36);
    return (b - a) / sqrt(12);
}

double yk_distribution_tolerance(const YkDistribution *d, double nominal)
{
    double low = d->low, high = d->high;
    if (d->kind == YK_DISTRIBUTION_NORMAL) {
        low = fmax(low, d->center - 3 * d->spread);
        high = fmin(high, d->center + 3 * d->spread);
    }
    return fmax(fabs(nominal - low), fabs(high - nominal));
}
