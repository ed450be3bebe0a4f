#define _XOPEN_SOURCE 700 // realpath
#include "out/file.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/problems.h"
#include "base/text.h"

enum { TEMPORARY_TRIES = 100 };

YkFileKind yk_file_kind(const char *path)
{
    const char *folder = strrchr(path, '/'), *ending = strrchr(folder ? folder : path, '.');
    for (YkFileKind kind = YK_FILE_SVG; ending && kind < YK_FILE_OTHER; kind++)
        if (strcasecmp(ending + 1, yk_file_kind_name(kind)) == 0) return kind;
    return YK_FILE_OTHER;
}

const char *yk_file_kind_name(YkFileKind kind)
{
    static const char *const names[] = {"svg", "pdf", "png", "other"};
    return names[kind];
}

static bool fail_at(const char *path, int error, YkProblems *problems)
{
    const YkPlace nowhere = {0};
    char words[128] = "unknown error";
    if (error == ENOENT || error == ENOTDIR) {
        yk_problem(problems, YK_CODE_OUTPUT_NO_FOLDER, nowhere, "cannot write %q: its folder does not exist", path);
    } else if (error == EACCES || error == EPERM || error == EROFS) {
        yk_problem(problems, YK_CODE_OUTPUT_DENIED, nowhere, "cannot write %q: permission denied", path);
    } else if (error == EISDIR) {
        yk_problem(problems, YK_CODE_OUTPUT_IS_FOLDER, nowhere, "cannot write %q: it is a folder", path);
    } else if (error == ENOSPC || error == EDQUOT || error == EFBIG) {
        yk_problem(problems, YK_CODE_OUTPUT_FULL, nowhere, "cannot write %q: no space left", path);
    } else {
        (void)strerror_r(error, words, sizeof words);
        yk_problem(problems, YK_CODE_OUTPUT_FAILED, nowhere, "cannot write %q: %s", path, words);
    }
    return false;
}

// Returns 0, or the error. A write of nothing finds no fault, so an empty output is fine everywhere.
static int write_all(int descriptor, const char *data, size_t length)
{
    while (length > 0) {
        ssize_t written = write(descriptor, data, length);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        data += written;
        length -= (size_t)written;
    }
    return 0;
}

bool yk_file_write_to(int descriptor, const char *name, const char *data, size_t length, YkProblems *problems)
{
    int error = write_all(descriptor, data, length);
    return error == 0 || fail_at(name, error, problems);
}

// A device, a pipe: no file can take its place.
static int write_directly(const char *path, const char *data, size_t length)
{
    int descriptor = open(path, O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    int error = write_all(descriptor, data, length);
    if (close(descriptor) < 0 && error == 0) error = errno;
    return error;
}

// Opens a new file in the folder of `path`; its name goes to `name`. -1 with errno set.
static int open_beside(const char *path, YkText *name)
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

// Fills the new file, gives it the old one's permissions, and brings it safely to the disk.
static int fill(int descriptor, const struct stat *old, const char *data, size_t length)
{
    int error = write_all(descriptor, data, length);
    if (error == 0 && old && fchmod(descriptor, old->st_mode & 07777) < 0) error = errno;
    if (error == 0 && fsync(descriptor) < 0 && errno != EINVAL && errno != ENOTSUP) error = errno;
    if (close(descriptor) < 0 && error == 0) error = errno;
    return error;
}

static int replace_whole(const char *path, const struct stat *old, const char *data, size_t length)
{
    YkText name = {0};
    int descriptor = open_beside(path, &name), error = descriptor < 0 ? errno : 0;
    if (error == 0) {
        error = fill(descriptor, old, data, length);
        if (error == 0 && rename(name.data, path) < 0) error = errno;
        if (error != 0) unlink(name.data);
    }
    yk_text_free(&name);
    return error;
}

bool yk_file_write(const char *path, const char *data, size_t length, YkProblems *problems)
{
    struct stat old;
    int error;
    bool exists = stat(path, &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) {
        error = EISDIR;
    } else if (exists && !S_ISREG(old.st_mode)) {
        error = write_directly(path, data, length);
    } else if (exists) {
        char *target = realpath(path, NULL); // what a link points to is replaced, not the link
        error = !target ? errno : access(target, W_OK) < 0 ? errno : replace_whole(target, &old, data, length);
        free(target);
    } else {
        error = *path == '\0'                   ? ENOENT
                : path[strlen(path) - 1] == '/' ? EISDIR
                                                : replace_whole(path, NULL, data, length);
    }
    return error == 0 || fail_at(path, error, problems);
}
