// Writes the unit of a bare number, as a file would write it.
#include "base/units/units.h"

typedef struct Factor {
    const char *name;
    int power;
} Factor;

enum { FACTORS = 5 };

static void add_factor(YkText *text, Factor factor, int sign, const char *before)
{
    yk_text_format(text, "%s%s", before, factor.name);
    int power = sign * factor.power;
    if (power != 1) yk_text_format(text, "^%d", power);
}

// Adds the factors whose power has this sign; returns how many.
static int add_factors(YkText *text, const Factor *factors, int sign, const char *first, const char *others)
{
    int count = 0;
    for (int i = 0; i < FACTORS; i++)
        if (factors[i].power * sign > 0) add_factor(text, factors[i], sign, count++ > 0 ? others : first);
    return count;
}

// Returns the name of the file's unit of force: its own, or the newton where the others make it. NULL: it has none.
static const char *name_of_force(const YkUnits *units)
{
    if (units->force_name) return units->force_name;
    return units->mass * units->length / (units->time * units->time) == 1 ? "N" : NULL;
}

void yk_units_name(const YkUnits *units, YkDimension d, YkText *text)
{
    const char *force = name_of_force(units);
    bool is_of_force = force && d.mass != 0 && d.time != 0; // kg = N s^2 / m
    const Factor factors[FACTORS] = {{force, is_of_force ? d.mass : 0},
                                     {units->mass_name, is_of_force ? 0 : d.mass},
                                     {units->length_name, is_of_force ? d.length - d.mass : d.length},
                                     {units->time_name, is_of_force ? d.time + 2 * d.mass : d.time},
                                     {units->angle_name, d.angle}};
    if (add_factors(text, factors, 1, "", "*") > 0) {
        add_factors(text, factors, -1, "/", "/");
        return;
    }
    const char *before = "";
    for (int i = 0; i < FACTORS; i++) {
        if (factors[i].power >= 0) continue;
        add_factor(text, factors[i], 1, before); // no factor above the line: s^-1
        before = "*";
    }
}
