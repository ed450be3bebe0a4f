// Values of loads: elements of the ring if they are polynomials, otherwise symbols with formulas beside them.
#include "derive/forces/free_bodies.h"
#include "model/formulas.h"

typedef struct Variables {
    const YkDerivation *d;
    YkDeriveOpaque *opaque;
} Variables;

static int entry_of(YkDeriveOpaque *opaque, int32_t symbol)
{
    for (size_t k = 1; k < opaque->variable_count; k++)
        if (opaque->variables[k] == symbol) return (int)k;
    opaque->variables[opaque->variable_count] = symbol;
    return (int)opaque->variable_count++;
}

static int variable_of(void *context, int32_t declared, bool is_rate)
{
    Variables *v = context;
    if (declared == YK_NONE) return entry_of(v->opaque, v->d->spring[is_rate]);
    const YkCoordinate *c = &v->d->model->coordinates[declared];
    int32_t index = c->is_distance ? v->d->joint_distance[c->joint] : v->d->joint_angle[c->joint];
    if (index == YK_NONE) return -2;
    const YkDeriveCoordinate *of = &v->d->coordinates[index];
    return entry_of(v->opaque, is_rate ? of->rate : of->position);
}

static const YkPoisson *opaque(YkDeriveForces *f, const YkExpr *expr, const YkLaw *law, const char *name)
{
    YkDerivation *d = f->d;
    YkDeriveOpaque *o = &f->opaques[f->opaque_count++];
    *o = (YkDeriveOpaque){.expr = expr, .law = law, .symbol = yk_derive_symbol(d, name, YK_RING_FORCE)};
    o->variables = YK_NEW(d->arena, int32_t, 2 * d->coordinate_count + 3);
    if (!o->variables || o->symbol < 0) return NULL;
    o->variables[o->variable_count++] = d->time;
    o->formula = yk_model_formula(d->model, expr, variable_of, &(Variables){d, o}, d->arena);
    if (!o->formula) d->failed = true;
    return yk_ring_of(d->ring, o->symbol);
}

const YkPoisson *yk_derive_load_value(YkDeriveForces *f, const YkStrength *strength, const char *name,
                                      const char *ending)
{
    YkRing *ring = f->d->ring;
    const YkExpr *expr = strength->expr;
    const YkLaw *law = expr && strength->law != YK_NONE ? f->d->model->laws[strength->law].law : NULL;
    const YkPoisson *value = law ? NULL : yk_derive_expression(f->d, expr);
    if (value || (yk_ring_status(ring) != YK_RING_OK && yk_ring_status(ring) != YK_RING_DIVISOR)) return value;
    yk_ring_clear(ring); // no polynomial
    return opaque(f, expr, law, yk_derive_text(f->d, name, ending, ""));
}

// --- The meaning of the symbols

static const char *law_name(const YkDerivation *d, const YkLaw *law)
{
    for (size_t k = 0; k < d->model->law_count; k++)
        if (d->model->laws[k].law == law) return d->model->laws[k].name;
    return "";
}

// "t", "theta1, theta1'": what the value depends on.
static const char *variables_of(YkDerivation *d, const YkDeriveOpaque *o)
{
    const char *list = "";
    for (size_t k = 1; k < o->variable_count; k++)
        list = yk_derive_text(d, list, *list ? ", " : "", yk_ring_symbol_name(d->ring, o->variables[k]));
    return *list ? list : "t";
}

void yk_derive_put_loads(const YkDeriveForces *f, YkPage *page)
{
    YkDerivation *d = f->d;
    for (size_t k = 0; k < f->opaque_count; k++) {
        const YkDeriveOpaque *o = &f->opaques[k];
        const char *name = yk_ring_symbol_name(d->ring, o->symbol), *of = variables_of(d, o);
        if (o->law)
            yk_page_words(page, "%s is what the law %s gives, a function of %s.", name, law_name(d, o->law), of);
        else
            yk_page_words(page, "%s stands for the file's expression, a function of %s.", name, of);
    }
    for (size_t k = 0; k < f->load_count; k++)
        if (f->loads[k].kind == YK_DERIVE_DRY)
            yk_page_words(page,
                          "%s is what dry friction or a stop at %s exerts: it holds, or reaches its limit, as the "
                          "motion requires.",
                          yk_ring_symbol_name(d->ring, f->loads[k].symbol), f->loads[k].name);
}
