// Finds equilibria outside the range of a law: the end value that it keeps there is rarely what was meant.
#include "verbs/rest/rest.h"

bool yk_rest_watch_laws(YkRestAnswer *answer)
{
    YkDynamics *dynamics = yk_dynamics_new(answer->mech, NULL);
    answer->laws = dynamics ? yk_session_watch_laws(answer->session) : NULL;
    for (size_t i = 0; answer->laws && i < yk_rest_count(answer->rest); i++) {
        YkState *state = yk_rest_state(answer->rest, i);
        if (yk_dynamics_solve(dynamics, state, YK_METHOD_REDUCED) >= 0)
            yk_law_watch_look(answer->laws, state, dynamics, (double)(i + 1));
    }
    yk_dynamics_free(dynamics);
    return answer->laws != NULL;
}
