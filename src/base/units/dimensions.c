// Physical dimensions: their algebra and their names in words.
#include "base/units/units.h"

bool yk_dimension_equal(YkDimension a, YkDimension b)
{
    return a.length == b.length && a.mass == b.mass && a.time == b.time;
}

// Adds powers; exponents far outside physics saturate. No file reaches them by accident.
static signed char add_power(signed char a, signed char b, int power)
{
    int sum = a + b * (power > 127 ? 127 : power < -127 ? -127 : power);
    return (signed char)(sum > 127 ? 127 : sum < -127 ? -127 : sum);
}

YkDimension yk_dimension_times(YkDimension a, YkDimension b, int power)
{
    return (YkDimension){add_power(a.length, b.length, power), add_power(a.mass, b.mass, power),
                         add_power(a.time, b.time, power), add_power(a.angle, b.angle, power)};
}

typedef struct Named {
    YkDimension dimension;
    const char *name;
} Named;

// The first of several equal dimensions gives the name when no entry matches the angle exactly.
static const Named named[] = {
    {{0, 0, 0, 0}, "a number"},
    {{0, 0, 0, 1}, "an angle"},
    {{1, 0, 0, 0}, "a length"},
    {{0, 1, 0, 0}, "a mass"},
    {{0, 0, 1, 0}, "a time"},
    {{2, 0, 0, 0}, "an area"},
    {{3, 0, 0, 0}, "a volume"},
    {{0, 0, -1, 0}, "a frequency"},
    {{0, 0, -1, 1}, "an angular speed"},
    {{0, 0, -2, 0}, "an angular acceleration"},
    {{0, 0, -3, 1}, "an angular jerk"},
    {{1, 0, -1, 0}, "a speed"},
    {{1, 0, -2, 0}, "an acceleration"},
    {{1, 0, -3, 0}, "a jerk"},
    {{2, 1, 0, 0}, "a moment of inertia"},
    {{-3, 1, 0, 0}, "a density"},
    {{1, 1, -1, 0}, "a momentum"},
    {{2, 1, -1, 0}, "an angular momentum or angular damping"},
    {{2, 1, -1, -1}, "an angular damping"},
    {{1, 1, -2, 0}, "a force"},
    {{2, 1, -2, 0}, "a torque or energy"},
    {{2, 1, -2, -1}, "an angular stiffness"},
    {{0, 1, -2, 0}, "a stiffness"},
    {{0, 1, -1, 0}, "a damping"},
    {{2, 1, -3, 0}, "a power"},
    {{-1, 1, -2, 0}, "a pressure"},
};

// "a quantity in kg^b m^a s^c" for every a, c in -4..4 and b in -2..2, in rows of c.
#define IN_TIME(rest)                                                                                                  \
    {                                                                                                                  \
        "a quantity in" rest " s^-4", "a quantity in" rest " s^-3", "a quantity in" rest " s^-2",                      \
            "a quantity in" rest " s^-1", "a quantity in" rest, "a quantity in" rest " s",                             \
            "a quantity in" rest " s^2", "a quantity in" rest " s^3", "a quantity in" rest " s^4"                      \
    }
#define IN_LENGTH(mass)                                                                                                \
    {                                                                                                                  \
        IN_TIME(mass " m^-4"), IN_TIME(mass " m^-3"), IN_TIME(mass " m^-2"), IN_TIME(mass " m^-1"), IN_TIME(mass),     \
            IN_TIME(mass " m"), IN_TIME(mass " m^2"), IN_TIME(mass " m^3"), IN_TIME(mass " m^4")                       \
    }
static const char *const unnamed[5][9][9] = {IN_LENGTH(" kg^-2"), IN_LENGTH(" kg^-1"), IN_LENGTH(""), IN_LENGTH(" kg"),
                                             IN_LENGTH(" kg^2")};

static bool is_within(int value, int bound)
{
    return value >= -bound && value <= bound;
}

const char *yk_dimension_name(YkDimension dimension)
{
    const char *name = NULL;
    for (size_t i = 0; i < sizeof named / sizeof *named; i++) {
        if (!yk_dimension_equal(named[i].dimension, dimension)) continue;
        if (named[i].dimension.angle == dimension.angle) return named[i].name;
        if (!name) name = named[i].name;
    }
    if (name) return name;
    if (!is_within(dimension.mass, 2) || !is_within(dimension.length, 4) || !is_within(dimension.time, 4))
        return "a quantity of an unusual dimension";
    return unnamed[dimension.mass + 2][dimension.length + 4][dimension.time + 4];
}
