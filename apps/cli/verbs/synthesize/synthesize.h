// What the files of `yoke synthesize` share.
#ifndef CLI_SYNTHESIZE_H
#define CLI_SYNTHESIZE_H
#include "cli.h"

typedef struct YkSynthesisAnswer {
    YkSession *session;
    YkTask *task;
    YkSynthesis *synthesis;
    double deadline; // on the clock of yk_stop_now, s; 0: none
    bool is_late;    // the deadline ended the search
    uint64_t seed;
} YkSynthesisAnswer;

// "ok", "none", "interrupted" or "time".
const char *yk_synthesis_word(const YkSynthesisAnswer *answer);
void yk_synthesis_text(const YkSynthesisAnswer *answer);
void yk_synthesis_json(const YkSynthesisAnswer *answer, YkText *text);
// Writes the files of -o. Returns false with a problem added.
bool yk_synthesis_files(const YkSynthesisAnswer *answer, const char *folder);

#endif
