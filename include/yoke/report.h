// The report: everything about a machine on one page, an HTML document that needs nothing else.
#ifndef YOKE_REPORT_H
#define YOKE_REPORT_H

#include <yoke/draw.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkReportOptions {
    const YkCompileOptions *compile; // the options with which the mechanism was compiled; NULL: defaults
    bool has_range;
    int coordinate;  // with has_range: the input that is swept from `from` to `to` (rad, m); -1: time (s)
    double from, to; // without: chosen (a whole turn, the range in which the machine closes, or its motion under loads)
    double duration; // s: of the simulation, or of drives in time; 0: chosen
    size_t steps;    // one less than the rows; 0: chosen
    const size_t *traced_points; // model points whose path is shown at first
    size_t traced_count;         // 0: chosen
    bool is_plain;               // no script: the page does not move, and gnuplot draws the diagrams
    double pose_rate;            // > 0: only the motion, with so many poses a second, for yk_report_drawing
    bool no_labels;              // in that drawing
} YkReportOptions;
YK_API YkReportOptions yk_default_report_options(void);

typedef struct YkReportPage YkReportPage;
// Gathers everything from a state whose inputs are set: its pose or, without one, the configuration nearest to the
// guesses. Chooses a motion, goes through it and solves the forces. A machine that cannot be assembled also has a
// report (see yk_report_status). The state's model and mechanism must outlive it. Returns NULL with a problem added
// when out of memory, or if it was stopped: what watches the state (yk_state_set_progress) watches this call and
// yk_report_html.
// Cost: that of some hundred poses.
YK_API YkReportPage *yk_report_new(YkState *state, const YkReportOptions *options, YkProblems *problems);
YK_API void yk_report_free(YkReportPage *report);
YK_API YkStatus yk_report_status(const YkReportPage *report);     // of the assembly at the start
YK_API const char *yk_report_message(const YkReportPage *report); // a remark on it, or ""

// The findings, as sentences.
YK_API size_t yk_report_finding_count(const YkReportPage *report);
YK_API const char *yk_report_finding(const YkReportPage *report, size_t index);

// Returns the whole document, valid HTML without a reference to anything outside. It belongs to the report. Returns
// NULL with a problem added when out of memory or stopped; after a stop it may be asked again.
YK_API const char *yk_report_html(YkReportPage *report, YkProblems *problems);
// Returns the drawing of the motion's poses, one for each row, which belongs to the report; NULL if nothing can be
// drawn or without options.pose_rate > 0. yk_report_seconds returns the time of one pass on a screen, s;
// yk_report_goes_back says whether the motion goes back before it repeats.
YK_API YkDrawing *yk_report_drawing(YkReportPage *report);
YK_API double yk_report_seconds(const YkReportPage *report);
YK_API bool yk_report_goes_back(const YkReportPage *report);
// Returns whether Yoke was built with the script that moves the drawing and draws the diagrams.
YK_API bool yk_report_has_script(void);

#ifdef __cplusplus
}
#endif

#endif
