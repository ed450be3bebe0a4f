// Opens a text as a sketch, and sets parameters; a sketch that is wrong leaves the machine before as it was.
#include <stdlib.h>
#include <string.h>
#include "core.h"
#include "exports.h"

// Takes the text before the input's first NUL as the machine, and what follows as the name of its file. Returns 1 if
// there is a machine, 0 if there is none, -1 when out of memory. The text then says all that there is to tell.
YK_DOOR(ys_open) int ys_open(size_t length)
{
    YkCore made = {0};
    YkProblems *problems = yk_problems_new();
    if (!problems || length > yk_core.input.length) return -1;
    yk_core_forget_sliders();
    yk_text_clear(&yk_core.source);
    yk_text_clear(&yk_core.name);
    yk_text_add(&yk_core.source, yk_core.input.data, length);
    yk_text_puts(&yk_core.name, length + 1 < yk_core.input.length ? yk_core.input.data + length + 1 : "machine.yaml");
    bool good = yk_core_make(&made, NULL, NULL, problems);
    if (good)
        yk_core_take(&made);
    else
        yk_core_close();
    yk_core_write(&yk_core, problems);
    yk_problems_free(problems);
    return yk_core.text.failed ? -1 : good;
}

static YkSlider *slider_of(const char *name)
{
    for (size_t k = 0; k < yk_core.slider_count; k++)
        if (strcmp(yk_core.sliders[k].name, name) == 0) return &yk_core.sliders[k];
    if (yk_core.slider_count == YK_OVERRIDES) return NULL;
    YkSlider *slider = &yk_core.sliders[yk_core.slider_count];
    *slider = (YkSlider){.name = strdup(name)};
    if (slider->name) yk_core.slider_count++;
    return slider->name ? slider : NULL;
}

// Sets the parameter named by the input to a value, SI; the assembly is carried over. Returns as ys_open. A value that
// makes no valid machine, or one that cannot be put together, leaves the machine as it was, and the problems say why.
YK_DOOR(ys_parameter) int ys_parameter(double value)
{
    YkProblems *problems = yk_problems_new();
    YkSlider *slider = yk_core.model && problems ? slider_of(yk_text_get(&yk_core.input)) : NULL;
    if (!slider) {
        yk_problems_free(problems);
        return -1;
    }
    YkText words = {0};
    YkCore made = {0};
    char *before = slider->value;
    yk_text_format(&words, "%g", value / yk_model_parameter_unit(yk_core.model, slider->name));
    slider->value = words.failed ? NULL : words.data;
    bool good = slider->value && yk_core_make(&made, &yk_core, NULL, problems);
    if (good) {
        free(before);
        yk_core_take(&made);
    } else {
        free(words.data);
        slider->value = before;
    }
    if (!slider->value) { // the file's own value
        free(slider->name);
        *slider = yk_core.sliders[--yk_core.slider_count];
    }
    yk_core_write(&yk_core, problems);
    yk_problems_free(problems);
    return yk_core.text.failed ? -1 : 1;
}
