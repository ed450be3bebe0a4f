// The server: the page's files and one machine, on the loopback address alone.
#ifdef YOKE_HAS_SERVER
#include <errno.h>
#include <arpa/inet.h>
#include <fcntl.h>
#include <microhttpd.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "stop.h"
#include "verbs/studio/studio.h"
#include "write/file.h"
#include "write/json.h"

extern char **environ; // POSIX: the process's environment, declared in no header

enum { BODY_MAX = 8 << 20, CONNECTIONS = 256, PATIENCE = 20 /* s */ };

typedef struct Server {
    const YkAssets *assets;
    YkServed *served;
    char token[YK_TOKEN_SIZE];
    unsigned port;
} Server;

// A request while it comes in.
typedef struct Incoming {
    YkText body;
    bool is_too_large;
} Incoming;

typedef struct MHD_Connection Connection;
typedef enum MHD_Result Result;

static const char policy[] =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; style-src 'self' "
    "'unsafe-inline'; img-src 'self' data: blob:; manifest-src 'self'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

static Result give(Connection *connection, unsigned status, const char *type, const char *data, size_t length,
                   bool is_kept)
{
    struct MHD_Response *response = MHD_create_response_from_buffer(
        length, (void *)(uintptr_t)data, is_kept ? MHD_RESPMEM_PERSISTENT : MHD_RESPMEM_MUST_COPY);
    if (!response) return MHD_NO;
    (void)MHD_add_response_header(response, "Content-Type", type);
    (void)MHD_add_response_header(response, "Content-Security-Policy", policy);
    (void)MHD_add_response_header(response, "X-Content-Type-Options", "nosniff");
    (void)MHD_add_response_header(response, "Referrer-Policy", "no-referrer");
    (void)MHD_add_response_header(response, "Cross-Origin-Resource-Policy", "same-origin");
    (void)MHD_add_response_header(response, "Cache-Control", "no-store");
    if (status == MHD_HTTP_METHOD_NOT_ALLOWED) (void)MHD_add_response_header(response, "Allow", "GET, HEAD, PUT");
    Result result = MHD_queue_response(connection, status, response);
    MHD_destroy_response(response);
    return result;
}

static Result refuse(Connection *connection, unsigned status, const char *why)
{
    return give(connection, status, "text/plain; charset=utf-8", why, strlen(why), true);
}

static Result give_json(Connection *connection, unsigned status, YkText *text)
{
    Result result = text->failed ? refuse(connection, MHD_HTTP_INTERNAL_SERVER_ERROR, "out of memory\n")
                                 : give(connection, status, "application/json", yk_text_get(text), text->length, false);
    yk_text_free(text);
    return result;
}

static const char *header(Connection *connection, const char *name)
{
    return MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name);
}

// --- the machine

static Result give_machine(Connection *connection, unsigned status, const YkServed *served)
{
    YkText text = {0};
    YkJson json = {.text = &text};
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_string(&json, "name", served->name);
    yk_json_string(&json, "text", yk_text_get(&served->text));
    yk_json_string(&json, "version", served->version);
    yk_json_end(&json);
    return give_json(connection, status, &text);
}

static Result fail(Connection *connection, YkProblems *problems)
{
    YkText text = {0};
    YkJson json = {.text = &text};
    bool is_known = problems && yk_problems_count(problems) > 0;
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_string(&json, "error", is_known ? yk_problems_get(problems, 0)->message : "out of memory");
    yk_json_end(&json);
    return give_json(connection, MHD_HTTP_INTERNAL_SERVER_ERROR, &text);
}

static Result read_machine(Connection *connection, Server *server, YkProblems *problems)
{
    const char *known = header(connection, MHD_HTTP_HEADER_IF_NONE_MATCH);
    if (!yk_served_read(server->served, problems)) return fail(connection, problems);
    if (known && strcmp(known, server->served->version) == 0)
        return give(connection, MHD_HTTP_NOT_MODIFIED, "application/json", "", 0, true);
    return give_machine(connection, MHD_HTTP_OK, server->served);
}

// Saves only over the version that the page has seen.
static Result save_machine(Connection *connection, Server *server, const Incoming *incoming, YkProblems *problems)
{
    YkServed *served = server->served;
    const char *seen = header(connection, MHD_HTTP_HEADER_IF_MATCH);
    YkText text = {0};
    if (incoming->is_too_large)
        return refuse(connection, MHD_HTTP_CONTENT_TOO_LARGE, "a machine file is smaller than 8 MB\n");
    if (!seen) return refuse(connection, MHD_HTTP_PRECONDITION_REQUIRED, "If-Match is missing\n");
    if (!yk_served_read(served, problems)) return fail(connection, problems);
    if (strcmp(seen, served->version) != 0) return give_machine(connection, MHD_HTTP_CONFLICT, served);
    if (!yk_file_write(served->path, yk_text_get(&incoming->body), incoming->body.length, problems) ||
        !yk_served_read(served, problems))
        return fail(connection, problems);
    YkJson json = {.text = &text};
    yk_json_object(&json, NULL, YK_JSON_INLINE);
    yk_json_string(&json, "version", served->version);
    yk_json_end(&json);
    return give_json(connection, MHD_HTTP_OK, &text);
}

static Result answer_machine(Connection *connection, Server *server, const char *method, const Incoming *incoming)
{
    bool reads = strcmp(method, MHD_HTTP_METHOD_GET) == 0, saves = strcmp(method, MHD_HTTP_METHOD_PUT) == 0;
    const char *token = MHD_lookup_connection_value(connection, MHD_GET_ARGUMENT_KIND, "token");
    if (!yk_guard_token(token, server->token)) return refuse(connection, MHD_HTTP_FORBIDDEN, "wrong token\n");
    if (!reads && !saves) return refuse(connection, MHD_HTTP_METHOD_NOT_ALLOWED, "GET or PUT\n");
    if (!server->served->path)
        return refuse(connection, MHD_HTTP_NOT_FOUND, "Studio was opened without a machine file\n");
    YkProblems *problems = yk_problems_new();
    Result result = !problems ? fail(connection, NULL)
                    : reads   ? read_machine(connection, server, problems)
                              : save_machine(connection, server, incoming, problems);
    yk_problems_free(problems);
    return result;
}

// --- requests

static Result answer(Connection *connection, Server *server, const char *url, const char *method,
                     const Incoming *incoming)
{
    if (strcmp(url, "/machine") == 0) return answer_machine(connection, server, method, incoming);
    if (strcmp(method, MHD_HTTP_METHOD_GET) != 0 && strcmp(method, MHD_HTTP_METHOD_HEAD) != 0)
        return refuse(connection, MHD_HTTP_METHOD_NOT_ALLOWED, "GET\n");
    const char *path = strcmp(url, "/") == 0 ? "index.html" : url + (*url == '/');
    const YkAsset *asset = yk_assets_find(server->assets, path);
    if (!asset) return refuse(connection, MHD_HTTP_NOT_FOUND, "not found\n");
    return give(connection, MHD_HTTP_OK, yk_assets_type(path), yk_text_get(&asset->data), asset->data.length, true);
}

static bool is_guarded(Connection *connection, const Server *server)
{
    return yk_guard_host(header(connection, MHD_HTTP_HEADER_HOST), server->port) &&
           yk_guard_origin(header(connection, MHD_HTTP_HEADER_ORIGIN), server->port) &&
           yk_guard_site(header(connection, "Sec-Fetch-Site"));
}

static Result handle(void *context, Connection *connection, const char *url, const char *method, const char *version,
                     const char *data, size_t *size, void **own)
{
    Server *server = context;
    Incoming *incoming = *own;
    (void)version;
    if (!incoming) { // its headers are here
        if (!is_guarded(connection, server)) return refuse(connection, MHD_HTTP_FORBIDDEN, "not from here\n");
        *own = incoming = calloc(1, sizeof *incoming);
        return incoming ? MHD_YES : MHD_NO;
    }
    if (*size > 0) {
        incoming->is_too_large |= *size > BODY_MAX - incoming->body.length;
        if (!incoming->is_too_large) yk_text_add(&incoming->body, data, *size);
        *size = 0;
        return incoming->body.failed ? MHD_NO : MHD_YES;
    }
    return answer(connection, server, url, method, incoming);
}

static void end_request(void *context, Connection *connection, void **own, enum MHD_RequestTerminationCode how)
{
    Incoming *incoming = *own;
    (void)context, (void)connection, (void)how;
    if (incoming) yk_text_free(&incoming->body);
    free(incoming);
    *own = NULL;
}

// --- the whole

static struct MHD_Daemon *start(Server *server, unsigned port)
{
    struct sockaddr_in here = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    struct MHD_Daemon *daemon = MHD_start_daemon(
        MHD_USE_INTERNAL_POLLING_THREAD | MHD_USE_AUTO, (uint16_t)port, NULL, NULL, handle, server,
        MHD_OPTION_SOCK_ADDR, &here, MHD_OPTION_CONNECTION_LIMIT, (unsigned)CONNECTIONS, MHD_OPTION_CONNECTION_TIMEOUT,
        (unsigned)PATIENCE, MHD_OPTION_NOTIFY_COMPLETED, end_request, NULL, MHD_OPTION_END);
    const union MHD_DaemonInfo *info = daemon ? MHD_get_daemon_info(daemon, MHD_DAEMON_INFO_BIND_PORT) : NULL;
    server->port = info ? info->port : port;
    return daemon;
}

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

int yk_studio_serve(YkSession *session, const YkAssets *assets, YkServed *served)
{
    Server server = {.assets = assets, .served = served};
    size_t port = 0;
    if (!yk_session_count(session, "--port", session->request->port, 65535, 0, &port)) return YK_EXIT_WRONG;
    bool has_token = yk_make_token(server.token);
    struct MHD_Daemon *daemon = has_token ? start(&server, (unsigned)port) : NULL;
    if (!daemon) {
        yk_problem(session->problems, YK_CODE_STUDIO_NO_PORT, (YkPlace){0}, "Studio cannot be served here: %s",
                   has_token ? strerror(errno) : "the system gives no random numbers");
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
    MHD_stop_daemon(daemon);
    yk_text_free(&address);
    return YK_EXIT_DONE;
}
#else
typedef int yoke_studio_has_no_server;
#endif
