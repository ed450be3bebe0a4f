// yoke synthesize -o DIR: a model file for each candidate, pictures of all, and the answer as JSON.
#include "session.h"
#include "verbs/synthesize/synthesize.h"
#include "write/file_set.h"

bool yk_synthesis_files(const YkSynthesisAnswer *answer, const char *folder)
{
    YkSession *session = answer->session;
    size_t count = yk_synthesis_count(answer->synthesis);
    enum { MORE = 2 + YK_SHEET_FILES };
    YkFileEntry *files = yk_session_alloc(answer->session, count + MORE, sizeof *files);
    const char *picture = yk_synthesis_picture(answer->synthesis);
    bool good = files && picture;
    size_t written = 0;
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
        written = count + 2;
    }
    for (size_t k = 0; k < YK_SHEET_FILES && good; k++) {
        bool ran_out;
        const char *svg, *name = yk_synthesis_sheet_file(answer, k, &svg, &ran_out);
        good = !ran_out;
        if (!svg) continue;
        files[written].name = name;
        yk_text_puts(&files[written++].text, svg);
    }
    for (size_t k = 0; k < written && good; k++) good = !files[k].text.failed;
    if (!good) yk_session_refuse_for_memory(session);
    good = good && yk_files_write(folder, files, written, session->problems);
    for (size_t k = 0; k < count + MORE && files; k++) yk_text_free(&files[k].text);
    return good;
}
