// Prints docs/codes.md from src/base/codes.def.
#include <stdbool.h>
#include <stdio.h>

typedef struct Entry {
    const char *name;
    int number;
    char severity;
    const char *explanation;
} Entry;
enum { N = 'N', W = 'W', E = 'E' };
static const Entry entries[] = {
#define X(name, number, severity, explanation) {#name, number, severity, explanation},
#include "base/codes.def"
#undef X
};

static const char *const rooms[] = {"",
                                    "Text and YAML",
                                    "Keys and structure",
                                    "Expressions and units",
                                    "Names and geometry",
                                    "Topology and freedom",
                                    "Solving",
                                    "Output",
                                    "Command line"};

// The heading of a hundred; those that were opened when the others were full have no kind of their own.
static void print_heading(int hundred)
{
    bool is_named = hundred < (int)(sizeof rooms / sizeof *rooms);
    printf("\n## %s", is_named ? rooms[hundred] : "Of every kind");
    if (!is_named) printf(", from %d", 100 * hundred);
    printf("\n\n| code | | meaning |\n|---|---|---|\n");
}

static const char *severity_name(char severity)
{
    return severity == 'E' ? "error" : severity == 'W' ? "warning" : "note";
}

// A table's cell: a bar would end it.
static void print_cell(const char *text)
{
    for (; *text; text++) printf(*text == '|' ? "\\%c" : "%c", *text);
}

int main(void)
{
    int hundred = 0, last = 0;
    printf("# Codes\n\nEvery message has a code; `yoke explain E0401` prints its paragraph. A code keeps its number "
           "and meaning.\n"
           "This page is written by `sh tools/list-codes > docs/codes.md` from src/base/codes.def.\n");
    for (size_t i = 0; i < sizeof entries / sizeof *entries; i++) {
        const Entry *entry = &entries[i];
        if (entry->number <= last || entry->number > 9999) {
            fprintf(stderr, "codes.def: %s (%d) is out of order or range\n", entry->name, entry->number);
            return 1;
        }
        last = entry->number;
        if (last / 100 != hundred) {
            hundred = last / 100;
            print_heading(hundred);
        }
        printf("| %c%04d | %s | ", entry->severity, last, severity_name(entry->severity));
        print_cell(entry->explanation);
        printf(" |\n");
    }
    return 0;
}
