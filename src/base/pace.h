// Paces long work: counts it, and asks the caller after every slice whether to go on (<yoke/progress.h>).
//
// The public call creates the pace, on its stack or in the object it works on. Everything that runs on its behalf
// counts in it through a pointer, which is NULL if the caller is not watching. A stopped pace stays stopped: code that
// gets false gives up, and the public call returns YK_STOPPED whatever its parts returned.
#ifndef BASE_PACE_H
#define BASE_PACE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <yoke/progress.h>

// Work is counted in units of about a nanosecond: a multiplication, an entry that is read. A slice is some 10 ms.
enum { YK_PACE_SLICE = 8000000 };

typedef struct YkPace {
    YkProgress progress;
    double from, to; // the shares of the whole call between which the present stage lies
    double part;     // of the whole call: reported last
    uint64_t work;   // since the caller was asked
    bool is_stopped;
} YkPace;

// Begins a call: asks for the first time. Returns false if it is to stop at once.
bool yk_pace_begin(YkPace *pace, YkProgress progress);
// Begins a stage of the call, between two shares of it.
void yk_pace_stage(YkPace *pace, double from, double to);
// Notes which part of the stage is done; the caller learns of it when it is asked next.
void yk_pace_reach(YkPace *pace, double part);
bool yk_pace_ask(YkPace *pace); // asks, whatever was counted

// Counts work. Returns whether to go on.
static inline bool yk_pace_spend(YkPace *pace, uint64_t work)
{
    if (!pace) return true;
    pace->work += work;
    return pace->work < YK_PACE_SLICE ? !pace->is_stopped : yk_pace_ask(pace);
}
static inline bool yk_pace_is_stopped(const YkPace *pace)
{
    return pace && pace->is_stopped;
}
// Returns what a call within this one is given: what it does is a part of the present stage. The pace must outlive it.
YkProgress yk_pace_within(YkPace *pace);

#endif
