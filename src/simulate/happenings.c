// Keeps what happens on the way.
#include <string.h>
#include "simulate/simulation.h"

enum { HAPPENINGS_MAX = 100000 };

void yk_simulation_note(YkSimulation *sim, YkHappeningKind kind, double time, const char *name, double value)
{
    if (sim->happening_count >= HAPPENINGS_MAX) return;
    if (!YK_ROOM(sim->happenings, sim->happening_count, sim->happening_capacity)) {
        yk_arena_fail(sim->arena);
        return;
    }
    const char *kept = yk_arena_copy(sim->arena, name, strlen(name)); // the mechanism may be freed
    if (kept) sim->happenings[sim->happening_count++] = (YkHappening){kind, time, kept, value};
}
