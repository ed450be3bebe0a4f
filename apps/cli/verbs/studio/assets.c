// Reads the page: every file of its folder, into memory.
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "doc/node.h"
#include "verbs/studio/studio.h"

enum { DEPTH_MAX = 3, FILES_MAX = 2000 };

static bool add_file(YkAssets *assets, const char *path, const char *name)
{
    size_t length;
    YkProblems *quiet = yk_problems_new();
    char *data = quiet ? yk_doc_read_file(path, &length, quiet) : NULL;
    yk_problems_free(quiet);
    if (!data) return false;
    bool good = assets->count < FILES_MAX && YK_ROOM(assets->items, assets->count, assets->capacity);
    if (good) {
        YkAsset *asset = &assets->items[assets->count++];
        *asset = (YkAsset){.path = strdup(name)};
        yk_text_add(&asset->data, data, length);
        good = asset->path && !asset->data.failed;
    }
    free(data);
    return good;
}

// Adds what is in a folder; `within` is its path in the page, "" or "gallery/".
static bool add_folder(YkAssets *assets, const char *folder, const char *within, int depth)
{
    DIR *opened = opendir(folder);
    bool good = opened != NULL;
    for (struct dirent *entry; good && (entry = readdir(opened));) {
        YkText path = {0}, name = {0};
        struct stat found;
        if (entry->d_name[0] == '.') continue;
        yk_text_format(&path, "%s/%s", folder, entry->d_name);
        yk_text_format(&name, "%s%s", within, entry->d_name);
        if (path.failed || name.failed || stat(path.data, &found) != 0) {
            good = false;
        } else if (S_ISREG(found.st_mode)) {
            good = add_file(assets, path.data, name.data);
        } else if (S_ISDIR(found.st_mode) && depth > 1) {
            yk_text_puts(&name, "/");
            good = !name.failed && add_folder(assets, path.data, name.data, depth - 1);
        }
        yk_text_free(&path);
        yk_text_free(&name);
    }
    if (opened) closedir(opened);
    return good;
}

static bool has_page(const char *folder)
{
    YkText index = {0};
    yk_text_format(&index, "%s/index.html", folder);
    bool found = !index.failed && access(index.data, R_OK) == 0;
    yk_text_free(&index);
    return found;
}

// Finds the page beside the command, as it is installed: bin/yoke and share/yoke/studio.
static bool find_installed(YkText *folder)
{
#ifdef __wasm__
    (void)folder;
    return false;
#else
    char own[4096];
    ssize_t length = readlink("/proc/self/exe", own, sizeof own - 1);
    if (length <= 0) return false;
    own[length] = '\0';
    char *slash = strrchr(own, '/');
    if (slash) *slash = '\0';
    yk_text_format(folder, "%s/../share/yoke/studio", own);
    return !folder->failed && has_page(folder->data);
#endif
}

static bool find_page(YkText *folder)
{
    const char *named = getenv("YOKE_STUDIO");
    if (named && *named) {
        yk_text_puts(folder, named);
        return !folder->failed && has_page(folder->data);
    }
    if (find_installed(folder)) return true;
    yk_text_clear(folder);
    yk_text_puts(folder, YOKE_STUDIO_BUILT);
    return !folder->failed && has_page(folder->data);
}

bool yk_assets_load(YkAssets *assets, YkSession *session)
{
    YkText folder = {0};
    bool found = find_page(&folder), good = found && add_folder(assets, folder.data, "", DEPTH_MAX);
    if (!found) {
        yk_problem(session->problems, YK_CODE_STUDIO_NO_PAGE, (YkPlace){0}, "the page of Studio is not installed");
        yk_problem_hint(session->problems, "build Yoke with Node, npm and clang's WebAssembly (`tools/install-deps web "
                                           "studio`), or let YOKE_STUDIO name a folder that has the page");
    } else if (!good) {
        yk_problem(session->problems, YK_CODE_STUDIO_NO_PAGE, (YkPlace){0}, "the page of Studio in %q cannot be read",
                   folder.data);
    }
    yk_text_free(&folder);
    return good;
}

void yk_assets_free(YkAssets *assets)
{
    for (size_t k = 0; k < assets->count; k++) {
        free(assets->items[k].path);
        yk_text_free(&assets->items[k].data);
    }
    free(assets->items);
}

const YkAsset *yk_assets_find(const YkAssets *assets, const char *path)
{
    for (size_t k = 0; k < assets->count; k++)
        if (strcmp(assets->items[k].path, path) == 0) return &assets->items[k];
    return NULL;
}

const char *yk_assets_type(const char *path)
{
    static const struct {
        const char *ending, *type;
    } known[] = {
        {".html", "text/html; charset=utf-8"},
        {".js", "text/javascript; charset=utf-8"},
        {".css", "text/css; charset=utf-8"},
        {".wasm", "application/wasm"},
        {".json", "application/json"},
        {".svg", "image/svg+xml"},
        {".yaml", "text/plain; charset=utf-8"},
        {".txt", "text/plain; charset=utf-8"},
        {".webmanifest", "application/manifest+json"},
        {".png", "image/png"},
    };
    const char *dot = strrchr(path, '.');
    for (size_t k = 0; dot && k < sizeof known / sizeof *known; k++)
        if (strcmp(dot, known[k].ending) == 0) return known[k].type;
    return "application/octet-stream";
}
