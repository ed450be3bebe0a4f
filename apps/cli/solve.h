// One configuration, in each format.
#ifndef CLI_SOLVE_H
#define CLI_SOLVE_H
#include "answer.h"

void yk_solve_text_head(YkSession *session, YkStatus status);
void yk_solve_text(YkSession *session, const YkState *state, size_t index);
void yk_solve_json(YkSession *session, YkJson *json, const YkState *state);
void yk_solve_csv_head(YkSession *session);
void yk_solve_csv(YkSession *session, const YkState *state, size_t index);

#endif
