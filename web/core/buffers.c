// The two buffers, and what every call answers.
#include <stdlib.h>
#include "core.h"
#include "exports.h"

YkCore yk_core;

double *yk_core_room(size_t count)
{
    if (count > yk_core.number_capacity) {
        double *larger = count <= ((size_t)-1 >> 4) ? realloc(yk_core.numbers, count * sizeof *larger) : NULL;
        if (!larger) return NULL;
        yk_core.numbers = larger;
        yk_core.number_capacity = count;
    }
    yk_core.number_count = count;
    return yk_core.numbers;
}

// Returns where the caller writes `length` bytes and a final NUL; 0 when out of memory.
YK_DOOR(ys_input) char *ys_input(size_t length)
{
    yk_text_free(&yk_core.input);
    if (!yk_text_reserve(&yk_core.input, length + 1)) return NULL;
    yk_core.input.length = length;
    yk_core.input.data[length] = '\0';
    return yk_core.input.data;
}

YK_DOOR(ys_numbers) double *ys_numbers(void)
{
    return yk_core.numbers;
}

YK_DOOR(ys_number_count) size_t ys_number_count(void)
{
    return yk_core.number_count;
}

// Returns where the caller writes numbers; 0 when out of memory.
YK_DOOR(ys_number_room) double *ys_number_room(size_t count)
{
    return yk_core_room(count);
}

YK_DOOR(ys_text) const char *ys_text(void)
{
    return yk_core.text.failed ? NULL : yk_text_get(&yk_core.text);
}

YK_DOOR(ys_text_length) size_t ys_text_length(void)
{
    return yk_core.text.length;
}

YK_DOOR(ys_message) const char *ys_message(void)
{
    return yk_core.message.failed ? "out of memory" : yk_text_get(&yk_core.message);
}

YK_DOOR(ys_status_name) const char *ys_status_name(int status)
{
    return yk_status_name((YkStatus)status);
}

YK_DOOR(ys_version) const char *ys_version(void)
{
    return yk_version();
}

// Frees everything.
YK_DOOR(ys_close) void ys_close(void)
{
    yk_core_close();
    yk_core_forget_sliders();
    yk_text_free(&yk_core.text);
    yk_text_free(&yk_core.input);
    yk_text_free(&yk_core.message);
    yk_text_free(&yk_core.source);
    yk_text_free(&yk_core.name);
    free(yk_core.numbers);
    yk_core = (YkCore){0};
}
