// Multiplies structured forms out, and evaluates them in numbers and in the prime field. Visits every node once.
#include <stdlib.h>
#include "ring/proof/form_inside.h"

enum { NODE = 20 }; // work of visiting one

typedef enum Way { EXPAND, FIELD, DOUBLE } Way;

// The result for a node.
typedef struct Result {
    bool known;
    const YkPoisson *element;
    uint64_t field;
    YkVec value;
    double magnitude; // scale of rounding errors in the value
} Result;

typedef struct Walk {
    YkRing *ring;
    Way way;
    const YkFieldPoint *point;
    const double *values;
    Result *results; // [root's number - first + 1]
    size_t first;    // the lowest number of the graph
} Walk;

static Result of_element(const Walk *walk, const YkPoisson *a)
{
    Result result = {.known = true};
    if (walk->way == EXPAND) result.element = a;
    if (walk->way == DOUBLE) {
        result.value = yk_ring_value(walk->ring, a, walk->values);
        result.magnitude = yk_ring_magnitude(walk->ring, a, walk->values);
    }
    if (walk->way == FIELD) result.field = yk_ring_field(walk->ring, a, walk->point, false);
    return result;
}

static Result add(const Walk *walk, Result a, Result b)
{
    if (walk->way == EXPAND) a.element = yk_ring_add(walk->ring, a.element, b.element);
    a.value = yk_add(a.value, b.value);
    a.magnitude += b.magnitude;
    a.field = yk_field_add(a.field, b.field);
    return a;
}

static Result multiply(const Walk *walk, Result a, Result b)
{
    if (walk->way == EXPAND) a.element = yk_ring_multiply(walk->ring, a.element, b.element);
    a.value = yk_mul(a.value, b.value);
    a.magnitude *= b.magnitude;
    a.field = yk_field_multiply(a.field, b.field);
    return a;
}

static Result divide(const Walk *walk, Result a, Result b)
{
    if (walk->way == EXPAND) a.element = yk_ring_divide(walk->ring, a.element, b.element);
    if (walk->way == DOUBLE) {
        double size = yk_dot(b.value, b.value);
        a.value = yk_mul(a.value, yk_vec(b.value.x / size, -b.value.y / size));
        a.magnitude *= b.magnitude / size;
    }
    if (walk->way == FIELD) {
        a.known = b.field != 0;
        a.field = yk_field_multiply(a.field, yk_field_invert(b.field));
    }
    return a;
}

// Combines the results of all parts, which are known.
static Result of_parts(const Walk *walk, const YkForm *form)
{
    if (form->kind == YK_FORM_ELEMENT) return of_element(walk, form->element);
    Result a = walk->results[form->parts[0]->number - walk->first],
           b = walk->results[form->parts[1]->number - walk->first];
    if (form->kind == YK_FORM_QUOTIENT) return divide(walk, a, b);
    return form->kind == YK_FORM_PRODUCT ? multiply(walk, a, b) : add(walk, a, b);
}

static bool visit(const Walk *walk, const YkForm *form)
{
    Result *result = &walk->results[form->number - walk->first];
    if (result->known) return true;
    if (!yk_ring_spend(walk->ring, NODE)) return false;
    for (size_t i = 0; i < form->count; i++)
        if (!visit(walk, form->parts[i])) return false;
    *result = of_parts(walk, form);
    if (walk->way == EXPAND && !result->element) result->known = false;
    return result->known;
}

// Visits the whole graph; returns false on failure. *result is the root's.
static bool run(Walk *walk, const YkForm *form, Result *result)
{
    if (!form) return false;
    walk->first = form->least;
    walk->results = calloc(form->number - form->least + 1, sizeof *walk->results);
    if (!walk->results) return yk_ring_fail(walk->ring, YK_RING_MEMORY) != NULL;
    bool well = visit(walk, form);
    *result = walk->results[form->number - walk->first];
    free(walk->results);
    return well;
}

const YkPoisson *yk_form_expand(YkRing *ring, const YkForm *form, size_t terms)
{
    Walk walk = {.ring = ring, .way = EXPAND};
    Result result = {0};
    size_t limit = ring->limit;
    if (terms < limit) yk_ring_set_limit(ring, terms);
    bool well = run(&walk, form, &result);
    ring->limit = limit;
    return well ? result.element : NULL;
}

bool yk_form_field(YkRing *ring, const YkForm *form, const YkFieldPoint *point, uint64_t *value)
{
    Walk walk = {.ring = ring, .way = FIELD, .point = point};
    Result result = {0};
    bool well = run(&walk, form, &result);
    *value = result.field;
    return well;
}

YkVec yk_form_value(YkRing *ring, const YkForm *form, const double *values)
{
    Walk walk = {.ring = ring, .way = DOUBLE, .values = values};
    Result result = {0};
    return run(&walk, form, &result) ? result.value : yk_vec(NAN, NAN);
}

double yk_form_magnitude(YkRing *ring, const YkForm *form, const double *values)
{
    Walk walk = {.ring = ring, .way = DOUBLE, .values = values};
    Result result = {0};
    return run(&walk, form, &result) ? result.magnitude : NAN;
}

// Compares at one point: 1 equal, 0 different, -1 no value there.
static int compare_at(YkRing *ring, const YkForm *a, const YkForm *b, const YkFieldPoint *point)
{
    uint64_t left, right;
    int verdict = -1;
    if (point && yk_form_field(ring, a, point, &left) && yk_form_field(ring, b, point, &right)) verdict = left == right;
    return verdict == 0 && yk_field_point_is_loose(point) ? -1 : verdict;
}

YkFormVerdict yk_form_compare_at(YkRing *ring, const YkForm *a, const YkForm *b, int points, YkFieldPoints *kept)
{
    enum { SPARE = 4 };
    int agreed = 0;
    for (int i = 0; i < points + SPARE && agreed < points; i++) {
        int verdict = a && b ? compare_at(ring, a, b, yk_field_points_get(kept, (size_t)i)) : -1;
        if (verdict == 0) return YK_FORM_DIFFERENT;
        agreed += verdict == 1;
    }
    return agreed == points ? YK_FORM_EQUAL : YK_FORM_UNDECIDED;
}
