// Help: a short tour for who types `yoke` alone, and what each verb takes.
#ifndef CLI_HELP_H
#define CLI_HELP_H
#include "cli.h"

void yk_help_tour(YkText *text);
void yk_help_verb(YkText *text, const YkVerb *verb);

#endif
