// Help: a short tour for a user who types only `yoke`, and the options of each verb.
#ifndef CLI_HELP_H
#define CLI_HELP_H
#include "cli.h"

void yk_help_tour(YkText *text);
void yk_help_verb(YkText *text, const YkVerb *verb);

#endif
