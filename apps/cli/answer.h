// Shared by the answers of all verbs: how a status is reported, how a number is shown, how JSON begins.
#ifndef CLI_ANSWER_H
#define CLI_ANSWER_H
#include "cli.h"
#include "write/json.h"

enum { YK_CODE_SIZE = 6, YK_DIGITS = 6, YK_NAME_SIZE = 256 };

// Returns the code that `yoke explain` knows for a status; YK_CODE_NONE for YK_OK.
YkCode yk_status_code(YkStatus status);
// Writes a code as it is printed: "E0602".
const char *yk_code_word(YkCode code, char word[YK_CODE_SIZE]);
// Adds a status other than YK_OK to the problems, in the given words.
void yk_tell_status(YkSession *session, YkStatus status, const char *message);
// Remembers that memory ran out where a status that is not reported says so; the verb then gives no answer.
void yk_note_status(YkSession *session, YkStatus status);
// Returns 0 if the answer stands, 1 if the machine has none, 2 if the request was wrong.
int yk_status_exit(YkStatus status);
// Returns the degrees of freedom: by rank if that could be measured, otherwise by Gruebler's count.
int yk_freedom_of(const YkMechanism *mech);
// Writes "model", "status", "freedom" and, if the status is not ok, "message" and "code".
void yk_json_head(YkJson *json, YkSession *session, YkStatus status, const char *message);
// Returns a value in the file's unit; noise by the session's scale (scale.h) becomes zero.
double yk_shown(const YkSession *session, double value, YkQuantity quantity);
// Warns of a cam that would have to pull its follower, from a time on (NULL: at this pose).
void yk_warn_of_pulling_cam(YkSession *session, const char *name, const double *since);
// Warns of all such cams at the pose just solved.
void yk_warn_of_pulling_cams(YkSession *session, const YkDynamics *dynamics);
const char *yk_unit_of(const YkSession *session, YkQuantity quantity);
// Returns the quantity of a coordinate's order-th derivative.
YkQuantity yk_quantity_of(bool is_distance, int order);
// Adds "190.09 deg", to `digits` significant digits, in the file's unit; angles in radians also in degrees.
void yk_add_value(const YkSession *session, YkText *text, double value, YkQuantity quantity, int digits);
// Returns the configuration's label in a text of its own, which the caller frees.
YkText yk_label_of(const YkState *state);
// Returns an acceleration; NaN if it is undefined, or if the dynamics that should give it found none.
double yk_if_accelerations(const YkSession *session, const YkState *state, double value);
// Returns a position; NaN for a rate that is undefined here.
double yk_if_rates(const YkState *state, double value);

#endif
