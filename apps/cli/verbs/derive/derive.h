// What the files of `yoke derive` share.
#ifndef CLI_DERIVE_H
#define CLI_DERIVE_H
#include "answer.h"
#include "page/print.h"
#include "prove/check.h"
#include "session.h"

// Assembles at the inputs and solves the forces too; false (told) where the machine does not close.
bool yk_derive_pose(YkSession *session);
// --check: verdicts on all equations; returns the exit code.
int yk_derive_checks(YkSession *session, YkDerivation *derivation, bool as_json);
// --svg: free bodies as drawings; returns the exit code.
int yk_derive_drawings(YkSession *session, YkDerivation *derivation);

#endif
