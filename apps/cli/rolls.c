// Ends the enumeration of configurations.
#include "roll.h"
#include <stdlib.h>

void yk_roll_end(YkSession *session)
{
    if (session->rolls) yk_configurations_free(session->rolls->configurations);
    free(session->rolls);
    session->rolls = NULL;
}
