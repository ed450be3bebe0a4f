// Hands the machine in its present state over to another module: its text, sliders, inputs and states as bytes. The
// other module goes on with the same bits.
#include <stdlib.h>
#include <string.h>
#include "core.h"
#include "exports.h"

// Writes a text, or reads it into an empty one.
static void walk_text(YkArchive *a, YkText *text)
{
    size_t length = text->length;
    yk_archive_sizes(a, (size_t *const[]){&length}, 1);
    if (a->is_reading) {
        if (a->failed || length > a->capacity - a->at || !yk_text_reserve(text, length + 1)) {
            a->failed = true;
            return;
        }
        text->length = length;
        text->data[length] = '\0';
    }
    if (length > 0) yk_archive_bytes(a, text->data, length);
}

static void walk_word(YkArchive *a, char **word)
{
    YkText text = {0};
    if (!a->is_reading) yk_text_puts(&text, *word);
    walk_text(a, &text);
    if (a->is_reading)
        *word = a->failed ? NULL : text.data;
    else
        yk_text_free(&text);
}

static void walk_sliders(YkArchive *a)
{
    size_t count = yk_core.slider_count;
    yk_archive_sizes(a, (size_t *const[]){&count}, 1);
    if (count > YK_OVERRIDES) a->failed = true;
    for (size_t k = 0; k < count && !a->failed; k++) {
        YkSlider *slider = &yk_core.sliders[k];
        walk_word(a, &slider->name);
        walk_word(a, &slider->value);
        if (a->is_reading) yk_core.slider_count = k + 1;
    }
}

static void walk_settings(YkArchive *a)
{
    walk_text(a, &yk_core.source);
    walk_text(a, &yk_core.name);
    walk_sliders(a);
    yk_archive_numbers(a, &yk_core.scale, 1);
}

// Writes the names of the inputs, where they are not those of the file.
static void write_inputs(YkArchive *a, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char *name = (char *)(uintptr_t)yk_coordinate_info(yk_core.mech, yk_input_coordinate(yk_core.mech, i)).name;
        walk_word(a, &name);
    }
}

// Reads them, and makes these the inputs.
static void read_inputs(YkArchive *a, size_t count)
{
    char **names = count <= yk_coordinate_count(yk_core.mech) ? calloc(count + 1, sizeof *names) : NULL;
    a->failed |= !names;
    for (size_t i = 0; i < count && !a->failed; i++) walk_word(a, &names[i]);
    if (!a->failed && yk_core_use_inputs((const char *const *)names, count, NULL) != YK_OK) a->failed = true;
    for (size_t i = 0; names && i < count; i++) free(names[i]);
    free((void *)names);
}

static void walk_inputs(YkArchive *a)
{
    size_t count = yk_core.other ? yk_input_count(yk_core.mech) : 0;
    yk_archive_sizes(a, (size_t *const[]){&count}, 1);
    if (count == 0 || a->failed) return;
    if (a->is_reading)
        read_inputs(a, count);
    else
        write_inputs(a, count);
}

static void walk_states(YkArchive *a)
{
    walk_inputs(a);
    yk_archive_flags(a, &yk_core.is_scheduled, 1);
    if (a->failed) return;
    yk_core_walk_state(a, yk_core.start);
    yk_core_walk_state(a, yk_core.state);
}

static void walk(YkArchive *a)
{
    walk_settings(a);
    bool has_machine = yk_core.state != NULL;
    yk_archive_flags(a, &has_machine, 1);
    if (a->failed || !has_machine) return;
    if (a->is_reading) {
        YkCore made = {0};
        YkProblems *problems = yk_problems_new();
        bool good = problems && yk_core_make(&made, NULL, a, problems);
        yk_problems_free(problems);
        a->failed = !good;
        if (!good) return;
        yk_core_take(&made);
    } else {
        yk_core_walk_state(a, yk_core.drawn);
    }
    walk_states(a);
}

// Writes the machine in its present state as the text. A drag, ghosts and a simulation are not part of it. Returns 1,
// or -1 when out of memory.
YK_DOOR(ys_save) int ys_save(void)
{
    YkArchive count = {0};
    walk(&count);
    yk_text_clear(&yk_core.text);
    if (count.failed || !yk_text_reserve(&yk_core.text, count.at + 1)) return -1;
    YkArchive a = {.bytes = (unsigned char *)yk_core.text.data, .capacity = count.at};
    walk(&a);
    yk_core.text.length = a.at;
    yk_core.text.data[a.at] = '\0';
    return a.failed ? -1 : 1;
}

// Takes the machine that another module saved: `length` bytes of the input. Returns 1; -1 when out of memory, or when
// the bytes make no machine, and then there is none.
YK_DOOR(ys_restore) int ys_restore(size_t length)
{
    if (length > yk_core.input.length) return -1;
    YkArchive a = {.bytes = (unsigned char *)yk_core.input.data, .capacity = length, .is_reading = true};
    yk_core_close();
    yk_core_forget_sliders();
    yk_text_free(&yk_core.source);
    yk_text_free(&yk_core.name);
    walk(&a);
    if (yk_core.drawing && ys_scene() < 0) a.failed = true; // names hang on where the scene has them
    if (!a.failed && a.at == length) return 1;
    yk_core_close();
    return -1;
}
