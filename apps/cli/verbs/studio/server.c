// The server: the page's files and one machine, on the loopback address alone.
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "plugin.h"
#include "stop.h"
#include "verbs/studio/http_table.h"
#include "verbs/studio/studio.h"
#include "write/file.h"
#include "write/json.h"

extern char **environ; // POSIX: the process's environment, declared in no header

enum { BODY_MAX = 8 << 20 };
enum { OK = 200, NOT_MODIFIED = 304, FORBIDDEN = 403, NOT_FOUND = 404, NOT_ALLOWED = 405, CONFLICT = 409 };
enum { TOO_LARGE = 413, PRECONDITION_REQUIRED = 428, FAILED = 500 };

typedef struct Server {
    const YkHttp *http;
    const YkAssets *assets;
    YkServed *served;
    char token[YK_TOKEN_SIZE];
    unsigned port;
} Server;

static const char *headers[][2] = {
    {"Content-Security-Policy",
     "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; style-src "
     "'self' "
     "'unsafe-inline'; img-src 'self' data: blob:; manifest-src 'self'; base-uri 'none'; form-action 'none'; "
     "frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cache-Control", "no-store"},
    {"Allow", "GET, HEAD, PUT"},
    {NULL, NULL}};

static void refuse(const Server *server, YkRequestIn *request, unsigned status, const char *why)
{
    server->http->give(request, status, "text/plain; charset=utf-8", why, strlen(why), true);
}

static void give_json(const Server *server, YkRequestIn *request, unsigned status, YkText *text)
{
    if (text->failed)
        refuse(server, request, FAILED, "out of memory\n");
    else
        server->http->give(request, status, "application/json", yk_text_get(text), text->length, false);
    yk_text_free(text);
}

// --- the machine

static void give_machine(const Server *server, YkRequestIn *request, unsigned status)
{
    YkText text = {0};
    YkJson json = {.text = &text};
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_string(&json, "name", server->served->name);
    yk_json_string(&json, "text", yk_text_get(&server->served->text));
    yk_json_string(&json, "version", server->served->version);
    yk_json_end(&json);
    give_json(server, request, status, &text);
}

static void fail(const Server *server, YkRequestIn *request, YkProblems *problems)
{
    YkText text = {0};
    YkJson json = {.text = &text};
    bool is_known = problems && yk_problems_count(problems) > 0;
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_string(&json, "error", is_known ? yk_problems_get(problems, 0)->message : "out of memory");
    yk_json_end(&json);
    give_json(server, request, FAILED, &text);
}

static void read_machine(const Server *server, YkRequestIn *request, YkProblems *problems)
{
    const char *known = server->http->header(request, "If-None-Match");
    if (!yk_served_read(server->served, problems))
        fail(server, request, problems);
    else if (known && strcmp(known, server->served->version) == 0)
        server->http->give(request, NOT_MODIFIED, "application/json", "", 0, true);
    else
        give_machine(server, request, OK);
}

static void write_machine(const Server *server, YkRequestIn *request, YkProblems *problems)
{
    YkServed *served = server->served;
    YkText text = {0};
    YkJson json = {.text = &text};
    if (!yk_file_write(served->path, request->body, request->length, problems) || !yk_served_read(served, problems)) {
        fail(server, request, problems);
        return;
    }
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_string(&json, "version", served->version);
    yk_json_end(&json);
    give_json(server, request, OK, &text);
}

// Saves only over the version that the page has seen.
static void save_machine(const Server *server, YkRequestIn *request, YkProblems *problems)
{
    const char *seen = server->http->header(request, "If-Match");
    if (request->is_too_large)
        refuse(server, request, TOO_LARGE, "a machine file is smaller than 8 MB\n");
    else if (!seen)
        refuse(server, request, PRECONDITION_REQUIRED, "If-Match is missing\n");
    else if (!yk_served_read(server->served, problems))
        fail(server, request, problems);
    else if (strcmp(seen, server->served->version) != 0)
        give_machine(server, request, CONFLICT);
    else
        write_machine(server, request, problems);
}

static bool has_token(const Server *server, const YkRequestIn *request)
{
    return yk_guard_token(server->http->argument(request, "token"), server->token);
}

static void answer_machine(const Server *server, YkRequestIn *request)
{
    bool reads = strcmp(request->method, "GET") == 0, saves = strcmp(request->method, "PUT") == 0;
    if (!has_token(server, request)) {
        refuse(server, request, FORBIDDEN, "wrong token\n");
    } else if (!reads && !saves) {
        refuse(server, request, NOT_ALLOWED, "GET or PUT\n");
    } else if (!server->served->path) {
        refuse(server, request, NOT_FOUND, "Studio was opened without a machine file\n");
    } else {
        YkProblems *problems = yk_problems_new();
        if (!problems)
            fail(server, request, NULL);
        else if (reads)
            read_machine(server, request, problems);
        else
            save_machine(server, request, problems);
        yk_problems_free(problems);
    }
}

// --- requests

static bool is_machine(const YkRequestIn *request)
{
    return strcmp(request->path, "/machine") == 0;
}

static void answer(void *context, YkRequestIn *request)
{
    const Server *server = context;
    bool reads = strcmp(request->method, "GET") == 0 || strcmp(request->method, "HEAD") == 0;
    const char *path = strcmp(request->path, "/") == 0 ? "index.html" : request->path + (*request->path == '/');
    if (is_machine(request)) {
        answer_machine(server, request);
        return;
    }
    const YkAsset *asset = reads ? yk_assets_find(server->assets, path) : NULL;
    if (asset)
        server->http->give(request, OK, yk_assets_type(path), yk_text_get(&asset->data), asset->data.length, true);
    else
        refuse(server, request, reads ? NOT_FOUND : NOT_ALLOWED, reads ? "not found\n" : "GET\n");
}

static bool accept(void *context, YkRequestIn *request)
{
    const Server *server = context;
    bool is_guarded = yk_guard_host(server->http->header(request, "Host"), server->port) &&
                      yk_guard_origin(server->http->header(request, "Origin"), server->port) &&
                      yk_guard_site(server->http->header(request, "Sec-Fetch-Site"));
    if (!is_guarded) refuse(server, request, FORBIDDEN, "not from here\n");
    request->keeps_body = is_guarded && is_machine(request) && has_token(server, request);
    return is_guarded;
}

// --- the whole

// Opens the browser where there is a screen; the address is printed anyway.
static void open_browser(const char *address)
{
    const char *screen = getenv("DISPLAY"), *other = getenv("WAYLAND_DISPLAY");
    const char *words[] = {"xdg-open", address, NULL};
    posix_spawn_file_actions_t actions;
    pid_t child;
    if (!(screen && *screen) && !(other && *other)) return;
    if (posix_spawn_file_actions_init(&actions) != 0) return;
    (void)posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    (void)posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    (void)posix_spawnp(&child, words[0], &actions, NULL, (char *const *)(const void *)words, environ);
    posix_spawn_file_actions_destroy(&actions);
}

static void wait_for_stop(void)
{
    const struct timespec span = {.tv_nsec = 100000000};
    while (!yk_stop_is_asked()) nanosleep(&span, NULL);
}

static const YkHttp *find_server(YkSession *session)
{
    const char *why;
    const YkPlugin *found = yk_plugin_open("yoke-http", YK_HTTP_ENTRY, &why);
    bool fits = found && found->interface == YK_HTTP_INTERFACE && strcmp(found->yoke, yk_version()) == 0;
    if (fits) return (const YkHttp *)(const void *)found;
    yk_problem(session->problems, YK_CODE_STUDIO_NO_SERVER, (YkPlace){0},
               "the plugin yoke-http, which serves Studio, %s%s",
               found ? "is of another version"
               : why ? "cannot be loaded: "
                     : "is missing",
               why ? why : "");
    yk_problem_hint(session->problems,
                    "`yoke studio FILE -o page.html` writes the page with the machine in it as one file");
    return NULL;
}

int yk_studio_serve(YkSession *session, const YkAssets *assets, YkServed *served)
{
    Server server = {.http = find_server(session), .assets = assets, .served = served};
    const YkHttpHandler handler = {&server, BODY_MAX, headers, accept, answer};
    size_t port = 0;
    if (!server.http || !yk_session_count(session, "--port", session->request->port, 65535, 0, &port))
        return YK_EXIT_WRONG;
    bool is_made = yk_make_token(server.token);
    void *started = is_made ? server.http->start(&handler, (unsigned)port, &server.port) : NULL;
    if (!started) {
        yk_problem(session->problems, YK_CODE_STUDIO_NO_PORT, (YkPlace){0}, "Studio cannot be served here: %s",
                   is_made ? strerror(errno) : "the system gives no random numbers");
        if (port > 0) yk_problem_hint(session->problems, "without --port a free one is taken");
        return YK_EXIT_WRONG;
    }
    YkText address = {0};
    yk_text_format(&address, "http://127.0.0.1:%u/?token=%s", server.port, server.token);
    printf("Studio: %s\n", yk_text_get(&address));
    printf("Ctrl-C ends it.\n");
    fflush(stdout);
    if (!session->request->no_browser && !address.failed) open_browser(address.data);
    session->keeps_what_is_done = true; // Ctrl-C is how it ends
    wait_for_stop();
    server.http->stop(started);
    yk_text_free(&address);
    return YK_EXIT_DONE;
}
