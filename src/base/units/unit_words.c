// Reads unit words. Sizes stay a quotient and a power of ten until the end, so that every decimal unit, and every
// product of decimal units, becomes the double nearest to its true size.
#include "base/units/units.h"
#include <math.h>
#include <string.h>
#include "base/names.h"
#include "base/vec.h"

// The unit is factor * 10^tens of the SI unit.
typedef struct Unit {
    const char *name;
    double factor;
    int tens;
    YkDimension dimension; // length, mass, time, angle
} Unit;

// The angle in a dimension says which bare numbers to convert: `N*m/rad` and `N*m` differ in nothing else.
static const Unit units[] = {
    {"m", 1, 0, {1, 0, 0, 0}},
    {"mm", 1, -3, {1, 0, 0, 0}},
    {"cm", 1, -2, {1, 0, 0, 0}},
    {"dm", 1, -1, {1, 0, 0, 0}},
    {"km", 1, 3, {1, 0, 0, 0}},
    {"um", 1, -6, {1, 0, 0, 0}},
    {"in", 254, -4, {1, 0, 0, 0}},
    {"ft", 3048, -4, {1, 0, 0, 0}},
    {"kg", 1, 0, {0, 1, 0, 0}},
    {"g", 1, -3, {0, 1, 0, 0}},
    {"t", 1, 3, {0, 1, 0, 0}},
    {"lb", 45359237, -8, {0, 1, 0, 0}},
    {"s", 1, 0, {0, 0, 1, 0}},
    {"ms", 1, -3, {0, 0, 1, 0}},
    {"us", 1, -6, {0, 0, 1, 0}},
    {"min", 60, 0, {0, 0, 1, 0}},
    {"h", 3600, 0, {0, 0, 1, 0}},
    {"rad", 1, 0, {0, 0, 0, 1}},
    {"mrad", 1, -3, {0, 0, 0, 1}},
    {"deg", 0.017453292519943295769, 0, {0, 0, 0, 1}},
    {"turn", 2 * YK_PI, 0, {0, 0, 0, 1}},
    {"rev", 2 * YK_PI, 0, {0, 0, 0, 1}},
    {"rpm", 0.10471975511965977462, 0, {0, 0, -1, 1}},
    {"rps", 2 * YK_PI, 0, {0, 0, -1, 1}},
    {"Hz", 1, 0, {0, 0, -1, 0}},
    {"N", 1, 0, {1, 1, -2, 0}},
    {"mN", 1, -3, {1, 1, -2, 0}},
    {"kN", 1, 3, {1, 1, -2, 0}},
    {"MN", 1, 6, {1, 1, -2, 0}},
    {"lbf", 44482216152605, -13, {1, 1, -2, 0}}, // 0.45359237 * 9.80665, exactly
    {"kgf", 980665, -5, {1, 1, -2, 0}},
    {"Nm", 1, 0, {2, 1, -2, 0}},
    {"Nmm", 1, -3, {2, 1, -2, 0}},
    {"kNm", 1, 3, {2, 1, -2, 0}},
    {"J", 1, 0, {2, 1, -2, 0}},
    {"mJ", 1, -3, {2, 1, -2, 0}},
    {"kJ", 1, 3, {2, 1, -2, 0}},
    {"W", 1, 0, {2, 1, -3, 0}},
    {"mW", 1, -3, {2, 1, -3, 0}},
    {"kW", 1, 3, {2, 1, -3, 0}},
    {"Pa", 1, 0, {-1, 1, -2, 0}},
    {"kPa", 1, 3, {-1, 1, -2, 0}},
    {"MPa", 1, 6, {-1, 1, -2, 0}},
    {"GPa", 1, 9, {-1, 1, -2, 0}},
    {"bar", 1, 5, {-1, 1, -2, 0}},
    {"%", 1, -2, {0, 0, 0, 0}},
};
enum { UNIT_COUNT = sizeof units / sizeof *units, POWER_MAX = 9, TENS_MAX = 22 };

// A size being built up: above / below * 10^tens.
typedef struct Size {
    double above, below;
    int tens;
    YkDimension dimension;
} Size;

static const Unit *find_unit(const char *text, size_t length)
{
    for (size_t i = 0; i < UNIT_COUNT; i++)
        if (strlen(units[i].name) == length && memcmp(units[i].name, text, length) == 0) return &units[i];
    return NULL;
}

static void multiply_size(Size *size, const Unit *unit, int power)
{
    for (int i = 0; i < power; i++) size->above *= unit->factor;
    for (int i = 0; i < -power; i++) size->below *= unit->factor;
    size->tens += power * unit->tens;
    size->dimension = yk_dimension_times(size->dimension, unit->dimension, power);
}

static double power_of_ten(int exponent)
{
    double power = 1; // exact up to 10^22
    for (; exponent > 0; exponent--) power *= 10;
    return power;
}

static double size_value(const Size *size)
{
    return size->tens >= 0 ? size->above * power_of_ten(size->tens) / size->below
                           : size->above / (size->below * power_of_ten(-size->tens));
}

// Reads "^2" or "^-1" at text[at]; without one the power is 1. Returns the index after it, 0 when it is malformed.
static size_t read_power(const char *text, size_t length, size_t at, int *power)
{
    *power = 1;
    if (at == length || text[at] != '^') return at;
    bool negative = ++at < length && text[at] == '-';
    at += negative;
    if (at == length || text[at] < '1' || text[at] > '0' + POWER_MAX) return 0;
    *power = negative ? '0' - text[at] : text[at] - '0';
    return at + 1;
}

// Reads one factor: a unit with an optional power, or the 1 that starts a quotient ("1/s").
static bool read_factor(const char *text, size_t length, bool is_first, int sign, Size *size)
{
    if (is_first && length == 1 && text[0] == '1') return true;
    const char *caret = memchr(text, '^', length);
    size_t name_length = caret ? (size_t)(caret - text) : length;
    int power;
    const Unit *unit = find_unit(text, name_length);
    if (!unit || read_power(text, length, name_length, &power) != length) return false;
    multiply_size(size, unit, sign * power);
    return true;
}

bool yk_unit_read(const char *text, size_t length, double *size, YkDimension *dimension, const char **bad,
                  size_t *bad_length)
{
    Size total = {1, 1, 0, {0, 0, 0, 0}};
    int sign = 1;
    size_t start = 0;
    for (size_t i = 0; i <= length; i++) {
        if (i < length && text[i] != '*' && text[i] != '/') continue;
        bool is_first = start == 0, ends = i == length;
        if (!read_factor(text + start, i - start, is_first && !ends, sign, &total) || total.tens > TENS_MAX ||
            total.tens < -TENS_MAX) {
            *bad = text + start;
            *bad_length = i - start;
            return false;
        }
        sign = !ends && text[i] == '/' ? -1 : 1;
        start = i + 1;
    }
    *size = size_value(&total);
    *dimension = total.dimension;
    *bad = text;
    *bad_length = length;
    return *size > 0 && isfinite(*size); // min^9*min^9*... leaves the range of double
}

// Words that people write for units, perhaps with an `s` behind them.
static const struct {
    char word[11], unit[4];
} words[] = {{"degree", "deg"},    {"radian", "rad"},    {"meter", "m"},   {"metre", "m"},
             {"millimeter", "mm"}, {"millimetre", "mm"}, {"micron", "um"}, {"sec", "s"},
             {"second", "s"},      {"kilogram", "kg"},   {"pound", "lb"},  {"newton", "N"}};

const char *yk_unit_nearest(const char *text, size_t length)
{
    const char *names[UNIT_COUNT];
    char word[16];
    const char *caret = length > 0 ? memchr(text, '^', length) : NULL;
    if (caret) length = (size_t)(caret - text);
    if (length >= sizeof word) return NULL;
    if (length > 0) memcpy(word, text, length);
    word[length] = '\0';
    if (length > 3 && word[length - 1] == 's') length--;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strlen(words[i].word) == length && memcmp(words[i].word, word, length) == 0) return words[i].unit;
    for (size_t i = 0; i < UNIT_COUNT; i++) names[i] = units[i].name;
    return yk_nearest(word, names, UNIT_COUNT);
}
