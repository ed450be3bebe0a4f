// Plugins: parts of yoke that need a library of their own, loaded by those verbs alone that use them.
#ifndef CLI_PLUGIN_H
#define CLI_PLUGIN_H

// The beginning of every plugin's table.
typedef struct YkPlugin {
    int interface;    // of the header that describes the table
    const char *yoke; // the version of yoke that it belongs to
} YkPlugin;

// Loads the plugin NAME.so from beside the command, where it is built, or from lib/yoke, where it is installed, and
// calls its function ENTRY. Returns the table, which stays until the process ends. NULL: there is none, or it cannot be
// loaded, and `why` then points at the reason, until the next call; otherwise at NULL.
const YkPlugin *yk_plugin_open(const char *name, const char *entry, const char **why);

#endif
