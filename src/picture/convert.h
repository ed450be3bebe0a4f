// Drawings in other formats: SVG text to PDF or PNG, by rsvg-convert.
#ifndef PICTURE_CONVERT_H
#define PICTURE_CONVERT_H
#include "base/text.h"
#include "write/file.h"

// Adds the picture in the given format to `output` (YK_FILE_SVG: a copy). A PNG has two pixels for each of the
// drawing's. Returns false with a problem added.
bool yk_convert_svg(const char *svg, YkFileKind kind, YkText *output, YkProblems *problems);

#endif
