// The version of the library.
#include <yoke/yoke.h>

#ifndef YOKE_VERSION
#error "the build gives YOKE_VERSION, a string"
#endif

const char *yk_version(void)
{
    return YOKE_VERSION;
}
