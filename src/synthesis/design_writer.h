// How the model file of a design is written.
#ifndef SYNTHESIS_DESIGN_WRITER_H
#define SYNTHESIS_DESIGN_WRITER_H
#include "synthesis/design.h"

typedef struct YkDesignWriter {
    YkText *text;
    double unit; // of length, m
    int digits;
} YkDesignWriter;

// Write text before a length (m) in the file's unit, or around an angle (rad) in degrees.
void yk_write_length(const YkDesignWriter *w, const char *before, double value);
void yk_write_angle(const YkDesignWriter *w, const char *before, double value, const char *after);

// design_dyad_text.c: the parts of a machine with a dyad beside its first loop; nothing for other machines.
void yk_write_dyad_parameters(const YkDesignWriter *w, const YkDesign *design);
// Adds the points at which link and arm begin to those of a body (YkChainBody).
void yk_write_dyad_points(const YkDesignWriter *w, const YkDesign *design, int body);
void yk_write_dyad_bodies(const YkDesignWriter *w, const YkDesign *design);
void yk_write_dyad_joints(const YkDesignWriter *w, const YkDesign *design);
void yk_write_dyad_start(const YkDesignWriter *w, const YkDesign *design);

#endif
