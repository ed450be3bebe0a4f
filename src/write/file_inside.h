// What whole files and streams share.
#ifndef WRITE_FILE_INSIDE_H
#define WRITE_FILE_INSIDE_H
#include <sys/stat.h>
#include <yoke/problem.h>
#include "base/text.h"
#include "write/file.h"

// Writes everything; *written (may be NULL) says how much of it. Returns 0, or the error: ENOMEM for what a failed text
// reads as. A write of nothing finds no fault, so an empty output is fine everywhere.
int yk_file_write_all(int descriptor, const char *data, size_t length, size_t *written);
// Opens a new file in the folder of `path`; its name goes to `name`. -1 with errno set.
int yk_file_open_beside(const char *path, YkText *name);
// Where an output goes. Regular files and new ones get a target, what links point to, to be freed; devices and pipes
// get NULL: no file can take their place. `old` is filled where something stands there. Returns 0, or the error.
int yk_file_find(const char *path, char **target, bool *exists, struct stat *old);
// Gives the new file the old one's permissions (old may be NULL), brings it safely to the disk, closes it and renames
// it into place; whatever goes wrong, it is removed and what stood there still stands. Returns 0, or the error.
int yk_file_put(int descriptor, const char *temporary, const char *target, const struct stat *old);

#endif
