// Output files: they appear whole or not at all. A text that failed (base/text.h) is not written: E0100.
#ifndef WRITE_FILE_H
#define WRITE_FILE_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/problem.h>

// The kind of a file, by its ending.
typedef enum YkFileKind { YK_FILE_SVG, YK_FILE_PDF, YK_FILE_PNG, YK_FILE_OTHER } YkFileKind;
YkFileKind yk_file_kind(const char *path);

// Writes a new file beside the old one, synced and renamed into place: whatever goes wrong, the old file remains.
// Links are followed; devices and pipes are written directly. Returns false with a problem added (E07xx).
bool yk_file_write(const char *path, const char *data, size_t length, YkProblems *problems);
// Writes everything to an open descriptor, called `name` in messages. Returns false with a problem added.
bool yk_file_write_to(int descriptor, const char *name, const char *data, size_t length, YkProblems *problems);
// Adds the problem of an error number when a file could not be written; returns false.
bool yk_file_fail(const char *path, int error, YkProblems *problems);

#endif
