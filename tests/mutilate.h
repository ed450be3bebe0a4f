// Files of the gallery in which one value is replaced by something else: each is refused with words and a place in the
// file, or it is taken. Nothing is lost on the way.
#ifndef TESTS_MUTILATE_H
#define TESTS_MUTILATE_H
#include "interposed.h"
#include <yoke/yoke.h>
#include "base/problems.h"

// Reads a text as the file of this path. Returns whether it is taken, and has freed what it made.
typedef bool (*MutilatedReader)(const char *text, const char *path, YkProblems *problems);

enum { MUTILATED_MAX = 1 << 14 };

static inline void mutilate_read(const char *path, char *text)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t length = fread(text, 1, MUTILATED_MAX - 1, file);
    assert_true(length > 0 && length < MUTILATED_MAX - 1);
    fclose(file);
    text[length] = '\0';
}

// Tries one text: it is taken, or there are errors, all of which say something about a line of the file.
static inline void mutilate_check(const char *text, const char *path, MutilatedReader reads)
{
    long before = live;
    size_t errors = 0, lines = 1;
    YkProblems *problems = yk_problems_new();
    for (const char *c = text; *c; c++) lines += *c == '\n';
    bool is_taken = reads(text, path, problems);
    for (size_t k = 0; k < yk_problems_count(problems); k++) {
        const YkProblem *p = yk_problems_get(problems, k);
        bool is_told = p->message[0] != '\0' && p->place.line <= lines;
        if (!is_told || p->code == YK_CODE_OUT_OF_MEMORY)
            fail_msg("line %zu: %s:\n%s", (size_t)p->place.line, p->message, text);
        errors += p->severity == YK_SEVERITY_ERROR;
    }
    if ((errors == 0) != is_taken) fail_msg("%s, with %zu errors:\n%s", is_taken ? "taken" : "refused", errors, text);
    yk_problems_free(problems);
    if (IS_INTERPOSED && live != before) fail_msg("%ld blocks lost:\n%s", live - before, text);
}

// Returns the end of the next value of a text, whose beginning is *first. It is empty at the end of the text.
static inline const char *mutilate_next(const char *at, const char **first)
{
    at += strspn(at, " \n,:[]{}");
    while (*at == '#') { // a comment
        at += strcspn(at, "\n");
        at += strspn(at, " \n,:[]{}");
    }
    *first = at;
    return at + strcspn(at, "\n,:[]{}#");
}

// Tries every stride-th of all texts in which one value or key is another word. Returns how many.
static inline size_t mutilate(const char *folder, const char *const *names, size_t count, size_t stride,
                              MutilatedReader reads)
{
    static const char *const words[] = {"",       "x", "-1",     "0",   "1e300", "[1, 2]", "{a: 1}", "[]",
                                        "1 kg*m", "~", "ground", "2.5", "{}",    "[[0]]",  "pi*t",   "nan"};
    static char text[MUTILATED_MAX], wrong[MUTILATED_MAX + 16];
    size_t all = 0, tried = 0;
    for (size_t f = 0; f < count; f++) {
        char path[512];
        snprintf(path, sizeof path, YOKE_ROOT "/examples/%s%s.yaml", folder, names[f]);
        mutilate_read(path, text);
        const char *first;
        for (const char *end = mutilate_next(text, &first); end > first; end = mutilate_next(end, &first))
            for (size_t w = 0; w < sizeof words / sizeof *words; w++) {
                if (all++ % stride != 0) continue;
                snprintf(wrong, sizeof wrong, "%.*s%s%s", (int)(first - text), text, words[w], end);
                mutilate_check(wrong, path, reads);
                tried++;
            }
    }
    return tried;
}
#endif
