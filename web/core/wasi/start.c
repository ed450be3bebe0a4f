// Starts the command in a module whose other functions are called without it: the linker's own start would run before
// each.
#include <stdlib.h>

int __main_void(void); // of wasi-libc: reads the words and calls main()
void yk_start(void);

__attribute__((export_name("_start"))) void yk_start(void)
{
    exit(__main_void());
}
