// Yoke: the workbench for planar machines. This header is the whole door of libyoke.
//
//   model file --yk_model_load--> YkModel --yk_mechanism_compile--> YkMechanism --yk_state_new--> YkState --> answers
#ifndef YOKE_YOKE_H
#define YOKE_YOKE_H

#ifdef __cplusplus
extern "C" {
#endif

#include <yoke/status.h>
#include <yoke/problem.h>
#include <yoke/model.h>
#include <yoke/mechanism.h>
#include <yoke/variant.h>
#include <yoke/state.h>
#include <yoke/move.h>
#include <yoke/drag.h>
#include <yoke/sweep.h>
#include <yoke/batch.h>
#include <yoke/dynamics.h>
#include <yoke/simulation.h>
#include <yoke/rest.h>
#include <yoke/design.h>
#include <yoke/train.h>
#include <yoke/cam.h>
#include <yoke/study.h>
#include <yoke/draw.h>
#include <yoke/code.h>
#include <yoke/report.h>

YK_API const char *yk_version(void); // "0.1.0"

#ifdef __cplusplus
}
#endif
#endif
