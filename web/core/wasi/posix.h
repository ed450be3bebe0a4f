// Declares what the command takes from POSIX and wasi-libc leaves out; included before every source that needs it.
#ifndef WASI_POSIX_H
#define WASI_POSIX_H
#include <signal.h>
#include <stdio.h>
#include <sys/types.h>

char *realpath(const char *path, char *resolved); // a copy: there are no links
char *mkdtemp(char *pattern);
int fchmod(int descriptor, mode_t mode); // files have no permissions
uid_t geteuid(void);
char *strdup(const char *string);

// Signals never come: the page ends the worker instead.
struct sigaction {
    void (*sa_handler)(int signal_number);
    int sa_flags;
};
#define SA_RESETHAND 0
static inline int sigaction(int signal_number, const struct sigaction *action, struct sigaction *old)
{
    (void)signal_number, (void)action, (void)old;
    return 0;
}

#endif
