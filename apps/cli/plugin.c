// Finds and loads plugins.
#include "plugin.h"
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef const YkPlugin *(*Entry)(void);

static const YkPlugin *open_at(const char *path, const char *name, const char **why)
{
    if (access(path, F_OK) != 0) return NULL;
    void *plugin = dlopen(path, RTLD_NOW | RTLD_GLOBAL); // Open MPI loads parts of its own, which need its functions
    Entry entry = NULL;
    if (plugin) *(void **)&entry = dlsym(plugin, name);
    if (!entry) *why = dlerror();
    return entry ? entry() : NULL;
}

const YkPlugin *yk_plugin_open(const char *name, const char *entry, const char **why)
{
    *why = NULL;
    char own[4096], path[sizeof own + 128];
    ssize_t length = readlink("/proc/self/exe", own, sizeof own - 1);
    if (length <= 0) return NULL;
    own[length] = '\0';
    char *slash = strrchr(own, '/');
    if (slash) *slash = '\0';
    snprintf(path, sizeof path, "%s/%s.so", own, name);
    const YkPlugin *found = open_at(path, entry, why);
    if (found || *why) return found;
    snprintf(path, sizeof path, "%s/../" YOKE_LIBDIR "/yoke/%s.so", own, name);
    return open_at(path, entry, why);
}
