// Output line by line: whatever happens, it ends after a whole line.
#ifndef WRITE_STREAM_H
#define WRITE_STREAM_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/problem.h>

// A zeroed stream is closed.
typedef struct YkStream {
    const char *name; // for messages
    char *target;     // the final place of a file; NULL: standard output, a device or a pipe
    char *temporary;  // the new file beside it, which takes the lines
    int descriptor;
    bool is_open, has_old;
    unsigned old_mode; // permissions of the old file
    bool has_lines;    // at least one was written
} YkStream;

// Opens the stream. path: a file, which appears when the stream is closed; NULL or "-": standard output. The path must
// remain valid. Returns false with a problem added.
bool yk_stream_open(YkStream *stream, const char *path, YkProblems *problems);
// Adds whole lines. If they do not all fit, those that do stay, and the part of the next one is cut off (except on
// pipes and devices). Returns false with a problem added.
bool yk_stream_write(YkStream *stream, const char *data, size_t length, YkProblems *problems);
// Ends the stream. A file now appears with all its lines, or stays as it was if there are none. Returns false with a
// problem added.
bool yk_stream_close(YkStream *stream, YkProblems *problems);

// Ends the stream without its file, which stays as it was; what went to standard output, a device or a pipe is lost.
void yk_stream_drop(YkStream *stream);

#endif
