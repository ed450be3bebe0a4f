// Reads the words of an equation: numbers with units, names, functions.
#include <string.h>
#include "base/letters.h"
#include "prove/quantities.h"
#include "base/names.h"
#include "base/number.h"
#include "base/units/units.h"
#include "derive/forces/free_bodies.h"
#include "prove/equation.h"

static const YkForm *form_of(YkEquationReader *reader, const YkPoisson *a)
{
    return yk_form_of(reader->d->ring, a);
}

static size_t name_end(const YkEquationReader *reader, size_t at)
{
    while (at < reader->length &&
           (yk_begins_name(reader->text[at]) || yk_is_digit(reader->text[at]) || reader->text[at] == '.'))
        at++;
    while (at < reader->length && reader->text[at] == '\'') at++;
    return at;
}

static const char *copy(YkEquationReader *reader, size_t start, size_t end)
{
    const char *name = yk_arena_copy(reader->d->arena, reader->text + start, end - start);
    return name ? name : "";
}

// --- Units

static size_t letters_end(const YkEquationReader *reader, size_t at)
{
    while (at < reader->length && yk_is_letter(reader->text[at])) at++;
    return at;
}

static size_t digits_end(const YkEquationReader *reader, size_t at)
{
    if (at >= reader->length || reader->text[at] != '^') return at;
    size_t end = at + 1 + (at + 1 < reader->length && reader->text[at + 1] == '-'), first = end;
    while (end < reader->length && yk_is_digit(reader->text[end])) end++;
    return end > first ? end : at;
}

static bool is_unit(const YkEquationReader *reader, size_t start, size_t end, double *size, YkDimension *dimension)
{
    const char *bad;
    size_t bad_length;
    return end > start && yk_unit_read(reader->text + start, end - start, size, dimension, &bad, &bad_length);
}

// Reads the unit behind a number, one word as in the file: mm, deg, N*m, m/s^2. A word that begins with a name of the
// machine is not a unit: with a parameter m, `2 m` is twice that. A t is the time, never a tonne.
static const YkForm *read_unit(YkEquationReader *reader, const YkForm *value)
{
    double size, more;
    YkDimension dimension, wider;
    yk_equation_peek(reader);
    size_t start = reader->at, letters = letters_end(reader, start), end = digits_end(reader, letters);
    if (letters == start || name_end(reader, start) != letters) return value;
    if (yk_ring_find(reader->d->ring, copy(reader, start, letters)) >= 0) return value;
    if (!is_unit(reader, start, end, &size, &dimension)) return value;
    while (end < reader->length && (reader->text[end] == '*' || reader->text[end] == '/')) {
        letters = letters_end(reader, end + 1);
        size_t next = digits_end(reader, letters);
        bool is_time = letters == end + 2 && reader->text[end + 1] == 't';
        if (is_time || name_end(reader, end + 1) != letters || !is_unit(reader, start, next, &more, &wider)) break;
        size = more, dimension = wider, end = next;
    }
    reader->at = end;
    reader->size = (YkEquationSize){YK_SIZE_KNOWN, dimension, true};
    const YkPoisson *unit = yk_derive_unit_size(reader->d, size, dimension.angle);
    return yk_form_multiply(reader->d->ring, value, form_of(reader, unit));
}

// --- Names

static const char *nearest_name(const YkDerivation *d, const char *name)
{
    enum { CANDIDATES_MAX = 1000 };
    const char *candidates[CANDIDATES_MAX];
    size_t count = yk_ring_symbol_count(d->ring);
    if (count > CANDIDATES_MAX) count = CANDIDATES_MAX;
    for (size_t k = 0; k < count; k++) candidates[k] = yk_ring_symbol_name(d->ring, (int32_t)k);
    return yk_nearest(name, candidates, count);
}

// theta1dot and theta1ddot are theta1' and theta1''. Returns NULL for other names.
static const char *dotted_name(YkEquationReader *reader, const char *name)
{
    static const char *const endings[] = {"ddot", "dot"};
    for (int k = 0; k < 2; k++) {
        size_t length = strlen(name), size = strlen(endings[k]);
        if (length <= size || strcmp(name + length - size, endings[k]) != 0) continue;
        length -= size + (name[length - size - 1] == '_');
        const char *base = yk_arena_copy(reader->d->arena, name, length);
        if (base && yk_ring_find(reader->d->ring, base) >= 0)
            return yk_derive_text(reader->d, base, k == 0 ? "''" : "'", "");
    }
    return NULL;
}

// Finds names of vectors, and of what only words define, as pages print them; NULL for other names.
static const char *printed_name(const YkEquationReader *reader, const char *name)
{
    bool is_marked = reader->at + 1 < reader->length && strncmp(reader->text + reader->at, "^{", 2) == 0;
    bool is_force = name[0] != '\0' && strchr("FMNTWSDRQev", name[0]) && name[1] == '_';
    if (is_marked || is_force)
        return "pages print vectors like this; equations here are between numbers: F12x, M01, crank.A.x, crank.A.x'";
    if (strcmp(name, "work") == 0) return "pages say this in words; T and V are known here, and theta1.effort";
    if (reader->d->model->cam_count > 0 && (strcmp(name, "alpha") == 0 || strcmp(name, "rho") == 0))
        return "a cam's pressure angle and radius of curvature belong to its shape: `yoke cam` gives their values";
    return NULL;
}

// Finds answers of `solve` that are not polynomials of what is known here; NULL for other names.
static const char *other_answer(const char *name)
{
    if (yk_has_ending(name, ".force")) return "its size is a root: write A.force.x^2 + A.force.y^2 for its square";
    if (yk_has_ending(name, ".speed")) return "its size is a root: write crank.A.x'^2 + crank.A.y'^2 for its square";
    if (yk_has_ending(name, ".transmission"))
        return "write it as the angle between two links: sin(coupler.angle - rocker.angle)";
    return NULL;
}

// dx/dt is x'; x_B is rod.B.x. Returns NULL for other names.
static const char *books_name(YkEquationReader *reader, const char *name)
{
    const YkDerivation *d = reader->d;
    size_t left = reader->length - reader->at;
    bool is_rate = left >= 3 && strncmp(reader->text + reader->at, "/dt", 3) == 0;
    if (is_rate && name[0] == 'd' && yk_ring_find(d->ring, name + 1) >= 0)
        return yk_derive_text(reader->d, name + 1, "'", "");
    bool is_place = (name[0] == 'x' || name[0] == 'y') && name[1] == '_';
    for (size_t p = 0; is_place && p < d->model->point_count; p++) {
        const YkPoint *point = &d->model->points[p];
        if (point->body == 0 || strcmp(point->name, name + 2) != 0) continue;
        const char *of = yk_derive_text(reader->d, d->model->bodies[point->body].name, ".", point->name);
        return yk_derive_text(reader->d, of, name[0] == 'x' ? ".x" : ".y", "");
    }
    return NULL;
}

static const YkForm *unknown_name(YkEquationReader *reader, size_t start, const char *name)
{
    static const char *const inverse[] = {"asin", "acos", "atan", "atan2", "arcsin", "arccos", "arctan"};
    YkPlace place = reader->place;
    place.column += (uint32_t)start;
    place.length = (uint32_t)strlen(name);
    reader->failed = true;
    for (size_t k = 0; k < sizeof inverse / sizeof *inverse; k++) {
        if (strcmp(name, inverse[k]) != 0) continue;
        yk_problem(reader->problems, YK_CODE_UNKNOWN_NAME, place, "%q has many values: it cannot be proved", name);
        yk_problem_hint(reader->problems,
                        "compare sines, cosines or tangents: tan(theta2) = ... for theta2 = atan(...)");
        return NULL;
    }
    yk_problem(reader->problems, YK_CODE_UNKNOWN_NAME, place, "unknown name %q", name);
    const char *near = dotted_name(reader, name);
    if (!near) near = books_name(reader, name);
    const char *printed = near ? NULL : printed_name(reader, name);
    if (!near && !printed) printed = other_answer(name);
    if (printed) {
        yk_problem_hint(reader->problems, "%s", printed);
        return NULL;
    }
    if (!near) near = nearest_name(reader->d, name);
    if (near)
        yk_problem_hint(reader->problems, "did you mean %q?", near);
    else
        yk_problem_hint(reader->problems, "an equation may contain the file's parameters and coordinates, rates as "
                                          "theta1' or theta1.rate, crank.angle, crank.A.x, T and V, and forces as "
                                          "`--what free-bodies` names them");
    return NULL;
}

static const YkForm *read_pi(YkEquationReader *reader)
{
    reader->size = (YkEquationSize){.kind = YK_SIZE_KNOWN};
    return read_unit(reader, form_of(reader, yk_ring_pi(reader->d->ring)));
}

static bool is_coordinate(const YkDerivation *d, int32_t symbol)
{
    for (size_t k = 0; k < d->coordinate_count; k++)
        if (symbol == d->coordinates[k].position || symbol == d->coordinates[k].rate ||
            symbol == d->coordinates[k].acceleration)
            return true;
    return false;
}

// x(t) is x. No equation here is about x at t = 0; with a blank it is a product.
static bool take_time(YkEquationReader *reader, int32_t symbol)
{
    const char *at = reader->text + reader->at;
    size_t left = reader->length - reader->at, inside = 1;
    if (left < 3 || *at != '(' || !is_coordinate(reader->d, symbol)) return true;
    if (strncmp(at, "(t)", 3) == 0) {
        reader->at += 3;
        return true;
    }
    while (inside < left && (yk_is_digit(at[inside]) || at[inside] == '.')) inside++;
    if (inside == 1 || inside == left || at[inside] != ')') return true;
    yk_equation_refuse(reader, reader->at, "an equation here is about any pose, not about one time",
                       "`yoke solve --time` gives values at one time; for a product write *");
    return false;
}

static const YkForm *read_name(YkEquationReader *reader)
{
    YkRing *ring = reader->d->ring;
    size_t start = reader->at;
    reader->at = name_end(reader, start);
    const char *name = copy(reader, start, reader->at);
    reader->size = (YkEquationSize){.kind = YK_SIZE_OPEN};
    if (strcmp(name, "pi") == 0) return read_pi(reader);
    int32_t symbol = yk_ring_find(ring, name);
    if (symbol < 0 && strcmp(name, "i") == 0) return form_of(reader, yk_ring_i(ring));
    const YkPoisson *quantity = symbol < 0 ? yk_derive_quantity(reader->d, name) : NULL;
    if (quantity) reader->size = yk_equation_size_of_quantity(reader->d, name);
    if (quantity) return form_of(reader, quantity);
    if (symbol < 0 && yk_ring_status(ring) == YK_RING_OK) symbol = yk_equation_find(reader->d, name);
    if (yk_ring_status(ring) != YK_RING_OK) return NULL;
    if (symbol < 0) return unknown_name(reader, start, name);
    if (!take_time(reader, symbol)) return NULL;
    const YkForm *call = yk_equation_call(reader, symbol);
    reader->size = yk_equation_size_of(reader->d, symbol);
    return call || reader->failed ? call : yk_equation_meaning(reader->d, symbol);
}

// --- Numbers

static const YkForm *read_number(YkEquationReader *reader, size_t bytes)
{
    YkPlace place = reader->place;
    size_t start = reader->at;
    place.column += (uint32_t)start;
    const YkPoisson *value =
        yk_ring_read(reader->d->ring, YK_RING_TEXT, reader->text + start, bytes, place, reader->problems);
    reader->at += bytes;
    if (!value) reader->failed = true;
    reader->size = (YkEquationSize){.kind = YK_SIZE_BARE};
    return value ? read_unit(reader, form_of(reader, value)) : NULL;
}

// --- Functions

typedef enum Function { COS, SIN, TAN, SQRT, EXP, POW, NO_FUNCTION } Function;

static Function function_at(const YkEquationReader *reader, size_t start, size_t end)
{
    static const char *const words[] = {"cos", "sin", "tan", "sqrt", "exp", "pow"};
    size_t k = 0;
    while (k < NO_FUNCTION &&
           (strlen(words[k]) != end - start || strncmp(words[k], reader->text + start, end - start) != 0))
        k++;
    return (Function)k;
}

static const YkForm *root(YkEquationReader *reader, size_t start)
{
    YkRing *ring = reader->d->ring;
    int64_t over = 0, under = 1;
    const YkForm *square = yk_equation_bracket(reader);
    const YkPoisson *value = square ? yk_form_expand(ring, square, 100) : NULL, *of = NULL;
    if (!square) return NULL;
    if (value && yk_ring_is_rational(value, &over, &under) && under < 1000000 && over < INT64_MAX / under && over >= 0)
        of = yk_ring_sqrt(ring, over * under);
    reader->size = yk_equation_size_root(reader->size);
    if (of) return form_of(reader, yk_ring_scale(ring, of, 1, under));
    yk_ring_clear(ring);
    of = yk_equation_root(reader->d, value);
    if (of) return form_of(reader, of);
    yk_ring_clear(ring);
    return yk_equation_refuse(reader, start, "the root of a quotient by a sum cannot be read",
                              "square both sides: d^2 = ... for d = sqrt(...)");
}

// tan(x/2) = sin(x) / (1 + cos(x)): textbooks have half angles, whose cos and sin are not polynomials.
static const YkForm *half_tangent(YkEquationReader *reader, const YkPoisson *angle)
{
    YkRing *ring = reader->d->ring;
    const YkPoisson *unit = yk_ring_exp_of(ring, yk_ring_scale(ring, angle, 2, 1));
    yk_ring_clear(ring);
    if (!unit) return NULL;
    const YkPoisson *one = yk_ring_rational(ring, 1, 1), *under = yk_ring_add(ring, one, yk_ring_real(ring, unit));
    const YkForm *over = form_of(reader, yk_ring_imaginary(ring, unit));
    return yk_form_divide(ring, over, form_of(reader, under));
}

// Reads cos, sin, tan of an angle: a sum of whole multiples of angles and of fractions of pi, including 30 deg.
static const YkForm *trigonometric(YkEquationReader *reader, Function function)
{
    YkRing *ring = reader->d->ring;
    size_t start = reader->at + 1;
    const YkForm *angle = yk_equation_bracket(reader);
    const YkPoisson *a = angle ? yk_form_expand(ring, angle, 1000) : NULL, *unit = yk_ring_exp_of(ring, a);
    if (!angle || !yk_equation_size_is_angle(reader, start, reader->size)) return NULL;
    reader->size = (YkEquationSize){.kind = YK_SIZE_KNOWN};
    if (a && !unit) {
        yk_ring_clear(ring);
        const YkForm *half = function == TAN ? half_tangent(reader, a) : NULL;
        if (half) return half;
        unit = yk_equation_unit(reader->d, a);
    }
    if (!unit) {
        yk_ring_clear(ring);
        return yk_equation_refuse(reader, start, "an angle here is a polynomial of angles, parameters and t", NULL);
    }
    const YkForm *cos = form_of(reader, yk_ring_real(ring, unit)),
                 *sin = form_of(reader, yk_ring_imaginary(ring, unit));
    return function == COS ? cos : function == SIN ? sin : yk_form_divide(ring, sin, cos);
}

// Reads exp(...) and pow(...), as the ring prints them.
static const YkForm *ring_function(YkEquationReader *reader, size_t start)
{
    int depth = 0;
    size_t end = reader->at;
    YkPlace place = reader->place;
    do {
        depth += (reader->text[end] == '(') - (reader->text[end] == ')');
        end++;
    } while (end < reader->length && depth > 0);
    if (depth > 0) return yk_equation_refuse(reader, reader->at, "this bracket is never closed", NULL);
    place.column += (uint32_t)start;
    reader->at = end;
    const YkPoisson *a =
        yk_ring_read(reader->d->ring, YK_RING_TEXT, reader->text + start, end - start, place, reader->problems);
    if (!a) reader->failed = true;
    reader->size = (YkEquationSize){.kind = YK_SIZE_OPEN};
    return form_of(reader, a);
}

static const YkForm *no_bracket(YkEquationReader *reader, size_t start, size_t end)
{
    YkText message = {0}, hint = {0};
    const char *name = copy(reader, start, end);
    size_t next = name_end(reader, reader->at);
    yk_text_format(&message, "`(` is expected after `%s`", name);
    yk_text_format(&hint, "write %s(%s)", name, next > reader->at ? copy(reader, reader->at, next) : "theta1");
    yk_equation_refuse(reader, reader->at, yk_text_get(&message), yk_text_get(&hint));
    yk_text_free(&message);
    yk_text_free(&hint);
    return NULL;
}

// Reads sin(x), and sin^2(x) as in textbooks.
static const YkForm *read_function(YkEquationReader *reader, Function function, size_t start)
{
    size_t end = reader->at, power = 0;
    int exponent = 0;
    if (yk_equation_peek(reader) == '^' && function <= TAN) {
        power = ++reader->at;
        char c = yk_equation_peek(reader);
        if (c == '-')
            return yk_equation_refuse(reader, power, "a negative power here could be the inverse function",
                                      "write 1/sin(x); inverse functions cannot be proved: compare sin(x) itself");
        for (; yk_is_digit(yk_equation_peek(reader)) && exponent < 1000; reader->at++)
            exponent = 10 * exponent + (reader->text[reader->at] - '0');
        if (exponent < 1 || exponent > 32)
            return yk_equation_refuse(reader, power, "an exponent is a whole number here, up to 32", NULL);
    }
    if (yk_equation_peek(reader) != '(') return no_bracket(reader, start, end);
    const YkForm *value = function <= TAN    ? trigonometric(reader, function)
                          : function == SQRT ? root(reader, start)
                                             : ring_function(reader, start);
    const YkForm *product = value;
    if (exponent > 1) reader->size = yk_equation_size_power(reader->size, exponent);
    for (int k = 1; k < exponent; k++) product = yk_form_multiply(reader->d->ring, product, value);
    return product;
}

const YkForm *yk_equation_atom(YkEquationReader *reader)
{
    char c = yk_equation_peek(reader);
    size_t start = reader->at;
    if (c == '(' || c == '[') return yk_equation_bracket(reader);
    if (yk_begins_name(c)) {
        Function function = function_at(reader, start, name_end(reader, start));
        if (function == NO_FUNCTION) return read_name(reader);
        reader->at = name_end(reader, start);
        return read_function(reader, function, start);
    }
    double value;
    size_t bytes =
        yk_is_digit(c) || c == '.' ? yk_number_read(reader->text + start, reader->length - start, &value) : 0;
    if (bytes > 0) return read_number(reader, bytes);
    if (c == '\0') return yk_equation_refuse(reader, start, "the equation ends where a quantity is expected", NULL);
    if (c == '=') return yk_equation_refuse(reader, start, "a quantity is expected before `=`", NULL);
    if ((unsigned char)c >= 0x80)
        return yk_equation_refuse(reader, start, "this sign cannot be used in equations",
                                  "names are the file's; products `*` or a blank, minus `-`, rates theta1'");
    return yk_equation_refuse(reader, start, "a quantity is expected here",
                              "write products with `*` or a blank, powers with `^`");
}
