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

// Writes the files into a folder, which is made if it does not exist (its parent must). The files are written and
// synced aside before they take their places; older files with the same names are replaced, others stay. Returns false
// with a problem added; a folder made here is then removed. Cost: O(bytes).
bool yk_files_write(const char *folder, const YkFileEntry *files, size_t count, YkProblems *problems);

#endif
