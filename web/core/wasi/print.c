// The formats of printf that the command uses; the others would be a hundredth of panels.wasm.
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

// Progress goes to a terminal, and there is none here.
int fprintf(FILE *file, const char *format, ...)
{
    (void)file, (void)format;
    return 0;
}

// Puts texts together: knows %s alone. Returns the length of the whole text, as C says.
int snprintf(char *to, size_t room, const char *format, ...)
{
    size_t length = 0;
    va_list arguments;
    va_start(arguments, format);
    for (const char *c = format; *c; c++) {
        bool is_text = c[0] == '%' && c[1] == 's';
        const char *part = is_text ? va_arg(arguments, const char *) : c;
        size_t count = is_text ? strlen(part) : 1;
        for (size_t k = 0; k < count; k++, length++)
            if (length + 1 < room) to[length] = part[k];
        c += is_text;
    }
    va_end(arguments);
    if (room > 0) to[length < room ? length : room - 1] = '\0';
    return (int)length;
}
