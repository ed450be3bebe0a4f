// yoke synthesize -o DIR: a model file for each candidate, one picture of all, and the answer as JSON.
#include <stdlib.h>
#include "session.h"
#include "verbs/synthesize/synthesize.h"
#include "write/file_set.h"

bool yk_synthesis_files(const YkSynthesisAnswer *answer, const char *folder)
{
    YkSession *session = answer->session;
    size_t count = yk_synthesis_count(answer->synthesis);
    YkFileEntry *files = calloc(count + 2, sizeof *files);
    const char *picture = yk_synthesis_picture(answer->synthesis);
    bool good = files && picture;
    for (size_t k = 0; k < count && good; k++) {
        YkCandidate candidate = yk_synthesis_candidate(answer->synthesis, k);
        files[k].name = candidate.file;
        yk_text_puts(&files[k].text, candidate.model);
    }
    if (good) {
        files[count].name = "candidates.svg";
        yk_text_puts(&files[count].text, picture);
        files[count + 1].name = "task.json";
        yk_synthesis_json(answer, &files[count + 1].text);
    }
    for (size_t k = 0; k < count + 2 && good; k++) good = !files[k].text.failed;
    if (!good) yk_session_refuse(session, YK_CODE_OUT_OF_MEMORY, "out of memory%s", "");
    good = good && yk_files_write(folder, files, count + 2, session->problems);
    for (size_t k = 0; k < count + 2 && files; k++) yk_text_free(&files[k].text);
    free(files);
    return good;
}
