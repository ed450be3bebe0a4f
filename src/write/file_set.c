// Writes several files into a folder, all or none.
#define _XOPEN_SOURCE 700
#include "write/file_set.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>
#include "write/file_inside.h"

typedef struct Place {
    const char *folder;
    YkText aside;      // a folder within it, for what is not complete yet
    YkText from, path; // of one file
    bool made_folder;
} Place;

// Makes the paths of one file, aside and in its place. Returns false when out of memory.
static bool name_file(Place *place, const char *name)
{
    yk_text_clear(&place->from);
    yk_text_clear(&place->path);
    yk_text_format(&place->from, "%s/%s", yk_text_get(&place->aside), name);
    yk_text_format(&place->path, "%s/%s", place->folder, name);
    return !place->from.failed && !place->path.failed;
}

static int make_folders(Place *place)
{
    struct stat found;
    yk_text_format(&place->aside, "%s/.yoke-%d.tmp", place->folder, (int)getpid());
    if (place->aside.failed) return ENOMEM;
    if (mkdir(place->folder, 0777) == 0)
        place->made_folder = true;
    else if (errno != EEXIST)
        return errno;
    else if (stat(place->folder, &found) < 0 || !S_ISDIR(found.st_mode))
        return EEXIST;
    return mkdir(place->aside.data, 0777) < 0 ? errno : 0;
}

static int write_aside(Place *place, const YkFileEntry *file)
{
    struct stat found;
    if (!name_file(place, file->name)) return ENOMEM;
    if (stat(place->path.data, &found) == 0 && S_ISDIR(found.st_mode)) return EISDIR;
    int descriptor = open(place->from.data, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return errno;
    int error = yk_file_write_all(descriptor, yk_text_get(&file->text), file->text.length, NULL);
    if (error == 0 && fsync(descriptor) < 0 && errno != EINVAL && errno != ENOTSUP) error = errno;
    if (close(descriptor) < 0 && error == 0) error = errno;
    return error;
}

static int write_all(Place *place, const YkFileEntry *files, size_t count)
{
    int error = 0;
    for (size_t k = 0; k < count && error == 0; k++) error = write_aside(place, &files[k]);
    for (size_t k = 0; k < count && error == 0; k++) {
        if (!name_file(place, files[k].name)) return ENOMEM;
        if (rename(place->from.data, place->path.data) < 0) error = errno;
    }
    return error;
}

bool yk_files_write(const char *folder, const YkFileEntry *files, size_t count, YkProblems *problems)
{
    Place place = {.folder = folder};
    int error = make_folders(&place);
    if (error == 0) {
        error = write_all(&place, files, count);
        for (size_t k = 0; k < count && error != 0; k++)
            if (name_file(&place, files[k].name)) unlink(place.from.data);
        rmdir(place.aside.data);
    }
    if (error != 0 && place.made_folder) rmdir(folder);
    if (error != 0) yk_file_fail(place.path.length > 0 ? place.path.data : folder, error, problems);
    yk_text_free(&place.aside);
    yk_text_free(&place.from);
    yk_text_free(&place.path);
    return error == 0;
}
