// Looks for a single slip that would explain a false equation.
#include <string.h>
#include "base/letters.h"
#include "prove/check_inside.h"

static const char *keep(YkCheck *check, YkText *text)
{
    if (check->points->ground != YK_GROUND_FIRM) yk_text_puts(text, " with this file's numbers");
    const char *kept = yk_arena_copy(check->d->arena, yk_text_get(text), text->length);
    yk_text_free(text);
    return kept;
}

// Tests for all dimensions or, if nothing can be proved, at poses of this machine: where a false equation seems true,
// too, a slip would explain nothing.
static bool is_true(YkCheck *check, const YkForm *zero)
{
    return yk_check_prove(check, zero) == YK_PROVED ||
           (check->points->ground != YK_GROUND_FIRM && yk_check_is_zero_at_poses(check, zero) &&
            !yk_check_is_zero_at_poses(check, check->difference));
}

// --- A summand with another factor: sign, 2, 1/2, 0

typedef struct Factor {
    int64_t over, under;
    const char *words; // around the summand
} Factor;

// The difference is left - right: f times a summand instead of the summand adds f - 1 times its share.
static const YkForm *with_factor(YkCheck *check, const YkEquationTerm *term, const Factor *factor)
{
    YkRing *ring = check->d->ring;
    bool is_subtracted = term->is_negative != term->is_right;
    int64_t more = factor->over - factor->under;
    const YkPoisson *by = yk_ring_rational(ring, is_subtracted ? -more : more, factor->under);
    const YkForm *added = yk_form_multiply(ring, yk_form_of(ring, by), term->form);
    return yk_form_add(ring, check->difference, added);
}

static const char *find_factor(YkCheck *check, const Factor *factor)
{
    const YkEquation *equation = &check->equation;
    // From the end: the first summand often has no sign of its own.
    for (size_t k = equation->term_count; k > 0 && equation->term_count > 1; k--) {
        const YkEquationTerm *term = &equation->terms[k - 1];
        if (factor->over == 0 && equation->term_count < 3) return NULL; // nothing would be left
        if (!is_true(check, with_factor(check, term, factor))) continue;
        YkText text = {0}, words = {0};
        yk_text_add(&words, check->text + term->start, term->end - term->start);
        yk_text_format(&text, factor->words, yk_text_get(&words));
        yk_text_free(&words);
        return keep(check, &text);
    }
    return NULL;
}

// --- Another word in the text

// Reads the equation with text[start..end) replaced. Returns true if it is then proved.
static bool is_true_with(YkCheck *check, const char *text, size_t length)
{
    YkEquation equation;
    YkProblems *problems = yk_problems_new();
    bool is_read = problems && yk_equation_read(check->d, text, length, (YkPlace){1, 1, 0}, problems, &equation);
    check->failed |= !problems || yk_problems_ran_out(problems);
    yk_problems_free(problems);
    if (!is_read) return false;
    return is_true(check, yk_form_subtract(check->d->ring, equation.left, equation.right));
}

static bool is_word_part(char c)
{
    return yk_begins_name(c) || yk_is_digit(c) || c == '.';
}

static bool stands_at(const YkCheck *check, size_t at, const char *word)
{
    size_t length = strlen(word);
    return at + length <= check->length && strncmp(check->text + at, word, length) == 0 &&
           (at == 0 || !is_word_part(check->text[at - 1])) &&
           (at + length == check->length || !is_word_part(check->text[at + length]) ||
            check->text[at + length] == '.'); // theta4.rate
}

static size_t behind_bracket(const YkCheck *check, size_t at)
{
    int depth = 0;
    while (at < check->length) {
        depth += (check->text[at] == '(') - (check->text[at] == ')');
        at++;
        if (depth == 0) break;
    }
    return at;
}

// Tries a cosine for each sine, and a sine for each cosine.
static const char *find_function(YkCheck *check)
{
    for (size_t at = 0; at + 4 < check->length; at++) {
        bool is_sin = stands_at(check, at, "sin");
        if (!is_sin && !stands_at(check, at, "cos")) continue;
        YkText text = {0};
        const char *word = is_sin ? "cos" : "sin";
        yk_text_add(&text, check->text, at);
        yk_text_puts(&text, word);
        yk_text_add(&text, check->text + at + 3, check->length - at - 3);
        check->failed |= text.failed;
        bool found = !text.failed && is_true_with(check, yk_text_get(&text), text.length);
        yk_text_clear(&text);
        if (found) {
            size_t end = check->text[at + 3] == '(' ? behind_bracket(check, at + 3) : at + 3;
            yk_text_format(&text, "with `%s", word);
            yk_text_add(&text, check->text + at + 3, end - at - 3);
            yk_text_format(&text, "` in place of `%s", is_sin ? "sin" : "cos");
            yk_text_add(&text, check->text + at + 3, end - at - 3);
            yk_text_puts(&text, "` it would be true");
            return keep(check, &text);
        }
        yk_text_free(&text);
    }
    return NULL;
}

// Tries a body's angle to the ground for a joint's angle, which is measured against its first body.
static const char *find_angle(YkCheck *check, const YkDeriveCoordinate *c)
{
    YkDerivation *d = check->d;
    const int32_t *body = d->model->joints[c->joint].body;
    YkText text = {0};
    size_t count = 0;
    for (size_t at = 0; at < check->length; at++) {
        if (!stands_at(check, at, c->name)) {
            yk_text_add(&text, check->text + at, 1);
            continue;
        }
        yk_text_format(&text, "%s.angle", d->bodies[body[1]].name);
        at += strlen(c->name) - 1;
        count++;
    }
    check->failed |= text.failed;
    bool found = count > 0 && !text.failed && is_true_with(check, yk_text_get(&text), text.length);
    yk_text_clear(&text);
    if (found)
        yk_text_format(&text, "with `%s.angle` in place of `%s`, which is measured from %s, it would be true",
                       d->bodies[body[1]].name, c->name, d->bodies[body[0]].name);
    if (found) return keep(check, &text);
    yk_text_free(&text);
    return NULL;
}

const char *yk_check_slip(YkCheck *check)
{
    static const Factor factors[] = {{-1, 1, "with the other sign before %q it would be true"},
                                     {2, 1, "with twice %q it would be true"},
                                     {1, 2, "with half of %q it would be true"},
                                     {0, 1, "without %q it would be true"}};
    const char *slip = NULL;
    for (size_t k = 0; k < sizeof factors / sizeof *factors && !slip; k++) slip = find_factor(check, &factors[k]);
    if (!slip) slip = find_function(check);
    for (size_t k = 0; k < check->d->tree_count && !slip; k++) {
        const YkDeriveCoordinate *c = &check->d->coordinates[k];
        if (!c->is_distance && check->d->model->joints[c->joint].body[0] != 0) slip = find_angle(check, c);
    }
    return slip;
}
