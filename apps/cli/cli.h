// The command `yoke`: what its files share. One verb, one question; results go to standard output, everything else to
// standard error.
#ifndef CLI_CLI_H
#define CLI_CLI_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/yoke.h>
#include "base/memory.h"
#include "base/problems.h"
#include "base/text.h"
#include "scale.h"

// Exit codes.
enum { YK_EXIT_DONE = 0, YK_EXIT_NO_ANSWER = 1, YK_EXIT_WRONG = 2 }; // 128 + its number: ended by a signal (stop.h)

typedef enum YkFormat { YK_FORMAT_TEXT, YK_FORMAT_JSON, YK_FORMAT_CSV } YkFormat;

// --at theta1=30deg, as a name and a value.
typedef struct YkAssignment {
    const char *name, *value;
} YkAssignment;
typedef struct YkAssignments {
    YkAssignment *items;
    size_t count, capacity;
} YkAssignments;
typedef struct YkWords {
    const char **items;
    size_t count, capacity;
} YkWords;

typedef struct YkVerb YkVerb;
typedef struct YkAnswerColumns YkAnswerColumns;

// A command line, read.
typedef struct YkRequest {
    YkArena *arena;     // copies of words, and what the run needs
    const YkVerb *verb; // NULL: none given
    const char *file;   // the model; for `explain` a code
    YkAssignments at, rate, accel, param, effort;
    YkWords trace;
    YkWords checks;         // derive
    const char *what, *svg; // derive
    const char *animate;    // draw
    const char *polygon;    // draw, solve
    const char *centrodes;  // draw
    const char *assembly;
    const char *time, *over, *of, *steps, *poses, *plot, *output, *format_word;
    const char *from, *to, *tolerance, *every, *method, *step, *starts; // simulate, rest
    YkAssignments event;
    const char *cam, *profile, *chord, *cutter, *compare, *limits, *speed; // cam
    const char *lock, *in, *out, *efficiency;                              // gears
    YkWords vary;                                                          // study
    const char *sample, *designs, *seed, *threads;                         // study
    YkFormat format;
    bool sensitivities, fresh; // study
    const char *within;        // solve --all, synthesize
    const char *solver;        // solve --all
    const char *task;          // new
    const char *fluctuation;   // balance
    const char *weights;       // balance
    bool defects, centers;     // synthesize; solve, draw
    bool so_far;               // synthesize
    const char *prefix;        // code
    bool single, kinematics;   // code
    YkAssignments pose, reach; // map
    const char *port;          // studio
    bool no_browser;           // studio
    bool trust;                // solve, sweep, simulate, draw, report
    bool all, modes, sketch, quiet, help, version, no_labels, numbers, plain;
} YkRequest;

// One run: the request and its results so far.
struct YkSession {
    const YkRequest *request;
    YkProblems *problems; // of the command line and of the answer: printed as "yoke: error: ..."
    YkModel *model;
    YkMechanism *mech;
    YkMechanism *base; // compiled without the command line's inputs, if those differ; otherwise NULL
    YkModel *own;      // the file with its own parameters, if --param gives others; otherwise NULL
    YkState *state;
    YkInputHold *holds; // [hold_count]: what --at, --rate and --accel set
    size_t hold_count;
    YkMotion *bodies;               // yk_session_bodies keeps them here
    double time;                    // --time, s
    YkMove move;                    // how the pose was reached
    YkText reach_message;           // why it was not reached
    bool is_chosen;                 // --assembly chose the configuration
    bool is_start;                  // the configuration that is written is the machine's own
    YkDynamics *dynamics;           // if forces are asked for and the machine has masses or loads; otherwise NULL
    const char *forces_message;     // why the pose has no forces although the machine has loads; otherwise NULL
    const YkAnswerColumns *columns; // solve: those of --of; NULL: everything is written
    bool lacks_accelerations;       // the dynamics found none for the pose: the state's are meaningless
    bool is_told;                   // the problems are printed already
    bool has_told_error;            // of these or of another list
    bool keeps_what_is_done;        // Ctrl-C: the verb answers with what is done, and says so itself
    bool ran_out;                   // memory ran out, so nothing is answered
    bool has_told_memory;           // E0100
    bool is_simulation;        // only --at chooses inputs; the file's problems are printed later, with the simulation's
    YkProblems *file_problems; // then; otherwise NULL
    YkText out;                // for standard output; written once, at the end
    YkScale scale;             // what is noise in the text
    struct YkRolls *rolls;     // configurations that were enumerated (roll.h); or NULL
    YkCertifier *certifier;    // that watches session->state (certify.h); NULL: the motion is not certified
};

struct YkVerb {
    const char *name, *summary;
    const char *usage; // "FILE [options]"
    const char *about; // for --help: what the verb answers, in a few lines
    const char *example;
    int (*run)(YkSession *session);
};

// The verbs in the order in which they are listed; ends at name NULL.
extern const YkVerb yk_verbs[];
const YkVerb *yk_verb_find(const char *name);
int yk_run_check(YkSession *session);
int yk_run_solve(YkSession *session);
int yk_run_sweep(YkSession *session);
int yk_run_simulate(YkSession *session);
int yk_run_rest(YkSession *session);
int yk_run_cam(YkSession *session);
int yk_run_draw(YkSession *session);
int yk_run_explain(YkSession *session);
int yk_run_new(YkSession *session);
int yk_run_gears(YkSession *session);
int yk_run_derive(YkSession *session);
int yk_run_report(YkSession *session);
int yk_run_study(YkSession *session);
int yk_run_code(YkSession *session);
int yk_run_synthesize(YkSession *session);
int yk_run_studio(YkSession *session);
int yk_run_cognates(YkSession *session);
int yk_run_map(YkSession *session);
int yk_run_balance(YkSession *session);

// Returns whether a request for memory was refused since the start, anywhere in the program (watch.c); always false
// if the linker does not say.
bool yk_memory_ran_out(void);
// Prints a list of problems on standard error; with --quiet, only if there is an error among them. NULL: there was
// no memory for a list. A verb that returns YK_EXIT_WRONG without a report ran out of memory, and main says so.
void yk_tell_problems(YkSession *session, YkProblems *problems);
// Returns them in words, "" for none. The words are kept in the list, so that printing it needs no more memory.
const char *yk_words_of_problems(const YkSession *session, YkProblems *problems);

#endif
