// The bodies round a loop, for the formats of `yoke check`.
#include "verbs/check/check.h"

size_t yk_check_loop(const YkCheckAnswer *answer, size_t loop)
{
    size_t most = yk_model_body_count(answer->session->model);
    size_t count = yk_loop_bodies(answer->session->mech, loop, answer->bodies, most);
    return count < most ? count : most;
}
