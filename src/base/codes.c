// Looks up a code's number, severity and explanation in the table that codes.def holds.
#include "base/codes.h"
#include <stddef.h>

typedef struct Entry {
    int number;
    YkSeverity severity;
} Entry;

#define N YK_SEVERITY_NOTE
#define W YK_SEVERITY_WARNING
#define E YK_SEVERITY_ERROR
#define X(name, number, severity, explanation) {number, severity},
static const Entry entries[] = {
#include "base/codes.def"
};
#undef X

// Apart from the entries, so that a program that explains nothing does not carry the texts.
#define X(name, number, severity, explanation) explanation,
static const char *const explanations[] = {
#include "base/codes.def"
};
#undef X
#undef N
#undef W
#undef E

enum { ENTRY_COUNT = sizeof entries / sizeof *entries };

// Bisects: the entries ascend, which the tests check.
static const Entry *find(int code)
{
    size_t low = 0, high = ENTRY_COUNT;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (entries[middle].number < code)
            low = middle + 1;
        else
            high = middle;
    }
    return low < ENTRY_COUNT && entries[low].number == code ? &entries[low] : NULL;
}

const char *yk_code_explain(int code)
{
    const Entry *entry = find(code);
    return entry ? explanations[entry - entries] : NULL;
}

size_t yk_code_count(void)
{
    return ENTRY_COUNT;
}

int yk_code_at(size_t index)
{
    return index < ENTRY_COUNT ? entries[index].number : YK_CODE_NONE;
}

YkSeverity yk_code_severity(int code)
{
    const Entry *entry = find(code);
    return entry ? entry->severity : YK_SEVERITY_ERROR;
}
