// What the answers of all verbs share: how a status is told, how a number is shown, how JSON begins.
#ifndef CLI_ANSWER_H
#define CLI_ANSWER_H
#include "cli.h"
#include "write/json.h"

enum { YK_CODE_SIZE = 6, YK_DIGITS = 6, YK_LABEL_SIZE = 256, YK_NAME_SIZE = 256 };

// The code that `yoke explain` knows for a status; YK_CODE_NONE for YK_OK.
YkCode yk_status_code(YkStatus status);
// A code as it is printed: "E0602".
const char *yk_code_word(YkCode code, char word[YK_CODE_SIZE]);
// Adds a status other than YK_OK to the problems, in the words given.
void yk_tell_status(YkSession *session, YkStatus status, const char *message);
// Notes a status that is not told: want of memory leaves no answer.
void yk_note_status(YkSession *session, YkStatus status);
// 0 if the answer stands, 1 if the machine has none, 2 where the request was wrong.
int yk_status_exit(YkStatus status);
// The degrees of freedom: by rank where it could be measured, otherwise by Gruebler's count.
int yk_freedom_of(const YkMechanism *mech);
// "model", "status", "freedom" and, when the status is not ok, "message" and "code".
void yk_json_head(YkJson *json, YkSession *session, YkStatus status, const char *message);
// A value in the file's unit, with what is rounding noise by the session's scale (scale.h) taken for zero.
double yk_shown(const YkSession *session, double value, YkQuantity quantity);
// Warns of cams that would have to pull their followers at the pose just solved; `at` (or NULL) is the time. True:
// there are such.
bool yk_warn_of_pulling_cams(YkSession *session, const YkDynamics *dynamics, const double *at);
const char *yk_unit_of(const YkSession *session, YkQuantity quantity);
// Adds "190.09 deg", to `digits` significant digits, in the file's unit; angles in radians also in degrees.
void yk_add_value(const YkSession *session, YkText *text, double value, YkQuantity quantity, int digits);
// The configuration's label in a text of its own; the caller frees it.
YkText yk_label_of(const YkState *state);
// An acceleration, or NaN where it is not defined, or where the dynamics that should give it found none.
double yk_if_accelerations(const YkSession *session, const YkState *state, double value);
// A position, or NaN where it is a rate that is not defined here.
double yk_if_rates(const YkState *state, double value);

#endif
