// The functions that the plugin yoke-http gives the command: whole requests of a browser on this computer, and answers
// to them.
#ifndef CLI_HTTP_TABLE_H
#define CLI_HTTP_TABLE_H
#include <stdbool.h>
#include <stddef.h>

enum { YK_HTTP_INTERFACE = 2 };
#define YK_HTTP_ENTRY "yk_http_open"

// A request, whole; before it is accepted it has no body yet.
typedef struct YkRequestIn {
    const char *method, *path; // the path without its arguments
    const char *body;
    size_t length;     // of the body, in bytes
    bool keeps_body;   // set by `accept`: otherwise the body is read and dropped
    bool is_too_large; // the body was longer than the limit, and was not kept
    void *own;         // the plugin's
} YkRequestIn;

// Called from the server's thread, for one request at a time.
typedef struct YkHttpHandler {
    void *context;
    size_t body_max;                              // bytes of a body that are kept
    const char *(*headers)[2];                    // of every answer: names and values; ends with NULL
    bool (*accept)(void *context, YkRequestIn *); // its headers are here; returns false if it has been refused
    void (*answer)(void *context, YkRequestIn *); // it is whole: gives an answer
} YkHttpHandler;

typedef struct YkHttp {
    int interface;    // YK_HTTP_INTERFACE of the headers that it was built with
    const char *yoke; // the version of yoke that it belongs to
    // Listens on the loopback address until it is stopped; port 0 takes a free one. Returns NULL, with errno, if it
    // cannot. The handler is kept, not copied.
    void *(*start)(const YkHttpHandler *, unsigned port, unsigned *taken);
    void (*stop)(void *server);
    const char *(*header)(const YkRequestIn *, const char *name);   // NULL if it has none
    const char *(*argument)(const YkRequestIn *, const char *name); // of the address: "token" of "/machine?token=..."
    // Answers a request, once. Data that is not kept until the server stops is copied.
    void (*give)(YkRequestIn *, unsigned status, const char *type, const char *data, size_t length, bool is_kept);
} YkHttp;
typedef const YkHttp *(*YkHttpOpen)(void);

#endif
