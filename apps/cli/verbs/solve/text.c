// `yoke solve` for people.
#include <string.h>
#include "reach.h"
#include "session.h"
#include "roll.h"
#include "verbs/solve/solve.h"
#include "write/amount.h"
#include "write/table.h"

static bool is_named(const YkAssignments *pairs, const char *name)
{
    for (size_t i = 0; i < pairs->count; i++)
        if (strcmp(pairs->items[i].name, name) == 0) return true;
    return false;
}

static YkTable *motion_table(YkSession *session, const char *subject, bool is_distance)
{
    static const char *const heads[] = {"position", "velocity", "acceleration"};
    YkTable *table = yk_table_new(4);
    yk_table_head(table, subject, NULL);
    for (int order = 0; order < 3; order++)
        yk_table_head(table, heads[order], yk_unit_of(session, yk_quantity_of(is_distance, order)));
    return table;
}

// `given`: the coordinate whose values on the command line are written as given; or NULL.
static void add_motion(YkSession *session, YkTable *table, const YkState *state, const char *name, YkMotion motion,
                       bool is_distance, const char *given)
{
    const YkAssignments *lists[] = {&session->request->at, &session->request->rate, &session->request->accel};
    const double values[] = {motion.position, yk_if_rates(state, motion.velocity),
                             yk_if_accelerations(session, state, motion.acceleration)};
    yk_table_word(table, name);
    for (int order = 0; order < 3; order++) {
        YkQuantity quantity = yk_quantity_of(is_distance, order);
        double shown = given && is_named(lists[order], given) ? yk_amount_of(session->model, values[order], quantity)
                                                              : yk_shown(session, values[order], quantity);
        yk_table_number(table, shown, YK_DIGITS);
    }
}

// Adds coordinates of one kind; inputs are marked.
static void add_coordinates(YkSession *session, const YkState *state, bool is_distance)
{
    YkTable *table = motion_table(session, is_distance ? "distance" : "angle", is_distance);
    YkText name = {0};
    for (size_t i = 0; i < yk_coordinate_count(session->mech); i++) {
        YkCoordinateInfo info = yk_coordinate_info(session->mech, i);
        if (info.is_distance != is_distance) continue;
        yk_text_clear(&name);
        yk_text_format(&name, "%s%s", info.name, info.input >= 0 ? " (input)" : "");
        yk_scale_of_bodies(session, yk_model_joint_body(session->model, info.joint, 0),
                           yk_model_joint_body(session->model, info.joint, 1));
        add_motion(session, table, state, yk_text_get(&name), yk_state_coordinate(state, i), is_distance, info.name);
    }
    yk_scale_of_bodies(session, 0, 0);
    yk_text_free(&name);
    yk_table_show(table, NULL, &session->out);
}

static void add_bodies(YkSession *session, const YkState *state)
{
    YkTable *table = motion_table(session, "body angle", false);
    const YkMotion *bodies = yk_session_bodies(session, state);
    for (size_t i = 1; bodies && i < yk_model_body_count(session->model); i++) {
        yk_scale_of_bodies(session, i, 0);
        add_motion(session, table, state, yk_model_body_name(session->model, i), bodies[i], false, NULL);
    }
    yk_scale_of_bodies(session, 0, 0);
    yk_table_show(table, NULL, &session->out);
}

static void add_points(YkSession *session, const YkState *state)
{
    static const char *const heads[] = {"x", "y", "x'", "y'", "x''", "y''"};
    YkTable *table = yk_table_new(7);
    YkText name = {0};
    yk_table_head(table, "point", NULL);
    for (int i = 0; i < 6; i++) yk_table_head(table, heads[i], yk_unit_of(session, yk_quantity_of(true, i / 2)));
    for (size_t p = 0; p < yk_model_point_count(session->model); p++) {
        size_t body = yk_model_point_body(session->model, p);
        if (body == 0) continue; // stands still where the file says
        yk_scale_of_bodies(session, body, 0);
        YkPointMotion m = yk_state_point(state, p);
        const double *values[] = {m.position, m.velocity, m.acceleration};
        yk_text_clear(&name);
        yk_text_format(&name, "%s.%s", yk_model_body_name(session->model, body),
                       yk_model_point_name(session->model, p));
        yk_table_word(table, yk_text_get(&name));
        for (int i = 0; i < 6; i++) {
            double value = values[i / 2][i % 2];
            if (i >= 2) value = i < 4 ? yk_if_rates(state, value) : yk_if_accelerations(session, state, value);
            yk_table_number(table, yk_shown(session, value, yk_quantity_of(true, i / 2)), YK_DIGITS);
        }
    }
    yk_scale_of_bodies(session, 0, 0);
    yk_text_free(&name);
    yk_table_show(table, NULL, &session->out);
}

static void add_transmission(YkSession *session, const YkState *state)
{
    YkTable *table = yk_table_new(2);
    yk_table_head(table, "transmission angle at", NULL);
    yk_table_head(table, "", yk_unit_of(session, YK_QUANTITY_ANGLE));
    for (size_t i = 0; i < yk_block_count(session->mech); i++) {
        YkBlockInfo block = yk_block_info(session->mech, i);
        if (block.assur_class != 2 || block.kind == YK_BLOCK_PP) continue;
        yk_table_word(table, block.label);
        yk_table_number(table, yk_shown(session, yk_state_transmission(state, i), YK_QUANTITY_ANGLE), YK_DIGITS);
    }
    yk_table_show(table, NULL, &session->out);
}

void yk_solve_text_head(YkSession *session, YkStatus status)
{
    int freedom = yk_freedom_of(session->mech);
    yk_text_format(&session->out, "%s: %d degree%s of freedom", yk_model_name(session->model), freedom,
                   freedom == 1 ? "" : "s");
    if (status != YK_OK) yk_text_format(&session->out, "; %s", yk_status_name(status));
    yk_text_puts(&session->out, "\n");
}

static void add_all(YkSession *session, const YkState *state)
{
    add_coordinates(session, state, false);
    add_coordinates(session, state, true);
    add_bodies(session, state);
    add_points(session, state);
    add_transmission(session, state);
    if (session->dynamics) yk_forces_text(session);
}

void yk_solve_text(YkSession *session, const YkState *state, size_t index)
{
    YkText label = yk_configuration_name(session, state);
    if (session->request->all) {
        const YkContinuum *continuum = yk_session_continuum(session);
        yk_text_format(&session->out, "\nConfiguration %z: %s%s\n", index + 1, yk_text_get(&label),
                       session->is_start ? " (the machine's own)" : "");
        if (continuum) yk_text_format(&session->out, "  one of a continuum of dimension %z\n", continuum->dimension);
    } else if (yk_text_has_some(&label)) {
        yk_text_format(&session->out, "Configuration %s%s\n", yk_text_get(&label),
                       session->is_chosen ? " (chosen)" : "");
    }
    yk_scale_begin(session);
    yk_scale_add_pose(session, state);
    if (session->columns) {
        yk_solve_of_text(session, state);
    } else {
        add_all(session, state);
    }
    if (session->request->centers) yk_centers_text(session, state);
    if (session->request->polygon) yk_polygon_text(session, state);
    yk_text_free(&label);
}
