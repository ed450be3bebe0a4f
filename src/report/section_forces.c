// Writes the forces at the start: reactions, efforts, and every body's balance.
#include <math.h>
#include "elementary/elementary.h"
#include "report/html.h"
#include "report/report.h"
#include "write/amount.h"

enum { DIGITS = 6, ROWS_MAX = 200 };

static double shown(const YkReportPage *report, double value, double largest, YkQuantity quantity)
{
    double scale = quantity == YK_QUANTITY_TORQUE ? yk_mechanism_size(report->mech) : 1;
    return fabs(value) <= 1e-13 * largest * scale ? 0 : yk_amount_of(report->model, value, quantity);
}

static double largest_reaction(const YkReportPage *report)
{
    double largest = 0;
    for (size_t j = 0; j < yk_model_joint_count(report->model); j++) {
        YkReaction r = yk_dynamics_reaction(report->dynamics, j);
        largest = fmax(largest, yk_hypot(r.force[0], r.force[1]));
    }
    return largest;
}

static void add_reactions(const YkReportPage *report, double largest, YkText *html)
{
    const char *force = yk_model_shown_unit(report->model, YK_QUANTITY_FORCE, NULL);
    YkTable *table = yk_table_new(7);
    bool is_choice = false;
    static const char *const heads[] = {"joint", "by", "on"}, *const sizes[] = {"force x", "force y", "size"};
    for (int i = 0; i < 3; i++) yk_table_head(table, heads[i], NULL);
    for (int i = 0; i < 3; i++) yk_table_head(table, sizes[i], force);
    yk_table_head(table, "moment", yk_model_shown_unit(report->model, YK_QUANTITY_TORQUE, NULL));
    for (size_t j = 0; j < yk_model_joint_count(report->model) && j < ROWS_MAX; j++) {
        YkReaction r = yk_dynamics_reaction(report->dynamics, j);
        yk_table_word(table, report->model->joints[j].name);
        yk_table_word(table, report->model->bodies[r.by].name);
        yk_table_word(table, report->model->bodies[r.on].name);
        for (int axis = 0; axis < 2; axis++)
            yk_table_number(table, shown(report, r.force[axis], largest, YK_QUANTITY_FORCE), DIGITS);
        yk_table_number(table, shown(report, yk_hypot(r.force[0], r.force[1]), largest, YK_QUANTITY_FORCE), DIGITS);
        yk_table_number(table, shown(report, r.moment, largest, YK_QUANTITY_TORQUE), DIGITS);
        is_choice |= !r.is_determinate;
    }
    yk_html_table(html, table, "Reactions at the start: what a joint's first body exerts on its second");
    if (is_choice)
        yk_html_element(html, "p",
                        yk_dynamics_is_held_by_friction(report->dynamics)
                            ? "Some of these are one choice of many, without friction in the joints at rest."
                            : "Some of these are one choice of many, the least in norm, since constraints repeat each "
                              "other.");
}

static void add_efforts(const YkReportPage *report, bool is_distance, double largest, YkText *html)
{
    YkQuantity quantity = is_distance ? YK_QUANTITY_FORCE : YK_QUANTITY_TORQUE;
    YkTable *table = yk_table_new(2);
    YkText words = {0};
    bool is_open = false;
    yk_table_head(table, "along", NULL);
    yk_table_head(table, is_distance ? "force" : "torque", yk_model_shown_unit(report->model, quantity, NULL));
    for (size_t c = 0; c < yk_coordinate_count(report->mech); c++) {
        YkCoordinateInfo info = yk_coordinate_info(report->mech, c);
        if (info.is_distance != is_distance || !yk_dynamics_has_effort(report->dynamics, c)) continue;
        yk_table_word(table, info.name);
        YkEffortRange range = yk_dynamics_effort_range(report->dynamics, c);
        double low = shown(report, range.low, largest, quantity), high = shown(report, range.high, largest, quantity);
        yk_text_clear(&words);
        if (range.is_known)
            yk_amount_between(&words, low, high, DIGITS);
        else
            yk_text_puts(&words, "not found");
        if (range.is_single)
            yk_table_number(table, low, DIGITS);
        else
            yk_table_word(table, yk_text_get(&words));
        is_open |= !range.is_single;
    }
    yk_html_table(html, table,
                  is_distance ? "Forces along coordinates at the start" : "Torques along coordinates at the start");
    if (is_open)
        yk_html_element(html, "p",
                        "Dry friction of joints at rest holds the machine with every effort in the range: there is no "
                        "single answer.");
    html->failed |= words.failed;
    yk_text_free(&words);
}

// Adds a free body as a table: loads, reactions, and the remainder for its inertia.
static void add_balances(const YkReportPage *report, double largest, YkText *html)
{
    const char *force = yk_model_shown_unit(report->model, YK_QUANTITY_FORCE, NULL),
               *torque = yk_model_shown_unit(report->model, YK_QUANTITY_TORQUE, NULL);
    static const char *const words[] = {"loads x",          "loads y",   "loads moment", "reactions x",   "reactions y",
                                        "reactions moment", "inertia x", "inertia y",    "inertia moment"};
    YkTable *table = yk_table_new(10);
    yk_table_head(table, "body", NULL);
    for (int i = 0; i < 9; i++) yk_table_head(table, words[i], i % 3 == 2 ? torque : force);
    for (size_t b = 1; b < yk_model_body_count(report->model) && b < ROWS_MAX; b++) {
        YkBalance balance = yk_dynamics_balance(report->dynamics, b);
        const YkWrench *wrenches[] = {&balance.loads, &balance.reactions, &balance.inertia};
        yk_table_word(table, report->model->bodies[b].name);
        for (int i = 0; i < 3; i++) {
            yk_table_number(table, shown(report, wrenches[i]->force[0], largest, YK_QUANTITY_FORCE), DIGITS);
            yk_table_number(table, shown(report, wrenches[i]->force[1], largest, YK_QUANTITY_FORCE), DIGITS);
            yk_table_number(table, shown(report, wrenches[i]->moment, largest, YK_QUANTITY_TORQUE), DIGITS);
        }
    }
    yk_html_table(html, table,
                  "Free bodies at the start: loads + reactions = inertia, moments about the centre of mass");
}

void yk_section_forces(YkReportPage *report, YkText *html, YkProblems *problems)
{
    (void)problems;
    if (!report->has_forces) return;
    double largest = largest_reaction(report);
    YkEnergy energy = yk_dynamics_energy(report->dynamics);
    add_reactions(report, largest, html);
    add_efforts(report, false, largest, html);
    add_efforts(report, true, largest, html);
    add_balances(report, largest, html);
    yk_text_puts(html, "<p>Kinetic energy ");
    yk_report_amount(report, html, energy.kinetic, YK_QUANTITY_ENERGY);
    yk_text_puts(html, ", potential energy ");
    yk_report_amount(report, html, energy.potential, YK_QUANTITY_ENERGY);
    yk_text_puts(html, ".</p>\n");
}
