// Finds the angle of a steady drive after any number of turns, less those turns. A product w t of 1e15 turns keeps no
// digit after the point, so whole turns are removed before it is rounded.
#include <float.h>
#include <math.h>
#include "base/vec.h"
#include "elementary/elementary.h"
#include "model/model.h"

// 2 pi = TURN_1 + TURN_2 + TURN_3 to 1e-49.
#define TURN_1 0x1.921fb54442d18p+2
#define TURN_2 0x1.1a62633145c07p-52
#define TURN_3 (-0x1.f1976b7ed8fbcp-108)
#define WHOLE_MAX 0x1p53 // up to here every whole number is a double

// Returns a * b mod modulus, for whole numbers below the modulus.
static double multiply_modulo(double a, double b, double modulus)
{
    double product = 0, addend = a;
    for (; b > 0; b = floor(b / 2)) {
        if (yk_fmod(b, 2) != 0) product = product >= modulus - addend ? product - (modulus - addend) : product + addend;
        addend = addend >= modulus - addend ? addend - (modulus - addend) : addend + addend;
    }
    return product;
}

// Returns numerator / modulus * t in turns, less whole turns. The part of t before the point is multiplied in whole
// numbers; the part after it gives a product and its rounding, whose remainder is exact.
static double turns_of(double numerator, double modulus, double t)
{
    double whole, part = modf(fabs(t), &whole), sign = numerator * t < 0 ? -1 : 1;
    double size = fabs(numerator), rest = multiply_modulo(yk_fmod(size, modulus), yk_fmod(whole, modulus), modulus);
    double product = size * part, rounding = fma(size, part, -product);
    double turns = rest / modulus + (yk_fmod(product, modulus) + rounding) / modulus;
    return sign * (turns - rint(turns));
}

// Finds numerator / denominator * t in radians, less whole turns.
static bool radians_of(double numerator, double denominator, double t, double *phase)
{
    double product = numerator * t, rounding = fma(numerator, t, -product), high = product / denominator;
    double low = (fma(-high, denominator, product) + rounding) / denominator, turns = rint(high / TURN_1);
    if (!(fabs(turns) <= WHOLE_MAX / 8)) return false;
    double first = turns * TURN_1, first_low = fma(turns, TURN_1, -first);
    double second = turns * TURN_2, second_low = fma(turns, TURN_2, -second);
    *phase = (((high - first) - first_low) - second) + (low - second_low - turns * TURN_3);
    return true;
}

static bool add_phase(YkExact value, double t, double *phase)
{
    double numerator = (double)value.numerator, denominator = (double)value.denominator, radians = 0;
    if (!value.is_exact || !(fabs(numerator) < WHOLE_MAX) || !(denominator < WHOLE_MAX / 2)) return false;
    if (numerator == 0) return true;
    if (value.pi == 1)
        radians = TURN_1 * turns_of(numerator, 2 * denominator, t);
    else if (value.pi != 0 || !radians_of(numerator, denominator, t, &radians))
        return false;
    *phase += radians;
    return true;
}

// Returns whether the expression still gives the value: designs of a study have values of their own.
static bool has_value(YkExact exact, double value)
{
    double own = (double)exact.numerator / (double)exact.denominator * (exact.pi == 1 ? YK_PI : 1);
    return exact.is_exact && (exact.numerator == 0 || exact.pi == 0 || exact.pi == 1) &&
           fabs(own - value) <= 4 * DBL_EPSILON * fabs(value);
}

bool yk_model_drive_phase(const YkModel *model, size_t drive, double t, double *phase)
{
    const YkDrive *d = &model->drives[drive];
    if (d->law != YK_NONE || !isfinite(t)) return false;
    YkExactLine line = yk_model_exact_line(model, d->expr);
    double sum = 0;
    YkJet at_zero;
    if (yk_model_drive(model, drive, 0, &at_zero, NULL) != YK_OK) return false;
    if (!has_value(line.constant, at_zero.d[0]) || !has_value(line.rate, at_zero.d[1])) return false;
    if (!add_phase(line.constant, 1, &sum) || !add_phase(line.rate, t, &sum)) return false;
    *phase = sum - TURN_1 * rint(sum / TURN_1);
    return true;
}
