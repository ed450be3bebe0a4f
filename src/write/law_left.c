// Says where a law's range is left, in the file's units.
#include "write/law_left.h"
#include <math.h>
#include <string.h>
#include "model/model.h"
#include "write/amount.h"

enum { DIGITS = 6 };

const char *yk_law_user_word(YkLawUser user)
{
    static const char *const words[] = {"drive", "effort", "force", "spring"};
    return words[user];
}

static void add(YkText *text, const YkModel *model, double value, YkDimension dimension)
{
    YkQuantity quantity = yk_amount_quantity(dimension);
    yk_amount_write_shown(text, model, yk_amount_of(model, value, quantity), quantity, DIGITS);
    if (quantity == YK_QUANTITY_NUMBER) yk_text_puts(text, " (SI)"); // a plain number was read as an angle or a length
}

// Returns what a law keeps beyond its end; what is rounding against its largest value is 0.
static double kept(const YkModelLaw *law, double value)
{
    return fabs(value) < 1e-12 * fabs(yk_law_peak(law->law, 0).value) ? 0 : value;
}

static void add_user(YkText *text, const YkLawLeft *left)
{
    bool is_along = left->user == YK_LAW_USER_DRIVE || left->user == YK_LAW_USER_EFFORT;
    yk_text_format(text, "the %s%s %q", yk_law_user_word(left->user), is_along ? " of" : "", left->name);
}

void yk_law_left_write(YkText *text, const YkModel *model, const YkLawLeft *left)
{
    for (size_t k = 0; k < model->law_count; k++) {
        const YkModelLaw *law = &model->laws[k];
        if (strcmp(law->name, left->law) != 0) continue;
        add_user(text, left);
        yk_text_format(text, " leaves the range of law %q, ", left->law);
        add(text, model, left->from, law->of);
        yk_text_puts(text, " to ");
        add(text, model, left->to, law->of);
        yk_text_puts(text, ": at ");
        add(text, model, left->argument, law->of);
        yk_text_puts(text, " it keeps its end value, ");
        add(text, model, kept(law, left->value), law->value);
        return;
    }
}
