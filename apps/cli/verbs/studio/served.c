// The machine's file: read, with a version of its bytes.
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "doc/node.h"
#include "verbs/studio/studio.h"

// FNV-1a, 64 bits: a fingerprint that distinguishes texts. It is not cryptographic.
static void make_version(YkServed *served)
{
    uint64_t hash = 14695981039346656037u;
    for (size_t k = 0; k < served->text.length; k++)
        hash = (hash ^ (unsigned char)served->text.data[k]) * 1099511628211u;
    for (size_t k = 0; k < YK_VERSION_SIZE - 1; k++) served->version[k] = "0123456789abcdef"[hash >> (60 - 4 * k) & 15];
    served->version[YK_VERSION_SIZE - 1] = '\0';
}

bool yk_served_read(YkServed *served, YkProblems *problems)
{
    struct stat found;
    size_t length;
    const char *slash = strrchr(served->path, '/');
    served->name = slash ? slash + 1 : served->path;
    yk_text_clear(&served->text);
    memcpy(served->version, "none", 5);
    if (stat(served->path, &found) != 0) return true;
    char *data = yk_doc_read_file(served->path, &length, problems);
    if (!data) return false;
    yk_text_add(&served->text, data, length);
    free(data);
    if (!served->text.failed) make_version(served);
    return !served->text.failed;
}

void yk_served_free(YkServed *served)
{
    yk_text_free(&served->text);
}
