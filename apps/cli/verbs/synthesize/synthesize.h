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

// spread.c: lets all ranks of mpirun compute pieces of the search. Returns NULL with problems added, or stopped.
typedef struct YkSynthesisSpread YkSynthesisSpread;
YkSynthesisSpread *yk_synthesis_spread(YkSynthesisAnswer *answer, YkSynthesisOptions *options, YkProblems *problems);
void yk_synthesis_gather(YkSynthesisSpread *spread); // ends it
// What ranks other than 0 do, whether the task could be read or not. Returns the exit code.
int yk_synthesis_serve(YkSynthesisAnswer *answer, bool is_read);

#endif
