# One program for all tests of a room, whose argument names one: linking takes longer than compiling, and starting the compiler as long.
# Its tests are compiled in groups, in which no name is given to two things. -DYOKE_TESTS_APART=ON makes each test a program of its own.
option(YOKE_TESTS_APART "Build each test as a program of its own" OFF)
set(YOKE_TESTS_TOGETHER 6) # files at most

# Sets OUT to the headers of tests that a file of a room includes, and that these include.
function(yoke_test_headers source out)
  get_filename_component(folder ${source} DIRECTORY)
  file(STRINGS ${source} lines REGEX "^#include \"[^\"]*\\.h\"")
  set(found "")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[^\"]*\"([^\"]*)\".*" "\\1" name "${line}")
    foreach(place ${folder} ${CMAKE_CURRENT_SOURCE_DIR})
      if(EXISTS ${place}/${name})
        get_filename_component(header ${place}/${name} ABSOLUTE)
        yoke_test_headers(${header} more)
        list(APPEND found ${header} ${more})
        break()
      endif()
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES found)
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# Sets OUT to whether a test has a program of its own: it compiles sources of the library in, takes libraries of its own, or has the
# program's allocator, which the sanitizers have themselves.
function(yoke_is_test_apart source out)
  file(STRINGS ${source} apart REGEX "^#include \"[^\"]*\\.c\"|YOKE_MPFR")
  yoke_test_headers(${source} headers)
  if(YOKE_TESTS_APART OR apart OR "${headers}" MATCHES "/similar\\.h" OR ("${headers}" MATCHES "/interposed\\.h" AND NOT YOKE_SANITIZE))
    set(${out} TRUE PARENT_SCOPE)
  else()
    set(${out} FALSE PARENT_SCOPE)
  endif()
endfunction()

# Sets NAMES to the names of a test, SHARED to those of its headers, MACROS to its macros; MOST to 1 where these concern all that follows.
function(yoke_test_names source names shared macros most)
  yoke_own_names(${source} own defined)
  yoke_test_headers(${source} headers)
  set(more "")
  foreach(header ${headers})
    yoke_own_names(${header} here inside)
    list(APPEND more ${here} ${inside})
  endforeach()
  list(REMOVE_DUPLICATES more)
  set(${names} ${own} ${defined} PARENT_SCOPE)
  set(${shared} ${more} PARENT_SCOPE)
  set(${macros} ${defined} PARENT_SCOPE)
  set(${most} ${YOKE_TESTS_TOGETHER} PARENT_SCOPE)
  if("${defined}" MATCHES "(^|;)(_|ANY|malloc|calloc|realloc|free)")
    set(${most} 1 PARENT_SCOPE)
  endif()
endfunction()

# The program tests_ROOM of these tests of a room.
function(yoke_test_room room)
  set(declared "")
  set(called "")
  set(groups "")
  foreach(name ${ARGN})
    string(APPEND declared "int yoke_test_${name}(void);\n")
    string(APPEND called "    if (!strcmp(arguments[1], \"${name}\")) return yoke_test_${name}();\n")
    set(source ${CMAKE_CURRENT_SOURCE_DIR}/${room}/test_${name}.c)
    yoke_test_names(${source} names shared macros most)
    if(most EQUAL 1)
      set(group ${name})
    else()
      yoke_choose_group("" ${most} "${names}" "${shared}" group)
    endif()
    list(APPEND groups ${group})
    list(REMOVE_DUPLICATES macros)
    list(TRANSFORM macros PREPEND "#undef ")
    list(JOIN macros "\n" forgotten)
    string(APPEND text_${group} "#define main yoke_test_${name}\n#include \"${source}\"\n#undef main\n${forgotten}\n")
  endforeach()
  list(REMOVE_DUPLICATES groups)
  set(main ${CMAKE_CURRENT_BINARY_DIR}/${room}_tests.c)
  set(sources ${main})
  foreach(group ${groups})
    set(file ${CMAKE_CURRENT_BINARY_DIR}/${room}_tests_${group}.c)
    file(CONFIGURE OUTPUT ${file} CONTENT "${text_${group}}" @ONLY)
    list(APPEND sources ${file})
  endforeach()
  file(CONFIGURE OUTPUT ${main} CONTENT "// Made by tests/together.cmake: runs the test of the room `${room}` that its argument names.
#include <string.h>
${declared}
int main(int count, char **arguments)
{
    if (count != 2) return 2;
${called}    return 2;
}
" @ONLY)
  yoke_test_program(tests_${room} ${sources})
  # What takes time in a test is the library. To compile the test itself for speed, eight times as long, costs more than it saves.
  target_compile_options(tests_${room} PRIVATE -O0)
endfunction()
