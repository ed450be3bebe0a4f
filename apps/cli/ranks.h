// Ranks: this process and the others that one `mpirun` started. They exchange messages through the plugin yoke-mpi, the
// only part that needs the libraries of Open MPI; it is loaded only if there are several ranks.
#ifndef CLI_RANKS_H
#define CLI_RANKS_H
#include <stdbool.h>
#include <stddef.h>
#include "cli.h"
#include "ranks_table.h"

// Return what mpirun's environment says: this rank, from 0; how many there are, 1 without mpirun; and how many of them
// share this computer. In a browser there is one, and what ranks say to each other is left out.
#ifdef YOKE_HAS_RANKS
int yk_ranks_rank(void);
int yk_ranks_count(void);
const YkRanks *yk_ranks(void); // what the plugin gives; NULL before yk_ranks_begin
#else
static inline int yk_ranks_rank(void)
{
    return 0;
}
static inline int yk_ranks_count(void)
{
    return 1;
}
static inline const YkRanks *yk_ranks(void)
{
    return NULL;
}
#endif
size_t yk_ranks_share(size_t processors); // this rank's share of the computer's processors, at least 1
bool yk_ranks_is_first_here(void);        // whether this is the first rank on its computer

// Loads the plugin and begins to speak. Returns false with a problem added.
bool yk_ranks_begin(YkSession *session);
void yk_ranks_end(void);
// Returns the plugin's version and that of its libraries, "0.1.0, Open MPI v4.1.4"; NULL if it is not installed.
const char *yk_ranks_plugin(void);

// Ranks other than 0 print nothing themselves: from now on their standard error is kept back.
void yk_ranks_hush(void);
// Waits a second. mpirun ends all ranks when one of them fails: the others wait so that rank 0 can say why.
void yk_ranks_linger(void);
// Returns what was kept back, in text[size]; standard error is itself again.
void yk_ranks_unhush(char *text, size_t size);
void yk_ranks_speak(void); // nothing more is kept back

#endif
