// Writes whole files, each by way of a new file beside it.
#define _XOPEN_SOURCE 700 // realpath
#include "write/file_inside.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>
#include "base/problems.h"

enum { TEMPORARY_TRIES = 100 };

YkFileKind yk_file_kind(const char *path)
{
    const char *folder = strrchr(path, '/'), *ending = strrchr(folder ? folder : path, '.');
    static const char *const names[] = {"svg", "pdf", "png"};
    for (YkFileKind kind = YK_FILE_SVG; ending && kind < YK_FILE_OTHER; kind++)
        if (strcasecmp(ending + 1, names[kind]) == 0) return kind;
    return YK_FILE_OTHER;
}

bool yk_file_fail(const char *path, int error, YkProblems *problems)
{
    const YkPlace nowhere = {0};
    char words[128] = "unknown error";
    if (error == ENOENT || error == ENOTDIR) {
        yk_problem(problems, YK_CODE_OUTPUT_NO_FOLDER, nowhere, "cannot write %q: its folder does not exist", path);
    } else if (error == EACCES || error == EPERM || error == EROFS) {
        yk_problem(problems, YK_CODE_OUTPUT_DENIED, nowhere, "cannot write %q: permission denied", path);
    } else if (error == EISDIR) {
        yk_problem(problems, YK_CODE_OUTPUT_IS_FOLDER, nowhere, "cannot write %q: it is a folder", path);
    } else if (error == ENOMEM) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, nowhere, "out of memory");
    } else if (error == EFBIG) {
        yk_problem(problems, YK_CODE_OUTPUT_FULL, nowhere,
                   "cannot write %q: it would be larger than a file may be here", path);
    } else if (error == ENOSPC || error == EDQUOT) {
        yk_problem(problems, YK_CODE_OUTPUT_FULL, nowhere, "cannot write %q: no space left", path);
    } else {
        (void)strerror_r(error, words, sizeof words);
        yk_problem(problems, YK_CODE_OUTPUT_FAILED, nowhere, "cannot write %q: %s", path, words);
    }
    return false;
}

int yk_file_write_all(int descriptor, const char *data, size_t length, size_t *written)
{
    size_t done = 0;
    int error = data == yk_text_lost ? ENOMEM : 0;
    while (done < length && error == 0) {
        ssize_t count = write(descriptor, data + done, length - done);
        if (count >= 0)
            done += (size_t)count;
        else if (errno != EINTR)
            error = errno;
    }
    if (written) *written = done;
    return error;
}

bool yk_file_write_to(int descriptor, const char *name, const char *data, size_t length, YkProblems *problems)
{
    int error = yk_file_write_all(descriptor, data, length, NULL);
    return error == 0 || yk_file_fail(name, error, problems);
}

int yk_file_open_beside(const char *path, YkText *name)
{
    const char *slash = strrchr(path, '/');
    int descriptor = -1;
    for (unsigned i = 0; i < TEMPORARY_TRIES; i++) {
        yk_text_clear(name);
        if (slash) yk_text_add(name, path, (size_t)(slash - path) + 1);
        yk_text_format(name, ".yoke-%d-%u.tmp", (int)getpid(), i);
        errno = ENOMEM;
        if (name->failed) return -1;
        descriptor = open(name->data, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) return descriptor;
    }
    return descriptor;
}

int yk_file_find(const char *path, char **target, bool *exists, struct stat *old)
{
    *target = NULL;
    *exists = stat(path, old) == 0;
    if (*exists && S_ISDIR(old->st_mode)) return EISDIR;
    if (*exists && !S_ISREG(old->st_mode)) return 0;
    if (!*exists && *path == '\0') return ENOENT;
    if (!*exists && path[strlen(path) - 1] == '/') return EISDIR;
    *target = *exists ? realpath(path, NULL) : strdup(path); // replaces what a link points to, not the link
    if (!*target) return errno;
    return *exists && access(*target, W_OK) < 0 ? errno : 0;
}

int yk_file_put(int descriptor, const char *temporary, const char *target, const struct stat *old)
{
    int error = old && fchmod(descriptor, old->st_mode & 07777) < 0 ? errno : 0;
    if (error == 0 && fsync(descriptor) < 0 && errno != EINVAL && errno != ENOTSUP) error = errno;
    if (close(descriptor) < 0 && error == 0) error = errno;
    if (error == 0 && rename(temporary, target) < 0) error = errno;
    if (error != 0) unlink(temporary);
    return error;
}

static int write_directly(const char *path, const char *data, size_t length)
{
    int descriptor = open(path, O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    int error = yk_file_write_all(descriptor, data, length, NULL);
    if (close(descriptor) < 0 && error == 0) error = errno;
    return error;
}

static int replace_whole(const char *path, const struct stat *old, const char *data, size_t length)
{
    YkText name = {0};
    int descriptor = yk_file_open_beside(path, &name), error = descriptor < 0 ? errno : 0;
    if (error == 0) {
        error = yk_file_write_all(descriptor, data, length, NULL);
        if (error == 0) {
            error = yk_file_put(descriptor, name.data, path, old);
        } else {
            close(descriptor);
            unlink(name.data);
        }
    }
    yk_text_free(&name);
    return error;
}

bool yk_file_write(const char *path, const char *data, size_t length, YkProblems *problems)
{
    struct stat old;
    bool exists;
    char *target;
    int error = yk_file_find(path, &target, &exists, &old);
    if (error == 0)
        error = target ? replace_whole(target, exists ? &old : NULL, data, length) : write_directly(path, data, length);
    free(target);
    return error == 0 || yk_file_fail(path, error, problems);
}
