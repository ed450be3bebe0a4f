// Stands in for server.c where Yoke is built without libmicrohttpd.
#include "verbs/studio/studio.h"

#ifndef YOKE_HAS_SERVER
int yk_studio_serve(YkSession *session, const YkAssets *assets, YkServed *served)
{
    (void)assets, (void)served;
    yk_problem(session->problems, YK_CODE_STUDIO_NO_SERVER, (YkPlace){0},
               "this yoke was built without libmicrohttpd, and cannot serve Studio");
    yk_problem_hint(session->problems,
                    "`yoke studio FILE -o page.html` writes the page with the machine in it as one file");
    return YK_EXIT_WRONG;
}
#else
typedef int yoke_studio_has_a_server;
#endif
