// A report inside: what was gathered about a machine, and the parts of the page that present it.
//
// `gather` fills it in this order: the pose at the start, the motion that is shown (`motion`), its rows (`rows`), the
// findings in sentences (`findings*`). Then `page` asks every section for its part; a section without content writes
// nothing. Sections read what was gathered and compute nothing anew.
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H
#include <yoke/laws.h>
#include <yoke/report.h>
#include <yoke/simulation.h>
#include "base/memory.h"
#include "base/pace.h"
#include "base/text.h"
#include "model/model.h"
#include "picture/drawing/drawing.h"
#include "solve/state.h"

typedef enum YkReportMotionKind {
    YK_REPORT_STILL,     // nothing moves: no freedom, or no pose
    YK_REPORT_TURN,      // an input through one whole turn
    YK_REPORT_RANGE,     // an input through the range in which the machine closes, or a given one; back and forth
    YK_REPORT_TIME,      // all drives, in time
    YK_REPORT_SIMULATION // free inputs move under loads
} YkReportMotionKind;

typedef struct YkReportMotion {
    YkReportMotionKind kind;
    int coordinate;  // TURN, RANGE: what is swept
    double from, to; // rad, m or s
    size_t steps;
    double duration; // s that one pass takes; 0: no rate is known
    bool is_cut;     // RANGE: both ends are limits of the machine, and the sweep stops a little before them
} YkReportMotion;

// The purpose of a column of numbers.
typedef enum YkReportRole {
    YK_ROLE_COORDINATE,   // and its derivatives
    YK_ROLE_TRANSMISSION, // angle of a block
    YK_ROLE_EFFORT,
    YK_ROLE_REACTION, // size of a joint's force
    YK_ROLE_ENERGY,
    YK_ROLE_SHAKING,
    YK_ROLE_VELOCITY, // of a point, x and y: for arrows
    YK_ROLE_FORCE     // of a joint, x and y: for arrows
} YkReportRole;

typedef struct YkReportColumn {
    const char *name;
    YkChannel channel;
    YkReportRole role;
    size_t of; // coordinate, block, joint, point
} YkReportColumn;

typedef enum YkFindingKind { YK_FINDING_FACT, YK_FINDING_LOOK } YkFindingKind; // LOOK: worth a closer look
typedef struct YkFinding {
    YkFindingKind kind;
    const char *text; // one or two sentences
} YkFinding;

enum { YK_REPORT_RANGES_MAX = 8 };

struct YkReportPage {
    YkArena *arena;
    const YkModel *model;
    const YkMechanism *mech;
    YkReportOptions options;
    YkState *start; // the pose at the start
    YkStatus status;
    const char *message;
    YkDynamics *dynamics; // for a machine with masses or loads: at the start, solved there when has_forces
    YkDynamics *along;    // the same machine's for sweeps, which leave it at their last row
    bool has_forces;
    const char *forces_message;
    YkRange ranges[YK_REPORT_RANGES_MAX]; // of the one input, in which the configuration closes
    size_t range_count;

    YkReportMotion motion;
    YkReportColumn *columns;
    size_t column_count, column_capacity;
    double *at;     // [row]: swept coordinate or time
    double *values; // [row][column], SI; NaN if there is none
    size_t row_count, row_capacity;
    YkSweep *sweep;
    YkSimulation *simulation;
    YkStatus motion_status; // how it ended
    const char *motion_message;

    YkLawWatch *laws;                  // that the motion, or the pose at the start, leaves
    YkDrawing *drawing;                // poses: one for each row, then that of the start
    size_t *traced;                    // model points with a path
    size_t traced_count, traced_shown; // the first of them are shown when the page opens
    size_t posed;                      // rows whose pose is in the drawing

    YkFinding *findings;
    size_t finding_count, finding_capacity;
    bool failed;         // out of memory
    YkWitness *witness;  // of the state from which it is made, or NULL
    YkProgress progress; // of the state that was reported on
    YkPace pace;         // of the call that is running
    YkText html;
};

// Returns a new state that works for the page; NULL when out of memory, which is noted.
YkState *yk_report_new_state(YkReportPage *report);

static inline double yk_report_value(const YkReportPage *report, size_t row, size_t column)
{
    return report->values[row * report->column_count + column];
}
// Returns the first column of a role for `of`; -1 if there is none. order: of a coordinate's derivative.
int yk_report_column(const YkReportPage *report, YkReportRole role, size_t of, int order);

// motion.c: chooses the motion.
void yk_report_choose_motion(YkReportPage *report);
// columns.c: chooses what is recorded on the way.
void yk_report_choose_columns(YkReportPage *report);
void yk_report_choose_traces(YkReportPage *report);
// rows.c: runs the motion.
void yk_report_run(YkReportPage *report, YkProblems *problems);
// Returns what is swept at a state: the coordinate, or the time.
double yk_report_place(const YkReportPage *report, const YkState *state);

// The largest magnitude of a column over the rows, refined between them if possible. row_count must not be 0.
typedef struct YkPeak {
    double value, at;
} YkPeak;
YkPeak yk_report_peak(YkReportPage *report, size_t column);
YkPeak yk_report_least(YkReportPage *report, size_t column); // the same for the least value

// notes.c: remember that memory ran out below, whatever else happens to the answer: the whole page is then refused.
void yk_report_note(YkReportPage *report, YkStatus status);
void yk_report_note_problems(YkReportPage *report, const YkProblems *problems);
// Adds a finding, the sentences in `text`, which is emptied.
void yk_report_find(YkReportPage *report, YkFindingKind kind, YkText *text);
// findings.c: writes all of them, one file for each kind.
void yk_report_findings(YkReportPage *report);
void yk_findings_structure(YkReportPage *report, YkText *text); // freedom, redundant constraints, four-bars
void yk_findings_motion(YkReportPage *report, YkText *text);    // ranges, dead points, strokes, transmission
void yk_findings_forces(YkReportPage *report, YkText *text);    // efforts, reactions, energy
void yk_findings_simulation(YkReportPage *report, YkText *text);
void yk_findings_parts(YkReportPage *report, YkText *text); // gears, cams
void yk_findings_laws(YkReportPage *report, YkText *text);  // laws whose range is left
// amounts.c: returns "theta1", or "t" for a motion in time; its quantity.
const char *yk_report_axis(const YkReportPage *report);
YkQuantity yk_report_axis_quantity(const YkReportPage *report);
// Returns the unit of a quantity on the page, its size in SI (may be NULL), and a value in it: the file's unit, but
// degrees instead of radians.
const char *yk_report_unit(const YkReportPage *report, YkQuantity quantity, double *size);
double yk_report_in_unit(const YkReportPage *report, double value, YkQuantity quantity);
void yk_report_error(YkText *text, double value); // to two digits
// Writes "190.09 deg"; "theta1 = 30 deg".
void yk_report_amount(const YkReportPage *report, YkText *text, double value, YkQuantity quantity);
void yk_report_amount_at(const YkReportPage *report, YkText *text, double at);

// Called by page.c in order; each adds to `html` what is below its heading.
typedef void YkReportSection(YkReportPage *report, YkText *html, YkProblems *problems);
YkReportSection yk_section_findings, yk_section_motion, yk_section_diagrams, yk_section_forces, yk_section_gears,
    yk_section_cams, yk_section_parameters, yk_section_topology, yk_section_equations, yk_section_method;
// Writes the script's data as JSON.
void yk_report_data(YkReportPage *report, YkText *json);

// Embedded at build time: the page's style.
extern const unsigned char yk_report_style[];
extern const size_t yk_report_style_size;
// script.c: the page's script, embedded as well; empty if there was no Node to bundle it.
void yk_report_add_script(YkText *html);

#endif
