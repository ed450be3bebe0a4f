// Shared by the parts of the section on cams: symbols made once, a segment's own variable, lines that hold in it.
#include "derive/cams/cams.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "derive/inside.h"
#include "elementary/elementary.h"

typedef struct YkDeriveOwn { // a symbol of the section
    const char *key;
    int32_t symbol;
    struct YkDeriveOwn *next;
} YkDeriveOwn;

int32_t yk_derive_once(YkDerivation *d, const char *key, const char *name, YkRingClass kind, bool is_angle,
                       bool *is_new)
{
    *is_new = false;
    for (const YkDeriveOwn *own = d->own; own; own = own->next)
        if (strcmp(own->key, key) == 0) return own->symbol;
    YkDeriveOwn *own = YK_NEW(d->arena, YkDeriveOwn, 1);
    const char *kept = own ? yk_arena_copy(d->arena, key, strlen(key)) : NULL;
    if (!kept) return -1;
    *is_new = true;
    *own = (YkDeriveOwn){kept, is_angle ? yk_derive_angle(d, name) : yk_derive_symbol(d, name, kind), d->own};
    d->own = own;
    return own->symbol;
}

const YkPoisson *yk_derive_once_root(YkDerivation *d, const char *key, const char *name, const YkPoisson *square)
{
    for (const YkDeriveOwn *own = d->own; own; own = own->next)
        if (strcmp(own->key, key) == 0) return yk_ring_of(d->ring, own->symbol);
    YkText fit = {0};
    yk_text_puts(&fit, name);
    while (yk_ring_find(d->ring, yk_text_get(&fit)) >= 0) yk_text_puts(&fit, "_");
    YkDeriveOwn *own = YK_NEW(d->arena, YkDeriveOwn, 1);
    const char *kept = yk_arena_copy(d->arena, key, strlen(key));
    if (own && kept && !fit.failed) {
        *own = (YkDeriveOwn){kept, yk_ring_root(d->ring, yk_text_get(&fit), square), d->own};
        d->own = own;
    }
    d->failed |= !own || !kept || fit.failed;
    yk_text_free(&fit);
    return d->failed ? NULL : yk_ring_of(d->ring, own->symbol);
}

static bool is_symbol(YkRing *ring, const YkPoisson *a)
{
    int32_t symbol = yk_ring_next_symbol(ring, a, -1);
    return symbol >= 0 && yk_ring_is_same(a, yk_ring_of(ring, symbol));
}

const YkPoisson *yk_derive_call(YkDeriveLaw *law, const char *stem, const YkPoisson *meaning)
{
    YkDerivation *d = law->d;
    YkText key = {0}, name = {0};
    bool is_new;
    if (!meaning || is_symbol(d->ring, meaning)) return meaning;
    yk_text_format(&key, "%s %z %s", law->law->name, law->index, stem);
    yk_text_format(&name, "%s%s", stem, law->ending);
    int32_t symbol = yk_derive_once(d, yk_text_get(&key), yk_text_get(&name), YK_RING_CONSTANT, false, &is_new);
    d->failed |= key.failed || name.failed;
    yk_text_free(&key);
    yk_text_free(&name);
    if (symbol < 0 || (is_new && !yk_derive_define(d, symbol, meaning))) return NULL;
    const YkPoisson *called = yk_ring_of(d->ring, symbol);
    yk_page_equation(law->page, NULL, called, meaning, YK_RING_TEXTBOOK);
    return called;
}

typedef struct Fixed {
    int32_t symbol;
    double value;
} Fixed;

static void fill_fixed(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    const Fixed *fixed = context;
    (void)state, (void)dynamics;
    values[fixed->symbol] = fixed->value;
}

int32_t yk_derive_cam_symbol(YkDerivation *d, const YkCam *cam, const char *stem, bool is_angle, bool *is_new)
{
    YkText key = {0}, name = {0};
    yk_text_format(&key, "cam %s %s", cam->name, stem);
    if (d->model->cam_count > 1)
        yk_text_format(&name, "%s_%s", stem, cam->name);
    else
        yk_text_puts(&name, stem);
    int32_t symbol = yk_derive_once(d, yk_text_get(&key), yk_text_get(&name), YK_RING_CONSTANT, is_angle, is_new);
    yk_text_free(&key);
    yk_text_free(&name);
    return symbol;
}

bool yk_derive_fix(YkDerivation *d, int32_t symbol, double value)
{
    Fixed *fixed = YK_NEW(d->arena, Fixed, 1);
    if (!fixed || symbol < 0) return false;
    *fixed = (Fixed){symbol, value};
    return yk_derive_add_source(d, fill_fixed, fixed);
}

double yk_derive_fixed(YkDerivation *d, const YkPoisson *a)
{
    double *values = yk_derive_scratch(d, yk_ring_symbol_count(d->ring) + 1, sizeof *values);
    if (!values) return NAN;
    for (size_t k = 0; k < d->model->parameter_count; k++) values[d->parameters[k]] = d->model->parameters[k].value;
    for (size_t k = 0; k < d->constant_count; k++) values[d->constants[k].symbol] = d->constants[k].value;
    yk_ring_complete(d->ring, values);
    for (size_t k = d->change_count - d->definition_count; k < d->change_count; k++)
        values[d->changes[k].symbol] = yk_ring_value(d->ring, d->changes[k].value, values).x;
    double value = yk_ring_value(d->ring, a, values).x;
    free(values);
    return value;
}

// --- A segment's own variable

typedef struct Local {
    const YkDerivation *d;
    const YkPoisson *theta;
    YkLawRange range;
    double from, to;
    bool is_backwards;
    int32_t u;
} Local;

static double within_period(const YkLawRange *range, double x)
{
    if (!(range->period > 0)) return x;
    double past = yk_fmod(x - range->from, range->period);
    return range->from + (past < 0 ? past + range->period : past);
}

static void fill(void *context, const YkState *state, YkDynamics *dynamics, double *values)
{
    const Local *local = context;
    (void)state, (void)dynamics;
    double x = within_period(&local->range, yk_ring_value(local->d->ring, local->theta, values).x);
    double part = local->is_backwards ? local->to - x : x - local->from;
    values[local->u] = part / (local->to - local->from);
}

static const YkPoisson *enter_u(YkDeriveLaw *law, double from, double to, bool is_backwards)
{
    YkDerivation *d = law->d;
    YkText key = {0}, name = {0};
    bool is_new;
    yk_text_format(&key, "%s %z u", law->law->name, law->index);
    yk_text_format(&name, "u%s", law->ending);
    int32_t u = yk_derive_once(d, yk_text_get(&key), yk_text_get(&name), YK_RING_COORDINATE, false, &is_new);
    d->failed |= key.failed || name.failed;
    yk_text_free(&key);
    yk_text_free(&name);
    if (u < 0) return NULL;
    if (is_new) {
        Local *local = YK_NEW(d->arena, Local, 1);
        if (!local) return NULL;
        *local = (Local){d, law->theta, yk_law_range(law->law->law), from, to, is_backwards, u};
        yk_derive_add_source(d, fill, local);
    }
    return yk_ring_of(d->ring, u);
}

// = (high - low) / length.
static void put_part(YkDeriveLaw *law, YkLine *line, const YkPoisson *high, const YkPoisson *low,
                     const YkPoisson *length)
{
    yk_line_sign(law->page, line, "=");
    if (yk_ring_is_zero(low)) {
        yk_line_quotient(law->page, line, high, length);
        return;
    }
    yk_line_sign(law->page, line, "(");
    yk_line_element(law->page, line, high, YK_RING_TEXTBOOK);
    yk_line_sign(law->page, line, "-");
    yk_line_factor(law->page, line, low);
    yk_line_sign(law->page, line, ")");
    yk_line_sign(law->page, line, "/");
    bool is_name = is_symbol(law->d->ring, length);
    if (!is_name) yk_line_sign(law->page, line, "(");
    yk_line_element(law->page, line, length, YK_RING_TEXTBOOK);
    if (!is_name) yk_line_sign(law->page, line, ")");
}

bool yk_derive_span(YkDeriveLaw *law, const YkPoisson *from, const YkPoisson *to, bool is_backwards, YkDeriveSpan *span)
{
    YkDerivation *d = law->d;
    YkLawSegment segment = yk_law_segment(law->law->law, law->index);
    *span = (YkDeriveSpan){.from = from, .to = to, .length = yk_ring_subtract(d->ring, to, from)};
    span->beta = yk_derive_call(law, "beta", span->length);
    span->u = enter_u(law, segment.from, segment.to, is_backwards);
    if (!span->beta || !span->u) return false;
    const YkPoisson *part =
        is_backwards ? yk_ring_subtract(d->ring, to, law->theta) : yk_ring_subtract(d->ring, law->theta, from);
    YkLine *line = yk_page_formula(law->page, NULL);
    yk_line_element(law->page, line, span->u, YK_RING_TEXTBOOK);
    const YkPoisson *high = is_backwards ? to : law->theta, *low = is_backwards ? law->theta : from;
    put_part(law, line, high, low, span->beta);
    if (!yk_ring_is_same(span->beta, span->length)) put_part(law, line, high, low, span->length);
    if (!line) return false;
    line->value = line->within = span->u;
    line->over = part, line->under = span->length;
    line->solved = yk_ring_next_symbol(d->ring, span->u, -1);
    return true;
}

// --- Lines

static bool has_angle(YkRing *ring, const YkPoisson *a)
{
    for (int32_t s = yk_ring_next_symbol(ring, a, -1); s >= 0; s = yk_ring_next_symbol(ring, a, s))
        if (yk_ring_is_angle(ring, s)) return true;
    return false;
}

static void put_powers(YkPage *page, YkLine *line, const YkPoisson *inside, int32_t u)
{
    YkRing *ring = page->ring;
    int32_t lowest, highest;
    bool any = false;
    if (!yk_ring_powers(ring, inside, u, &lowest, &highest)) return;
    for (int32_t k = lowest; k <= highest; k++) {
        const YkPoisson *coefficient = yk_ring_coefficient(ring, inside, u, k);
        if (yk_ring_is_zero(coefficient)) continue;
        const YkPoisson *term = yk_ring_multiply(ring, coefficient, yk_ring_power(ring, yk_ring_of(ring, u), k));
        bool is_negative = yk_page_is_negative(ring, term);
        if (any || is_negative) yk_line_sign(page, line, is_negative ? "-" : "+");
        yk_line_element(page, line, is_negative ? yk_ring_negate(ring, term) : term, YK_RING_TEXTBOOK);
        any = true;
    }
}

void yk_derive_put_bracket(YkPage *page, YkLine *line, const YkPoisson *factor, const YkPoisson *inside,
                           const YkPoisson *u)
{
    int64_t over, under;
    bool is_one = yk_ring_is_rational(factor, &over, &under) && over == 1 && under == 1;
    if (!is_one) yk_line_element(page, line, factor, YK_RING_TEXTBOOK);
    yk_line_sign(page, line, "[");
    if (yk_ring_is_zero(inside) || has_angle(page->ring, inside))
        yk_line_element(page, line, inside, YK_RING_TEXTBOOK);
    else
        put_powers(page, line, inside, yk_ring_next_symbol(page->ring, u, -1));
    yk_line_sign(page, line, "]");
}

YkLine *yk_derive_begin_line(YkDeriveLaw *law, int order, const char *remark)
{
    YkLine *line = yk_page_formula(law->page, remark);
    yk_line_element(law->page, line, order == 0 ? law->position : law->shown[order], YK_RING_TEXTBOOK);
    yk_line_sign(law->page, line, "=");
    return line;
}

void yk_derive_end_line(YkDeriveLaw *law, YkLine *line, int order, const YkPoisson *value, const YkPoisson *within,
                        const char *zone)
{
    YkRing *ring = law->d->ring;
    YkText target = {0};
    if (!line || !value) return;
    int32_t symbol = yk_ring_next_symbol(ring, law->shown[order], -1);
    yk_text_format(&target, "%s_%z%s", yk_ring_name_in(ring, symbol, YK_RING_C), law->index + 1, zone);
    line->left = law->shown[order], line->right = value;
    line->value = yk_derive_in_joints(law->d, value);
    line->within = within;
    line->target = yk_arena_copy(law->page->arena, yk_text_get(&target), target.length);
    law->page->failed |= target.failed || !line->target;
    yk_text_free(&target);
}
