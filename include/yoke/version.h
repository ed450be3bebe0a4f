// The version of these headers; yk_version() returns that of the library that is loaded.
#ifndef YOKE_VERSION_H
#define YOKE_VERSION_H

#include <yoke/status.h>

#ifdef __cplusplus
extern "C" {
#endif

// CMakeLists.txt reads the version here. While MAJOR is 0, a new MINOR may change what is declared in these headers.
#define YOKE_VERSION_MAJOR 0
#define YOKE_VERSION_MINOR 1
#define YOKE_VERSION_PATCH 0
#define YOKE_VERSION_STRING "0.1.0"

YK_API const char *yk_version(void); // "0.1.0"

#ifdef __cplusplus
}
#endif

#endif
