// Output that comes piece by piece: whatever happens, it ends behind a whole piece.
#ifndef OUT_STREAM_H
#define OUT_STREAM_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/problem.h>

// A zeroed stream is closed.
typedef struct YkStream {
    const char *name;   // for messages
    char *target;       // of a file: its place; NULL: standard output, a device or a pipe
    char *temporary;    // the new file beside it, where the pieces go
    int descriptor;
    bool is_open, has_old;
    unsigned old_mode;  // permissions of the file that stood there
    size_t pieces;      // written whole
} YkStream;

// path: a file, which appears when the stream is closed; NULL or "-": standard output. The path must stay. False with a
// problem added.
bool yk_stream_open(YkStream *stream, const char *path, YkProblems *problems);
// Adds a piece. Where only a part of it fits, that part is cut off again (not from pipes and devices). False with a
// problem added.
bool yk_stream_write(YkStream *stream, const char *data, size_t length, YkProblems *problems);
// Ends the stream; a file appears now, with all pieces written whole, or stays as it was where there are none. False
// with a problem added.
bool yk_stream_close(YkStream *stream, YkProblems *problems);

#endif
