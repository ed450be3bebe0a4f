// Shared by the files of `yoke derive`.
#ifndef CLI_DERIVE_H
#define CLI_DERIVE_H
#include <yoke/derive.h>
#include "answer.h"
#include "prove/check.h"
#include "session.h"

// --check: gives verdicts on all equations from session->state, a pose; returns the exit code.
int yk_derive_checks(YkSession *session, YkDerivation *derivation, bool as_json);
// --svg: draws the free bodies at session->state, a pose, with the forces there if they were found; returns the exit
// code.
int yk_derive_drawings(YkSession *session, YkDerivation *derivation, bool has_forces);

#endif
