# Writes a file as C: cmake -D INPUT=file -D OUTPUT=file.c -D NAME=symbol -P embed.cmake
# gives `const unsigned char NAME[]` and `const size_t NAME_size`. A missing file counts as empty.
set(hex "")
if(EXISTS "${INPUT}")
  file(READ "${INPUT}" hex HEX)
endif()
string(LENGTH "${hex}" size)
math(EXPR size "${size} / 2")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
file(WRITE "${OUTPUT}" "// Written by cmake/embed.cmake.
#include <stddef.h>
extern const unsigned char ${NAME}[];
extern const size_t ${NAME}_size;
const unsigned char ${NAME}[] = {
${bytes}0};
const size_t ${NAME}_size = ${size};
")
