// What the files of `yoke derive` share.
#ifndef CLI_DERIVE_H
#define CLI_DERIVE_H
#include <yoke/derive.h>
#include "answer.h"
#include "prove/check.h"
#include "session.h"

// Assembles at the inputs and solves the forces too. Returns false (reported) if the machine does not close.
bool yk_derive_pose(YkSession *session);
// --check: gives verdicts on all equations; returns the exit code.
int yk_derive_checks(YkSession *session, YkDerivation *derivation, bool as_json);
// --svg: draws the free bodies; returns the exit code.
int yk_derive_drawings(YkSession *session, YkDerivation *derivation);

#endif
