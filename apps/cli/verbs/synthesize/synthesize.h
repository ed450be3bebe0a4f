// Shared by the files of `yoke synthesize`.
#ifndef CLI_SYNTHESIZE_H
#define CLI_SYNTHESIZE_H
#include "cli.h"
#include "write/json.h"

typedef struct YkSynthesisAnswer {
    YkSession *session;
    YkTask *task;
    YkSynthesis *synthesis;
    double deadline; // on the clock of yk_stop_now, s; 0: none
    bool is_late;    // the deadline ended the search
    uint64_t seed;
    size_t threads;
    int percent; // of the search, printed last by --so-far
} YkSynthesisAnswer;

// "ok", "none", "interrupted" or "time".
const char *yk_synthesis_word(const YkSynthesisAnswer *answer);
void yk_synthesis_text(const YkSynthesisAnswer *answer);
void yk_synthesis_json(const YkSynthesisAnswer *answer, YkText *text);
// Writes what is known of a machine while the search runs.
void yk_synthesis_json_machine(YkJson *json, const YkCandidate *candidate);
// so_far.c: print a line about the part that is done, if it is another one; and about a machine (YkFindings).
void yk_synthesis_tell_part(YkSynthesisAnswer *answer, double part);
void yk_synthesis_tell_found(void *context, const YkCandidate *candidate, size_t place, size_t best);
// Writes the files of -o. Returns false with a problem added.
bool yk_synthesis_files(const YkSynthesisAnswer *answer, const char *folder);

// spread.c: lets all ranks of mpirun compute pieces of the search. Returns NULL with problems added, or stopped.
typedef struct YkSynthesisSpread YkSynthesisSpread;
YkSynthesisSpread *yk_synthesis_spread(YkSynthesisAnswer *answer, YkSynthesisOptions *options, YkProblems *problems);
void yk_synthesis_gather(YkSynthesisSpread *spread); // ends it
// The part of ranks other than 0, whether the task could be read or not. Returns the exit code.
int yk_synthesis_serve(YkSynthesisAnswer *answer, bool is_read);

// sheets.c: returns the name of a further picture, with its text; NULL if the task has none. *ran_out: out of memory.
enum { YK_SHEET_FILES = 2 };
const char *yk_synthesis_sheet_file(const YkSynthesisAnswer *answer, size_t index, const char **svg, bool *ran_out);

// threads.c: lets threads of this process compute pieces. Returns NULL with problems added when out of memory.
typedef struct YkSynthesisThreads YkSynthesisThreads;
YkSynthesisThreads *yk_synthesis_threads(YkSynthesisAnswer *answer, YkSynthesisOptions *options, YkProblems *problems);
void yk_synthesis_join(YkSynthesisThreads *threads); // ends them

#endif
