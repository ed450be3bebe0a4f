// yoke explain: explains a message's code.
#include <string.h>
#include "answer.h"
#include "session.h"

enum { LINE = 100 };

// Reads "E0401", "e401", "401"; returns the number, or -1. Any of the letters E, W, N may come before it.
static int read_code(const char *word)
{
    if (*word && strchr("EWNewn", *word)) word++;
    int code = 0, digits = 0;
    for (; *word >= '0' && *word <= '9' && digits < 5; word++, digits++) code = 10 * code + (*word - '0');
    return *word == '\0' && digits > 0 ? code : -1;
}

// Breaks a paragraph between words.
static void add_wrapped(YkText *text, const char *paragraph)
{
    size_t column = 0;
    while (*paragraph) {
        size_t length = strcspn(paragraph, " ");
        if (column > 0 && column + 1 + length > LINE) {
            yk_text_puts(text, "\n");
            column = 0;
        }
        if (column > 0) yk_text_puts(text, " ");
        yk_text_add(text, paragraph, length);
        column += length + (column > 0);
        paragraph += length;
        paragraph += strspn(paragraph, " ");
    }
    yk_text_puts(text, "\n");
}

static void list_codes(YkText *text)
{
    char shown[YK_CODE_SIZE];
    for (size_t i = 0; i < yk_code_count(); i++) {
        int code = yk_code_at(i);
        const char *words = yk_code_explain(code);
        size_t sentence = strcspn(words, ".:;");
        yk_text_format(text, "%s  ", yk_code_word((YkCode)code, shown));
        yk_text_add(text, words, sentence);
        yk_text_puts(text, "\n");
    }
}

int yk_run_explain(YkSession *session)
{
    const char *word = session->request->file;
    char shown[YK_CODE_SIZE];
    if (word) {
        int code = read_code(word);
        const char *words = code >= 0 ? yk_code_explain(code) : NULL;
        if (!words) {
            yk_session_refuse(session, YK_CODE_UNKNOWN_CODE, "there is no message with the code %q", word);
            yk_problem_hint(session->problems, "`yoke explain` lists all codes; one looks like E0401");
            return YK_EXIT_WRONG;
        }
        yk_text_format(&session->out, "%s\n", yk_code_word((YkCode)code, shown));
        add_wrapped(&session->out, words);
    } else {
        list_codes(&session->out);
    }
    return yk_session_finish(session, YK_EXIT_DONE);
}
