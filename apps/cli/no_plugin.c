// Stands in for plugin.c in a browser, where nothing is loaded.
#include "plugin.h"
#include <stddef.h>

const YkPlugin *yk_plugin_open(const char *name, const char *entry, const char **why)
{
    (void)name, (void)entry;
    *why = NULL;
    return NULL;
}
