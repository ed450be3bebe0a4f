// Writes amounts for messages in the file's own units.
#include "base/number.h"
#include "base/vec.h"
#include "model/laws/read.h"

// Returns the unit of a dimension, "" if the file has no word for it; *size gets its size in SI.
static const char *unit_of(const YkModel *model, YkDimension dimension, double *size)
{
    *size = 1;
    if (yk_dimension_equal(dimension, YK_DIM_ANGLE)) return yk_model_unit(model, YK_QUANTITY_ANGLE, size);
    if (yk_dimension_equal(dimension, YK_DIM_LENGTH)) return yk_model_unit(model, YK_QUANTITY_LENGTH, size);
    if (yk_dimension_equal(dimension, YK_DIM_TIME)) return yk_model_unit(model, YK_QUANTITY_TIME, size);
    if (yk_dimension_equal(dimension, YK_DIM_FORCE)) return yk_model_unit(model, YK_QUANTITY_FORCE, size);
    if (yk_dimension_equal(dimension, YK_DIM_TORQUE)) return yk_model_unit(model, YK_QUANTITY_TORQUE, size);
    return "";
}

static void append(YkAmount *amount, const char *text)
{
    while (*text && amount->length + 1 < sizeof amount->text) amount->text[amount->length++] = *text++;
    amount->text[amount->length] = '\0';
}

YkAmount yk_load_law_amount(const YkModel *model, const YkModelLaw *law, double value, int order)
{
    double value_size, of_size;
    const char *unit = unit_of(model, law->value, &value_size), *of = unit_of(model, law->of, &of_size);
    const char *const powers[] = {"", "", "^2", "^3", "^4"};
    char number[YK_NUMBER_SIZE];
    YkAmount amount = {.length = 0};
    value /= value_size;
    for (int m = 0; m < order; m++) value *= of_size;
    yk_number_write_digits(value, 6, number);
    append(&amount, number);
    append(&amount, unit[0] ? " " : "");
    append(&amount, unit);
    if (order == 0 || !of[0] || !unit[0]) return amount;
    append(&amount, "/");
    append(&amount, of);
    append(&amount, powers[order]);
    return amount;
}

// Returns a place. An angle in radians is also given in degrees: cams are drawn up in degrees.
YkAmount yk_load_law_place(const YkModel *model, const YkModelLaw *law, double x)
{
    double size;
    const char *unit = unit_of(model, law->of, &size);
    char number[YK_NUMBER_SIZE];
    YkAmount amount = {.length = 0};
    yk_number_write_digits(x / size, 6, number);
    append(&amount, number);
    append(&amount, unit[0] ? " " : "");
    append(&amount, unit);
    if (size != 1 || x == 0 || !yk_dimension_equal(law->of, YK_DIM_ANGLE)) return amount;
    yk_number_write_digits(x * 180 / YK_PI, 6, number);
    append(&amount, " (");
    append(&amount, number);
    append(&amount, " deg)");
    return amount;
}
