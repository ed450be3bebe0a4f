// The version of the library.
#include <yoke/version.h>

const char *yk_version(void)
{
    return YOKE_VERSION_STRING;
}
