#include <string.h>
#include "options.h"

#define POSE " solve sweep draw "
#define MODEL " check solve sweep draw "
#define FIELD(name) offsetof(YkRequest, name)

const YkOption yk_options[] = {
    {"at", 0, YK_OPTION_PAIRS, FIELD(at), "NAME=VALUE", POSE,
     "set a coordinate, in place of its drive's value; repeatable"},
    {"rate", 0, YK_OPTION_PAIRS, FIELD(rate), "NAME=VALUE", POSE, "set a coordinate's rate; repeatable"},
    {"accel", 0, YK_OPTION_PAIRS, FIELD(accel), "NAME=VALUE", POSE, "set a coordinate's acceleration; repeatable"},
    {"time", 0, YK_OPTION_WORD, FIELD(time), "VALUE", POSE, "evaluate the drives at this time (default 0)"},
    {"param", 0, YK_OPTION_PAIRS, FIELD(param), "NAME=VALUE", MODEL, "change a parameter; repeatable"},
    {"effort", 0, YK_OPTION_PAIRS, FIELD(effort), "NAME=VALUE", POSE, "a joint effort (not part of this version yet)"},
    {"all", 0, YK_OPTION_SWITCH, FIELD(all), NULL, " solve ",
     "every assembly configuration, not only the nearest to start:"},
    {"over", 0, YK_OPTION_WORD, FIELD(over), "NAME=FROM:TO", " sweep draw ",
     "the coordinate, or t, that goes through a range"},
    {"steps", 0, YK_OPTION_WORD, FIELD(steps), "N", " sweep ", "so many steps, one more rows (default 36)"},
    {"of", 0, YK_OPTION_WORD, FIELD(of), "LIST", " sweep ",
     "columns: d5,d5.rate,lever.angle,ram.C.x,... (default: all coordinates)"},
    {"plot", 0, YK_OPTION_WORD, FIELD(plot), "FILE", " sweep ",
     "draw the columns: FILE.svg, .pdf or .png (needs gnuplot)"},
    {"poses", 0, YK_OPTION_WORD, FIELD(poses), "N", " draw ", "with --over: N poses, faint, as a stroboscope"},
    {"trace", 0, YK_OPTION_WORDS, FIELD(trace), "BODY.POINT", " draw ", "draw a point's path; repeatable"},
    {"no-labels", 0, YK_OPTION_SWITCH, FIELD(no_labels), NULL, " draw ", "without names and scale"},
    {"output", 'o', YK_OPTION_WORD, FIELD(output), "FILE", MODEL, "write the answer here instead of standard output"},
    {"format", 0, YK_OPTION_WORD, FIELD(format_word), "text|json|csv", " check solve sweep ",
     "text for people; json and csv in SI and radians (default text)"},
    {"quiet", 'q', YK_OPTION_SWITCH, FIELD(quiet), NULL, "*", "no notes and warnings"},
    {"help", 'h', YK_OPTION_SWITCH, FIELD(help), NULL, "*", "this help"},
    {"version", 0, YK_OPTION_SWITCH, FIELD(version), NULL, "*", "the version"},
    {NULL, 0, YK_OPTION_SWITCH, 0, NULL, NULL, NULL},
};

bool yk_option_is_for(const YkOption *option, const char *verb)
{
    if (*option->verbs == '*') return true;
    size_t length = strlen(verb);
    for (const char *at = strstr(option->verbs, verb); at; at = strstr(at + 1, verb))
        if (at[-1] == ' ' && at[length] == ' ') return true;
    return false;
}
