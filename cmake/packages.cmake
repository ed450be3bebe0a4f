# Debian packages by component: `cpack` in the build folder gives yoke, libyoke-dev, yoke-doc and, where the Python package is built,
# python3-yoke.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME yoke)
set(CPACK_PACKAGE_CONTACT "The Yoke developers <yoke@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL runtime dev doc)
if(TARGET yoke_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR})

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME yoke)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
# Other packages then depend on the version whose functions they use.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/debian/symbols)
add_custom_command(TARGET yoke_shared POST_BUILD VERBATIM COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/debian
  COMMAND sh ${CMAKE_SOURCE_DIR}/tools/list-symbols $<TARGET_FILE:yoke_shared> ${PROJECT_VERSION} > ${CMAKE_BINARY_DIR}/debian/symbols)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "gnuplot-nox, librsvg2-bin")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Answers what a course in kinematics and machine dynamics asks of linkages, gears and cams.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libyoke-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "yoke (= ${PROJECT_VERSION}), libyaml-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "For programs that use libyoke; with pkg-config and CMake files.")

set(CPACK_DEBIAN_DOC_PACKAGE_NAME yoke-doc)
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_DOC_DESCRIPTION "The guide, the mathematics with its sources, and the gallery of machines.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-yoke)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.9), python3-cffi-backend, python3-numpy, yoke (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-tqdm, python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/cmake/python3-yoke/postinst ${CMAKE_SOURCE_DIR}/cmake/python3-yoke/prerm)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Yoke in Python: planar machines in programs and notebooks, with NumPy.")
include(CPack)
