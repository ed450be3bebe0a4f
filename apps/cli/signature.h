// Signatures: numbers that show whether two runs have the same request. FNV-1a over all that decides an answer.
#ifndef CLI_SIGNATURE_H
#define CLI_SIGNATURE_H
#include <stdint.h>
#include "cli.h"

uint64_t yk_signature_begin(void); // with the version
uint64_t yk_signature_bytes(uint64_t signature, const void *bytes, size_t length);
uint64_t yk_signature_word(uint64_t signature, const char *word); // NULL is a word of its own
uint64_t yk_signature_pairs(uint64_t signature, const YkAssignments *pairs);
// Adds the content of a file; nothing for NULL or a file that cannot be read. Notes that memory ran out.
uint64_t yk_signature_file(YkSession *session, uint64_t signature, const char *path);

#endif
