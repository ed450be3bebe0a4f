// The answer of `yoke solve`: one configuration, in each format.
#ifndef CLI_SOLVE_H
#define CLI_SOLVE_H
#include "answer.h"

void yk_solve_text_head(YkSession *session, YkStatus status);
void yk_solve_text(YkSession *session, const YkState *state, size_t index);
void yk_solve_json(YkSession *session, YkJson *json, const YkState *state);
void yk_solve_csv_head(YkSession *session);
void yk_solve_csv(YkSession *session, const YkState *state, size_t index);
// The same for the columns of --of, session->columns.
void yk_solve_of_warn(YkSession *session); // of efforts among the columns that dry friction at rest leaves open
void yk_solve_of_text(YkSession *session, const YkState *state);
void yk_solve_of_json(YkSession *session, YkJson *json, const YkState *state); // "of": {name: value}
void yk_solve_of_csv_head(YkSession *session);
void yk_solve_of_csv(YkSession *session, const YkState *state); // one row a configuration
// Write the instant centres (--centers); a machine without them gets a problem, and nothing is written.
void yk_centers_text(YkSession *session, const YkState *state);
void yk_centers_json(YkSession *session, YkJson *json, const YkState *state);
// Finds forces at a pose, and the accelerations that they give to free inputs. dynamics may be NULL. A pose without
// forces (a dead point, a freedom without inertia) keeps its motion; session->dynamics is then NULL, and the status
// says why.
YkStatus yk_solve_forces(YkSession *session, YkDynamics *dynamics, YkMethod method, YkState *state);
// Write the polygon of --polygon; at a pose without one there is a problem, and nothing is written.
bool yk_polygon_read(YkSession *session, YkPolygonKind *kind); // false with a problem: --polygon has another word
bool yk_wants_force_polygons(const YkSession *session);        // --polygon force
// Makes the polygon of a pose whose forces yk_solve_forces has found. Returns NULL with a problem if there is none.
YkPolygon *yk_polygon_of(YkSession *session, const YkState *state);
// Makes the force polygons of a pose. dynamics: solved there, or NULL if it has no forces, and why (NULL: unknown).
// Returns NULL with a problem if there are none.
YkForcePolygons *yk_force_polygons_of(YkSession *session, const YkDynamics *dynamics, const char *why);
void yk_polygon_pair(YkJson *json, const char *key, const double value[2]); // "key": [x, y]
void yk_force_polygon_text(YkSession *session);
void yk_force_polygon_json(YkSession *session, YkJson *json);
// Returns whether instant centres or a polygon were asked for where there are none.
bool yk_lacks_construction(const YkSession *session);
void yk_polygon_text(YkSession *session, const YkState *state);
void yk_polygon_json(YkSession *session, YkJson *json, const YkState *state);
// Write the forces of the configuration if session->dynamics has them.
void yk_forces_text(YkSession *session);
void yk_forces_json(YkSession *session, YkJson *json);
void yk_forces_csv(YkSession *session, const char *label);
// Writes "12 force + 4 moment + 4 acceleration = 20 equations; 20 unknowns".
void yk_add_count(YkText *text, YkEquationCount count);
void yk_add_equations_json(YkJson *json, YkEquationCount count); // "equations": the counts and the text

#endif
