# Two components: `development` is the library for find_package(osculate) and pkg-config, `program` the osculate program
# with its catalogue of shapes. `cmake --install BUILD --component program` installs one alone.
include(CMakePackageConfigHelpers)
set(OSCULATE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/osculate)

install(TARGETS osculate EXPORT osculateTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY include/osculate DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
if(OSCULATE_BUILD_C)
  install(TARGETS osculate_c EXPORT osculateTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  # The prefix is found from where the file stands, so that an installed tree may be moved.
  set(pkgconfig_dir ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH OSCULATE_PC_PREFIX ${pkgconfig_dir} ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" OSCULATE_PC_PREFIX ${OSCULATE_PC_PREFIX})
  configure_file(cmake/osculate.pc.in osculate.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/osculate.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endif()
if(OSCULATE_BUILD_FORTRAN)
  install(TARGETS osculate_fortran EXPORT osculateTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(FILES ${PROJECT_BINARY_DIR}/src/fortran/modules/osculate.mod
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/fortran/osculate COMPONENT development)
  install(FILES src/fortran/osculate.f90 DESTINATION ${CMAKE_INSTALL_DATADIR}/osculate/fortran COMPONENT development)
  configure_file(cmake/osculate-fortran.pc.in osculate-fortran.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/osculate-fortran.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endif()
install(EXPORT osculateTargets NAMESPACE osculate:: DESTINATION ${OSCULATE_CMAKE_DIR} COMPONENT development)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)

if(OSCULATE_BUILD_PROGRAM)
  install(TARGETS osculate_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  if(OSCULATE_HAS_LAMMPS)
    install(TARGETS osculate_lammps_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  endif()
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
