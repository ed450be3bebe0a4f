// A machine that synthesis proposes: its dimensions, its model file, and the engine's judgement of it.
#ifndef SYNTHESIS_DESIGN_H
#define SYNTHESIS_DESIGN_H
#include "synthesis/tasks/task.h"

typedef enum YkDesignKind {
    YK_DESIGN_FOUR_BAR,
    YK_DESIGN_SLIDER_CRANK,
    YK_DESIGN_INVERTED, // slider-crank whose coupler slides through a block that turns about the output pivot
    YK_DESIGN_GEARED,   // five-bar whose cranks are geared to each other
    YK_DESIGN_WATT,
    YK_DESIGN_STEPHENSON,
    YK_DESIGN_KINDS
} YkDesignKind;
const char *yk_design_kind_name(YkDesignKind kind); // "four-bar", ...

typedef struct YkDesign {
    YkDesignKind kind;
    YkVec pivot[YK_SIDES]; // slider-crank: [1] is a point of the slider's line
    double along;          // slider-crank: the line's direction, rad
    double length[4];      // ground, input, coupler, output; slider-crank: ground and output are 0
    bool has_point;
    YkVec point; // in the coupler's axes: x along the coupler from the input side, m
    double turn; // angle of the task's body less that of the coupler, rad
    double
        angle[3]; // input, coupler, output at the first position, to the ground, rad; slider-crank: [2] is a distance
    int dyad[YK_SIDES];
    // For a machine with a dyad (path_chain.h): how it is built, where link and arm begin in the axes of their carriers
    // (geared five-bar: nothing), their lengths, and their absolute angles at the first position, rad. Inverted
    // slider-crank: length[3] is the distance of the output pivot from the coupler's line, to its left, and angle[2]
    // how far along it this is, m.
    int variant;
    YkVec end[2];
    double dyad_length[2], dyad_angle[2];
} YkDesign;

// The task of a design, in terms of its input.
typedef struct YkJourney {
    const YkTask *task;        // NULL for a machine that no task asked for, which then has:
    const YkModel *sheet;      // its units
    const char *name, *origin; // its name, and a comment on where it comes from
    double *input;             // [count] absolute angles, each reached from the one before by moving straight, rad
    size_t count;
    bool turns;                // goes round as a whole
    const YkPose *pose;        // [count + rates] of the body: positions, and rates at some of them; or NULL
    size_t rates;              //
    const size_t *rate_of;     // [rates]
    const double *output;      // [count] absolute angles of the output, rad (NaN: any), or NULL
    bool exact;                // poses and outputs are met exactly; otherwise only near
    const YkVec *point, *path; // [count] wanted of the coupler point, and where it passes by its equations, or NULL
} YkJourney;

enum { YK_CURVE_ROWS = 181 };

// The engine's findings.
typedef struct YkVerdict {
    YkDefect defect;
    double error, worst, transmission[2];
    double curve[2 * YK_CURVE_ROWS]; // coupler point (m), or input angle and error (rad)
    size_t rows;
    double low, high, low_at, high_at; // extremes of the output (with a point: of its y), and the input there, rad
} YkVerdict;

// design.c
bool yk_design_of_dyads(const YkPose *first, const YkDyad *input, const YkDyad *output, YkDesign *design);
YkFourBarClass yk_design_class(const YkDesign *design);
// Finds where A, B and the traced point are at the first position, m, and C, D, E if the machine has a dyad. If the
// kind has no B, it is the end of the output, or the output pivot.
typedef struct YkDesignPlaces {
    YkVec A, B, P, C, D, E;
} YkDesignPlaces;
YkDesignPlaces yk_design_places(const YkDesign *design);
const char *yk_design_type(const YkDesign *design);  // "crank-rocker", ...
bool yk_design_has_circuits(const YkDesign *design); // two of them, so that one cannot be reached from the other
bool yk_design_turns(const YkDesign *design);        // the input turns through
// Finds the angles of input, coupler and output (slider-crank: the distance) where the body is at a pose.
void yk_design_angles(const YkDesign *design, YkPose pose, double angle[3]);
// Judges by signs of angles whether positions lie on one circuit, between dead points. Source: Chase & Mirth 1993.
YkDefect yk_design_signs(const YkDesign *design, double (*angle)[3], size_t count);
// Checks the task's bounds, lengths and sizes.
YkDefect yk_design_bounds(const YkDesign *design, const YkTask *task);

// design_text.c: adds the model file.
void yk_design_write(const YkDesign *design, const YkJourney *journey, YkText *text);
// judge.c: reads the model file back and drives the machine through the journey.
YkStatus yk_design_judge(const char *text, const YkDesign *design, const YkJourney *journey, YkVerdict *verdict);

#endif
