// Signals, and progress on a terminal.
#include "stop.h"
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const double shown_after = 1, shown_every = 0.2; // s of real time

static volatile sig_atomic_t signal_seen;
static bool is_heeded;

static struct { // the line on the terminal
    bool is_shown;
    double began, last; // s; began 0: no call yet
} line;

static void note(int signal_number)
{
    signal_seen = signal_number;
}

void yk_stop_catch(void)
{
    struct sigaction once = {.sa_handler = note};
    once.sa_flags = (int)SA_RESETHAND;
    sigaction(SIGINT, &once, NULL);
    sigaction(SIGTERM, &once, NULL);
}

void yk_stop_release(void)
{
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
}

bool yk_stop_is_asked(void)
{
    return signal_seen != 0;
}

bool yk_stop_is_due(void)
{
    is_heeded |= signal_seen != 0;
    return signal_seen != 0;
}

bool yk_stop_is_heeded(void)
{
    return is_heeded;
}

int yk_stop_exit(void)
{
    fputs(signal_seen == SIGINT ? "yoke: stopped by Ctrl-C\n" : "yoke: stopped by a signal\n", stderr);
    return 128 + signal_seen;
}

// --- the line

double yk_stop_now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

bool yk_is_at_terminal(void)
{
    const char *terminal = getenv("TERM");
    return isatty(STDERR_FILENO) && !(terminal && strcmp(terminal, "dumb") == 0);
}

bool yk_stop_shows_progress(const YkSession *session)
{
    return !session->request->quiet && yk_is_at_terminal();
}

void yk_stop_clear_line(void)
{
    if (line.is_shown) fputs("\r\033[K", stderr);
    line.is_shown = false;
}

static void show(const YkSession *session, double part)
{
    double time = yk_stop_now();
    if (line.began == 0) line.began = time;
    if (time - line.began < shown_after || time - line.last < shown_every) return;
    const char *verb = session->request->verb ? session->request->verb->name : "yoke";
    if (part > 0)
        fprintf(stderr, "\r%s: %.0f %%, %.0f s \033[K", verb, 100 * part, time - line.began);
    else
        fprintf(stderr, "\r%s: %.0f s \033[K", verb, time - line.began);
    line.last = time;
    line.is_shown = true;
}

static bool go_on(void *context, double part)
{
    const YkSession *session = context;
    if (!session->keeps_what_is_done && yk_stop_shows_progress(session)) show(session, part);
    return session->keeps_what_is_done ? !yk_stop_is_asked() : !yk_stop_is_due();
}

YkProgress yk_stop_progress(const YkSession *session)
{
    return (YkProgress){go_on, (void *)(uintptr_t)session};
}

YkState *yk_session_new_state(const YkSession *session, const YkMechanism *mech)
{
    YkState *state = yk_state_new(mech);
    if (!state || yk_state_set_progress(state, yk_stop_progress(session)) == YK_OK) return state;
    yk_state_free(state);
    return NULL;
}
