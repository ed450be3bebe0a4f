// Shared by the answers of all verbs.
#include "answer.h"
#include <math.h>
#include "solve/state.h"
#include "write/amount.h"

YkCode yk_status_code(YkStatus status)
{
    switch (status) {
    case YK_OK:
        return YK_CODE_NONE;
    case YK_REDUNDANT:
        return YK_CODE_POSE_REDUNDANT;
    case YK_CHANGE_POINT:
        return YK_CODE_POSE_CHANGE_POINT;
    case YK_SINGULAR:
        return YK_CODE_POSE_SINGULAR;
    case YK_LIMIT:
        return YK_CODE_POSE_LIMIT;
    case YK_NO_ASSEMBLY:
        return YK_CODE_POSE_NO_ASSEMBLY;
    case YK_NOT_CONVERGED:
        return YK_CODE_POSE_NOT_CONVERGED;
    case YK_NO_MEMORY:
        return YK_CODE_OUT_OF_MEMORY;
    case YK_STOPPED:
        return YK_CODE_POSE_STOPPED;
    default:
        return YK_CODE_OPTION_VALUE;
    }
}

const char *yk_code_word(YkCode code, char word[YK_CODE_SIZE])
{
    int number = (int)code;
    word[0] = "NWE"[yk_code_severity(number)];
    for (int i = 4; i > 0; i--, number /= 10) word[i] = (char)('0' + number % 10);
    word[5] = '\0';
    return word;
}

void yk_note_status(YkSession *session, YkStatus status)
{
    session->ran_out |= status == YK_NO_MEMORY;
}

int yk_status_exit(YkStatus status)
{
    if (status >= 0) return YK_EXIT_DONE;
    return status == YK_LIMIT || status == YK_NO_ASSEMBLY || status == YK_NOT_CONVERGED || status == YK_STOPPED
               ? YK_EXIT_NO_ANSWER
               : YK_EXIT_WRONG;
}

// Returns the meaning of a status, if the solver has no more to say about it.
static const char *words_of(YkStatus status, const char *message)
{
    if (message && *message) return message;
    switch (status) {
    case YK_REDUNDANT:
        return "some constraints repeat others; the machine moves as long as its dimensions are exact";
    case YK_CHANGE_POINT:
        return "two configurations meet here";
    case YK_SINGULAR:
        return "a dead point, where velocities and accelerations are not determined";
    case YK_NO_MEMORY:
        return "out of memory";
    default:
        return yk_status_name(status);
    }
}

void yk_tell_status(YkSession *session, YkStatus status, const char *message)
{
    if (status == YK_OK) return;
    yk_problem(session->problems, yk_status_code(status), (YkPlace){0}, "%s: %s", yk_status_name(status),
               words_of(status, message));
    bool gave_up = status == YK_NOT_CONVERGED && session->state && yk_state_report(session->state)->status == status;
    if (gave_up) yk_problem_hint(session->problems, "give guesses nearer to the intended assembly in `start:`");
}

int yk_freedom_of(const YkMechanism *mech)
{
    YkFreedom freedom = yk_mechanism_freedom(mech);
    return freedom.by_rank >= 0 ? freedom.by_rank : freedom.gruebler;
}

void yk_json_head(YkJson *json, YkSession *session, YkStatus status, const char *message)
{
    char code[YK_CODE_SIZE];
    yk_json_string(json, "model", yk_model_name(session->model));
    yk_json_string(json, "status", yk_status_name(status));
    yk_json_integer(json, "freedom", yk_freedom_of(session->mech));
    if (status == YK_OK) return;
    yk_json_string(json, "message", words_of(status, message));
    yk_json_string(json, "code", yk_code_word(yk_status_code(status), code));
}

double yk_shown(const YkSession *session, double value, YkQuantity quantity)
{
    return fabs(value) <= yk_scale_noise(session, quantity) ? 0 : yk_amount_of(session->model, value, quantity);
}

const char *yk_unit_of(const YkSession *session, YkQuantity quantity)
{
    return yk_model_shown_unit(session->model, quantity, NULL);
}

YkQuantity yk_quantity_of(bool is_distance, int order)
{
    static const YkQuantity angles[] = {YK_QUANTITY_ANGLE, YK_QUANTITY_ANGLE_RATE, YK_QUANTITY_ANGLE_ACCELERATION};
    static const YkQuantity distances[] = {YK_QUANTITY_LENGTH, YK_QUANTITY_SPEED, YK_QUANTITY_ACCELERATION};
    return is_distance ? distances[order] : angles[order];
}

void yk_add_value(const YkSession *session, YkText *text, double value, YkQuantity quantity, int digits)
{
    yk_amount_write_shown(text, session->model, yk_shown(session, value, quantity), quantity, digits);
}

YkText yk_label_of(const YkState *state)
{
    YkText label = {0};
    yk_state_write_label(state, &label);
    return label;
}

double yk_if_rates(const YkState *state, double value)
{
    return yk_state_has_rates(state) ? value : (double)NAN;
}

double yk_if_accelerations(const YkSession *session, const YkState *state, double value)
{
    return session->lacks_accelerations ? (double)NAN : yk_if_rates(state, value);
}

void yk_warn_of_pulling_cam(YkSession *session, const char *name, const double *since)
{
    YkText when = {0};
    if (since) {
        yk_text_puts(&when, ", from t = ");
        yk_add_value(session, &when, *since, YK_QUANTITY_TIME, YK_DIGITS);
        yk_text_puts(&when, " on");
    }
    yk_problem(session->problems, YK_CODE_CAM_PARTS, (YkPlace){0},
               "cam %q would have to pull its follower, which leaves the cam instead%s; the answer assumes that "
               "they stay in contact",
               name, yk_text_get(&when));
    yk_text_free(&when);
}

void yk_warn_of_pulling_cams(YkSession *session, const YkDynamics *dynamics)
{
    for (size_t k = 0; k < yk_dynamics_contact_count(dynamics); k++)
        if (yk_dynamics_contact_pulls(dynamics, k))
            yk_warn_of_pulling_cam(session, yk_dynamics_contact_name(dynamics, k), NULL);
}
