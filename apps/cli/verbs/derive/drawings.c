// yoke derive --svg DIR: draws the free bodies, with one file for each body and junction.
#include "picture/free_body.h"
#include "verbs/derive/derive.h"
#include "write/file_set.h"

enum { DRAWINGS_MAX = 2000 };

static bool draw_all(YkSession *session, YkFreeBodyDrawings *pictures, YkFileEntry *files, YkText *names)
{
    for (size_t k = 0; k < yk_free_body_drawings_count(pictures); k++) {
        const char *svg = yk_free_body_drawings_svg(pictures, k);
        if (!svg) return yk_session_refuse_for_memory(session);
        yk_text_puts(&files[k].text, svg);
        yk_text_format(&names[k], "%s.svg", yk_free_body_drawings_stem(pictures, k));
        if (files[k].text.failed || names[k].failed) return yk_session_refuse_for_memory(session);
        files[k].name = yk_text_get(&names[k]);
    }
    return true;
}

static bool write_all(YkSession *session, YkFreeBodyDrawings *pictures)
{
    size_t count = yk_free_body_drawings_count(pictures);
    YkFileEntry *files = yk_session_alloc(session, count + 1, sizeof *files);
    YkText *names = yk_session_alloc(session, count + 1, sizeof *names);
    bool good = files && names ? draw_all(session, pictures, files, names) : yk_session_refuse_for_memory(session);
    good = good && yk_files_write(session->request->svg, files, count, session->problems);
    for (size_t k = 0; k < count && files; k++) yk_text_free(&files[k].text);
    for (size_t k = 0; k < count && names; k++) yk_text_free(&names[k]);
    return good;
}

int yk_derive_drawings(YkSession *session, YkDerivation *derivation, bool has_forces)
{
    if (derivation->model->body_count > DRAWINGS_MAX) {
        yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--svg draws machines of at most 2000 bodies%s", "");
        return YK_EXIT_WRONG;
    }
    YkFreeBodyDrawings *pictures =
        yk_free_body_drawings_new(derivation, session->state, has_forces ? session->dynamics : NULL);
    if (!pictures) {
        const char *why = yk_ring_status_text(yk_ring_status(derivation->ring));
        if (yk_derivation_ran_out(derivation)) {
            yk_session_refuse_for_memory(session);
            return YK_EXIT_WRONG;
        }
        yk_session_refuse(session, YK_CODE_DERIVATION, "--svg: the free bodies cannot be drawn: %s",
                          yk_ring_status(derivation->ring) == YK_RING_OK ? "the pose is not finite" : why);
        return YK_EXIT_NO_ANSWER;
    }
    bool good = write_all(session, pictures);
    yk_free_body_drawings_free(pictures);
    return good ? YK_EXIT_DONE : YK_EXIT_WRONG;
}
