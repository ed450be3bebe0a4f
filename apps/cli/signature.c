// Signatures of requests.
#include "signature.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>

static const uint64_t prime = 0x100000001b3u;

uint64_t yk_signature_bytes(uint64_t hash, const void *bytes, size_t length)
{
    const unsigned char *at = bytes;
    for (size_t k = 0; k < length; k++) hash = (hash ^ at[k]) * prime;
    return (hash ^ 0xff) * prime;
}

uint64_t yk_signature_begin(void)
{
    return yk_signature_word(0xcbf29ce484222325u, yk_version());
}

uint64_t yk_signature_word(uint64_t hash, const char *word)
{
    return yk_signature_bytes(hash, word ? word : "\001", word ? strlen(word) : 1);
}

uint64_t yk_signature_pairs(uint64_t hash, const YkAssignments *pairs)
{
    hash = yk_signature_bytes(hash, &pairs->count, sizeof pairs->count);
    for (size_t k = 0; k < pairs->count; k++)
        hash = yk_signature_word(yk_signature_word(hash, pairs->items[k].name), pairs->items[k].value);
    return hash;
}

uint64_t yk_signature_file(YkSession *session, uint64_t hash, const char *path)
{
    FILE *file = path ? fopen(path, "rb") : NULL;
    if (path && !file && errno == ENOMEM) session->ran_out = true;
    char block[8192];
    size_t length;
    while (file && (length = fread(block, 1, sizeof block, file)) > 0)
        for (size_t k = 0; k < length; k++) hash = (hash ^ (unsigned char)block[k]) * prime;
    if (file) fclose(file);
    return yk_signature_word(hash, "|");
}
