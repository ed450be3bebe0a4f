// Output that comes line by line: whatever happens, it ends behind a whole line.
#ifndef WRITE_STREAM_H
#define WRITE_STREAM_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/problem.h>

// A zeroed stream is closed.
typedef struct YkStream {
    const char *name; // for messages
    char *target;     // of a file: its place; NULL: standard output, a device or a pipe
    char *temporary;  // the new file beside it, where the lines go
    int descriptor;
    bool is_open, has_old;
    unsigned old_mode; // permissions of the file that stood there
    bool has_lines;    // at least one was written
} YkStream;

// path: a file, which appears when the stream is closed; NULL or "-": standard output. The path must stay. False with a
// problem added.
bool yk_stream_open(YkStream *stream, const char *path, YkProblems *problems);
// Adds whole lines. Where they do not all fit, those that do stay, and the part of the next is cut off again (not from
// pipes and devices). False with a problem added.
bool yk_stream_write(YkStream *stream, const char *data, size_t length, YkProblems *problems);
// Ends the stream; a file appears now, with all lines that were written, or stays as it was if there are none. False
// with a problem added.
bool yk_stream_close(YkStream *stream, YkProblems *problems);

// Ends the stream without its file, which stays as it was; what went to standard output, a device or a pipe is gone.
void yk_stream_drop(YkStream *stream);

#endif
