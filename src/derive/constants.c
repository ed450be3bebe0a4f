// Names constants that are not polynomials of parameters, and writes what all named constants mean.
#include <string.h>
#include "derive/inside.h"

static bool is_constant_name(void *context, const YkExpr *expr)
{
    const YkDerivation *d = context;
    return strcmp(expr->name, "pi") == 0 || yk_names_find(&d->model->parameter_names, expr->name) != YK_NONE;
}

static void look_for_variable(void *context, const YkExpr *expr)
{
    void **pair = context;
    if (!is_constant_name(pair[0], expr)) *(bool *)pair[1] = false;
}

static bool is_constant(YkDerivation *d, const YkExpr *expr)
{
    bool constant = true;
    void *pair[] = {d, &constant};
    yk_expr_names(expr, look_for_variable, pair);
    return constant;
}

bool yk_derive_add_constant(YkDerivation *d, YkDeriveConstant constant)
{
    if (!YK_ROOM(d->constants, d->constant_count, d->constant_capacity)) return !(d->failed = true);
    d->constants[d->constant_count++] = constant;
    return true;
}

const YkPoisson *yk_derive_constant(YkDerivation *d, const YkExpr *expr, bool is_angle, int32_t *symbol)
{
    YkJet jet;
    *symbol = -1;
    if (!is_constant(d, expr) || yk_model_eval(d->model, expr, 0, &jet, NULL) != YK_OK) return NULL;
    for (size_t i = 0; i < d->constant_count; i++)
        if (d->constants[i].expr == expr && yk_ring_is_angle(d->ring, d->constants[i].symbol) == is_angle)
            *symbol = d->constants[i].symbol;
    if (*symbol < 0) {
        YkText text = {0};
        yk_text_format(&text, "%s%z", is_angle ? "alpha_" : "k_", ++d->opaque_count[is_angle]);
        *symbol = is_angle ? yk_derive_angle(d, yk_text_get(&text))
                           : yk_derive_symbol(d, yk_text_get(&text), YK_RING_CONSTANT);
        yk_text_free(&text);
        if (*symbol < 0 || !yk_derive_add_constant(d, (YkDeriveConstant){*symbol, expr, jet.d[0], NULL})) return NULL;
    }
    return yk_ring_of(d->ring, *symbol);
}

// --- The meaning of the names

static const char *unit_of(const YkDerivation *d, const YkDeriveConstant *c)
{
    YkRingClass kind = yk_ring_symbol_class(d->ring, c->symbol);
    return kind == YK_RING_MASS ? " kg" : kind == YK_RING_INERTIA ? " kg*m^2" : "";
}

// Returns the double nearest to the exact value: products with units in floating point (90 * 1e-6) may be the one
// beside it, which is a number of 17 digits that no check can read.
static double shown(const YkDeriveConstant *c)
{
    const int64_t most = INT64_C(1) << 53;
    int64_t over, under;
    bool is_plain = c->exact && yk_ring_is_rational(c->exact, &over, &under);
    if (!is_plain || over > most || over < -most || under > most) return c->value;
    return (double)over / (double)under;
}

static void put_constant(YkDerivation *d, YkPage *page, const YkDeriveConstant *c)
{
    YkText place = {0}, value = {0};
    yk_text_format(&place, "line %d, column %d", c->expr->place.line, c->expr->place.column);
    yk_text_format(&value, "%g%s", shown(c), unit_of(d, c));
    YkLine *line = yk_page_formula(page, yk_text_get(&place));
    yk_line_element(page, line, yk_ring_of(d->ring, c->symbol), YK_RING_TEXTBOOK);
    yk_line_sign(page, line, "=");
    yk_line_words(page, line, yk_text_get(&value));
    page->failed |= place.failed || value.failed;
    yk_text_free(&place);
    yk_text_free(&value);
}

void yk_derive_put_constants(YkDerivation *d, YkPage *page, bool of_masses)
{
    size_t *told = &page->constants_told[of_masses];
    bool has_heading = false;
    for (; *told < d->constant_count; ++*told) {
        const YkDeriveConstant *c = &d->constants[*told];
        if ((c->exact != NULL) != of_masses) continue;
        if (!has_heading) yk_page_heading(page, 2, "Constants of the file");
        has_heading = true;
        put_constant(d, page, c);
    }
}
