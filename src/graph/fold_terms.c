// Sums of products that are less than they seem: multiples of the same factors, and the squares of a unit vector's two
// parts. Vectors that turn with one body are full of them: a gear's teeth, its arms and its accelerations all have the
// direction of the line of centres, so that products of the two fold to numbers.
#include <float.h>
#include <math.h>
#include "graph/graph.h"

enum { FACTORS = 6 };
static const double ALMOST = 4 * DBL_EPSILON; // coefficients that differ by less were rounded on different ways

typedef struct Product { // number times factors, which ascend
    double number;
    size_t count;
    YkRef factor[FACTORS];
} Product;

static const YkValue *at(const YkGraph *g, YkRef value)
{
    return &g->values[value];
}

// Multiplies by a value. Returns false if there are too many factors.
static bool take(const YkGraph *g, YkRef value, Product *p)
{
    const YkValue *v = at(g, value);
    if (v->op == YK_VALUE_NUMBER || v->op == YK_VALUE_MINUS) p->number *= v->op == YK_VALUE_MINUS ? -1 : v->number;
    if (v->op == YK_VALUE_NUMBER) return true;
    if (v->op == YK_VALUE_MINUS) return take(g, v->a, p);
    if (v->op == YK_VALUE_MULTIPLY) return take(g, v->a, p) && take(g, v->b, p);
    if (p->count == FACTORS) return false;
    size_t k = p->count++;
    for (; k > 0 && p->factor[k - 1] > value; k--) p->factor[k] = p->factor[k - 1];
    p->factor[k] = value;
    return true;
}

// Multiplies squares first, which are likely to exist.
static YkRef product_of(YkGraph *g, const Product *p)
{
    YkRef value = YK_NONE;
    for (size_t k = 0; k < p->count; k++) {
        YkRef next = p->factor[k];
        if (k + 1 < p->count && p->factor[k + 1] == next) next = yk_graph_multiply(g, next, p->factor[++k]);
        value = value == YK_NONE ? next : yk_graph_multiply(g, value, next);
    }
    YkRef number = yk_graph_number(g, p->number);
    return p->count == 0 || p->number == 0 ? number : yk_graph_multiply(g, number, value);
}

static bool is_almost(double a, double b)
{
    return fabs(a - b) <= ALMOST * fabs(a);
}

static bool have_same_factors(const Product *a, const Product *b)
{
    bool same = a->count == b->count && a->count > 0;
    for (size_t k = 0; same && k < a->count; k++) same = a->factor[k] == b->factor[k];
    return same;
}

// Removes from each product what both contain.
static void remove_common(Product *a, Product *b, Product *common)
{
    Product left = {a->number, 0, {0}}, right = {b->number, 0, {0}};
    size_t i = 0, k = 0;
    *common = (Product){1, 0, {0}};
    while (i < a->count || k < b->count) {
        if (i < a->count && k < b->count && a->factor[i] == b->factor[k]) {
            common->factor[common->count++] = a->factor[i];
            i++, k++;
        } else if (k == b->count || (i < a->count && a->factor[i] < b->factor[k])) {
            left.factor[left.count++] = a->factor[i++];
        } else {
            right.factor[right.count++] = b->factor[k++];
        }
    }
    *a = left, *b = right;
}

static bool is_square(const Product *p)
{
    return p->count == 2 && p->factor[0] == p->factor[1];
}

// Adds k s^2 x to k c^2 x, where c and s are the parts of a unit vector. Returns false for anything else.
static bool add_squares(const YkGraph *g, Product *a, Product b)
{
    if (a->count != b.count || a->count < 2 || !is_almost(a->number, b.number)) return false;
    Product own = *a, common;
    remove_common(&own, &b, &common);
    if (!is_square(&own) || !is_square(&b)) return false;
    if (at(g, own.factor[0])->sine != b.factor[0] && at(g, b.factor[0])->sine != own.factor[0]) return false;
    common.number = a->number;
    *a = common;
    return true;
}

// Adds b to a if they are multiples of the same factors, or squares. Returns whether they are.
static bool add_product(const YkGraph *g, Product *a, Product b)
{
    if (!have_same_factors(a, &b)) return add_squares(g, a, b);
    a->number = is_almost(a->number, -b.number) ? 0 : a->number + b.number;
    return true;
}

static bool is_sum(const YkGraph *g, YkRef value)
{
    return at(g, value)->op == YK_VALUE_ADD || at(g, value)->op == YK_VALUE_SUBTRACT;
}

// --- products of sums

enum { TERMS = 8 };
typedef struct Terms {
    size_t count;
    Product term[TERMS];
} Terms;

static size_t find_sum(const YkGraph *g, const Product *p)
{
    size_t k = 0;
    while (k < p->count && !is_sum(g, p->factor[k])) k++;
    return k;
}

// Adds the terms of a product, whose factors may be sums. Returns false if there are too many.
static bool expand(const YkGraph *g, const Product *p, Terms *out)
{
    size_t k = find_sum(g, p);
    if (out->count == TERMS) return false;
    if (k == p->count) {
        out->term[out->count++] = *p;
        return true;
    }
    const YkValue *sum = at(g, p->factor[k]);
    Product one = *p, other;
    one.count--;
    for (; k < one.count; k++) one.factor[k] = one.factor[k + 1];
    other = one;
    if (sum->op == YK_VALUE_SUBTRACT) other.number = -other.number;
    return take(g, sum->a, &one) && take(g, sum->b, &other) && expand(g, &one, out) && expand(g, &other, out);
}

static void collect(const YkGraph *g, Terms *t)
{
    for (size_t i = 0; i < t->count; i++)
        for (size_t k = i + 1; k < t->count;) {
            if (!add_product(g, &t->term[i], t->term[k])) {
                k++;
                continue;
            }
            t->term[k] = t->term[--t->count];
            k = i + 1;
        }
    size_t left = 0;
    for (size_t i = 0; i < t->count; i++)
        if (t->term[i].number != 0) t->term[left++] = t->term[i];
    t->count = left;
}

// Returns whether a part of a unit vector is a factor of the product. In long products without one little can vanish.
static bool has_unit(const YkGraph *g, const Product *p)
{
    for (size_t k = 0; k < p->count; k++)
        if (at(g, p->factor[k])->sine != 0) return true;
    return false;
}

// Returns the sum of two products with sums as factors, multiplied out, if no more than two terms are left and as many
// vanish: as where an arm's moment of its own inertia becomes a multiple of its angular acceleration.
static YkRef join_expanded(YkGraph *g, const Product *p, const Product *q)
{
    Terms t;
    if (find_sum(g, p) == p->count || find_sum(g, q) == q->count) return YK_NONE;
    if (p->count > 1 && q->count > 1 && !(has_unit(g, p) && has_unit(g, q))) return YK_NONE;
    t.count = 0;
    if (!expand(g, p, &t) || !expand(g, q, &t)) return YK_NONE;
    size_t before = t.count;
    collect(g, &t);
    if (t.count > 2 || 2 * t.count > before) return YK_NONE;
    YkRef sum = yk_graph_number(g, 0);
    for (size_t k = 0; k < t.count; k++) sum = yk_graph_add(g, sum, product_of(g, &t.term[k]));
    return sum;
}

// --- sums

// Returns the only factor that is a part of a unit vector; YK_NONE if there is none, or more than one.
static YkRef direction_of(const YkGraph *g, const Product *p)
{
    YkRef found = YK_NONE;
    for (size_t k = 0; k < p->count; k++) {
        if (at(g, p->factor[k])->sine == 0) continue;
        if (found != YK_NONE) return YK_NONE;
        found = p->factor[k];
    }
    return found;
}

// Returns the sum of two products along one direction as a product with a sum, which other components share: YK_NONE
// if they are along none, or along two.
static YkRef join_along(YkGraph *g, const Product *p, const Product *q)
{
    YkRef direction = g->shares_signs ? direction_of(g, p) : YK_NONE;
    if (direction == YK_NONE || direction_of(g, q) != direction) return YK_NONE;
    Product one = *p, other = *q, common;
    remove_common(&one, &other, &common);
    YkRef sum = yk_graph_add(g, product_of(g, &one), product_of(g, &other));
    return yk_graph_multiply(g, product_of(g, &common), sum);
}

// Returns a + sign b in a simpler form; YK_NONE if there is none.
static YkRef join(YkGraph *g, YkRef a, YkRef b, double sign)
{
    Product p = {1, 0, {0}}, q = {sign, 0, {0}};
    if (!take(g, a, &p) || !take(g, b, &q)) return YK_NONE;
    if (p.count == 0 && q.count == 0)
        return yk_graph_number(g, is_almost(p.number, -q.number) ? 0 : p.number + q.number);
    if (add_product(g, &p, q)) return product_of(g, &p);
    YkRef joined = join_expanded(g, &p, &q);
    return joined != YK_NONE ? joined : join_along(g, &p, &q);
}

// Looks for a term of a sum that b joins. depth: how many sums within each other are searched.
static YkRef join_within(YkGraph *g, YkRef a, YkRef b, double sign, int depth)
{
    YkRef joined = join(g, a, b, sign);
    if (joined != YK_NONE || !is_sum(g, a) || depth == 0) return joined;
    YkValue sum = *at(g, a);
    double own = sum.op == YK_VALUE_ADD ? 1 : -1;
    if ((joined = join_within(g, sum.b, b, own * sign, depth - 1)) != YK_NONE)
        return own > 0 ? yk_graph_add(g, sum.a, joined) : yk_graph_subtract(g, sum.a, joined);
    if ((joined = join_within(g, sum.a, b, sign, depth - 1)) != YK_NONE)
        return own > 0 ? yk_graph_add(g, joined, sum.b) : yk_graph_subtract(g, joined, sum.b);
    return YK_NONE;
}

enum { DEPTH = 4 };

YkRef yk_graph_join(YkGraph *g, YkRef a, YkRef b, double sign)
{
    if (!g->joins_terms) return YK_NONE;
    YkRef joined = join_within(g, a, b, sign, DEPTH);
    if (joined != YK_NONE || !is_sum(g, b)) return joined;
    joined = join_within(g, b, a, sign, DEPTH); // sign (b + sign a) = a + sign b
    return joined == YK_NONE || sign > 0 ? joined : yk_graph_minus(g, joined);
}

// --- products

// Returns whether a value is 1 over another one, which is never 0.
static bool is_inverse(const YkGraph *g, YkRef value)
{
    return at(g, value)->op == YK_VALUE_DIVIDE && at(g, at(g, value)->a)->op == YK_VALUE_NUMBER;
}

static void drop(Product *p, size_t k)
{
    p->count--;
    for (; k < p->count; k++) p->factor[k] = p->factor[k + 1];
}

// Removes an inverse that is a factor of both.
static bool drop_inverse(const YkGraph *g, Product *p, Product *q)
{
    for (size_t i = 0; i < p->count; i++)
        for (size_t k = 0; k < q->count; k++) {
            if (p->factor[i] != q->factor[k] || !is_inverse(g, p->factor[i])) continue;
            drop(p, i);
            drop(q, k);
            return true;
        }
    return false;
}

YkRef yk_graph_cancel(YkGraph *g, YkRef value, YkRef quotient)
{
    YkValue v = *at(g, quotient);
    Product p = {1, 0, {0}}, q = {1, 0, {0}};
    if (!g->joins_terms || v.op != YK_VALUE_DIVIDE || !take(g, value, &p) || !take(g, v.b, &q)) return YK_NONE;
    if (!drop_inverse(g, &p, &q)) return YK_NONE;
    YkRef left = product_of(g, &p), rest = yk_graph_divide(g, v.a, product_of(g, &q));
    return yk_graph_multiply(g, left, rest);
}

// Returns whether a value is a number, or a multiple of something.
static bool is_multiple(const YkGraph *g, YkRef value)
{
    const YkValue *v = at(g, value);
    return v->op == YK_VALUE_NUMBER ||
           (v->op == YK_VALUE_MULTIPLY && (at(g, v->a)->op == YK_VALUE_NUMBER || at(g, v->b)->op == YK_VALUE_NUMBER));
}

// Returns whether all terms of a sum are multiples or numbers; of sums within it only where a number follows.
static bool has_multiples(const YkGraph *g, YkRef sum, bool within)
{
    const YkValue *v = at(g, sum);
    if (!is_sum(g, sum) || !is_multiple(g, v->b)) return false;
    return is_multiple(g, v->a) || (within && at(g, v->b)->op == YK_VALUE_NUMBER && has_multiples(g, v->a, false));
}

// A number times p x + q is (number p) x + number q: as many operations, and other such sums may join it. Where signs
// are shared, so is p x + q y, which costs an operation only if something else needs that sum as well.
static YkRef multiply_out(YkGraph *g, YkRef number, YkRef sum)
{
    YkValue v = *at(g, sum);
    if (!has_multiples(g, sum, g->shares_signs)) return YK_NONE;
    if (!g->shares_signs && at(g, v.a)->op != YK_VALUE_NUMBER && at(g, v.b)->op != YK_VALUE_NUMBER) return YK_NONE;
    YkRef a = yk_graph_multiply(g, number, v.a), b = yk_graph_multiply(g, number, v.b);
    return v.op == YK_VALUE_ADD ? yk_graph_add(g, a, b) : yk_graph_subtract(g, a, b);
}

// A product of two numbers that ought to be 1 is rounded to it.
YkRef yk_graph_join_numbers(YkGraph *g, YkRef number, YkRef product)
{
    const YkValue *v = at(g, product);
    if (!g->joins_terms) return YK_NONE;
    if (v->op != YK_VALUE_MULTIPLY) return multiply_out(g, number, product);
    bool is_second = at(g, v->b)->op == YK_VALUE_NUMBER;
    if (!is_second && at(g, v->a)->op != YK_VALUE_NUMBER) return YK_NONE;
    YkRef rest = is_second ? v->a : v->b;
    double both = at(g, number)->number * at(g, is_second ? v->b : v->a)->number;
    if (is_almost(1, fabs(both))) both = both < 0 ? -1 : 1;
    return yk_graph_multiply(g, yk_graph_number(g, both), rest);
}
