// Patterns: elements that are alike are worked out and typeset once. Two are alike if the second is the first with
// other symbols of the same classes in the same order, and if the replacements of these are alike as well. Their texts
// then differ in names alone. For use inside ring/ only.
#ifndef RING_PRINT_PATTERN_H
#define RING_PRINT_PATTERN_H
#include "ring/print/shown.h"

// Writes an element by the pattern of one that is alike. Returns false if there is none.
bool yk_pattern_write(YkRing *ring, const YkRingView *view, YkRingFormat format, YkRingStyle style, YkText *text);
// Keeps the text of a real element from `start` on, with the names that ring->marks lists, as a pattern. Call it after
// yk_pattern_write has found none and has asked for these marks.
void yk_pattern_keep(YkRing *ring, const YkRingView *view, YkRingFormat format, YkRingStyle style, const YkText *text,
                     size_t start);

#endif
