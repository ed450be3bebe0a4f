# The Python package `yoke` (python/): its extension module by cffi, beside the modules, in build/PRESET/python. Built where Debian's
# python3 has cffi, NumPy and its headers. Otherwise the package is left out and everything else is built as usual.
find_program(YOKE_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(YOKE_PYTHON AND NOT DEFINED YOKE_PYTHON_INCLUDE)
  execute_process(COMMAND ${YOKE_PYTHON} -c "import cffi, numpy, sysconfig, os
path = sysconfig.get_path('include')
print(path if os.path.exists(path + '/Python.h') else '')" OUTPUT_VARIABLE YOKE_PYTHON_FOUND ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(YOKE_PYTHON_FOUND)
    set(YOKE_PYTHON_INCLUDE ${YOKE_PYTHON_FOUND} CACHE INTERNAL "Where Python.h is")
  endif()
endif()
if(NOT YOKE_PYTHON_INCLUDE OR YOKE_SANITIZE OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux")
  return()
endif()

set(YOKE_PYTHON_SOURCE ${CMAKE_SOURCE_DIR}/python)
set(YOKE_PYTHON_DIR ${CMAKE_BINARY_DIR}/python)
file(GLOB YOKE_PYTHON_HEADERS CONFIGURE_DEPENDS include/yoke/*.h)
add_custom_command(OUTPUT ${YOKE_PYTHON_DIR}/native.c VERBATIM
  COMMAND ${CMAKE_COMMAND} -E env YOKE_INCLUDE=${CMAKE_SOURCE_DIR}/include PYTHONDONTWRITEBYTECODE=1
    ${YOKE_PYTHON} ${YOKE_PYTHON_SOURCE}/native/build_native.py ${YOKE_PYTHON_DIR}/native.c
  DEPENDS ${YOKE_PYTHON_SOURCE}/native/build_native.py ${YOKE_PYTHON_SOURCE}/native/host.c ${YOKE_PYTHON_SOURCE}/native/host.h
    ${YOKE_PYTHON_HEADERS}
  COMMENT "Writing the Python extension module")
add_library(yoke_python MODULE ${YOKE_PYTHON_DIR}/native.c)
set_target_properties(yoke_python PROPERTIES PREFIX "" OUTPUT_NAME _native SUFFIX .abi3.so C_VISIBILITY_PRESET default C_EXTENSIONS ON
  LIBRARY_OUTPUT_DIRECTORY ${YOKE_PYTHON_DIR}/yoke)
target_include_directories(yoke_python PRIVATE ${YOKE_PYTHON_SOURCE}/native SYSTEM ${YOKE_PYTHON_INCLUDE})
target_compile_definitions(yoke_python PRIVATE _POSIX_C_SOURCE=200809L Py_LIMITED_API=0x03070000)
target_compile_options(yoke_python PRIVATE -w -O1) # cffi writes most of it: 498 functions of the library, nothing that computes
target_link_libraries(yoke_python PRIVATE yoke_shared m)

file(GLOB YOKE_PYTHON_MODULES RELATIVE ${YOKE_PYTHON_SOURCE} CONFIGURE_DEPENDS python/yoke/*.py python/yoke/*.pyi python/yoke/py.typed)
foreach(module ${YOKE_PYTHON_MODULES})
  add_custom_command(OUTPUT ${YOKE_PYTHON_DIR}/${module} DEPENDS ${YOKE_PYTHON_SOURCE}/${module} VERBATIM
    COMMAND ${CMAKE_COMMAND} -E copy ${YOKE_PYTHON_SOURCE}/${module} ${YOKE_PYTHON_DIR}/${module})
  list(APPEND YOKE_PYTHON_COPIES ${YOKE_PYTHON_DIR}/${module})
  list(APPEND YOKE_PYTHON_INSTALLED ${YOKE_PYTHON_SOURCE}/${module})
endforeach()
add_custom_target(yoke_python_modules ALL DEPENDS ${YOKE_PYTHON_COPIES})

# Where Debian's python3 looks; only in the package python3-yoke, since another prefix has another place for modules.
set(YOKE_PYTHON_PACKAGES lib/python3/dist-packages/yoke)
install(TARGETS yoke_python LIBRARY DESTINATION ${YOKE_PYTHON_PACKAGES} COMPONENT python EXCLUDE_FROM_ALL)
install(FILES ${YOKE_PYTHON_INSTALLED} DESTINATION ${YOKE_PYTHON_PACKAGES} COMPONENT python EXCLUDE_FROM_ALL)
