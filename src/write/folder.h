// Folders for the files of an answer.
#ifndef WRITE_FOLDER_H
#define WRITE_FOLDER_H
#include <stdbool.h>
#include <yoke/problem.h>

// Returns whether files may be put into this folder without mixing with others: it does not exist yet, or is empty.
// Adds a problem otherwise.
bool yk_folder_is_free(const char *path, YkProblems *problems);

#endif
