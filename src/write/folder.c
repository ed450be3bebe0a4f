// Checks whether a folder is free.
#include "write/folder.h"
#include <dirent.h>
#include <errno.h>
#include <string.h>
#include "base/problems.h"
#include "write/file.h"

bool yk_folder_is_free(const char *path, YkProblems *problems)
{
    DIR *folder = opendir(path);
    bool is_empty = true;
    if (!folder && errno == ENOENT) return true;
    if (!folder && errno == ENOTDIR) {
        yk_problem(problems, YK_CODE_TASK_FOLDER, (YkPlace){0}, "%q is a file; a folder is needed here", path);
        return false;
    }
    if (!folder) return yk_file_fail(path, errno, problems);
    for (const struct dirent *entry = readdir(folder); entry && is_empty; entry = readdir(folder))
        is_empty = strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0;
    closedir(folder);
    if (is_empty) return true;
    yk_problem(problems, YK_CODE_TASK_FOLDER, (YkPlace){0}, "the folder %q holds other files", path);
    yk_problem_hint(problems, "name a folder that does not exist yet");
    return false;
}
