// Guards of the server: name of the host, origin, token.
#include <stdio.h>
#include <string.h>
#include "base/text.h"
#include "verbs/studio/studio.h"

static bool is_here(const char *host, unsigned port)
{
    static const char *const names[] = {"127.0.0.1", "localhost"};
    bool found = false;
    for (size_t k = 0; k < 2; k++) {
        YkText expected = {0};
        yk_text_format(&expected, "%s:%u", names[k], port);
        found |= !expected.failed && strcmp(host, yk_text_get(&expected)) == 0;
        yk_text_free(&expected);
    }
    return found;
}

bool yk_guard_host(const char *host, unsigned port)
{
    return host && is_here(host, port);
}

bool yk_guard_origin(const char *origin, unsigned port)
{
    static const char scheme[] = "http://";
    if (!origin) return true;
    return strncmp(origin, scheme, sizeof scheme - 1) == 0 && is_here(origin + sizeof scheme - 1, port);
}

bool yk_guard_site(const char *site)
{
    return !site || strcmp(site, "same-origin") == 0 || strcmp(site, "none") == 0;
}

// Takes as long for a nearly right token as for any other.
bool yk_guard_token(const char *given, const char *token)
{
    unsigned off = 0;
    if (!given || strlen(given) != strlen(token)) return false;
    for (size_t k = 0; token[k]; k++) off |= (unsigned)(given[k] ^ token[k]);
    return off == 0;
}

bool yk_make_token(char token[YK_TOKEN_SIZE])
{
    unsigned char bytes[(YK_TOKEN_SIZE - 1) / 2];
    FILE *random = fopen("/dev/urandom", "rb");
    bool good = random && fread(bytes, 1, sizeof bytes, random) == sizeof bytes;
    if (random) fclose(random);
    for (size_t k = 0; good && k < sizeof bytes; k++) {
        token[2 * k] = "0123456789abcdef"[bytes[k] >> 4];
        token[2 * k + 1] = "0123456789abcdef"[bytes[k] & 15];
    }
    token[YK_TOKEN_SIZE - 1] = '\0';
    return good;
}
