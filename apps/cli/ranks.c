// The ranks of mpirun: what its environment says, and the plugin through which they speak.
#include "ranks.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "plugin.h"

static const YkRanks *table;

// --- the environment of Open MPI

static int number_of(const char *name, int fallback)
{
    const char *text = getenv(name);
    char *end = NULL;
    long value = text ? strtol(text, &end, 10) : fallback;
    return !text || end == text || *end || value < 0 || value > 100000000 ? fallback : (int)value;
}

#ifdef YOKE_HAS_RANKS
int yk_ranks_count(void)
{
    int count = number_of("OMPI_COMM_WORLD_SIZE", 1);
    return count > 1 ? count : 1;
}

int yk_ranks_rank(void)
{
    return yk_ranks_count() > 1 ? number_of("OMPI_COMM_WORLD_RANK", 0) : 0;
}
#endif

size_t yk_ranks_share(size_t processors)
{
    size_t here = (size_t)(yk_ranks_count() > 1 ? number_of("OMPI_COMM_WORLD_LOCAL_SIZE", 1) : 1);
    if (here < 2) return processors;
    return processors > here ? processors / here : 1;
}

bool yk_ranks_is_first_here(void)
{
    return number_of("OMPI_COMM_WORLD_LOCAL_RANK", 0) == 0;
}

// --- the plugin

static const YkRanks *find_plugin(const char **why)
{
    static const YkRanks *found;
    *why = NULL;
    if (!found) found = (const YkRanks *)(const void *)yk_plugin_open("yoke-mpi", YK_RANKS_ENTRY, why);
    return found;
}

const char *yk_ranks_plugin(void)
{
    static char text[256];
    const char *why;
    const YkRanks *found = find_plugin(&why);
    if (!found || found->interface != YK_RANKS_INTERFACE) return NULL;
    snprintf(text, sizeof text, "%s, %s", found->yoke, found->made());
    return text;
}

static bool refuse(YkSession *session, const char *what, const char *why)
{
    yk_problem(session->problems, YK_CODE_RANKS_PLUGIN, (YkPlace){0}, "mpirun started several ranks, and %s%s", what,
               why);
    yk_problem_hint(session->problems, "install the package yoke-mpi of version %s, or start yoke without mpirun",
                    yk_version());
    return false;
}

bool yk_ranks_begin(YkSession *session)
{
    const char *why;
    const YkRanks *found = find_plugin(&why);
    if (!found && why) return refuse(session, "the plugin yoke-mpi cannot be loaded: ", why);
    if (!found) return refuse(session, "the plugin yoke-mpi is missing", "");
    if (found->interface != YK_RANKS_INTERFACE || strcmp(found->yoke, yk_version()) != 0)
        return refuse(session, "the plugin yoke-mpi is of another version", "");
    if (!found->begin()) return refuse(session, "Open MPI could not begin", "");
    table = found;
    return true;
}

#ifdef YOKE_HAS_RANKS
const YkRanks *yk_ranks(void)
{
    return table;
}
#endif

void yk_ranks_end(void)
{
    if (table) table->end();
    table = NULL;
}

// --- what is kept back

#ifdef YOKE_HAS_RANKS
static struct {
    FILE *kept;
    int own; // standard error
} hush;
#endif

void yk_ranks_hush(void)
{
#ifdef YOKE_HAS_RANKS
    fflush(stderr);
    hush.kept = tmpfile();
    if (!hush.kept) return;
    hush.own = dup(STDERR_FILENO);
    if (hush.own >= 0) dup2(fileno(hush.kept), STDERR_FILENO);
#endif
}

void yk_ranks_linger(void)
{
#ifdef YOKE_HAS_RANKS
    sleep(1);
#endif
}

void yk_ranks_unhush(char *text, size_t size)
{
    *text = '\0';
#ifdef YOKE_HAS_RANKS
    if (!hush.kept) return;
    fflush(stderr);
    rewind(hush.kept);
    text[fread(text, 1, size - 1, hush.kept)] = '\0';
    if (hush.own >= 0) {
        dup2(hush.own, STDERR_FILENO);
        close(hush.own);
    }
    fclose(hush.kept);
    hush.kept = NULL;
#else
    (void)size;
#endif
}

void yk_ranks_speak(void)
{
    char text[2];
    yk_ranks_unhush(text, sizeof text);
}
