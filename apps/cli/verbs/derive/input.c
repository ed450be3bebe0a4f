// Reads standard input as a text; in a file of its own, because doc/ and the command both have a YkAssignment.
#include "doc/node.h"
#include "verbs/derive/input.h"

char *yk_derive_read_input(size_t *length, YkProblems *problems)
{
    return yk_doc_read_file("-", length, problems);
}
