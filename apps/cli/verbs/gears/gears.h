// The answer of `yoke gears`, in each format.
#ifndef CLI_GEARS_H
#define CLI_GEARS_H
#include "session.h"

typedef struct YkGearsAnswer {
    YkSession *session;
    const YkTrain *train;
} YkGearsAnswer;

void yk_gears_text(const YkGearsAnswer *answer);
void yk_gears_motion_text(const YkGearsAnswer *answer); // speeds, ratio, shift table
void yk_gears_power_text(const YkGearsAnswer *answer);  // torques and power
void yk_gears_json(const YkGearsAnswer *answer);
void yk_gears_csv(const YkGearsAnswer *answer);
const char *yk_gears_body(const YkGearsAnswer *answer, size_t body);
const char *yk_gears_kind(YkTrainKind kind); // "gears", "belt", "rack"

#endif
