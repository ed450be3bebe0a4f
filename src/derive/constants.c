// Gives constants names of their own: those that are not polynomials of parameters, and numbers with many digits. With
// them, formulas would be hard to read, and products of a few too large to be exact.
#include <string.h>
#include "derive/inside.h"

// --- Constants that the ring cannot hold

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

static bool add(YkDerivation *d, YkDeriveConstant constant)
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
        if (*symbol < 0 || !add(d, (YkDeriveConstant){*symbol, expr, jet.d[0], NULL})) return NULL;
    }
    return yk_ring_of(d->ring, *symbol);
}

// --- Masses, inertias, stiffnesses and dampings of many digits

static bool is_short(const YkPoisson *a)
{
    enum { OVER_MAX = 1000, UNDER_MAX = 100 }; // of a fraction that is written in formulas itself
    int64_t over, under;
    return !yk_ring_is_rational(a, &over, &under) || (over <= OVER_MAX && over >= -OVER_MAX && under <= UNDER_MAX);
}

// Makes the constant letter_of, whose value is that of the expression.
static const YkPoisson *name_value(YkDerivation *d, const YkExpr *expr, const YkPoisson *exact, YkRingClass kind,
                                   const char *letter, const char *of)
{
    YkJet jet;
    YkText name = {0};
    if (yk_model_eval(d->model, expr, 0, &jet, NULL) != YK_OK) return exact;
    yk_text_format(&name, "%s_%s", letter, of);
    int32_t symbol = yk_derive_symbol(d, yk_text_get(&name), kind);
    yk_text_free(&name);
    const YkPoisson *named = symbol < 0 ? NULL : yk_ring_of(d->ring, symbol);
    if (!named || !add(d, (YkDeriveConstant){symbol, expr, jet.d[0], exact ? exact : named})) return NULL;
    yk_ring_set_number(d->ring, symbol, exact);
    return named;
}

const YkPoisson *yk_derive_measure(YkDerivation *d, const YkExpr *expr, YkRingClass kind, const char *letter,
                                   const char *body)
{
    const YkPoisson *exact = expr ? yk_derive_given(d, expr) : yk_ring_rational(d->ring, 0, 1);
    if (yk_ring_status(d->ring) != YK_RING_OK || (exact && is_short(exact))) return exact;
    return name_value(d, expr, exact, kind, letter, body);
}

const YkPoisson *yk_derive_strength(YkDerivation *d, const YkExpr *expr, const char *letter, const char *spring)
{
    const int64_t most = 1000000000; // 3 lbf/in is a fraction of 13 digits; products of a few such are too large
    int64_t over, under;
    const YkPoisson *exact = yk_derive_expression(d, expr), *number = exact;
    int32_t symbol = exact ? yk_ring_next_symbol(d->ring, exact, -1) : -1, power, highest; // pi, of stiffnesses per deg
    if (symbol >= 0 && symbol == yk_ring_find(d->ring, "pi") &&
        yk_ring_powers(d->ring, exact, symbol, &power, &highest))
        number = yk_ring_coefficient(d->ring, exact, symbol, power);
    if (!number || !yk_ring_is_rational(number, &over, &under)) return exact;
    if (over < most && over > -most && under < most) return exact;
    return name_value(d, expr, exact, YK_RING_CONSTANT, letter, spring);
}

// --- Enters them in the file's order, so that their names do not depend on what is asked for; a constant that the
// ring cannot hold fails where it is needed.

static bool has_call(const YkExpr *expr)
{
    if (!expr || expr->kind == YK_EXPR_NUMBER || expr->kind == YK_EXPR_NAME) return false;
    return expr->kind > YK_EXPR_MULTIPLY || has_call(expr->a) || has_call(expr->b);
}

static void enter_expression(YkDerivation *d, const YkExpr *expr)
{
    if (has_call(expr)) yk_derive_given(d, expr);
}

void yk_derive_enter_constants(YkDerivation *d)
{
    const YkModel *model = d->model;
    for (size_t p = 0; p < model->point_count; p++) {
        enter_expression(d, model->points[p].x);
        enter_expression(d, model->points[p].y);
    }
    for (size_t b = 1; b < model->body_count; b++) {
        enter_expression(d, model->bodies[b].center_x);
        enter_expression(d, model->bodies[b].center_y);
        yk_derive_mass(d, (int32_t)b);
        if (!yk_derive_is_rod(&model->bodies[b])) yk_derive_inertia(d, (int32_t)b);
    }
    for (size_t j = 0; j < model->joint_count; j++) {
        yk_derive_turn(d, model->joints[j].along_expr);
        yk_derive_forgive(d);
        yk_derive_turn(d, model->joints[j].turned_expr);
        yk_derive_forgive(d);
    }
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
