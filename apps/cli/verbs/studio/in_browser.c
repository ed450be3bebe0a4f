// Stands in for the verb in a browser, where nothing can be served and the page is there already.
#include "base/problems.h"
#include "session.h"

int yk_run_studio(YkSession *session)
{
    yk_problem(session->problems, YK_CODE_STUDIO_NO_SERVER, (YkPlace){0},
               "this yoke runs in a browser, and cannot serve Studio");
    return YK_EXIT_WRONG;
}
