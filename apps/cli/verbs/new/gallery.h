// The examples, carried by the program.
#ifndef CLI_GALLERY_H
#define CLI_GALLERY_H
#include <stddef.h>

typedef struct YkExample {
    const char *family, *name, *machine, *shows; // as examples/README.md lists it
    const unsigned char *text;                   // the file; NULL if this program leaves it out
    size_t size;
} YkExample;
extern const YkExample yk_gallery[]; // families together, in their order
extern const size_t yk_gallery_count;

#endif
