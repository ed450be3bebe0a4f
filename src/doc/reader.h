// Shared by the files of this room; no other room includes it.
#ifndef DOC_READER_H
#define DOC_READER_H
#include <stdint.h>
#include <yaml.h>
#include "base/problems.h"
#include "doc/node.h"

// Returns whether a code point may appear in a text. Control characters, line separators other than \n, byte order
// marks, non-characters and the invisible marks that reorder a line on the screen may not. A tab is not allowed by this
// function. More lenient than yk_utf8_printable: joiners belong to the spelling of some languages.
bool yk_doc_is_allowed(uint32_t code_point);
// Returns the place of a byte in the text. Cost linear in offset: for the one problem that ends the reading.
YkPlace yk_doc_place_of(const char *text, size_t offset);
// Checks the bytes of the whole text. Adds a problem for the first fault and returns false.
bool yk_doc_guard(const char *text, size_t length, YkProblems *problems);

// Adds a problem for every repeated key of the map. Returns false when there was one, or no memory (also a problem).
// Cost linear in the number of pairs.
bool yk_doc_check_keys(const YkNode *map, YkProblems *problems);

// Adds a problem for every value of the map or list that YAML splits at a comma between parentheses. Returns false when
// there was one. Cost linear in the number of entries.
bool yk_doc_check_commas(const YkNode *node, YkProblems *problems);

// Adds a problem for the error at which libyaml stopped, in plain words.
void yk_doc_yaml_error(const yaml_parser_t *parser, const char *text, size_t length, YkProblems *problems);

#endif
