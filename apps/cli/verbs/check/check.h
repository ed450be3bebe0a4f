// The answer of `yoke check`, in each format.
#ifndef CLI_CHECK_H
#define CLI_CHECK_H
#include "answer.h"

enum { YK_FOUR_BARS_MAX = 64 };

typedef struct YkCheckAnswer {
    YkSession *session;
    YkStatus status; // of the assembly at the start
    const char *message;
    YkFourBar four_bars[YK_FOUR_BARS_MAX];
    size_t four_bar_count;
    size_t *bodies; // room for the bodies round a loop
    bool has_loads;
    YkLoadCounts loads;
    YkEquationCount equations; // if there are loads
} YkCheckAnswer;

void yk_check_text(const YkCheckAnswer *answer);
void yk_check_json(const YkCheckAnswer *answer);
void yk_check_csv(const YkCheckAnswer *answer);
// Finds the bodies round a loop, in answer->bodies. Returns their number.
size_t yk_check_loop(const YkCheckAnswer *answer, size_t loop);
// --sketch: what the machine lacks to move, in place of the rest; returns the exit code.
int yk_check_sketch(YkSession *session);

#endif
