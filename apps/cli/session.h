// A run's steps that the verbs share: from the file to a pose, and the output of the answer.
#ifndef CLI_SESSION_H
#define CLI_SESSION_H
#include "cli.h"

// Loads only the model. Returns false if the file is wrong, with everything printed.
bool yk_session_model(YkSession *session);
// Loads the model and compiles it; coordinates that the command line sets are its inputs. `swept` (or NULL) is one
// more, the first. Returns false if the file or a name is wrong, with everything printed.
bool yk_session_load(YkSession *session, const char *swept);
bool yk_session_load_over(YkSession *session, const char *first, const char *second); // with two that are swept
// Makes the state and sets its inputs: drives at --time, then --at, --rate, --accel, which are held from then on.
// Returns false if a value is wrong. The pose comes from yk_session_reach (reach.h).
bool yk_session_inputs(YkSession *session);
// Fills the options of loading with --param, unless with_params is false, and --lock. Returns false when out of memory.
bool yk_session_load_options(const YkSession *session, bool with_params, YkLoadOptions *options);
// Loads the model with the parameters of --param or, with_params false, with the file's own.
YkModel *yk_session_load_model(YkSession *session, bool with_params, YkProblems *problems);
// Makes a list of problems that quotes the model file. Returns NULL when out of memory.
YkProblems *yk_session_file_problems(const YkSession *session);
// Holds the inputs of a state as --at, --rate and --accel say.
void yk_session_hold(const YkSession *session, YkState *state);
// Makes the dynamics, with --effort; inputs set by --accel are prescribed, or all are (an imposed motion). Returns
// false if a name or value is wrong.
bool yk_session_forces(YkSession *session, bool all_prescribed);
// Returns whether there are forces; if there are none, refuses what was asked of them.
bool yk_session_has_forces(YkSession *session);
// Reads --method reduced|newton-euler.
bool yk_session_method(YkSession *session, YkMethod *method);
// Finds a coordinate by name; refuses unknown names and suggests the nearest.
bool yk_session_coordinate(YkSession *session, const char *name, size_t *coordinate);
// Reads --effort pair `index`: the coordinate and its value.
bool yk_session_effort(YkSession *session, size_t index, size_t *coordinate, double *effort);
// Reads a value of the command line; option and name ("--at", "theta1") stand for it in messages.
bool yk_session_value(YkSession *session, const char *option, const char *name, const char *text, YkQuantity quantity,
                      double *value);
// Returns whether the command line names a file; refuses it otherwise.
bool yk_session_has_file(YkSession *session);
// Reads a count between 1 and `most`; `fallback` if text is NULL.
bool yk_session_count(YkSession *session, const char *option, const char *text, size_t most, size_t fallback,
                      size_t *count);
// Reads --threads: by default as many as there are processors, or this rank's share of them.
bool yk_session_threads(YkSession *session, size_t *count);
// Does the same for a number that may be larger than a count can be.
bool yk_session_whole(YkSession *session, const char *option, const char *text, uint64_t most, uint64_t fallback,
                      uint64_t *whole);
// Finds points by name, BODY.POINT; points[names->count]. Returns false for an unknown name.
bool yk_session_points(YkSession *session, const YkWords *names, size_t *points);
// Returns whether something could not be made for want of memory: its problems say so, or there are none at all.
bool yk_ran_out(const YkProblems *problems);
// Remembers that memory ran out during an answer: it is then refused, whatever was found.
void yk_session_run_out(YkSession *session);
// Returns zeroed memory that lasts as long as the run; NULL when out of memory.
void *yk_session_alloc(const YkSession *session, size_t count, size_t size);
// Returns what yk_state_bodies does, valid until the next call; NULL when out of memory, which is remembered.
const YkMotion *yk_session_bodies(YkSession *session, const YkState *state);
// Refuses with a short message; returns false.
bool yk_session_refuse(YkSession *session, YkCode code, const char *format, const char *word);
// Refuses since memory ran out; returns false.
bool yk_session_refuse_for_memory(YkSession *session);
// Returns whether nothing has run out of memory so far: whatever is written then, no E0100 will stand beside it.
bool yk_session_has_memory(YkSession *session);
// Writes the answer to -o FILE or standard output; returns `exit_code`, or YK_EXIT_WRONG when it could not be written.
int yk_session_finish(YkSession *session, int exit_code);
void yk_session_free(YkSession *session);

#endif
