// Settings that every program under the address sanitizer gives it.
//
// The leak checker is to search the data of the program and of its libraries, but not the sanitizer's own 10 MB of tables, which
// take 50 ms at the end of every program. These data, registered here as roots, are all that it would have searched otherwise.
#define _GNU_SOURCE
#include <link.h>
#include <sanitizer/lsan_interface.h>
#include <string.h>

const char *__lsan_default_options(void);
const char *__lsan_default_options(void)
{
    return "use_globals=0";
}

// A request that malloc rightly refuses must not stop the program.
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "allocator_may_return_null=1";
}

static int add_data(struct dl_phdr_info *module, size_t size, void *unused)
{
    (void)size;
    (void)unused;
    if (strstr(module->dlpi_name, "libclang_rt.") || strstr(module->dlpi_name, "libasan.")) return 0;
    for (int i = 0; i < module->dlpi_phnum; i++) {
        const ElfW(Phdr) *part = &module->dlpi_phdr[i];
        if (part->p_type != PT_LOAD || !(part->p_flags & PF_W)) continue;
        __lsan_register_root_region((const void *)(module->dlpi_addr + part->p_vaddr), part->p_memsz); // NOLINT
    }
    return 0;
}

__attribute__((constructor)) static void add_data_of_all_modules(void)
{
    dl_iterate_phdr(add_data, NULL);
}
