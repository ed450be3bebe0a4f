// `yoke synthesize --so-far`: what a search has found so far, one line of JSON at a time, to be shown while it runs.
#include <stdio.h>
#include "verbs/synthesize/synthesize.h"
#include "write/json.h"

static void print(YkText *line)
{
    if (!line->failed) fputs(yk_text_get(line), stdout);
    fflush(stdout);
    yk_text_free(line);
}

void yk_synthesis_tell_part(YkSynthesisAnswer *answer, double part)
{
    int percent = (int)(100 * part);
    YkText line = {0};
    YkJson json = {.text = &line};
    if (percent <= answer->percent) return;
    answer->percent = percent;
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_number(&json, "part", percent / 100.0);
    yk_json_end(&json);
    print(&line);
}

void yk_synthesis_tell_found(void *context, const YkCandidate *candidate, size_t place, size_t best)
{
    YkText line = {0};
    YkJson json = {.text = &line};
    (void)context;
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_integer(&json, "rank", (long long)place + 1);
    yk_json_integer(&json, "best", (long long)best);
    yk_synthesis_json_machine(&json, candidate);
    yk_json_end(&json);
    print(&line);
}
