// Yoke: the workbench for planar machines. This header includes the whole public interface of libyoke.
//
//   model file --yk_model_load--> YkModel --yk_mechanism_compile--> YkMechanism --yk_state_new--> YkState --> answers
//
// Conventions of all these headers:
// - Numbers are in SI units and radians. Times are in seconds.
// - Whoever calls yk_x_new (or _load, _compile, _run) frees the result with yk_x_free, which takes NULL.
// - A returned `const char *` belongs to the object that was passed in and lives as long as that object, unless the
//   function says otherwise.
// - A YkStatus below 0 is a failure. A constructor that fails returns NULL and adds a problem that says why. `problems`
//   may be NULL; the call then does the same without saying why. A pose that could not be found is explained in the
//   state's report (yk_state_report), not among the problems.
// - Indices are size_t and count from 0. A search by name returns YK_NOT_FOUND if the name is unknown. A member of a
//   struct that may have no index is an int; it is -1 if there is none.
// - Any index is safe to pass. For one past the last, such as YK_NOT_FOUND, a function returns NaN for a number, NULL
//   for a pointer, YK_NOT_FOUND for an index, 0 for a count or a truth value, and a struct of these; a setter does
//   nothing.
// - Options come from yk_default_x_options() and are changed from there; NULL in their place means the defaults.
//   Options and requests without such a function start from {0}, which leaves out all that may be left out.
// - Enumerators begin with the name of their type; only the statuses (YK_OK, YK_LIMIT, ...) stand alone.
// - Constant objects (models, mechanisms) may be shared between threads; all others belong to one thread at a time.
#ifndef YOKE_YOKE_H
#define YOKE_YOKE_H

#include <yoke/version.h>
#include <yoke/status.h>
#include <yoke/progress.h>
#include <yoke/problem.h>
#include <yoke/model.h>
#include <yoke/builder.h>
#include <yoke/mechanism.h>
#include <yoke/sketch.h>
#include <yoke/variant.h>
#include <yoke/state.h>
#include <yoke/configurations.h>
#include <yoke/certificate.h>
#include <yoke/move.h>
#include <yoke/drag.h>
#include <yoke/sweep.h>
#include <yoke/map.h>
#include <yoke/regions.h>
#include <yoke/batch.h>
#include <yoke/dynamics.h>
#include <yoke/laws.h>
#include <yoke/simulation.h>
#include <yoke/lanes.h>
#include <yoke/rest.h>
#include <yoke/design.h>
#include <yoke/synthesis.h>
#include <yoke/centers.h>
#include <yoke/centrodes.h>
#include <yoke/polygon.h>
#include <yoke/force_polygon.h>
#include <yoke/balancing.h>
#include <yoke/derive.h>
#include <yoke/train.h>
#include <yoke/cam.h>
#include <yoke/study.h>
#include <yoke/blocks.h>
#include <yoke/draw.h>
#include <yoke/code.h>
#include <yoke/report.h>

#endif
