// Writes forces of a configuration: reactions, efforts, energy, balances, the count of equations.
#include <math.h>
#include "elementary/elementary.h"
#include "verbs/solve/solve.h"
#include "write/amount.h"
#include "write/csv.h"
#include "write/table.h"

void yk_add_count(YkText *text, YkEquationCount c)
{
    size_t equations = c.force + c.moment + c.acceleration;
    if (c.ran_out) yk_text_fail(text);
    yk_text_format(text, "%z force + %z moment + %z acceleration = %z equations; %z unknowns", c.force, c.moment,
                   c.acceleration, equations, c.unknown_reactions + c.unknown_accelerations + c.unknown_efforts);
}

// --- JSON

static void add_wrench(YkJson *json, const char *key, YkWrench wrench)
{
    yk_json_object(json, key, YK_JSON_INLINE);
    yk_json_numbers(json, "force", wrench.force, 2);
    yk_json_number(json, "moment", wrench.moment);
    yk_json_end(json);
}

static void add_reaction(YkSession *session, YkJson *json, const char *name, YkReaction r)
{
    yk_json_object(json, name, YK_JSON_INLINE);
    yk_json_string(json, "by", yk_model_body_name(session->model, r.by));
    yk_json_string(json, "on", yk_model_body_name(session->model, r.on));
    yk_json_numbers(json, "force", r.force, 2);
    yk_json_number(json, "moment", r.moment);
    if (!r.is_determinate) yk_json_bool(json, "determinate", false);
    yk_json_end(json);
}

static void add_reactions(YkSession *session, YkJson *json)
{
    size_t contacts = yk_dynamics_contact_count(session->dynamics);
    yk_json_object(json, "reactions", YK_JSON_LINES);
    for (size_t j = 0; j < yk_model_joint_count(session->model); j++)
        add_reaction(session, json, yk_model_joint_name(session->model, j), yk_dynamics_reaction(session->dynamics, j));
    yk_json_end(json);
    if (contacts == 0) return;
    yk_json_object(json, "contacts", YK_JSON_LINES);
    for (size_t k = 0; k < contacts; k++)
        add_reaction(session, json, yk_dynamics_contact_name(session->dynamics, k),
                     yk_dynamics_contact(session->dynamics, k));
    yk_json_end(json);
}

static bool has_range(const YkSession *session, size_t coordinate)
{
    return yk_dynamics_has_effort(session->dynamics, coordinate) &&
           !yk_dynamics_effort_range(session->dynamics, coordinate).is_single;
}

static bool has_ranges(const YkSession *session)
{
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++)
        if (has_range(session, c)) return true;
    return false;
}

// Writes the efforts that dry friction at rest leaves open; null at an end means that there is none.
static void add_ranges(YkSession *session, YkJson *json)
{
    if (!has_ranges(session)) return;
    yk_json_object(json, "effort_ranges", YK_JSON_LINES);
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++) {
        if (!has_range(session, c)) continue;
        YkEffortRange range = yk_dynamics_effort_range(session->dynamics, c);
        yk_json_object(json, yk_coordinate_info(session->mech, c).name, YK_JSON_INLINE);
        yk_json_bool(json, "known", range.is_known);
        yk_json_number(json, "from", range.low);
        yk_json_number(json, "to", range.high);
        yk_json_number(json, "without_friction", yk_dynamics_effort(session->dynamics, c));
        yk_json_string(json, "reason",
                       range.is_known
                           ? "dry friction of joints at rest holds the machine with every effort in this range"
                           : "dry friction of joints at rest holds the machine; the range was not found");
        yk_json_end(json);
    }
    yk_json_end(json);
}

static void add_efforts(YkSession *session, YkJson *json)
{
    yk_json_object(json, "efforts", YK_JSON_INLINE);
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++)
        if (yk_dynamics_has_effort(session->dynamics, c))
            yk_json_number(json, yk_coordinate_info(session->mech, c).name,
                           has_range(session, c) ? (double)NAN : yk_dynamics_effort(session->dynamics, c));
    yk_json_end(json);
    add_ranges(session, json);
}

static void add_balances(YkSession *session, YkJson *json)
{
    yk_json_object(json, "balance", YK_JSON_LINES);
    for (size_t b = 1; b < yk_model_body_count(session->model); b++) {
        YkBalance balance = yk_dynamics_balance(session->dynamics, b);
        yk_json_object(json, yk_model_body_name(session->model, b), YK_JSON_INLINE);
        add_wrench(json, "loads", balance.loads);
        add_wrench(json, "reactions", balance.reactions);
        add_wrench(json, "inertia", balance.inertia);
        yk_json_number(json, "residual", balance.residual);
        yk_json_end(json);
    }
    yk_json_end(json);
}

void yk_add_equations_json(YkJson *json, YkEquationCount c)
{
    YkText text = {0};
    yk_add_count(&text, c);
    yk_json_object(json, "equations", YK_JSON_INLINE);
    yk_json_integer(json, "force", (long long)c.force);
    yk_json_integer(json, "moment", (long long)c.moment);
    yk_json_integer(json, "acceleration", (long long)c.acceleration);
    yk_json_integer(json, "unknown_reactions", (long long)c.unknown_reactions);
    yk_json_integer(json, "unknown_accelerations", (long long)c.unknown_accelerations);
    yk_json_integer(json, "unknown_efforts", (long long)c.unknown_efforts);
    yk_json_string(json, "text", yk_text_get(&text));
    yk_json_end(json);
    yk_text_free(&text);
}

void yk_forces_json(YkSession *session, YkJson *json)
{
    YkEnergy energy = yk_dynamics_energy(session->dynamics);
    add_reactions(session, json);
    add_efforts(session, json);
    yk_json_object(json, "energy", YK_JSON_INLINE);
    yk_json_number(json, "kinetic", energy.kinetic);
    yk_json_number(json, "potential", energy.potential);
    yk_json_end(json);
    add_wrench(json, "shaking", yk_dynamics_shaking(session->dynamics));
    add_balances(session, json);
    yk_add_equations_json(json, yk_dynamics_count(session->dynamics));
}

// --- text

static void add_reaction_table(YkSession *session)
{
    size_t joints = yk_model_joint_count(session->model), contacts = yk_dynamics_contact_count(session->dynamics);
    YkTable *table = yk_table_new(6);
    YkText words = {0};
    const char *force = yk_unit_of(session, YK_QUANTITY_FORCE), *moment = yk_unit_of(session, YK_QUANTITY_TORQUE);
    yk_table_head(table, "reaction at", NULL);
    yk_table_head(table, "by, on", NULL);
    yk_table_head(table, "force x", force);
    yk_table_head(table, "force y", force);
    yk_table_head(table, "size", force);
    yk_table_head(table, "moment", moment);
    for (size_t j = 0; j < joints + contacts; j++) {
        bool is_joint = j < joints;
        YkReaction r =
            is_joint ? yk_dynamics_reaction(session->dynamics, j) : yk_dynamics_contact(session->dynamics, j - joints);
        yk_table_word(table, is_joint ? yk_model_joint_name(session->model, j)
                                      : yk_dynamics_contact_name(session->dynamics, j - joints));
        yk_text_clear(&words);
        yk_text_format(&words, "%s, %s%s", yk_model_body_name(session->model, r.by),
                       yk_model_body_name(session->model, r.on),
                       r.is_determinate                                     ? ""
                       : yk_dynamics_is_held_by_friction(session->dynamics) ? " (one of many)"
                                                                            : " (one of many, least)");
        yk_table_word(table, yk_text_get(&words));
        for (int axis = 0; axis < 2; axis++)
            yk_table_number(table, yk_shown(session, r.force[axis], YK_QUANTITY_FORCE), YK_DIGITS);
        yk_table_number(table, yk_shown(session, yk_hypot(r.force[0], r.force[1]), YK_QUANTITY_FORCE), YK_DIGITS);
        yk_table_number(table, yk_shown(session, r.moment, YK_QUANTITY_TORQUE), YK_DIGITS);
    }
    yk_text_free(&words);
    yk_table_show(table, NULL, &session->out);
}

static void add_range(YkSession *session, YkTable *table, YkEffortRange range, YkQuantity quantity)
{
    YkText words = {0};
    double low = yk_shown(session, range.low, quantity), high = yk_shown(session, range.high, quantity);
    if (range.is_known)
        yk_amount_between(&words, low, high, YK_DIGITS);
    else
        yk_text_puts(&words, "not found");
    yk_table_word(table, yk_text_get(&words));
    session->out.failed |= words.failed;
    yk_text_free(&words);
}

static void add_effort_table(YkSession *session, bool is_distance)
{
    YkQuantity quantity = is_distance ? YK_QUANTITY_FORCE : YK_QUANTITY_TORQUE;
    YkTable *table = yk_table_new(2);
    yk_table_head(table, is_distance ? "force along" : "torque along", NULL);
    yk_table_head(table, "", yk_unit_of(session, quantity));
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++) {
        if (yk_coordinate_info(session->mech, c).is_distance != is_distance ||
            !yk_dynamics_has_effort(session->dynamics, c))
            continue;
        yk_table_word(table, yk_coordinate_info(session->mech, c).name);
        YkEffortRange range = yk_dynamics_effort_range(session->dynamics, c);
        if (range.is_single)
            yk_table_number(table, yk_shown(session, range.low, quantity), YK_DIGITS);
        else
            add_range(session, table, range, quantity);
    }
    yk_table_show(table, NULL, &session->out);
}

static void explain_ranges(YkSession *session)
{
    YkText *out = &session->out;
    if (!yk_dynamics_is_held_by_friction(session->dynamics)) return;
    if (has_ranges(session))
        yk_text_puts(out,
                     "\n  Dry friction of joints at rest holds the machine with every effort in the range: there is no "
                     "single answer.\n");
    yk_text_puts(out, has_ranges(session) ? "  " : "\n  ");
    yk_text_puts(out, "Reactions marked as one of many are those without friction in the joints at rest.\n");
}

void yk_forces_text(YkSession *session)
{
    YkText *out = &session->out;
    YkEnergy energy = yk_dynamics_energy(session->dynamics);
    add_reaction_table(session);
    add_effort_table(session, false);
    add_effort_table(session, true);
    explain_ranges(session);
    yk_text_puts(out, "\n  energy: kinetic ");
    double kinetic = energy.kinetic <= yk_scale_kinetic_noise(session) ? 0 : energy.kinetic;
    yk_amount_write_shown(out, session->model, yk_amount_of(session->model, kinetic, YK_QUANTITY_ENERGY),
                          YK_QUANTITY_ENERGY, YK_DIGITS);
    yk_text_puts(out, ", potential ");
    yk_add_value(session, out, energy.potential, YK_QUANTITY_ENERGY, YK_DIGITS);
    yk_text_puts(out, "\n  ");
    yk_add_count(out, yk_dynamics_count(session->dynamics));
    yk_text_puts(out, "\n");
}

// --- CSV: one line per force: x, y and moment instead of position, velocity and acceleration

static void add_csv(YkSession *session, const char *label, const char *kind, const char *name, double a, double b,
                    double c)
{
    YkCsv csv = {.text = &session->out};
    yk_csv_name(&csv, label);
    yk_csv_name(&csv, kind);
    yk_csv_name(&csv, name);
    yk_csv_number(&csv, a);
    yk_csv_number(&csv, b);
    yk_csv_number(&csv, c);
    yk_csv_row(&csv);
}

void yk_forces_csv(YkSession *session, const char *label)
{
    for (size_t j = 0; j < yk_model_joint_count(session->model); j++) {
        YkReaction r = yk_dynamics_reaction(session->dynamics, j);
        add_csv(session, label, "reaction", yk_model_joint_name(session->model, j), r.force[0], r.force[1], r.moment);
    }
    for (size_t k = 0; k < yk_dynamics_contact_count(session->dynamics); k++) {
        YkReaction r = yk_dynamics_contact(session->dynamics, k);
        add_csv(session, label, "contact", yk_dynamics_contact_name(session->dynamics, k), r.force[0], r.force[1],
                r.moment);
    }
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++) {
        YkEffortRange range = yk_dynamics_effort_range(session->dynamics, c);
        const char *name = yk_coordinate_info(session->mech, c).name;
        if (!yk_dynamics_has_effort(session->dynamics, c)) continue;
        if (range.is_single)
            add_csv(session, label, "effort", name, range.low, (double)NAN, (double)NAN);
        else // from and to, instead of a value
            add_csv(session, label, "effort_range", name, range.low, range.high, (double)NAN);
    }
    YkEnergy energy = yk_dynamics_energy(session->dynamics);
    add_csv(session, label, "energy", "kinetic", energy.kinetic, (double)NAN, (double)NAN);
    add_csv(session, label, "energy", "potential", energy.potential, (double)NAN, (double)NAN);
}
