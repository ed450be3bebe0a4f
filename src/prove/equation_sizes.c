// Physical dimensions in equations, as far as they are known: of numbers with units, parameters, coordinates, forces.
#include <string.h>
#include "prove/quantities.h"
#include "derive/forces/free_bodies.h"
#include "prove/equation.h"

static YkEquationSize known(int length, int mass, int time)
{
    YkDimension dimension = {.length = (signed char)length, .mass = (signed char)mass, .time = (signed char)time};
    return (YkEquationSize){YK_SIZE_KNOWN, dimension, false};
}

static YkEquationSize angular(int time)
{
    return (YkEquationSize){YK_SIZE_KNOWN, {.time = (signed char)time, .angle = 1}, false};
}

static const YkEquationSize open = {.kind = YK_SIZE_OPEN};

static YkEquationSize per_time(YkEquationSize size, int order)
{
    size.dimension.time = (signed char)(size.dimension.time - order);
    return size;
}

static bool is_number(YkDimension dimension)
{
    return yk_dimension_equal(dimension, (YkDimension){0});
}

// --- Names

static YkEquationSize of_force(const YkDerivation *d, int32_t symbol)
{
    const YkDeriveForces *f = yk_derive_forces((YkDerivation *)d);
    for (size_t k = 0; f && k < f->reaction_count; k++)
        if (f->reactions[k] == symbol && f->reaction_part[k] != 'r')
            return f->reaction_part[k] == 'm' ? known(2, 1, -2) : known(1, 1, -2);
    for (size_t k = 0; f && k < f->effort_count; k++)
        if (f->efforts[k] == symbol)
            return d->coordinates[f->effort_coordinate[k]].is_distance ? known(1, 1, -2) : known(2, 1, -2);
    return open;
}

// A parameter may be a bare number only because nothing in the file says what else it is.
YkEquationSize yk_equation_size_of(const YkDerivation *d, int32_t symbol)
{
    for (size_t k = 0; k < d->model->parameter_count; k++)
        if (d->parameters[k] == symbol)
            return is_number(d->model->parameters[k].dimension)
                       ? open
                       : (YkEquationSize){YK_SIZE_KNOWN, d->model->parameters[k].dimension, false};
    for (size_t k = 0; k < d->coordinate_count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[k];
        const int32_t symbols[] = {c->position, c->rate, c->acceleration};
        for (int order = 0; order < 3; order++)
            if (symbols[order] == symbol) return per_time(c->is_distance ? known(1, 0, 0) : angular(0), order);
    }
    for (size_t b = 0; b < d->model->body_count; b++) {
        const YkDeriveBody *body = &d->bodies[b];
        const int32_t symbols[] = {body->angle, body->rate, body->acceleration};
        for (int order = 0; order < 3; order++)
            if (symbols[order] == symbol) return angular(-order);
    }
    for (size_t k = 0; k < d->constant_count; k++)
        if (d->constants[k].symbol == symbol && d->constants[k].exact) // a mass or an inertia
            return yk_ring_symbol_class(d->ring, symbol) == YK_RING_MASS ? known(0, 1, 0) : known(2, 1, 0);
    return symbol == d->time ? known(0, 0, 1) : of_force(d, symbol);
}

static bool ends_with(const char *name, size_t length, const char *ending)
{
    size_t size = strlen(ending);
    return length > size && strncmp(name + length - size, ending, size) == 0;
}

static YkEquationSize of_effort(const YkDerivation *d, const char *name, size_t length)
{
    length -= strlen(".effort");
    for (size_t c = 0; c < d->tree_count; c++)
        if (strlen(d->coordinates[c].name) == length && strncmp(d->coordinates[c].name, name, length) == 0)
            return d->coordinates[c].is_distance ? known(1, 1, -2) : known(2, 1, -2);
    return open;
}

YkEquationSize yk_equation_size_of_quantity(const YkDerivation *d, const char *name)
{
    static const char *const energies[] = {"T", "V", "L", "kinetic", "potential", "energy"};
    size_t length = strlen(name);
    int order = yk_derive_take_order(name, &length);
    for (size_t k = 0; k < sizeof energies / sizeof *energies; k++)
        if (strlen(energies[k]) == length && strncmp(name, energies[k], length) == 0)
            return per_time(known(2, 1, -2), order);
    if (strncmp(name, "T_", 2) == 0 || strncmp(name, "V_", 2) == 0) return per_time(known(2, 1, -2), order);
    if (strncmp(name, "omega_", 6) == 0) return angular(-1 - order);
    if (strncmp(name, "alpha_", 6) == 0) return angular(-2 - order);
    if (ends_with(name, length, ".force.x") || ends_with(name, length, ".force.y")) return known(1, 1, -2);
    if (ends_with(name, length, ".moment")) return known(2, 1, -2);
    if (strcmp(name, "shaking.x") == 0 || strcmp(name, "shaking.y") == 0) return known(1, 1, -2);
    if (ends_with(name, length, ".effort")) return of_effort(d, name, length);
    if (ends_with(name, length, ".x") || ends_with(name, length, ".y")) return per_time(known(1, 0, 0), order);
    return open;
}

// --- Products, powers

YkEquationSize yk_equation_size_times(YkEquationSize a, YkEquationSize b, int power)
{
    bool has_unit = a.has_unit || b.has_unit;
    if (a.kind == YK_SIZE_OPEN || b.kind == YK_SIZE_OPEN) return open;
    // A number without a unit may be a length in SI: 0.2 cos(theta).
    YkEquationSizeKind kind = a.kind == YK_SIZE_KNOWN && b.kind == YK_SIZE_KNOWN ? YK_SIZE_KNOWN : YK_SIZE_BARE;
    return (YkEquationSize){kind, yk_dimension_times(a.dimension, b.dimension, power), has_unit};
}

YkEquationSize yk_equation_size_power(YkEquationSize a, int exponent)
{
    YkEquationSize power = {a.kind, {0}, a.has_unit};
    power.dimension = yk_dimension_times(power.dimension, a.dimension, exponent);
    return power;
}

YkEquationSize yk_equation_size_root(YkEquationSize a)
{
    YkDimension d = a.dimension;
    if (a.kind != YK_SIZE_KNOWN) return a;
    if (d.length % 2 || d.mass % 2 || d.time % 2) return open;
    YkEquationSize root = known(d.length / 2, d.mass / 2, d.time / 2);
    root.has_unit = a.has_unit;
    return root;
}

// --- Comparing

// Compares only if one of them has a unit in the equation: a file's own numbers, which formulas do not show, have
// dimensions too.
static bool fit(YkEquationSize a, YkEquationSize b)
{
    bool are_known = a.kind == YK_SIZE_KNOWN && b.kind == YK_SIZE_KNOWN;
    return !are_known || !(a.has_unit || b.has_unit) || yk_dimension_equal(a.dimension, b.dimension);
}

static void report(YkEquationReader *reader, size_t start, const char *first, YkEquationSize a, const char *second,
                   YkEquationSize b)
{
    YkPlace place = reader->place;
    if (reader->failed) return;
    reader->failed = true;
    place.column += (uint32_t)start;
    place.length = 1;
    yk_problem(reader->problems, YK_CODE_MIXED_SUM, place, "%s is %s, %s %s", first, yk_dimension_name(a.dimension),
               second, yk_dimension_name(b.dimension));
}

YkEquationSize yk_equation_size_sum(YkEquationReader *reader, size_t start, YkEquationSize a, YkEquationSize b)
{
    if (!fit(a, b)) report(reader, start, "what stands before", a, "this is", b);
    YkEquationSize sum = a.kind == YK_SIZE_KNOWN ? a : b;
    sum.has_unit = a.has_unit || b.has_unit;
    return sum;
}

void yk_equation_compare_sides(YkEquationReader *reader, size_t start, YkEquationSize left, YkEquationSize right)
{
    if (!fit(left, right)) report(reader, start, "the left side", left, "the right side", right);
}

bool yk_equation_size_is_angle(YkEquationReader *reader, size_t start, YkEquationSize size)
{
    YkPlace place = reader->place;
    if (reader->failed || size.kind != YK_SIZE_KNOWN || is_number(size.dimension)) return !reader->failed;
    reader->failed = true;
    place.column += (uint32_t)start;
    place.length = 1;
    yk_problem(reader->problems, YK_CODE_WRONG_ARGUMENT, place, "an angle is expected here, this is %s",
               yk_dimension_name(size.dimension));
    return false;
}
