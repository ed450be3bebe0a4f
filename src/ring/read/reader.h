// Shared by the files that read expressions. For use inside ring/ only.
#ifndef RING_READ_READER_H
#define RING_READ_READER_H
#include "ring/inside.h"
#include "ring/print/write.h"

typedef struct YkRingReader {
    YkRing *ring;
    YkRingFormat format;
    const char *text;
    size_t length, at;
    YkPlace place; // of the first character
    YkProblems *problems;
    int depth;
    bool failed; // a problem was reported: the first is enough
} YkRingReader;

char yk_reader_peek(const YkRingReader *reader); // '\0' at the end
void yk_reader_blanks(YkRingReader *reader);     // also LaTeX's spaces and \left, \right
// Skips `what` and the blanks after it if the text continues with it (in LaTeX, a command not followed by a letter).
bool yk_reader_takes(YkRingReader *reader, const char *what);
bool yk_reader_sees(const YkRingReader *reader, const char *what);
// Reports a problem over text[start..at) and returns NULL.
const YkPoisson *yk_reader_refuse(YkRingReader *reader, YkCode code, size_t start, const char *message,
                                  const char *detail);
const YkPoisson *yk_reader_expected(YkRingReader *reader, const char *wanted);

// Reads a decimal number, exactly; `1i` is the imaginary unit.
const YkPoisson *yk_reader_number(YkRingReader *reader);
// Reads a name in the reader's format: the symbol, or pi, or i; in LaTeX with accents and subscript.
const YkPoisson *yk_reader_name(YkRingReader *reader);
// Reads cos(...), sin(...), exp(...), sqrt(...), pow(...): *found: whether one of them stands here.
const YkPoisson *yk_reader_function(YkRingReader *reader, bool *found);

const YkPoisson *yk_reader_sum(YkRingReader *reader);
const YkPoisson *yk_reader_factor(YkRingReader *reader);

#endif
