// Reads a whole file.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "base/problems.h"
#include "doc/node.h"

static const YkPlace nowhere = {0, 0, 0};

static void refuse_size(const char *path, YkProblems *problems)
{
    yk_problem(problems, YK_CODE_FILE_TOO_LARGE, nowhere, "%q has more than %z bytes", path, YK_DOC_SIZE_MAX);
    yk_problem_hint(problems, "a model file describes one machine in a few pages of text");
}

static void refuse_open(const char *path, int cause, YkProblems *problems)
{
    if (cause == ENOENT || cause == ENOTDIR)
        yk_problem(problems, YK_CODE_FILE_NOT_FOUND, nowhere, "there is no file %q", path);
    else if (cause == ENOMEM)
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, nowhere, "out of memory");
    else
        yk_problem(problems, YK_CODE_FILE_UNREADABLE, nowhere, "cannot read %q: %s", path,
                   cause == EACCES ? "permission denied" : "the system refuses it");
}

// Checks what was opened before reading it. *expected gets the size if it is known.
static bool is_readable(FILE *file, const char *path, size_t *expected, YkProblems *problems)
{
    struct stat status;
    *expected = 0;
    if (fstat(fileno(file), &status) != 0) return true; // reading will show why
    if (S_ISDIR(status.st_mode)) {
        yk_problem(problems, YK_CODE_FILE_DIRECTORY, nowhere, "%q is a directory, not a file", path);
        return false;
    }
    if (!S_ISREG(status.st_mode)) return true;
    if (status.st_size > (off_t)YK_DOC_SIZE_MAX) {
        refuse_size(path, problems);
        return false;
    }
    *expected = (size_t)status.st_size;
    return true;
}

// Reads to the end, doubling the memory; reads at most one byte beyond the limit.
static char *read_all(FILE *file, const char *path, size_t expected, size_t *length, YkProblems *problems)
{
    size_t capacity = expected + 1 > 4096 ? expected + 1 : 4096, used = 0;
    char *data = malloc(capacity);
    while (data && used <= YK_DOC_SIZE_MAX) {
        size_t got = fread(data + used, 1, capacity - used, file);
        used += got;
        if (got == 0) break;
        if (used < capacity) continue;
        capacity = capacity * 2 > YK_DOC_SIZE_MAX + 1 ? YK_DOC_SIZE_MAX + 1 : capacity * 2;
        if (capacity <= used) continue; // full to the limit: the loop ends
        char *larger = realloc(data, capacity);
        if (!larger) free(data);
        data = larger;
    }
    if (!data) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, nowhere, "out of memory");
    } else if (ferror(file)) {
        yk_problem(problems, YK_CODE_FILE_UNREADABLE, nowhere, "reading %q failed after %z bytes", path, used);
    } else if (used > YK_DOC_SIZE_MAX) {
        refuse_size(path, problems);
    } else {
        *length = used;
        return data;
    }
    free(data);
    return NULL;
}

char *yk_doc_read_file(const char *path, size_t *length, YkProblems *problems)
{
    *length = 0;
    bool is_input = strcmp(path, "-") == 0;
    const char *name = is_input ? "standard input" : path;
    if (problems) yk_problems_set_source(problems, name, NULL, 0);
    if (problems && yk_problems_ran_out(problems)) return NULL;
    FILE *file = is_input ? stdin : fopen(path, "rb");
    if (!file) {
        refuse_open(path, errno, problems);
        return NULL;
    }
    size_t expected;
    char *data = NULL;
    if (is_readable(file, name, &expected, problems)) data = read_all(file, name, expected, length, problems);
    if (!is_input) fclose(file);
    return data;
}
