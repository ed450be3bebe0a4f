// Finds the name that was probably meant, by optimal string alignment distance (Damerau 1964, Levenshtein 1966):
// transpositions of neighbours count 1, no part is edited twice.
#include "base/names.h"
#include <string.h>

enum { NAME_MAX_LENGTH = 64, CANDIDATES_MAX = 10000 };

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

static char lower(char c)
{
    return (char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

static bool equal_but_for_case(const char *a, const char *b)
{
    for (; *a && lower(*a) == lower(*b); a++) b++;
    return lower(*a) == lower(*b);
}

// Returns the edit distance. Three rows of the table of prefix distances suffice. Lengths up to NAME_MAX_LENGTH.
static size_t edit_distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
    size_t rows[3][NAME_MAX_LENGTH + 1], *above2 = rows[0], *above = rows[1], *row = rows[2];
    for (size_t j = 0; j <= b_length; j++) above[j] = j;
    for (size_t i = 1; i <= a_length; i++) {
        row[0] = i;
        for (size_t j = 1; j <= b_length; j++) {
            row[j] = smaller(above[j - 1] + (a[i - 1] != b[j - 1]), 1 + smaller(above[j], row[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = smaller(row[j], above2[j - 2] + 1);
        }
        size_t *reused = above2;
        above2 = above;
        above = row;
        row = reused;
    }
    return above[b_length];
}

// Returns twice the distance, so that a change of case (1) comes before any edit (2). SIZE_MAX when the two have
// nothing in common, or differ too much in length to be within `limit` edits.
static size_t twice_distance(const char *name, size_t length, const char *candidate, size_t limit)
{
    size_t other = strlen(candidate);
    if (equal_but_for_case(name, candidate)) return strcmp(name, candidate) != 0;
    if (other > NAME_MAX_LENGTH || other > length + limit || length > other + limit) return SIZE_MAX;
    size_t distance = edit_distance(name, length, candidate, other);
    return distance < (length > other ? length : other) ? 2 * distance : SIZE_MAX;
}

const char *yk_nearest(const char *name, const char *const *candidates, size_t count)
{
    const char *best = NULL;
    size_t length = strlen(name), limit = 1 + length / 4, best_distance = 2 * limit + 1;
    if (length == 0 || length > NAME_MAX_LENGTH) return NULL;
    for (size_t i = 0; i < count && i < CANDIDATES_MAX; i++) {
        if (!candidates[i]) continue;
        size_t distance = twice_distance(name, length, candidates[i], limit);
        if (distance >= best_distance) continue;
        best = candidates[i];
        best_distance = distance;
    }
    return best;
}
