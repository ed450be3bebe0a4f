// Writes help.
#include "help.h"
#include <string.h>
#include "options.h"

enum { VERB_COLUMN = 10, OPTION_COLUMN = 26 };

static void add_padded(YkText *text, const char *word, size_t length, size_t width)
{
    yk_text_puts(text, word);
    yk_text_repeat(text, ' ', width > length ? width - length : 1);
}

void yk_help_tour(YkText *text)
{
    yk_text_format(text,
                   "yoke %s: the workbench for planar machines. One file describes a machine; each verb asks one "
                   "question of it.\n\n",
                   yk_version());
    yk_text_puts(text,
                 "Start here:\n"
                 "  yoke new four-bar > machine.yaml                  a machine to begin with; `yoke new` lists more\n"
                 "  yoke check machine.yaml                           what machine is it? can it move?\n"
                 "  yoke solve machine.yaml --at theta2=30deg         where is everything, how fast?\n"
                 "  yoke sweep machine.yaml --over theta2=0:360deg    how does it move?\n"
                 "  yoke draw machine.yaml -o machine.svg             what does it look like?\n"
                 "  yoke derive machine.yaml                          by which equations?\n\n"
                 "Verbs:\n");
    for (const YkVerb *verb = yk_verbs; verb->name; verb++) {
        yk_text_puts(text, "  ");
        add_padded(text, verb->name, strlen(verb->name), VERB_COLUMN);
        yk_text_format(text, "%s\n", verb->summary);
    }
    yk_text_puts(text,
                 "\n`yoke VERB --help` tells what a verb takes, `man yoke-model` what a machine file may hold.\n");
}

static void add_option(YkText *text, const YkOption *option)
{
    YkText form = {0};
    if (option->letter) yk_text_format(&form, "-%c, ", option->letter);
    yk_text_format(&form, "--%s%s%s", option->name, option->value ? " " : "", option->value ? option->value : "");
    yk_text_puts(text, "  ");
    add_padded(text, yk_text_get(&form), form.length, OPTION_COLUMN);
    yk_text_format(text, "%s\n", option->help);
    yk_text_free(&form);
}

void yk_help_verb(YkText *text, const YkVerb *verb)
{
    yk_text_format(text, "yoke %s %s\n", verb->name, verb->usage);
    yk_text_format(text, "\n%s\n\nOptions:\n", verb->about);
    for (const YkOption *option = yk_options; option->name; option++)
        if (yk_option_is_for(option, verb->name)) add_option(text, option);
    yk_text_format(text,
                   "\nExit code: 0 done, 1 the machine has no answer (the message says why), 2 the file or the options "
                   "are wrong; 130 stopped by Ctrl-C.\n"
                   "FILE may be - for standard input.\n\nExample:\n  %s\n",
                   verb->example);
}
