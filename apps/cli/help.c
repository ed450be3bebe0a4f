// Writes help.
#include "help.h"
#include <string.h>
#include "option_table.h"

enum { VERB_COLUMN = 12, OPTION_COLUMN = 28, WIDTH = 100 };

// The value and the meaning of an option for certain verbs, if they differ from its entry in the table of options.
typedef struct Special {
    const char *option, *verbs, *value, *help;
} Special;

static const Special specials[] = {
    {"format", " derive ", "NAME", "text, latex, mathml, json or c; with --check text or json"},
    {"format", " code ", "text|json", "json: the code as a string"},
    {"format", " report ", "html|pdf", "default: what the ending of the file says"},
    {"format", " study ", "NAME", "text for people; json, jsonl (a row a line), csv or npy in SI and radians"},
    {"at", " simulate ", "NAME=VALUE", "start a coordinate at this value, in place of what start: says; repeatable"},
    {"steps", " simulate ", "N", "the number of steps of the table, one less than the rows (default 100)"},
    {"steps", " cam ", "N", "the number of steps of the table, one less than the rows (default 72; in text no table)"},
    {"steps", " draw ", "N", "the number of steps of --animate (default: 20 poses a second; .mp4 and .webm 30)"},
    {"steps", " report ", "N", "the number of steps (default: as many as the machine needs)"},
    {"method", " simulate ", "NAME", "dop853 (default), sdirk4 for stiff machines, rk4 with a fixed step"},
    {"output", " synthesize ", "DIR", "write the machines' files, a picture and task.json into this new folder"},
    {"output", " cognates balance ", "DIR", "write the models' files and the answer into this new folder"},
    {"format", " synthesize cognates balance ", "text|json", "text for people; json in SI and radians"},
    {"trace", " cognates ", "BODY.POINT", "the coupler's point (default: the first that is not a joint's)"},
    {"at", " map ", "NAME=VALUE", "hold another coordinate of a machine with more freedoms; repeatable"},
    {"over", " map ", "NAME", "the coordinate that is mapped (default: the drive's)"},
    {"tol", " map ", "NUMBER",
     "with --over A,B: width of squares that may stay unproved, as a part of the map's extent (default 1e-3)"},
    {"of", " map ", "NAME", "the coordinate that --plot draws over it (default: the first other)"},
    {"plot", " map ", "FILE", "draw the map: FILE.svg, .pdf or .png (the last two need rsvg-convert)"},
    {"trace", " map ", "BODY.POINT", "--plot also draws this point's curves on all circuits; repeatable"},
    {"format", " map ", "text|json", "text for people; json in SI and radians"},
    {"steps", " balance ", "N", "the number of poses of a cycle (default 360)"},
    {"seed", " synthesize ", "N", "the seed of the samples where a task leaves a choice (default 1)"},
    {"output", " studio ", "FILE", "write the page with the machine in it as one HTML file"},
    {"within", " synthesize ", "TIME", "end the search after this time with the best so far, as in 60s"},
    {"lock", " gears ", "NAME", "engage one of the file's locks: (default: a table of all)"},
};

static void add_padded(YkText *text, const char *word, size_t length, size_t width)
{
    yk_text_puts(text, word);
    yk_text_repeat(text, ' ', width > length ? width - length : 1);
}

// Adds words from column `at` on, lines at most WIDTH wide; further lines begin at column `indent`.
static void add_wrapped(YkText *text, const char *words, size_t at, size_t indent)
{
    size_t column = at;
    while (*words) {
        size_t length = strcspn(words, " \n");
        if (column > indent && column + 1 + length > WIDTH) {
            yk_text_puts(text, "\n");
            yk_text_repeat(text, ' ', indent);
            column = indent;
        } else if (column > at || column > indent) {
            yk_text_puts(text, " ");
            column++;
        }
        yk_text_add(text, words, length);
        column += length;
        words += length + (words[length] != '\0');
    }
    yk_text_puts(text, "\n");
}

void yk_help_tour(YkText *text)
{
    yk_text_format(text,
                   "yoke %s: the workbench for planar machines. One file describes a machine; each verb answers one "
                   "question about it.\n\n",
                   yk_version());
    yk_text_puts(text,
                 "Start here:\n"
                 "  yoke new four-bar > machine.yaml                  get a first machine; `yoke new` lists more\n"
                 "  yoke check machine.yaml                           what machine is it? can it move?\n"
                 "  yoke solve machine.yaml --at theta2=30deg         where is everything, and how fast?\n"
                 "  yoke sweep machine.yaml --over theta2=0:360deg    how does it move?\n"
                 "  yoke draw machine.yaml -o machine.svg             what does it look like?\n"
                 "  yoke derive machine.yaml                          which equations govern it?\n\n"
                 "Verbs:\n");
    for (const YkVerb *verb = yk_verbs; verb->name; verb++) {
        yk_text_puts(text, "  ");
        add_padded(text, verb->name, strlen(verb->name), VERB_COLUMN);
        yk_text_format(text, "%s\n", verb->summary);
    }
    yk_text_puts(text,
                 "\n`yoke VERB --help` lists the options of a verb; `man yoke-model` describes the model file.\n");
}

static const Special *find_special(const YkOption *option, const char *verb)
{
    for (size_t i = 0; i < sizeof specials / sizeof *specials; i++)
        if (strcmp(specials[i].option, option->name) == 0 && yk_option_lists(specials[i].verbs, verb))
            return &specials[i];
    return NULL;
}

static void add_option(YkText *text, const YkOption *option, const char *verb)
{
    const Special *special = find_special(option, verb);
    const char *value = special ? special->value : option->value;
    YkText form = {0};
    if (option->letter) yk_text_format(&form, "-%c, ", option->letter);
    yk_text_format(&form, "--%s%s%s", option->name, value ? " " : "", value ? value : "");
    yk_text_puts(text, "  ");
    add_padded(text, yk_text_get(&form), form.length, OPTION_COLUMN);
    const size_t column = 2 + OPTION_COLUMN;
    const size_t at = form.length < OPTION_COLUMN ? column : 2 + form.length + 1;
    yk_text_free(&form);
    add_wrapped(text, special ? special->help : option->help, at, column);
}

void yk_help_verb(YkText *text, const YkVerb *verb)
{
    yk_text_format(text, "yoke %s %s\n\n", verb->name, verb->usage);
    add_wrapped(text, verb->about, 0, 0);
    yk_text_puts(text, "\nOptions:\n");
    for (const YkOption *option = yk_options; option->name; option++)
        if (yk_option_is_for(option, verb->name)) add_option(text, option, verb->name);
    yk_text_format(text,
                   "\nExit status: 0 done; 1 the machine has no answer (the message says why); 2 the file or the "
                   "options are wrong;\n130 stopped by Ctrl-C. FILE may be - for standard input.\n\nExample:\n  %s\n",
                   verb->example);
}
