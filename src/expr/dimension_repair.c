// Writes a product whose numbers lack their units as it may have been meant: `10*theta.rate` as a torque is `10
// N*m*s/rad * theta.rate`.
#include <math.h>
#include <string.h>
#include "base/text.h"
#include "expr/dimension.h"

enum {
    NUMBERS_MAX = 16, // most numbers of one product
    POWER_MAX = 16,   // largest power of a base that a unit may repair
};

// A bare number that is a factor, or the base of a power.
typedef struct Factor {
    const YkExpr *number;
    int power;
} Factor;

typedef struct Product {
    Factor factors[NUMBERS_MAX];
    int count;
} Product;

// The text inserted after a number, and around the base of a power.
typedef struct Insertion {
    const YkExpr *number;
    YkDimension unit;
    bool is_base;
} Insertion;

typedef struct Repair {
    Insertion insertions[NUMBERS_MAX];
    int count;
    bool failed;
} Repair;

static void add_factor(Product *product, const YkExpr *number, int power)
{
    if (product->count < NUMBERS_MAX && number->text && power != 0)
        product->factors[product->count++] = (Factor){number, power};
}

// Finds the bare numbers among the factors of a product.
static void find_factors(const YkExpr *expr, int sign, Product *product)
{
    double power;
    switch (expr->kind) {
    case YK_EXPR_NUMBER:
        if (!expr->has_unit) add_factor(product, expr, sign);
        break;
    case YK_EXPR_NEGATE:
        find_factors(expr->a, sign, product);
        break;
    case YK_EXPR_MULTIPLY:
    case YK_EXPR_DIVIDE:
        find_factors(expr->a, sign, product);
        find_factors(expr->b, expr->kind == YK_EXPR_DIVIDE ? -sign : sign, product);
        break;
    case YK_EXPR_POWER:
        if (expr->a->kind == YK_EXPR_NUMBER && !expr->a->has_unit && yk_dim_literal(expr->b, &power) && power > 1 &&
            power <= POWER_MAX && power == floor(power))
            add_factor(product, expr->a, sign * (int)power);
        break;
    default:
        break;
    }
}

static void insert(Repair *repair, const Factor *factor, YkDimension unit)
{
    if (repair->count == NUMBERS_MAX) {
        repair->failed = true;
        return;
    }
    bool is_base = factor->power > 1 || factor->power < -1;
    repair->insertions[repair->count++] = (Insertion){factor->number, unit, is_base};
}

static bool is_decimal(const YkExpr *number)
{
    return memchr(number->text, '.', number->text_length) != NULL;
}

// Gives missing lengths to the numbers, one each: those with a decimal point come before counts like 2. Returns the
// rest.
static int insert_lengths(Repair *repair, const Product *product, int missing)
{
    const YkDimension length = {.length = 1};
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < product->count && missing > 0; i++) {
            const Factor *factor = &product->factors[i];
            if (factor->power < 1 || factor->power > missing || is_decimal(factor->number) != (pass == 0)) continue;
            insert(repair, factor, length);
            missing -= factor->power;
        }
    return missing;
}

static bool is_length_power(YkDimension d)
{
    return d.length > 0 && d.mass == 0 && d.time == 0 && d.angle == 0;
}

// Gives the numbers of a product the units that it lacks. Returns false if none can take them.
static bool repair_product(const YkExpr *expr, YkDimension missing, Repair *repair)
{
    Product product = {.count = 0};
    int before = repair->count;
    find_factors(expr, 1, &product);
    if (is_length_power(missing)) {
        if (insert_lengths(repair, &product, missing.length) == 0) return !repair->failed;
        repair->count = before;
    }
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < product.count; i++) {
            int sign = pass == 0 ? 1 : -1; // prefers a number above the line to one below
            if (product.factors[i].power != sign) continue;
            insert(repair, &product.factors[i], sign > 0 ? missing : yk_dimension_times(YK_DIM_NONE, missing, -1));
            return !repair->failed;
        }
    return false;
}

// Repairs a sum. All its terms lack the same, except bare numbers, which take the kind of the others.
static bool repair_terms(const YkExpr *expr, YkDimension missing, Repair *repair)
{
    if (yk_dim_is_bare(expr)) return true;
    if (expr->kind == YK_EXPR_NEGATE) return repair_terms(expr->a, missing, repair);
    if (expr->kind == YK_EXPR_ADD || expr->kind == YK_EXPR_SUBTRACT)
        return repair_terms(expr->a, missing, repair) && repair_terms(expr->b, missing, repair);
    return repair_product(expr, missing, repair);
}

static const Insertion *insertion_at(const Repair *repair, const char *at, bool is_end)
{
    for (int i = 0; i < repair->count; i++) {
        const YkExpr *number = repair->insertions[i].number;
        if (number->text + (is_end ? number->text_length : 0) == at) return &repair->insertions[i];
    }
    return NULL;
}

// Copies the blanks and the operator after a unit, so that the operator has blanks around it: `10 m * x`.
static const char *add_operator(YkText *text, const char *at, const char *end)
{
    const char *sign = at;
    while (sign < end && *sign == ' ') sign++;
    if (sign == end || (*sign != '*' && *sign != '/')) return at;
    yk_text_format(text, " %c ", *sign++);
    while (sign < end && *sign == ' ') sign++;
    return sign;
}

// Writes the whole expression with the insertions. Units of force are in N if the file names none.
static void write(const YkUnits *file, const YkExpr *whole, const Repair *repair, YkText *text)
{
    YkUnits units = *file;
    const char *at = whole->text, *end = whole->text + whole->text_length;
    if (!units.force_name) units.force_name = "N";
    while (at < end) {
        const Insertion *first = insertion_at(repair, at, false);
        if (first && first->is_base) yk_text_puts(text, "(");
        do yk_text_add(text, at++, 1);
        while (at < end && !insertion_at(repair, at, false) && !insertion_at(repair, at, true));
        const Insertion *last = insertion_at(repair, at, true);
        if (!last) continue;
        yk_text_puts(text, " ");
        yk_units_name(&units, last->unit, text);
        if (last->is_base)
            yk_text_puts(text, ")");
        else
            at = add_operator(text, at, end);
    }
}

bool yk_dim_repair(const YkUnits *units, const YkExpr *whole, const YkExpr *part, YkDimension missing, YkText *text)
{
    Repair repair = {.count = 0};
    if (!whole->text || !repair_terms(part, missing, &repair) || repair.count == 0) return false;
    write(units, whole, &repair, text);
    return !text->failed;
}
