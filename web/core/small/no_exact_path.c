// The modules leave Alt's problem out, whose start solutions alone are 100 KB: nine points are sought in them, not
// solved.
#include "synthesis/paths/path_search.h"

bool yk_path_is_exact(const YkTask *task)
{
    (void)task;
    return false;
}

size_t yk_path_exact_pieces(const YkTask *task)
{
    (void)task;
    return 0;
}

void yk_path_exact_piece(const YkTask *task, uint64_t seed, size_t piece, YkPace *pace, double *numbers)
{
    (void)task;
    (void)seed;
    (void)piece;
    (void)pace;
    (void)numbers;
}

bool yk_synthesise_exact_path(YkSynthesis *s, double to)
{
    (void)s;
    (void)to;
    return false;
}
