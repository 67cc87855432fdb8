# Two components: `development` is the core library for find_package(osculate), `program` the osculate program with its
# catalogue of shapes. `cmake --install BUILD --component program` installs one alone.
include(CMakePackageConfigHelpers)
set(OSCULATE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/osculate)

install(TARGETS osculate EXPORT osculateTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY include/osculate DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.hpp")
install(EXPORT osculateTargets NAMESPACE osculate:: DESTINATION ${OSCULATE_CMAKE_DIR} COMPONENT development)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)

if(OSCULATE_BUILD_PROGRAM)
  install(TARGETS osculate_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(DIRECTORY shapes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/osculate/shapes COMPONENT program)
  install(DIRECTORY examples/contacts DESTINATION ${CMAKE_INSTALL_DATADIR}/osculate/examples COMPONENT program)
endif()

configure_package_config_file(cmake/osculateConfig.cmake.in osculateConfig.cmake
  INSTALL_DESTINATION ${OSCULATE_CMAKE_DIR})
write_basic_package_version_file(osculateConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/osculateConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/osculateConfigVersion.cmake
  DESTINATION ${OSCULATE_CMAKE_DIR} COMPONENT development)

# The same package from the build tree: -Dosculate_DIR=<build>.
export(EXPORT osculateTargets NAMESPACE osculate:: FILE ${CMAKE_CURRENT_BINARY_DIR}/osculateTargets.cmake)
