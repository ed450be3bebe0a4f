// The modules leave the start solutions of Alt's problem out, which are 100 KB: nine points are sought in them, not solved.
#include "synthesis/alt_start.h"

const YkVec yk_alt_start_at[YK_ALT_PLACES] = {{0, 0}};
const size_t yk_alt_start_count = 0;
const char yk_alt_start_text[][YK_ALT_START_LENGTH + 1] = {""};
