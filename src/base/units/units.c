// The meaning of bare numbers in a file.
#include "base/units/units.h"
#include <math.h>

typedef struct Quotient {
    double above, below;
} Quotient;

YkUnits yk_units_si(void)
{
    return (YkUnits){.length = 1,
                     .mass = 1,
                     .time = 1,
                     .angle = 1,
                     .force = 0,
                     .length_name = "m",
                     .mass_name = "kg",
                     .time_name = "s",
                     .angle_name = "rad"};
}

// Multiplies size^power into a quotient; a size like 1e-3 counts as 1/1000, whose powers are exact.
static void multiply_power(Quotient *total, double size, int power)
{
    double inverse = rint(1 / size);
    bool is_part = size < 1 && inverse < 1e15 && 1 / inverse == size;
    double factor = is_part ? inverse : size;
    int steps = is_part ? -power : power;
    for (int i = 0; i < steps; i++) total->above *= factor;
    for (int i = 0; i < -steps; i++) total->below *= factor;
}

double yk_units_size(const YkUnits *units, YkDimension dimension)
{
    Quotient total = {1, 1};
    int length = dimension.length, mass = dimension.mass, time = dimension.time;
    if (units->force > 0 && mass != 0 && time != 0) {
        // kg = N s^2 / m
        multiply_power(&total, units->force, mass);
        length -= mass;
        time += 2 * mass;
        mass = 0;
    }
    multiply_power(&total, units->length, length);
    multiply_power(&total, units->mass, mass);
    multiply_power(&total, units->time, time);
    multiply_power(&total, units->angle, dimension.angle);
    return total.above / total.below;
}
