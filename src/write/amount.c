// Writes quantities as people read them.
#include "write/amount.h"
#include <math.h>
#include <string.h>
#include "base/number.h"

static const double noise = 1e-13; // of the machine's size: the rounding of a zero

static bool is_length(YkQuantity quantity)
{
    return quantity == YK_QUANTITY_LENGTH || quantity == YK_QUANTITY_SPEED || quantity == YK_QUANTITY_ACCELERATION;
}

double yk_amount_of(const YkModel *model, double value, YkQuantity quantity)
{
    double size = 1;
    yk_model_shown_unit(model, quantity, &size);
    return value / size;
}

double yk_amount_in_unit(const YkModel *model, const YkMechanism *mech, double value, YkQuantity quantity)
{
    double scale = is_length(quantity) && mech ? yk_mechanism_size(mech) : 1;
    return fabs(value) < noise * scale ? 0 : yk_amount_of(model, value, quantity);
}

static void add_number(YkText *text, double value, int digits)
{
    char number[YK_NUMBER_SIZE];
    yk_text_add(text, number, yk_number_write_digits(value, digits, number));
}

void yk_amount_write_shown(YkText *text, const YkModel *model, double shown, YkQuantity quantity, int digits)
{
    const char *unit = yk_model_shown_unit(model, quantity, NULL);
    add_number(text, shown, digits);
    if (*unit) yk_text_format(text, " %s", unit);
    if (quantity != YK_QUANTITY_ANGLE || strcmp(unit, "rad") != 0) return;
    yk_text_puts(text, " (");
    add_number(text, shown * (180 / 3.14159265358979323846), digits);
    yk_text_puts(text, " deg)");
}

void yk_amount_between(YkText *text, double low, double high, int digits)
{
    if (!isfinite(low) && !isfinite(high)) {
        yk_text_puts(text, "any");
        return;
    }
    if (!isfinite(low)) yk_text_puts(text, "up to ");
    add_number(text, isfinite(low) ? low : high, digits);
    if (!isfinite(high)) yk_text_puts(text, " or more");
    if (!isfinite(low) || !isfinite(high)) return;
    yk_text_puts(text, " to ");
    add_number(text, high, digits);
}

YkQuantity yk_amount_quantity(YkDimension dimension)
{
    static const struct {
        YkDimension dimension;
        YkQuantity quantity;
    } known[] = {
        {{0, 0, 0, 1}, YK_QUANTITY_ANGLE},   {{1, 0, 0, 0}, YK_QUANTITY_LENGTH},
        {{0, 0, 1, 0}, YK_QUANTITY_TIME},    {{0, 0, -1, 1}, YK_QUANTITY_ANGLE_RATE},
        {{1, 0, -1, 0}, YK_QUANTITY_SPEED},  {{1, 0, -2, 0}, YK_QUANTITY_ACCELERATION},
        {{1, 1, -2, 0}, YK_QUANTITY_FORCE},  {{2, 1, -2, 0}, YK_QUANTITY_TORQUE},
        {{0, 1, 0, 0}, YK_QUANTITY_MASS},    {{1, 1, 0, 0}, YK_QUANTITY_UNBALANCE},
        {{2, 1, 0, 0}, YK_QUANTITY_INERTIA},
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (yk_dimension_equal(known[k].dimension, dimension) &&
            (known[k].dimension.angle == 0) == (dimension.angle == 0))
            return known[k].quantity;
    return YK_QUANTITY_NUMBER;
}
