// Shared by the files that read `laws:`; no other file includes it.
#ifndef MODEL_LAWS_READ_H
#define MODEL_LAWS_READ_H
#include "model/laws/laws.h"
#include "model/load.h"

typedef struct YkLawReader {
    YkLoader *loader;
    YkModelLaw *law;
    YkLawSource *source;
} YkLawReader;

// Read values of a law; a mistake makes the source bad.
void yk_load_law_number(YkLawReader *reader, const YkNode *node, const char *noun, YkDimension dimension,
                        YkLawNumber *number);
bool yk_load_law_optional(YkLawReader *reader, const YkNode *map, const char *key, YkDimension dimension,
                          YkLawNumber *number); // false if the key is missing
void yk_load_law_required(YkLawReader *reader, const YkNode *map, const char *key, YkDimension dimension,
                          YkLawNumber *number);
bool yk_load_law_expect(YkLawReader *reader, const YkNode *node, YkNodeKind kind, const char *noun);

void yk_load_law_segments(YkLawReader *reader, const YkNode *segments); // segments.c
void yk_load_law_dimensions(YkLoader *loader, const YkNode *section);   // dimension.c: those of all laws

// A law under construction.
typedef struct YkLawWork {
    YkLoader *loader;
    YkModelLaw *law;
    const YkLawSource *source;
    YkLawBuilder *builder;
    const YkLawPart *part; // the present one
    // its conditions in order, and the place of each:
    YkLawCondition *conditions;
    YkPlace *places;
    size_t count, capacity, place_capacity;
    bool failed; // out of memory
} YkLawWork;

// report.c
void yk_load_law_report(const YkLawWork *work, YkCode code, YkPlace place, const char *what);
void yk_load_law_report_part(const YkLawWork *work, YkLawFault fault);
void yk_load_law_report_table(const YkLawWork *work, YkLawFault fault);
void yk_load_law_report_period(const YkLawWork *work, YkLawFault fault);
void yk_load_law_report_jumps(YkLoader *loader, const YkModelLaw *law); // jumps.c

// amount.c: amounts as the file would give them, "20 mm/deg": a value of the law or its derivative; an argument.
typedef struct YkAmount {
    char text[120];
    size_t length;
} YkAmount;
YkAmount yk_load_law_amount(const YkModel *model, const YkModelLaw *law, double value, int order);
YkAmount yk_load_law_place(const YkModel *model, const YkModelLaw *law, double x);

#endif
