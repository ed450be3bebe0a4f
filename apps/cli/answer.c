#include "answer.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/number.h"

static const double noise = 1e-13; // of the machine's size: what rounding leaves of a zero

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
    default:
        return YK_CODE_OPTION_VALUE;
    }
}

int yk_status_exit(YkStatus status)
{
    if (status >= 0) return YK_EXIT_DONE;
    return status == YK_LIMIT || status == YK_NO_ASSEMBLY || status == YK_NOT_CONVERGED ? YK_EXIT_NO_ANSWER
                                                                                        : YK_EXIT_WRONG;
}

// What a status means, where the solver has no more to say of it.
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
}

int yk_freedom_of(const YkMechanism *mech)
{
    YkFreedom freedom = yk_mechanism_freedom(mech);
    return freedom.by_rank >= 0 ? freedom.by_rank : freedom.gruebler;
}

void yk_json_head(YkJson *json, YkSession *session, YkStatus status, const char *message)
{
    char code[8] = "E0000";
    yk_json_string(json, "model", yk_model_name(session->model));
    yk_json_string(json, "status", yk_status_name(status));
    yk_json_integer(json, "freedom", yk_freedom_of(session->mech));
    if (status == YK_OK) return;
    int number = (int)yk_status_code(status);
    for (int i = 4; i > 0; i--, number /= 10) code[i] = (char)('0' + number % 10);
    yk_json_string(json, "message", words_of(status, message));
    yk_json_string(json, "code", code);
}

static bool is_length(YkQuantity quantity)
{
    return quantity == YK_QUANTITY_LENGTH || quantity == YK_QUANTITY_SPEED || quantity == YK_QUANTITY_ACCELERATION;
}

// The unit of a quantity in tables and its size in SI: the file's own. Where it names no unit of force, and its units
// of length, mass and time would make an unusual one (kg*mm/s^2), forces are told in N, N*m and J; energies always in J
// rather than in N*m.
static const char *unit_of(const YkSession *session, YkQuantity quantity, double *size)
{
    static const char *const si[] = {
        [YK_QUANTITY_FORCE] = "N", [YK_QUANTITY_TORQUE] = "N*m", [YK_QUANTITY_ENERGY] = "J"};
    const char *unit = yk_model_unit(session->model, quantity, size);
    bool is_of_force = quantity >= YK_QUANTITY_FORCE && quantity <= YK_QUANTITY_ENERGY;
    bool is_joule = quantity == YK_QUANTITY_ENERGY && *size == 1;
    if (!is_of_force || (!strchr(unit, '/') && !is_joule)) return unit;
    *size = 1;
    return si[quantity];
}

double yk_shown(const YkSession *session, double value, YkQuantity quantity)
{
    double size = 1, scale = is_length(quantity) && session->mech ? yk_mechanism_size(session->mech) : 1;
    unit_of(session, quantity, &size);
    if (fabs(value) < noise * scale) return 0;
    return value / size;
}

const char *yk_unit_of(const YkSession *session, YkQuantity quantity)
{
    double size = 1;
    return unit_of(session, quantity, &size);
}

static void add_number(YkText *text, double value, int digits)
{
    char number[YK_NUMBER_SIZE];
    yk_text_add(text, number, yk_number_write_digits(value, digits, number));
}

void yk_add_value(const YkSession *session, YkText *text, double value, YkQuantity quantity, int digits)
{
    const char *unit = yk_unit_of(session, quantity);
    add_number(text, yk_shown(session, value, quantity), digits);
    if (*unit) yk_text_format(text, " %s", unit);
    if (quantity != YK_QUANTITY_ANGLE || strcmp(unit, "rad") != 0) return;
    yk_text_puts(text, " (");
    add_number(text, yk_shown(session, value, quantity) * (180 / 3.14159265358979323846), digits);
    yk_text_puts(text, " deg)");
}

YkText yk_label_of(const YkState *state)
{
    char buffer[YK_LABEL_SIZE];
    YkText label = {0};
    size_t length = yk_state_label(state, buffer, sizeof buffer);
    yk_text_puts(&label, buffer);
    if (length < sizeof buffer) return label;
    char *whole = malloc(length + 1); // a machine of many blocks
    if (whole) {
        yk_state_label(state, whole, length + 1);
        yk_text_clear(&label);
        yk_text_puts(&label, whole);
    }
    free(whole);
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
