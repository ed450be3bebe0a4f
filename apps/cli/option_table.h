// The table of options, and which verbs take them.
#ifndef CLI_OPTION_TABLE_H
#define CLI_OPTION_TABLE_H
#include <stdbool.h>
#include <stddef.h>

typedef enum YkOptionKind {
    YK_OPTION_SWITCH,
    YK_OPTION_WORD,
    YK_OPTION_WORDS,  // any number of words
    YK_OPTION_VALUES, // any number of NAME=VALUE, one for each name
    YK_OPTION_PAIRS,  // any number of NAME=VALUE; a name may have several
} YkOptionKind;

typedef struct YkOption {
    const char *name;
    char letter; // short form, or 0
    YkOptionKind kind;
    size_t offset;     // its place in YkRequest
    const char *value; // the placeholder of its value in help
    const char *verbs; // names of the verbs that take it, each between blanks; "*": all
    const char *help;
} YkOption;

extern const YkOption yk_options[]; // ends at name NULL
bool yk_option_is_for(const YkOption *option, const char *verb);
bool yk_option_lists(const char *verbs, const char *verb); // whether `verbs`, written as in YkOption, contains the verb

#endif
