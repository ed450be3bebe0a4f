// yoke studio: the page on which a machine is drawn, moved and read; served to the browser, or written as one file.
#include <string.h>
#include "verbs/studio/studio.h"

static int write_page(YkSession *session, const YkAssets *assets, const YkServed *served)
{
    if (!yk_studio_page(assets, served, session, &session->out)) return YK_EXIT_WRONG;
    return yk_session_finish(session, YK_EXIT_DONE);
}

int yk_run_studio(YkSession *session)
{
    YkAssets assets = {0};
    YkServed served = {.path = session->request->file};
    int exit_code = YK_EXIT_WRONG;
    if (served.path && strcmp(served.path, "-") == 0) {
        yk_session_refuse(session, YK_CODE_OPTION_VALUE, "Studio saves into a file, and cannot save into %q", "-");
        return exit_code;
    }
    YkProblems *problems = yk_problems_new();
    bool good = problems && yk_assets_load(&assets, session) && (!served.path || yk_served_read(&served, problems));
    yk_tell_problems(session, problems);
    if (good)
        exit_code = session->request->output ? write_page(session, &assets, &served)
                                             : yk_studio_serve(session, &assets, &served);
    yk_problems_free(problems);
    yk_served_free(&served);
    yk_assets_free(&assets);
    return exit_code;
}
