// Runs other programs as filters.
#include "write/process.h"
#include <errno.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/problems.h"

extern char **environ; // POSIX: the process's environment, declared in no header

enum { WORDS_MAX = 200 }; // how much of a program's complaint is quoted

typedef struct Streams {
    FILE *input, *output, *error;
} Streams;

static bool open_streams(Streams *streams, const YkText *input)
{
    *streams = (Streams){.input = tmpfile(), .output = tmpfile(), .error = tmpfile()};
    if (!streams->input || !streams->output || !streams->error) return false;
    bool written = fwrite(yk_text_get(input), 1, input->length, streams->input) == input->length;
    return written && fflush(streams->input) == 0 && fseek(streams->input, 0, SEEK_SET) == 0;
}

static void close_streams(Streams *streams)
{
    if (streams->input) fclose(streams->input);
    if (streams->output) fclose(streams->output);
    if (streams->error) fclose(streams->error);
}

// Signals that the caller ignores end the program, since it may not check whether its writes succeed.
static int take_signals(posix_spawnattr_t *attributes)
{
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGPIPE);
#ifdef SIGXFSZ
    sigaddset(&signals, SIGXFSZ);
#endif
    int error = posix_spawnattr_setsigdefault(attributes, &signals);
    return error ? error : posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGDEF);
}

static int start(const char *const *argv, const Streams *streams, const posix_spawnattr_t *attributes, pid_t *child)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error) return error;
    error = posix_spawn_file_actions_adddup2(&actions, fileno(streams->input), STDIN_FILENO);
    if (!error) error = posix_spawn_file_actions_adddup2(&actions, fileno(streams->output), STDOUT_FILENO);
    if (!error) error = posix_spawn_file_actions_adddup2(&actions, fileno(streams->error), STDERR_FILENO);
    // posix_spawnp promises not to change the strings; its type is older than const.
    if (!error) error = posix_spawnp(child, argv[0], &actions, attributes, (char *const *)(const void *)argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

static int spawn(const char *const *argv, const Streams *streams, pid_t *child)
{
    posix_spawnattr_t attributes;
    int error = posix_spawnattr_init(&attributes);
    if (error) return error;
    error = take_signals(&attributes);
    if (!error) error = start(argv, streams, &attributes, child);
    posix_spawnattr_destroy(&attributes);
    return error;
}

static bool read_all(FILE *stream, YkText *text)
{
    char chunk[8192];
    size_t got;
    if (fseek(stream, 0, SEEK_SET) != 0) return false;
    while ((got = fread(chunk, 1, sizeof chunk, stream)) > 0) yk_text_add(text, chunk, got);
    return !ferror(stream) && !text->failed;
}

// Returns the program's exit status; -1 if it did not exit by itself.
static int wait_for(pid_t child)
{
    int status;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static bool run_out(YkProblems *problems)
{
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory");
    return false;
}

// Adds the last line of the program's output to the problem's text.
static bool fail_with(const char *program, const char *purpose, int status, FILE *error, YkProblems *problems)
{
    char words[WORDS_MAX + 1];
    YkText said = {0};
    read_all(error, &said);
    while (said.length > 0 && strchr(" \r\n", said.data[said.length - 1])) said.data[--said.length] = '\0';
    const char *line = strrchr(yk_text_get(&said), '\n');
    line = line ? line + 1 : yk_text_get(&said);
    size_t length = strlen(line) < WORDS_MAX ? strlen(line) : WORDS_MAX;
    memcpy(words, line, length);
    words[length] = '\0';
    yk_problem(problems, YK_CODE_PROGRAM_FAILED, (YkPlace){0}, "%s failed while %s: %s", program, purpose,
               length > 0   ? words
               : status < 0 ? "a signal ended it"
                            : "it said nothing");
    if (said.failed) run_out(problems);
    yk_text_free(&said);
    return false;
}

// A program that could not be started for lack of memory may well be there.
static bool fail_to_start(const char *program, const char *purpose, int error, YkProblems *problems)
{
    if (error == ENOMEM) return run_out(problems);
    yk_problem(problems, YK_CODE_PROGRAM_MISSING, (YkPlace){0}, "%s needs the program %q, which is not on the PATH",
               purpose, program);
    return false;
}

// Takes the output of a program that has ended.
static bool take(const char *const *argv, const char *purpose, int status, const Streams *streams, YkText *output,
                 YkProblems *problems)
{
    if (status == 127) { // the way some systems report a program that does not exist
        yk_problem(problems, YK_CODE_PROGRAM_MISSING, (YkPlace){0}, "%s needs the program %q, which could not be run",
                   purpose, argv[0]);
        return false;
    }
    bool good = status == 0 && read_all(streams->output, output);
    if (output->failed) return run_out(problems);
    return good || fail_with(argv[0], purpose, status, streams->error, problems);
}

bool yk_process_filter(const char *const *argv, const char *purpose, const YkText *input, YkText *output,
                       YkProblems *problems)
{
    Streams streams;
    pid_t child = 0;
    bool good = false;
    if (!open_streams(&streams, input)) {
        bool ran_out = errno == ENOMEM;
        yk_problem(problems, ran_out ? YK_CODE_OUT_OF_MEMORY : YK_CODE_OUTPUT_FAILED, (YkPlace){0},
                   "cannot make a temporary file for %s", argv[0]);
    } else {
        int error = spawn(argv, &streams, &child);
        good = error == 0 ? take(argv, purpose, wait_for(child), &streams, output, problems)
                          : fail_to_start(argv[0], purpose, error, problems);
    }
    close_streams(&streams);
    return good;
}
