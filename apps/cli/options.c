// Reads a command line.
#include "options.h"
#include <string.h>
#include "base/names.h"
#include "option_table.h"

enum { OPTIONS_MAX = 100, WORDS_IN_LIST = 3 };
static const YkPlace nowhere = {0};

// The command line as it is read.
typedef struct Reader {
    int argc, next;
    char **argv;
    YkRequest *request;
    YkProblems *problems;
    bool used[OPTIONS_MAX]; // by place in yk_options
    bool has_ended;         // after "--" all words are files
    bool has_unknown;       // an unknown option: a word too many may be its value
    size_t words;           // verb and file, so far
} Reader;

static void *field(Reader *reader, const YkOption *option)
{
    return (char *)reader->request + option->offset;
}

static void run_out(Reader *reader)
{
    yk_problem(reader->problems, YK_CODE_OUT_OF_MEMORY, nowhere, "out of memory");
}

static const YkOption *find_long(const char *name, size_t length)
{
    for (const YkOption *option = yk_options; option->name; option++)
        if (strlen(option->name) == length && strncmp(option->name, name, length) == 0) return option;
    return NULL;
}

static const YkOption *find_letter(char letter)
{
    for (const YkOption *option = yk_options; option->name; option++)
        if (option->letter == letter) return option;
    return NULL;
}

// Lists the names of the options that the verb takes; of all options if the verb is not known yet.
static size_t list_options(const YkVerb *verb, const char **names)
{
    size_t count = 0;
    for (const YkOption *option = yk_options; option->name && count < OPTIONS_MAX; option++)
        if (!verb || yk_option_is_for(option, verb->name)) names[count++] = option->name;
    return count;
}

static void refuse_unknown(Reader *reader, const char *word, size_t length)
{
    const char *names[OPTIONS_MAX];
    size_t count = list_options(reader->request->verb, names);
    reader->has_unknown = true;
    const char *own = yk_arena_copy(reader->request->arena, word, length);
    if (!own) {
        run_out(reader);
        return;
    }
    yk_problem(reader->problems, YK_CODE_UNKNOWN_OPTION, nowhere, "there is no option %q", own);
    const char *nearest = length > 2 ? yk_nearest(own + 2, names, count) : NULL;
    if (nearest) {
        yk_problem_hint(reader->problems, "did you mean `--%s`?", nearest);
    } else {
        yk_problem_hint(reader->problems, "`yoke VERB --help` lists the options of a verb");
    }
}

static void add_word(Reader *reader, YkWords *words, const char *value)
{
    if (YK_ROOM_IN(reader->request->arena, words->items, words->count, words->capacity)) {
        words->items[words->count++] = value;
    } else {
        run_out(reader);
    }
}

// Returns whether a name has another value already, and says so.
static bool is_given(Reader *reader, const YkOption *option, const YkAssignments *pairs, YkAssignment own)
{
    for (size_t k = 0; k < pairs->count; k++) {
        if (strcmp(pairs->items[k].name, own.name) != 0 || strcmp(pairs->items[k].value, own.value) == 0) continue;
        yk_problem(reader->problems, YK_CODE_OPTION_REPEATED, nowhere, "--%s gives %q twice: %q and %q", option->name,
                   own.name, pairs->items[k].value, own.value);
        return true;
    }
    return false;
}

static void add_pair(Reader *reader, const YkOption *option, YkAssignments *pairs, const char *value)
{
    const char *equals = strchr(value, '=');
    if (!equals || equals == value || equals[1] == '\0') {
        yk_problem(reader->problems, YK_CODE_OPTION_PAIR, nowhere, "--%s takes NAME=VALUE, not %q", option->name,
                   value);
        return;
    }
    YkAssignment own = {yk_arena_copy(reader->request->arena, value, (size_t)(equals - value)), equals + 1};
    if (own.name && option->kind == YK_OPTION_VALUES && is_given(reader, option, pairs, own)) return;
    if (own.name && YK_ROOM_IN(reader->request->arena, pairs->items, pairs->count, pairs->capacity)) {
        pairs->items[pairs->count++] = own;
    } else {
        run_out(reader);
    }
}

static void set_word(Reader *reader, const YkOption *option, const char *value)
{
    const char **word = field(reader, option);
    if (*word && strcmp(*word, value) != 0)
        yk_problem(reader->problems, YK_CODE_OPTION_REPEATED, nowhere, "--%s is given twice: %q and %q", option->name,
                   *word, value);
    *word = value;
}

static void set_option(Reader *reader, const YkOption *option, const char *value)
{
    reader->used[option - yk_options] = true;
    switch (option->kind) {
    case YK_OPTION_SWITCH:
        *(bool *)field(reader, option) = true;
        break;
    case YK_OPTION_WORD:
        set_word(reader, option, value);
        break;
    case YK_OPTION_WORDS:
        add_word(reader, field(reader, option), value);
        break;
    case YK_OPTION_VALUES:
    case YK_OPTION_PAIRS:
        add_pair(reader, option, field(reader, option), value);
        break;
    }
}

// value: what followed the name in the same word, or NULL.
static void read_option(Reader *reader, const YkOption *option, const char *value)
{
    bool is_switch = option->kind == YK_OPTION_SWITCH;
    if (is_switch && value) {
        yk_problem(reader->problems, YK_CODE_OPTION_TAKES_NO_VALUE, nowhere, "--%s takes no value", option->name);
        return;
    }
    if (!is_switch && !value && reader->next < reader->argc) value = reader->argv[reader->next++];
    if (!is_switch && (!value || *value == '\0')) {
        yk_problem(reader->problems, YK_CODE_OPTION_NEEDS_VALUE, nowhere, "--%s needs a value: --%s %s", option->name,
                   option->name, option->value);
        return;
    }
    set_option(reader, option, value);
}

static void read_dashed(Reader *reader, const char *word)
{
    if (word[1] == '-') {
        size_t length = strcspn(word + 2, "=");
        const YkOption *option = find_long(word + 2, length);
        if (option) {
            read_option(reader, option, word[2 + length] == '=' ? word + 3 + length : NULL);
        } else {
            refuse_unknown(reader, word, length + 2);
        }
        return;
    }
    const YkOption *option = find_letter(word[1]);
    if (option) {
        read_option(reader, option, word[2] ? word + 2 : NULL);
    } else {
        refuse_unknown(reader, word, strlen(word));
    }
}

static void read_verb(Reader *reader, const char *word)
{
    const char *names[OPTIONS_MAX];
    size_t count = 0;
    reader->request->verb = yk_verb_find(word);
    if (reader->request->verb) return;
    for (const YkVerb *verb = yk_verbs; verb->name && count < OPTIONS_MAX; verb++) names[count++] = verb->name;
    const char *nearest = yk_nearest(word, names, count);
    yk_problem(reader->problems, YK_CODE_UNKNOWN_VERB, nowhere, "yoke does not know the verb %q", word);
    if (nearest) {
        yk_problem_hint(reader->problems, "did you mean `%s`?", nearest);
    } else {
        yk_problem_hint(reader->problems, "`yoke` alone lists the verbs, as in `yoke solve machine.yaml`");
    }
}

// Takes a word: the first is the verb, the second the file; `help VERB` is another way to say `VERB --help`.
static void read_word(Reader *reader, const char *word)
{
    size_t place = reader->words++;
    if (place == 0 && strcmp(word, "help") == 0) {
        reader->request->help = true;
        reader->words = 0;
    } else if (place == 0) {
        read_verb(reader, word);
    } else if (place == 1) {
        reader->request->file = word;
    } else if (place == WORDS_IN_LIST - 1 && !reader->has_unknown) {
        yk_problem(reader->problems, YK_CODE_TOO_MANY_FILES, nowhere, "one file at a time: %q is one too many", word);
    }
}

static void check_format(Reader *reader)
{
    static const char *const words[] = {"text", "json", "csv"};
    YkRequest *request = reader->request;
    if (!request->format_word) return;
    const char *verb = request->verb ? request->verb->name : "";
    bool has_own = strcmp(verb, "derive") == 0 || strcmp(verb, "report") == 0 || strcmp(verb, "study") == 0;
    if (has_own) return;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (strcmp(request->format_word, words[i]) != 0) continue;
        request->format = (YkFormat)i;
        return;
    }
    yk_problem(reader->problems, YK_CODE_OPTION_VALUE, nowhere, "--format takes text, json or csv, not %q",
               request->format_word);
}

static void check_options(Reader *reader)
{
    const YkVerb *verb = reader->request->verb;
    for (size_t i = 0; verb && verb->run && yk_options[i].name; i++) {
        if (!reader->used[i] || yk_option_is_for(&yk_options[i], verb->name)) continue;
        yk_problem(reader->problems, YK_CODE_OPTION_NOT_HERE, nowhere, "`yoke %s` has no option --%s", verb->name,
                   yk_options[i].name);
        yk_problem_hint(reader->problems, "`yoke %s --help` lists what it takes", verb->name);
    }
}

void yk_options_read(int argc, char **argv, YkRequest *request, YkProblems *problems)
{
    Reader reader = {.argc = argc, .next = 1, .argv = argv, .request = request, .problems = problems};
    while (reader.next < argc) {
        const char *word = argv[reader.next++];
        if (!reader.has_ended && strcmp(word, "--") == 0) {
            reader.has_ended = true;
        } else if (!reader.has_ended && word[0] == '-' && word[1] != '\0') {
            read_dashed(&reader, word);
        } else {
            read_word(&reader, word);
        }
    }
    check_format(&reader);
    check_options(&reader);
}

void yk_request_free(YkRequest *request)
{
    yk_arena_free(request->arena);
}
