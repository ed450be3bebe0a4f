// Certificates of motions.
#include "certify.h"
#include <math.h>
#include "answer.h"

bool yk_certify_begin(YkSession *session)
{
    if (session->request->trust) return true;
    session->certifier = yk_certifier_new(session->mech);
    return session->certifier || yk_session_refuse_for_memory(session);
}

void yk_certify_end(YkSession *session)
{
    yk_certifier_free(session->certifier);
}

void yk_certify_watch(YkSession *session)
{
    yk_certify_state(session, session->state);
}

void yk_certify_state(YkSession *session, YkState *state)
{
    if (session->certifier) yk_state_set_certifier(state, session->certifier);
}

void yk_certify_simulation(YkSession *session, YkSimulation *simulation)
{
    if (session->certifier) yk_simulation_set_certifier(simulation, session->certifier);
}

// Writes "t = 1 and 2 s", or the same of the input that moved most.
static void add_place(YkSession *session, const YkMotionCertificate *found, YkText *text)
{
    size_t coordinate = yk_coordinate_find(session->mech, found->coordinate);
    bool is_time = found->from_time != found->to_time;
    bool is_distance = coordinate != YK_NOT_FOUND && yk_coordinate_info(session->mech, coordinate).is_distance;
    YkQuantity quantity = is_time ? YK_QUANTITY_TIME : yk_quantity_of(is_distance, 0);
    yk_text_format(text, "; first between %s = ", is_time ? "t" : found->coordinate);
    yk_add_value(session, text, is_time ? found->from_time : found->from, quantity, 12);
    yk_text_puts(text, " and ");
    yk_add_value(session, text, is_time ? found->to_time : found->to, quantity, 12);
    if (found->joint[0]) yk_text_format(text, ", at joint %q", found->joint);
    yk_text_format(text, ": %s", found->why);
}

void yk_certify_warn(YkSession *session)
{
    if (!session->certifier) return;
    YkMotionCertificate found = yk_certifier_report(session->certifier);
    session->out.failed |= found.has_run_out;
    if (found.input < 0) return; // all is proved, or nothing can be
    YkText place = {0};
    add_place(session, &found, &place);
    yk_problem(session->problems, YK_CODE_NOT_CERTIFIED, (YkPlace){0}, "%s%s", found.message, yk_text_get(&place));
    session->out.failed |= place.failed;
    yk_text_free(&place);
}

// Names the first step that is not proved, and says why.
static void add_reason(const YkMotionCertificate *found, YkJson *json)
{
    bool has_place = found->input >= 0;
    yk_json_object(json, "not_certified", YK_JSON_INLINE);
    yk_json_integer(json, "steps", (long long)found->steps);
    yk_json_integer(json, "proved", (long long)found->proved);
    yk_json_bool(json, "refuted", found->is_refuted);
    yk_json_string(json, "why", found->why);
    yk_json_string(json, "joint", found->joint[0] ? found->joint : NULL);
    yk_json_string(json, "coordinate", has_place ? found->coordinate : NULL);
    yk_json_number(json, "from", has_place ? found->from : (double)NAN);
    yk_json_number(json, "to", has_place ? found->to : (double)NAN);
    yk_json_number(json, "from_time", has_place ? found->from_time : (double)NAN);
    yk_json_number(json, "to_time", has_place ? found->to_time : (double)NAN);
    yk_json_end(json);
}

void yk_certify_json(const YkSession *session, YkJson *json)
{
    if (!session->certifier) {
        yk_json_null(json, "certified");
        return;
    }
    YkMotionCertificate found = yk_certifier_report(session->certifier);
    yk_json_bool(json, "certified", found.is_certified);
    if (!found.is_certified) add_reason(&found, json);
}

void yk_certify_text(const YkSession *session, const char *before, YkText *text)
{
    if (!session->certifier) return;
    YkMotionCertificate found = yk_certifier_report(session->certifier);
    if (found.has_run_out) yk_text_fail(text);
    if (found.steps > 0) yk_text_format(text, "%s%s\n", before, found.message);
}
