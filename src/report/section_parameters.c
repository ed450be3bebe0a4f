// Writes the parameters with their units, and the bodies with their points and masses.
#include "report/html.h"
#include "report/report.h"
#include "write/amount.h"

enum { DIGITS = 8, ROWS_MAX = 300 };

static void add_power(YkText *unit, const char *name, int power, bool *is_first)
{
    if (power <= 0) return;
    yk_text_format(unit, "%s%s", *is_first ? "" : "*", name);
    if (power > 1) yk_text_format(unit, "^%d", power);
    *is_first = false;
}

// Writes "kg*m^2/s": a dimension in SI.
static void add_si(YkText *unit, YkDimension d)
{
    bool is_first = true;
    add_power(unit, "kg", d.mass, &is_first);
    add_power(unit, "m", d.length, &is_first);
    add_power(unit, "s", d.time, &is_first);
    if (d.mass >= 0 && d.length >= 0 && d.time >= 0) return;
    if (is_first) yk_text_puts(unit, "1");
    const int powers[] = {-d.mass, -d.length, -d.time};
    static const char *const names[] = {"kg", "m", "s"};
    for (int i = 0; i < 3; i++) {
        if (powers[i] <= 0) continue;
        yk_text_format(unit, "/%s", names[i]);
        if (powers[i] > 1) yk_text_format(unit, "^%d", powers[i]);
    }
}

static void add_parameters(const YkReportPage *report, YkText *html)
{
    YkTable *table = yk_table_new(4);
    YkText unit = {0};
    static const char *const heads[] = {"parameter", "value", "unit", "is"};
    for (int i = 0; i < 4; i++) yk_table_head(table, heads[i], NULL);
    for (size_t k = 0; k < report->model->parameter_count && k < ROWS_MAX; k++) {
        const YkParameter *parameter = &report->model->parameters[k];
        YkQuantity quantity = yk_amount_quantity(parameter->dimension);
        yk_text_clear(&unit);
        if (quantity == YK_QUANTITY_NUMBER)
            add_si(&unit, parameter->dimension);
        else
            yk_text_puts(&unit, yk_model_shown_unit(report->model, quantity, NULL));
        yk_table_word(table, parameter->name);
        yk_table_number(table, yk_amount_in_unit(report->model, NULL, parameter->value, quantity), DIGITS);
        yk_table_word(table, yk_text_get(&unit));
        yk_table_word(table, yk_dimension_name(parameter->dimension));
    }
    html->failed |= unit.failed;
    yk_text_free(&unit);
    yk_html_table(html, table, "Parameters");
}

static void add_points(const YkReportPage *report, YkText *html)
{
    const char *unit = yk_model_shown_unit(report->model, YK_QUANTITY_LENGTH, NULL);
    YkTable *table = yk_table_new(4);
    yk_table_head(table, "point", NULL);
    yk_table_head(table, "of", NULL);
    yk_table_head(table, "x", unit);
    yk_table_head(table, "y", unit);
    for (size_t i = 0; i < report->model->point_count && i < ROWS_MAX; i++) {
        const YkPoint *point = &report->model->points[i];
        yk_table_word(table, point->name);
        yk_table_word(table, report->model->bodies[point->body].name);
        yk_table_number(table, yk_amount_in_unit(report->model, report->mech, point->at.x, YK_QUANTITY_LENGTH), DIGITS);
        yk_table_number(table, yk_amount_in_unit(report->model, report->mech, point->at.y, YK_QUANTITY_LENGTH), DIGITS);
    }
    yk_html_table(html, table, "Points, in the axes of their bodies");
}

static void add_masses(const YkReportPage *report, YkText *html)
{
    const char *unit = yk_model_shown_unit(report->model, YK_QUANTITY_LENGTH, NULL);
    YkTable *table = yk_table_new(5);
    yk_table_head(table, "body", NULL);
    yk_table_head(table, "mass", yk_model_shown_unit(report->model, YK_QUANTITY_MASS, NULL));
    yk_table_head(table, "inertia", yk_model_shown_unit(report->model, YK_QUANTITY_INERTIA, NULL));
    yk_table_head(table, "centre x", unit);
    yk_table_head(table, "centre y", unit);
    for (size_t b = 1; b < yk_model_body_count(report->model) && b < ROWS_MAX; b++) {
        const YkBody *body = &report->model->bodies[b];
        if (!body->has_mass) continue;
        yk_table_word(table, body->name);
        yk_table_number(table, yk_amount_of(report->model, body->mass, YK_QUANTITY_MASS), DIGITS);
        yk_table_number(table, yk_amount_of(report->model, body->inertia, YK_QUANTITY_INERTIA), DIGITS);
        yk_table_number(table, yk_amount_in_unit(report->model, report->mech, body->center.x, YK_QUANTITY_LENGTH),
                        DIGITS);
        yk_table_number(table, yk_amount_in_unit(report->model, report->mech, body->center.y, YK_QUANTITY_LENGTH),
                        DIGITS);
    }
    yk_html_table(html, table, "Masses; inertias about the centre of mass");
}

void yk_section_parameters(YkReportPage *report, YkText *html, YkProblems *problems)
{
    (void)problems;
    add_parameters(report, html);
    add_points(report, html);
    add_masses(report, html);
}
