// Several output files that belong together: all of them appear, or none.
#ifndef WRITE_FILE_SET_H
#define WRITE_FILE_SET_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/problem.h>
#include "base/text.h"

typedef struct YkFileEntry {
    const char *name; // in the folder, without a slash
    YkText text;
} YkFileEntry;

// Writes the files into a folder, which is made where it does not exist (the one above it must). They are written and
// brought to the disk aside, and only then take their places; older files of the same names are replaced, others stay.
// False with a problem added; then a folder made here is gone again. Cost O(bytes).
bool yk_files_write(const char *folder, const YkFileEntry *files, size_t count, YkProblems *problems);

#endif
