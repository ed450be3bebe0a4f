// The page in one file: style, scripts, modules and the machine stand in the document itself.
#include <string.h>
#include <strings.h>
#include "verbs/studio/studio.h"
#include "write/json.h"

static void add_base64(YkText *text, const YkText *data)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *bytes = (const unsigned char *)yk_text_get(data);
    for (size_t k = 0; k < data->length; k += 3) {
        size_t left = data->length - k;
        unsigned long group = (unsigned long)bytes[k] << 16 | (left > 1 ? (unsigned long)bytes[k + 1] << 8 : 0) |
                              (left > 2 ? bytes[k + 2] : 0);
        const char four[] = {digits[group >> 18 & 63], digits[group >> 12 & 63],
                             left > 1 ? digits[group >> 6 & 63] : '=', left > 2 ? digits[group & 63] : '='};
        yk_text_add(text, four, 4);
    }
}

// Adds JSON to a <script>: no "<" in it can end the element.
static void add_json(YkText *html, const YkText *json)
{
    const char *at = yk_text_get(json), *end = at + json->length;
    for (const char *next; (next = memchr(at, '<', (size_t)(end - at))) != NULL; at = next + 1) {
        yk_text_add(html, at, (size_t)(next - at));
        yk_text_puts(html, "\\u003c");
    }
    yk_text_add(html, at, (size_t)(end - at));
}

// Adds a script: its strings may say "</script" and "<!--", which would end the element or hide its end.
static void add_script(YkText *html, const YkText *script)
{
    const char *data = yk_text_get(script);
    for (size_t k = 0; k < script->length; k++) {
        yk_text_add(html, data + k, 1);
        if (data[k] == '<' && (strncmp(data + k, "<!--", 4) == 0 || strncasecmp(data + k, "</script", 8) == 0))
            yk_text_puts(html, "\\");
    }
}

static bool is_text(const char *path)
{
    const char *type = yk_assets_type(path);
    return strncmp(type, "text/plain", 10) == 0 || strcmp(type, "application/json") == 0 ||
           strcmp(type, "image/svg+xml") == 0;
}

// Writes what the page finds in place of files: the machine, the gallery.
static void add_data(YkText *html, const YkAssets *assets, const YkServed *served)
{
    YkText data = {0};
    YkJson json = {.text = &data};
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    if (served->path) {
        yk_json_object(&json, "machine", YK_JSON_INLINE);
        yk_json_string(&json, "name", served->name);
        yk_json_string(&json, "text", yk_text_get(&served->text));
        yk_json_end(&json);
    } else {
        yk_json_null(&json, "machine");
    }
    yk_json_object(&json, "files", YK_JSON_INLINE);
    for (size_t k = 0; k < assets->count; k++)
        if (is_text(assets->items[k].path))
            yk_json_string(&json, assets->items[k].path, yk_text_get(&assets->items[k].data));
    yk_json_end(&json);
    yk_json_end(&json);
    add_json(html, &data);
    html->failed |= data.failed;
    yk_text_free(&data);
}

// Files that the page contains unchanged, for its script.
static const char *const inside[] = {"core.wasm", "yoke.wasm", "worker.js", "report.js"};

// Writes a file of the page that no browser reads by itself.
static void add_file(YkText *html, const YkAssets *assets, const char *path)
{
    yk_text_format(html, "<script type=\"text/plain\" id=\"%s\">", path);
    add_base64(html, &yk_assets_find(assets, path)->data);
    yk_text_puts(html, "</script>\n");
}

// Writes `yokeInline`, which the page looks for: the worker's address, the bytes of the modules and of the report's
// script, and the data.
static void add_inline(YkText *html, const YkAssets *assets, const YkServed *served, const char *nonce)
{
    for (size_t k = 0; k < sizeof inside / sizeof *inside; k++) add_file(html, assets, inside[k]);
    yk_text_puts(html, "<script type=\"application/json\" id=\"yoke-data\">");
    add_data(html, assets, served);
    yk_text_format(html, "</script>\n<script nonce=\"%s\">\n", nonce);
    yk_text_puts(
        html, "var yokeInline = (() => {\n"
              "  const text = (id) => document.getElementById(id).textContent;\n"
              "  const bytes = (id) => Uint8Array.from(atob(text(id)), (c) => c.charCodeAt(0));\n"
              "  const worker = URL.createObjectURL(new Blob([bytes(\"worker.js\")], {type: \"text/javascript\"}));\n"
              "  return {worker, small: bytes(\"core.wasm\"), whole: bytes(\"yoke.wasm\"), "
              "report: bytes(\"report.js\"), ...JSON.parse(text(\"yoke-data\"))};\n"
              "})();\n</script>\n");
}

// Returns the name between `before` and `after` in a line; its length in *length.
static const char *between(const char *line, size_t size, const char *before, const char *after, size_t *length)
{
    size_t skip = strlen(before), end = strlen(after);
    for (size_t k = 0; k + skip + end <= size; k++) {
        if (memcmp(line + k, before, skip) != 0) continue;
        const char *name = line + k + skip;
        for (*length = 0; k + skip + *length + end <= size; ++*length)
            if (memcmp(name + *length, after, end) == 0) return name;
    }
    return NULL;
}

// Returns the file that a line names between `before` and `after`; NULL if it names none.
static const YkAsset *find_named(const YkAssets *assets, const char *line, size_t size, const char *before,
                                 const char *after)
{
    size_t length = 0;
    const char *name = between(line, size, before, after, &length);
    for (size_t k = 0; name && k < assets->count; k++)
        if (strlen(assets->items[k].path) == length && memcmp(assets->items[k].path, name, length) == 0)
            return &assets->items[k];
    return NULL;
}

typedef struct Page {
    const YkAssets *assets;
    const YkServed *served;
    YkText *html, scripts; // which come last, when all else stands
    char nonce[YK_TOKEN_SIZE];
} Page;

static void add_whole_script(YkText *html, const char *nonce, const YkAsset *script)
{
    yk_text_format(html, "<script nonce=\"%s\">\n", nonce);
    add_script(html, &script->data);
    yk_text_puts(html, "\n</script>\n");
}

// Writes the scripts that the page otherwise fetches when it plots, or makes a film.
static void add_later_scripts(Page *page)
{
    static const char *const later[] = {"plot.js", "film.js"};
    for (size_t k = 0; k < sizeof later / sizeof *later; k++) {
        const YkAsset *script = yk_assets_find(page->assets, later[k]);
        if (script) add_whole_script(page->html, page->nonce, script);
    }
}

// Puts what a line refers to in the place of the line.
static void add_line(Page *page, const char *line, size_t size)
{
    size_t length = 0;
    const YkAsset *style = find_named(page->assets, line, size, "<link rel=\"stylesheet\" href=\"", "\">");
    const YkAsset *script = find_named(page->assets, line, size, "<script src=\"", "\" defer></script>");
    if (between(line, size, "http-equiv=\"Content-Security-Policy\" content=\"", "\">", &length)) {
        yk_text_format(
            page->html,
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'nonce-%s' "
            "'wasm-unsafe-eval'; worker-src blob:; style-src 'unsafe-inline'; img-src data: blob:; base-uri "
            "'none'; form-action 'none'\">\n",
            page->nonce);
    } else if (style) {
        yk_text_puts(page->html, "<style>\n");
        yk_text_join(page->html, &style->data);
        yk_text_puts(page->html, "\n</style>\n");
    } else if (script) {
        add_whole_script(&page->scripts, page->nonce, script);
    } else if (between(line, size, "</body", ">", &length)) {
        add_inline(page->html, page->assets, page->served, page->nonce);
        add_later_scripts(page);
        yk_text_join(page->html, &page->scripts);
        yk_text_puts(page->html, "</body>\n");
    } else {
        yk_text_add(page->html, line, size);
    }
}

bool yk_studio_page(const YkAssets *assets, const YkServed *served, YkSession *session, YkText *html)
{
    Page page = {.assets = assets, .served = served, .html = html};
    const char *lacking = yk_assets_find(assets, "index.html") ? NULL : "index.html";
    for (size_t k = 0; k < sizeof inside / sizeof *inside; k++)
        if (!yk_assets_find(assets, inside[k])) lacking = inside[k];
    if (lacking) {
        yk_problem(session->problems, YK_CODE_STUDIO_NO_PAGE, (YkPlace){0}, "the page of Studio lacks its file %q",
                   lacking);
        return false;
    }
    if (!yk_make_token(page.nonce)) {
        yk_problem(session->problems, YK_CODE_STUDIO_NO_PORT, (YkPlace){0}, "the system gives no random numbers");
        return false;
    }
    const YkText *index = &yk_assets_find(assets, "index.html")->data;
    for (size_t at = 0; at < index->length;) {
        const char *line = index->data + at, *end = memchr(line, '\n', index->length - at);
        size_t size = end ? (size_t)(end - line) + 1 : index->length - at;
        add_line(&page, line, size);
        at += size;
    }
    html->failed |= page.scripts.failed;
    yk_text_free(&page.scripts);
    return true;
}
