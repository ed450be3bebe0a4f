// Keys of the format that would change the motion and that this version cannot compute: refused, never ignored.
#include "model/load.h"

static const char *const sections[] = {"gears", "racks", "belts", "cams", "locks"};

void yk_load_unsupported(YkLoader *loader)
{
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        const YkNode *key = yk_load_key(loader->root, sections[i]);
        if (!key) continue;
        yk_problem(loader->problems, YK_CODE_NOT_SUPPORTED, key->place, "%s are not part of this version yet",
                   sections[i]);
        loader->has_unsupported = true;
    }
}
