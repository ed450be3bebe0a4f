// The plugin yoke-http: requests of a browser on this computer, for the command (apps/cli/verbs/studio/http_table.h).
#include <arpa/inet.h>
#include <errno.h>
#include <microhttpd.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <yoke/version.h>
#include "verbs/studio/http_table.h"

enum { CONNECTIONS = 256, PATIENCE = 20 /* s */ };

typedef struct MHD_Connection Connection;
typedef enum MHD_Result Result;

typedef struct Server {
    struct MHD_Daemon *daemon;
    const YkHttpHandler *handler;
} Server;

// A request while it comes in. An answer that cannot be given closes the connection.
typedef struct Incoming {
    YkRequestIn request;
    Connection *connection;
    const YkHttpHandler *handler;
    char *body;
    size_t capacity;
    Result given; // MHD_YES once it has its answer
} Incoming;

static const char *header(const YkRequestIn *request, const char *name)
{
    return MHD_lookup_connection_value(((Incoming *)request->own)->connection, MHD_HEADER_KIND, name);
}

static const char *argument(const YkRequestIn *request, const char *name)
{
    return MHD_lookup_connection_value(((Incoming *)request->own)->connection, MHD_GET_ARGUMENT_KIND, name);
}

static void give(YkRequestIn *request, unsigned status, const char *type, const char *data, size_t length, bool is_kept)
{
    Incoming *incoming = request->own;
    struct MHD_Response *response = MHD_create_response_from_buffer(
        length, (void *)(uintptr_t)data, is_kept ? MHD_RESPMEM_PERSISTENT : MHD_RESPMEM_MUST_COPY);
    if (!response) return;
    bool is_whole = MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, type) == MHD_YES;
    for (const char *(*entry)[2] = incoming->handler->headers; (*entry)[0]; entry++)
        is_whole &= MHD_add_response_header(response, (*entry)[0], (*entry)[1]) == MHD_YES;
    if (is_whole) incoming->given = MHD_queue_response(incoming->connection, status, response);
    MHD_destroy_response(response);
}

static bool keep(Incoming *incoming, const char *data, size_t size)
{
    YkRequestIn *request = &incoming->request;
    if (!request->keeps_body) return true;
    request->is_too_large |= size > incoming->handler->body_max - request->length;
    if (request->is_too_large) return true;
    if (request->length + size > incoming->capacity) {
        size_t capacity = 2 * (request->length + size);
        char *body = realloc(incoming->body, capacity);
        if (!body) return false;
        request->body = incoming->body = body;
        incoming->capacity = capacity;
    }
    memcpy(incoming->body + request->length, data, size);
    request->length += size;
    return true;
}

// Called with the headers, then with each piece of the body, then once more.
static Result handle(void *context, Connection *connection, const char *url, const char *method, const char *version,
                     const char *data, size_t *size, void **own)
{
    const YkHttpHandler *handler = ((const Server *)context)->handler;
    Incoming *incoming = *own;
    (void)version;
    if (!incoming) {
        *own = incoming = calloc(1, sizeof *incoming);
        if (!incoming) return MHD_NO;
        *incoming = (Incoming){.connection = connection, .handler = handler};
        incoming->request = (YkRequestIn){.method = method, .path = url, .body = "", .own = incoming};
        return handler->accept(handler->context, &incoming->request) ? MHD_YES : incoming->given;
    }
    if (*size > 0) {
        bool is_kept = keep(incoming, data, *size);
        *size = 0;
        return is_kept ? MHD_YES : MHD_NO;
    }
    handler->answer(handler->context, &incoming->request);
    return incoming->given;
}

static void end_request(void *context, Connection *connection, void **own, enum MHD_RequestTerminationCode how)
{
    Incoming *incoming = *own;
    (void)context, (void)connection, (void)how;
    if (incoming) free(incoming->body);
    free(incoming);
    *own = NULL;
}

static void *start(const YkHttpHandler *handler, unsigned port, unsigned *taken)
{
    struct sockaddr_in here = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    Server *server = calloc(1, sizeof *server);
    if (!server) return NULL;
    server->handler = handler;
    server->daemon = MHD_start_daemon(MHD_USE_INTERNAL_POLLING_THREAD | MHD_USE_AUTO, (uint16_t)port, NULL, NULL,
                                      handle, server, MHD_OPTION_SOCK_ADDR, &here, MHD_OPTION_CONNECTION_LIMIT,
                                      (unsigned)CONNECTIONS, MHD_OPTION_CONNECTION_TIMEOUT, (unsigned)PATIENCE,
                                      MHD_OPTION_NOTIFY_COMPLETED, end_request, NULL, MHD_OPTION_END);
    if (!server->daemon) {
        int why = errno;
        free(server);
        errno = why;
        return NULL;
    }
    const union MHD_DaemonInfo *info = MHD_get_daemon_info(server->daemon, MHD_DAEMON_INFO_BIND_PORT);
    *taken = info ? info->port : port;
    return server;
}

static void stop(void *started)
{
    Server *server = started;
    MHD_stop_daemon(server->daemon);
    free(server);
}

__attribute__((visibility("default"))) const YkHttp *yk_http_open(void);
const YkHttp *yk_http_open(void)
{
    static const YkHttp table = {YK_HTTP_INTERFACE, YOKE_VERSION_STRING, start, stop, header, argument, give};
    return &table;
}
