// Stands in for server.c in a browser, where nothing can be served.
#include "verbs/studio/studio.h"

int yk_studio_serve(YkSession *session, const YkAssets *assets, YkServed *served)
{
    (void)assets, (void)served;
    yk_problem(session->problems, YK_CODE_STUDIO_NO_SERVER, (YkPlace){0},
               "this yoke runs in a browser, and cannot serve Studio");
    yk_problem_hint(session->problems,
                    "`yoke studio FILE -o page.html` writes the page with the machine in it as one file");
    return YK_EXIT_WRONG;
}
