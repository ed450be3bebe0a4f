// Writes one line per quantity: configuration, kind, name, position, velocity, acceleration; two per point (x, y).
#include "session.h"
#include "verbs/solve/solve.h"
#include "write/csv.h"

void yk_solve_csv_head(YkSession *session)
{
    static const char *const names[] = {"configuration", "kind", "name", "position", "velocity", "acceleration"};
    YkCsv csv = {.text = &session->out};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) yk_csv_name(&csv, names[i]);
    yk_csv_row(&csv);
}

static void add_row(YkSession *session, const YkState *state, const char *label, const char *kind, const char *name,
                    YkMotion motion)
{
    YkCsv csv = {.text = &session->out};
    yk_csv_name(&csv, label);
    yk_csv_name(&csv, kind);
    yk_csv_name(&csv, name);
    yk_csv_number(&csv, motion.position);
    yk_csv_number(&csv, yk_if_rates(state, motion.velocity));
    yk_csv_number(&csv, yk_if_accelerations(session, state, motion.acceleration));
    yk_csv_row(&csv);
}

static void add_point(YkSession *session, const YkState *state, const char *label, size_t point)
{
    YkPointMotion motion = yk_state_point(state, point);
    const char *body = yk_model_body_name(session->model, yk_model_point_body(session->model, point));
    for (int axis = 0; axis < 2; axis++) {
        YkText name = {0};
        yk_text_format(&name, "%s.%s.%c", body, yk_model_point_name(session->model, point), "xy"[axis]);
        add_row(session, state, label, "point", yk_text_get(&name),
                (YkMotion){motion.position[axis], motion.velocity[axis], motion.acceleration[axis]});
        yk_text_free(&name);
    }
}

void yk_solve_csv(YkSession *session, const YkState *state, size_t index)
{
    YkText label = yk_label_of(state);
    const char *word = yk_text_get(&label);
    (void)index;
    for (size_t i = 0; i < yk_coordinate_count(session->mech); i++)
        add_row(session, state, word, "coordinate", yk_coordinate_info(session->mech, i).name,
                yk_state_coordinate(state, i));
    const YkMotion *bodies = yk_session_bodies(session, state);
    for (size_t i = 1; bodies && i < yk_model_body_count(session->model); i++)
        add_row(session, state, word, "body", yk_model_body_name(session->model, i), bodies[i]);
    for (size_t i = 0; i < yk_model_point_count(session->model); i++) add_point(session, state, word, i);
    if (session->dynamics) yk_forces_csv(session, word);
    yk_text_free(&label);
}
