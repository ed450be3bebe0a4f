// Writes output line by line.
#define _XOPEN_SOURCE 700 // strdup
#include "write/stream.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "write/file_inside.h"

// Opens a new file beside the path, or what exists there and is not a file.
static int open_at(YkStream *stream, const char *path, const struct stat *old)
{
    YkText temporary = {0};
    if (!stream->target) {
        stream->descriptor = open(path, O_WRONLY | O_CLOEXEC);
        return stream->descriptor < 0 ? errno : 0;
    }
    stream->descriptor = yk_file_open_beside(stream->target, &temporary);
    stream->temporary = temporary.data;
    if (stream->has_old) stream->old_mode = (unsigned)old->st_mode;
    return stream->descriptor < 0 ? errno : 0;
}

static void release(YkStream *stream)
{
    free(stream->target);
    free(stream->temporary);
    stream->target = stream->temporary = NULL;
    stream->is_open = false;
}

bool yk_stream_open(YkStream *stream, const char *path, YkProblems *problems)
{
    struct stat old;
    *stream = (YkStream){.name = "standard output", .descriptor = STDOUT_FILENO, .is_open = true};
    if (!path || strcmp(path, "-") == 0) return true;
    stream->name = path;
    int error = yk_file_find(path, &stream->target, &stream->has_old, &old);
    if (error == 0) error = open_at(stream, path, &old);
    if (error == 0) return true;
    release(stream);
    return yk_file_fail(path, error, problems);
}

// Returns how much of the data is whole lines.
static size_t whole_lines(const char *data, size_t length)
{
    while (length > 0 && data[length - 1] != '\n') length--;
    return length;
}

// Removes the last bytes; if that is impossible (a pipe), they stay.
static void cut(const YkStream *stream, size_t length)
{
    off_t end = lseek(stream->descriptor, 0, SEEK_CUR);
    if (end < (off_t)length || ftruncate(stream->descriptor, end - (off_t)length) < 0) return;
    (void)lseek(stream->descriptor, -(off_t)length, SEEK_CUR);
}

bool yk_stream_write(YkStream *stream, const char *data, size_t length, YkProblems *problems)
{
    size_t written = 0;
    int error = yk_file_write_all(stream->descriptor, data, length, &written);
    size_t whole = error == 0 ? length : whole_lines(data, written);
    if (whole > 0) stream->has_lines = true;
    if (error == 0) return true;
    if (written > whole) cut(stream, written - whole);
    return yk_file_fail(stream->name, error, problems);
}

static int put_file(const YkStream *stream)
{
    struct stat old = {.st_mode = (mode_t)stream->old_mode};
    if (stream->has_lines)
        return yk_file_put(stream->descriptor, stream->temporary, stream->target, stream->has_old ? &old : NULL);
    close(stream->descriptor);
    unlink(stream->temporary);
    return 0;
}

bool yk_stream_close(YkStream *stream, YkProblems *problems)
{
    int error = 0;
    if (!stream->is_open) return true;
    if (stream->target)
        error = put_file(stream);
    else if (stream->descriptor != STDOUT_FILENO && close(stream->descriptor) < 0)
        error = errno;
    release(stream);
    return error == 0 || yk_file_fail(stream->name, error, problems);
}

void yk_stream_drop(YkStream *stream)
{
    if (!stream->is_open) return;
    stream->has_lines = false;
    if (stream->target)
        put_file(stream);
    else if (stream->descriptor != STDOUT_FILENO)
        close(stream->descriptor);
    release(stream);
}
