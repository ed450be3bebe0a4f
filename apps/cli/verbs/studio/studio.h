// yoke studio: what its files share. The page is a folder of files, read once; the machine is one file, read and saved.
#ifndef CLI_STUDIO_H
#define CLI_STUDIO_H
#include "session.h"

enum { YK_TOKEN_SIZE = 33, YK_VERSION_SIZE = 17 };

// A file of the page, in memory: nothing else is ever served, whatever is asked for.
typedef struct YkAsset {
    char *path; // within the page: "studio.js", "gallery/four-bar.yaml"
    YkText data;
} YkAsset;
typedef struct YkAssets {
    YkAsset *items;
    size_t count, capacity;
} YkAssets;

// Reads the page from where it is installed or built, or from the folder that YOKE_STUDIO names. Returns false where
// there is none; reported.
bool yk_assets_load(YkAssets *assets, YkSession *session);
void yk_assets_free(YkAssets *assets);
const YkAsset *yk_assets_find(const YkAssets *assets, const char *path); // NULL if there is none
const char *yk_assets_type(const char *path);                            // its media type

// The machine's file as it is now: its text, and a version that changes whenever its bytes do ("none" without a file).
typedef struct YkServed {
    const char *path; // NULL: no file was named
    const char *name; // without folders
    YkText text;
    char version[YK_VERSION_SIZE];
} YkServed;
bool yk_served_read(YkServed *served, YkProblems *problems); // a file that does not exist counts as empty
void yk_served_free(YkServed *served);

// Adds the whole page with the machine in it as one HTML document that fetches nothing. Returns false if the page is
// not one that can be put into one file; reported.
bool yk_studio_page(const YkAssets *assets, const YkServed *served, YkSession *session, YkText *html);

// Guards: who may ask. Other pages must not reach the machine through the browser, nor by a name of their own for this
// address.
bool yk_guard_host(const char *host, unsigned port);
bool yk_guard_origin(const char *origin, unsigned port); // NULL: no page asks
bool yk_guard_site(const char *site);                    // of Sec-Fetch-Site; NULL: an old browser, or none
bool yk_guard_token(const char *given, const char *token);
bool yk_make_token(char token[YK_TOKEN_SIZE]); // 128 random bits; false if the system gives none

// Serves until Ctrl-C. Returns the exit code.
int yk_studio_serve(YkSession *session, const YkAssets *assets, YkServed *served);

#endif
