// The answer of `yoke gears`, in each format.
#ifndef CLI_GEARS_H
#define CLI_GEARS_H
#include "session.h"

typedef struct YkGearsAnswer {
    YkSession *session;
    const YkTrain *train;
} YkGearsAnswer;

// Returns whether --lock and --in ask for a ratio that the train has without its drives, which contradict each other.
static inline bool yk_gears_leave_drives_out(const YkSession *session, const YkTrain *train)
{
    return yk_train_status(train) == YK_TRAIN_STATUS_LOCKED && session->request->lock && session->request->in &&
           yk_train_ratio(train).is_known;
}

void yk_gears_text(const YkGearsAnswer *answer);
void yk_gears_motion_text(const YkGearsAnswer *answer); // speeds, ratio, shift table
void yk_gears_power_text(const YkGearsAnswer *answer);  // torques and power
void yk_gears_json(const YkGearsAnswer *answer);
void yk_gears_csv(const YkGearsAnswer *answer);
const char *yk_gears_body(const YkGearsAnswer *answer, size_t body);
const char *yk_gears_kind(YkTrainKind kind); // "gears", "belt", "rack"

#endif
