// Certificates of motions.
#include "certify.h"
#include <string.h>
#include "answer.h"

bool yk_certify_begin(YkSession *session)
{
    if (session->request->trust) return true;
    session->certifier = yk_certifier_new(session->mech);
    return session->certifier || yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
}

void yk_certify_end(YkSession *session)
{
    yk_certifier_free(session->certifier);
}

void yk_certify_watch(YkSession *session)
{
    if (session->certifier) yk_state_set_certifier(session->state, session->certifier);
}

void yk_certify_warn(YkSession *session)
{
    if (!session->certifier) return;
    YkMotionCertificate found = yk_certifier_report(session->certifier);
    if (found.input < 0) return; // all is proved, or nothing can be
    YkText place = {0};
    if (found.input >= 0) {
        YkCoordinateInfo info =
            yk_coordinate_info(session->mech, yk_input_coordinate(session->mech, (size_t)found.input));
        YkQuantity quantity = yk_quantity_of(info.is_distance, 0);
        yk_text_format(&place, "; first between %s = ", info.name);
        yk_add_value(session, &place, found.from, quantity, 12);
        yk_text_puts(&place, " and ");
        yk_add_value(session, &place, found.to, quantity, 12);
    }
    yk_problem(session->problems, YK_CODE_NOT_CERTIFIED, (YkPlace){0}, "%s%s", found.message, yk_text_get(&place));
    session->out.failed |= place.failed;
    yk_text_free(&place);
}

void yk_certify_json(const YkSession *session, YkJson *json)
{
    if (session->certifier)
        yk_json_bool(json, "certified", yk_certifier_report(session->certifier).is_certified);
    else
        yk_json_null(json, "certified");
}

void yk_certify_text(const YkSession *session, const char *before, YkText *text)
{
    if (!session->certifier) return;
    YkMotionCertificate found = yk_certifier_report(session->certifier);
    if (found.steps > 0) yk_text_format(text, "%s%s\n", before, found.message);
}
