// The report: all that Yoke knows of a machine as one page, an HTML document that needs nothing else.
#ifndef YOKE_REPORT_H
#define YOKE_REPORT_H

#include <yoke/draw.h>

typedef struct YkReportOptions {
    const YkCompileOptions *compile; // with which the mechanism was compiled; NULL: defaults
    bool has_range;
    int coordinate;  // with has_range: what is swept, an input, from `from` to `to` (rad, m); -1: time (s)
    double from, to; // without: chosen (a whole turn, the range in which the machine closes, or its motion under loads)
    double duration; // s: of the simulation, or of drives in time; 0: chosen
    size_t steps;    // rows less one; 0: chosen
    const size_t *traced_points; // model points whose path is shown at first
    size_t traced_count;         // 0: chosen
    bool is_plain;               // no script: the page stands still, diagrams are pictures by gnuplot
    double pose_rate;            // > 0: only the motion, with so many poses a second, for yk_report_drawing
    bool no_labels;              // of that drawing
} YkReportOptions;
YK_API YkReportOptions yk_default_report_options(void);

typedef struct YkReportPage YkReportPage;
// Gathers everything from a state whose inputs are set: its pose, or where it has none the configuration nearest to the
// guesses; chooses a motion and goes through it, solves the forces. A machine that does not go together has a report too (yk_report_status tells). The state's model and
// mechanism must outlive it. NULL with a problem added when out of memory. Cost: some hundred poses.
YK_API YkReportPage *yk_report_new(YkState *state, const YkReportOptions *options, YkProblems *problems);
YK_API void yk_report_free(YkReportPage *report);
YK_API YkStatus yk_report_status(const YkReportPage *report);     // of assembling at the start
YK_API const char *yk_report_message(const YkReportPage *report); // what there is to say of it, or ""

// What it found, in sentences.
YK_API size_t yk_report_finding_count(const YkReportPage *report);
YK_API const char *yk_report_finding(const YkReportPage *report, size_t index);

// The whole document, valid HTML without a reference to anything outside. Belongs to the report. NULL with a problem
// added when out of memory.
YK_API const char *yk_report_html(YkReportPage *report, YkProblems *problems);
// The drawing of the motion's poses, one a row; only with options.pose_rate > 0, NULL where nothing can be drawn.
// Belongs to the report. How long one pass of it takes on a screen, s, and whether it goes back before it comes again.
YK_API YkDrawing *yk_report_drawing(YkReportPage *report);
YK_API double yk_report_seconds(const YkReportPage *report);
YK_API bool yk_report_goes_back(const YkReportPage *report);
// Was Yoke built with the script that moves the drawing and draws the diagrams?
YK_API bool yk_report_has_script(void);

#endif
