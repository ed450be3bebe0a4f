// Shared by whole files and streams.
#ifndef WRITE_FILE_INSIDE_H
#define WRITE_FILE_INSIDE_H
#include <sys/stat.h>
#include <yoke/problem.h>
#include "base/text.h"
#include "write/file.h"

// Writes everything; *written (may be NULL) receives how much was written. Returns 0 or the error: ENOMEM for a text
// that failed. Writing nothing finds no fault, so an empty output is always fine.
int yk_file_write_all(int descriptor, const char *data, size_t length, size_t *written);
// Opens a new file in the folder of `path`; its name goes to `name`. Returns -1 with errno set.
int yk_file_open_beside(const char *path, YkText *name);
// Finds where an output goes. Regular files and new ones get a target, which links point to, to be freed; devices and
// pipes get NULL: no file can replace them. Fills `old` if the target exists. Returns 0 or the error.
int yk_file_find(const char *path, char **target, bool *exists, struct stat *old);
// Gives the new file the old one's permissions (old may be NULL), syncs it to disk, closes it and renames it into
// place; whatever goes wrong, it is removed and the old file remains. Returns 0 or the error.
int yk_file_put(int descriptor, const char *temporary, const char *target, const struct stat *old);

#endif
