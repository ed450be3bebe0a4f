# The files of `cmake --install` and their places. Everything is relocatable: the prefix may change at install time.
include(CMakePackageConfigHelpers)
set(YOKE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/yoke)

install(DIRECTORY include/yoke DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev FILES_MATCHING PATTERN "*.h")
install(TARGETS yoke_core ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(TARGETS yoke_shared EXPORT yoke_targets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime
  NAMELINK_COMPONENT dev)
install(TARGETS yoke RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)

# find_package(yoke) gives yoke::yoke
install(EXPORT yoke_targets NAMESPACE yoke:: FILE yokeTargets.cmake DESTINATION ${YOKE_PACKAGE_DIR} COMPONENT dev)
configure_package_config_file(cmake/yokeConfig.cmake.in ${CMAKE_BINARY_DIR}/yokeConfig.cmake
  INSTALL_DESTINATION ${YOKE_PACKAGE_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/yokeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/yokeConfig.cmake ${CMAKE_BINARY_DIR}/yokeConfigVersion.cmake DESTINATION ${YOKE_PACKAGE_DIR} COMPONENT dev)

# pkg-config: the prefix is found from the place of the .pc file
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  set(YOKE_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
  set(YOKE_PC_LIBDIR ${CMAKE_INSTALL_FULL_LIBDIR})
  set(YOKE_PC_INCLUDEDIR ${CMAKE_INSTALL_FULL_INCLUDEDIR})
else()
  file(RELATIVE_PATH YOKE_PC_UP /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  string(REGEX REPLACE "/$" "" YOKE_PC_UP "${YOKE_PC_UP}")
  set(YOKE_PC_PREFIX "\${pcfiledir}/${YOKE_PC_UP}")
  set(YOKE_PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
  set(YOKE_PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
configure_file(cmake/yoke.pc.in ${CMAKE_BINARY_DIR}/yoke.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/yoke.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

# The page of Studio, if the preset `wasm` has built it.
install(DIRECTORY ${YOKE_STUDIO_BUILT}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/yoke/studio COMPONENT runtime OPTIONAL)
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/yoke/examples COMPONENT doc FILES_MATCHING PATTERN "*.yaml" PATTERN "README.md"
  PATTERN "*.c" PATTERN "*.cpp"
  PATTERN "expected" EXCLUDE)
# The target `studio` builds that preset.
add_custom_target(studio
  COMMAND ${CMAKE_COMMAND} --preset wasm
  COMMAND ${CMAKE_COMMAND} --build --preset wasm
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} USES_TERMINAL VERBATIM)
install(FILES schema/yoke.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/yoke COMPONENT runtime)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc FILES_MATCHING PATTERN "*.md")
install(FILES completions/yoke.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME yoke COMPONENT runtime OPTIONAL)
install(FILES completions/_yoke DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT runtime OPTIONAL)
install(FILES completions/yoke.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT runtime OPTIONAL)
