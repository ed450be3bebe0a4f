// Defines what posix.h declares.
#include "posix.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

char *realpath(const char *path, char *resolved)
{
    return resolved ? strcpy(resolved, path) : strdup(path);
}

// The first free name; the system is in memory, and one command runs in it.
char *mkdtemp(char *pattern)
{
    char *end = pattern + strlen(pattern) - 6;
    for (unsigned try = 0; try < 1000; try++) {
        for (unsigned k = 0, digits = try; k < 6; k++, digits /= 10) end[5 - k] = (char)('0' + digits % 10);
        if (mkdir(pattern, 0700) == 0) return pattern;
        if (errno != EEXIST) return NULL;
    }
    return NULL;
}

int fchmod(int descriptor, mode_t mode)
{
    (void)descriptor, (void)mode;
    return 0;
}

uid_t geteuid(void)
{
    return 1000;
}
