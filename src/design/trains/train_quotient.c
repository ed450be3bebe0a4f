// Writes a quotient of polynomials in factored form: `1 + N1*N3/(N2*N4)` if a single product divides, otherwise
// `N1*(N2 + N3)/(N4*(N5 + N6))`.
//
// A polynomial f splits into factors without common variables exactly if, for u in one and v in the other,
// f f_uv = f_u f_v (Shpilka and Volkovich 2010). Tooth numbers rarely appear twice in a product, so this finds the
// factors of ratios.
#include <string.h>
#include "design/trains/train.h"
#include "ring/print/write.h"

enum { FACTORS_MAX = YK_TRAIN_FACTORS_MAX, TERMS_SPLIT_MAX = 200 };
typedef YkTrainFactors Factors;
typedef YkTrainQuotient Quotient;

static const YkPoisson *primitive(YkRing *ring, const YkPoisson *a)
{
    return yk_ring_divide(ring, a, yk_ring_content(ring, a));
}

// Returns whether u and v are in different factors of f.
static bool are_apart(YkRing *ring, const YkPoisson *f, int32_t u, int32_t v)
{
    const YkPoisson *f_u = yk_ring_partial(ring, f, u), *f_v = yk_ring_partial(ring, f, v);
    const YkPoisson *left = yk_ring_multiply(ring, f, yk_ring_partial(ring, f_u, v));
    return yk_ring_is_same(left, yk_ring_multiply(ring, f_u, f_v));
}

// Returns the factor with the variables of group `part`: f with small primes for all others, without its content.
static const YkPoisson *factor_of(YkRing *ring, const YkPoisson *f, const int32_t *variable, const int32_t *group,
                                  int32_t count, int32_t part)
{
    static const int64_t primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
    YkRingChange changes[FACTORS_MAX];
    for (int64_t attempt = 0; attempt < 8; attempt++) {
        size_t used = 0;
        for (int32_t k = 0; k < count; k++) {
            if (group[k] == part) continue;
            changes[used++] = (YkRingChange){
                .symbol = variable[k], .value = yk_ring_rational(ring, primes[(k * (attempt + 1) + attempt) % 10], 1)};
        }
        const YkPoisson *value = yk_ring_substitute(ring, f, changes, used);
        if (yk_ring_terms(value) > 0) return primitive(ring, value);
    }
    return NULL;
}

static void take_whole(Factors *factors, const YkPoisson *f)
{
    factors->items[0] = f;
    factors->count = 1;
}

// Groups the variables that are in one factor.
static int32_t group_variables(YkRing *ring, const YkPoisson *f, int32_t *variable, int32_t *group)
{
    int32_t count = 0;
    for (int32_t s = 0; s < (int32_t)yk_ring_symbol_count(ring) && count < FACTORS_MAX; s++)
        if (yk_ring_mentions(ring, f, s)) variable[count++] = s;
    for (int32_t k = 0; k < count; k++) group[k] = k;
    for (int32_t a = 0; a < count; a++) {
        for (int32_t b = a + 1; b < count; b++) {
            int32_t old = group[b];
            if (group[a] == old || are_apart(ring, f, variable[a], variable[b])) continue;
            for (int32_t k = 0; k < count; k++)
                if (group[k] == old) group[k] = group[a];
        }
    }
    return count;
}

// Splits a primitive f: the product of the factors is f or -f.
static void split(YkRing *ring, const YkPoisson *f, Factors *factors)
{
    int32_t variable[FACTORS_MAX], group[FACTORS_MAX];
    if (yk_ring_terms(f) < 4 || yk_ring_terms(f) > TERMS_SPLIT_MAX) {
        take_whole(factors, f);
        return;
    }
    int32_t count = group_variables(ring, f, variable, group);
    for (int32_t part = 0; part < count; part++) {
        bool is_part = false;
        for (int32_t k = 0; k < count; k++) is_part |= group[k] == part;
        if (is_part) factors->items[factors->count++] = factor_of(ring, f, variable, group, count, part);
    }
    const YkPoisson *product = yk_ring_product(ring, factors->items, (size_t)factors->count);
    if (yk_ring_is_same(product, f)) return;
    factors->is_negative = yk_ring_is_same(yk_ring_negate(ring, product), f);
    if (!factors->is_negative) take_whole(factors, f);
}

static void drop(Factors *factors, int32_t index)
{
    factors->items[index] = factors->items[--factors->count];
}

// Cancels factors that are above and below; their sign stays in the content.
static void cancel(Quotient *q)
{
    for (int32_t a = 0; a < q->over.count; a++) {
        for (int32_t b = 0; b < q->under.count; b++) {
            bool is_same = yk_ring_is_same(q->over.items[a], q->under.items[b]);
            bool is_opposite =
                !is_same && yk_ring_is_same(q->over.items[a], yk_ring_negate(q->ring, q->under.items[b]));
            if (!is_same && !is_opposite) continue;
            if (is_opposite) q->content = yk_ring_negate(q->ring, q->content);
            drop(&q->over, a--);
            drop(&q->under, b);
            break;
        }
    }
}

// Turns the sign of factors that would begin with a minus, and drops those that are 1.
static void smooth(Quotient *q, Factors *factors)
{
    YkText text = {0};
    for (int32_t k = 0; k < factors->count; k++) {
        int64_t over, under;
        yk_text_clear(&text);
        if (yk_ring_is_rational(factors->items[k], &over, &under)) { // primitive: 1 or -1
            if (over < 0) q->content = yk_ring_negate(q->ring, q->content);
            drop(factors, k--);
        } else if (yk_ring_write(q->ring, factors->items[k], YK_RING_TEXT, YK_RING_EXPANDED, &text) &&
                   yk_text_get(&text)[0] == '-') {
            factors->items[k] = yk_ring_negate(q->ring, factors->items[k]);
            q->content = yk_ring_negate(q->ring, q->content);
        }
    }
    if (text.failed) yk_ring_fail(q->ring, YK_RING_MEMORY);
    yk_text_free(&text);
}

// Returns the part of a single term above (sign +1) or below (-1) the line: a whole number times symbols.
static const YkPoisson *part_of(YkRing *ring, const YkPoisson *term, int32_t sign)
{
    const YkPoisson *symbols = yk_ring_rational(ring, 1, 1), *rest = term;
    int64_t over = 1, under = 1;
    for (int32_t s = 0; s < (int32_t)yk_ring_symbol_count(ring); s++) {
        int32_t low = 0, high = 0;
        if (!yk_ring_powers(ring, term, s, &low, &high) || low == 0) continue;
        rest = yk_ring_divide(ring, rest, yk_ring_power(ring, yk_ring_of(ring, s), low));
        if (low * sign > 0)
            symbols = yk_ring_multiply(ring, symbols, yk_ring_power(ring, yk_ring_of(ring, s), low * sign));
    }
    if (!yk_ring_is_rational(rest, &over, &under)) return NULL;
    return yk_ring_scale(ring, symbols, sign > 0 ? over : under, 1);
}

// Writes a product, with brackets where they are needed. Returns the number of its factors.
static int write_product(const Quotient *q, const YkPoisson *content, const Factors *factors, YkText *text)
{
    int64_t over = 0, under = 1;
    bool is_number = yk_ring_is_rational(content, &over, &under);
    bool is_alone = factors->count == 1 && is_number && over == 1,
         is_one = is_number && over == 1 && factors->count > 0;
    int count = 0;
    if (is_number && over == -1 && factors->count > 0) {
        yk_text_puts(text, "-");
    } else if (!is_one) {
        if (!yk_ring_write(q->ring, content, YK_RING_TEXT, YK_RING_EXPANDED, text)) return 0;
        count++;
        if (!is_number && strchr(yk_text_get(text), '*')) count++;
    }
    for (int32_t k = 0; k < factors->count; k++) {
        bool needs_brackets = !is_alone && yk_ring_terms(factors->items[k]) > 1;
        if (count > 0) yk_text_puts(text, "*");
        if (needs_brackets) yk_text_puts(text, "(");
        if (!yk_ring_write(q->ring, factors->items[k], YK_RING_TEXT, YK_RING_EXPANDED, text)) return 0;
        if (needs_brackets) yk_text_puts(text, ")");
        count += is_alone && yk_ring_terms(factors->items[k]) > 1 ? 2 : 1;
    }
    return count;
}

const YkPoisson *yk_train_quotient_term(const YkTrainQuotient *q, bool is_above)
{
    return part_of(q->ring, q->content, is_above ? 1 : -1);
}

static bool write_fraction(const Quotient *q, YkText *text)
{
    YkText over = {0}, under = {0};
    const YkPoisson *above = yk_train_quotient_term(q, true), *below = yk_train_quotient_term(q, false);
    int above_count = write_product(q, above, &q->over, &over),
        below_count = write_product(q, below, &q->under, &under);
    int64_t top = 0, bottom = 1;
    bool is_sum = q->over.count == 1 && yk_ring_terms(q->over.items[0]) > 1 &&
                  yk_ring_is_rational(above, &top, &bottom) && top == 1;
    bool good = above && below && above_count > 0 && below_count > 0;
    if (good) {
        yk_text_format(text, is_sum ? "(%s)" : "%s", yk_text_get(&over));
        yk_text_format(text, below_count > 1 ? "/(%s)" : "/%s", yk_text_get(&under));
    }
    if (over.failed || under.failed) yk_text_fail(text);
    yk_text_free(&over);
    yk_text_free(&under);
    return good && !text->failed;
}

const YkPoisson *yk_train_quotient_sum(const YkTrainQuotient *q)
{
    if (q->under.count > 0) return NULL;
    const YkPoisson *over = yk_ring_product(q->ring, q->over.items, (size_t)q->over.count);
    if (q->over.count == 0) over = yk_ring_rational(q->ring, 1, 1);
    return q->over.count <= 1 || yk_ring_terms(over) <= 4 ? yk_ring_multiply(q->ring, over, q->content) : NULL;
}

bool yk_train_write_quotient(const YkTrainQuotient *q, YkText *text)
{
    const YkPoisson *sum = yk_train_quotient_sum(q);
    if (!sum) return write_fraction(q, text);
    return yk_ring_write(q->ring, sum, YK_RING_TEXT, YK_RING_EXPANDED, text) && !text->failed;
}

bool yk_train_quotient(YkRing *ring, const YkPoisson *over, const YkPoisson *under, YkTrainQuotient *q)
{
    *q = (Quotient){.ring = ring};
    const YkPoisson *content_over = yk_ring_content(ring, over), *content_under = yk_ring_content(ring, under);
    q->content = yk_ring_divide(ring, content_over, content_under);
    split(ring, yk_ring_divide(ring, over, content_over), &q->over);
    split(ring, yk_ring_divide(ring, under, content_under), &q->under);
    if (q->over.is_negative != q->under.is_negative) q->content = yk_ring_negate(ring, q->content);
    cancel(q);
    smooth(q, &q->over);
    smooth(q, &q->under);
    return yk_ring_status(ring) == YK_RING_OK;
}
