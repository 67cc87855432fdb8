include(CMakePackageConfigHelpers)
install(TARGETS osculate EXPORT osculateTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/osculate DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY shapes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/osculate/shapes)
install(EXPORT osculateTargets NAMESPACE osculate:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/osculate)
configure_package_config_file(cmake/osculateConfig.cmake.in osculateConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/osculate)
write_basic_package_version_file(osculateConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/osculateConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/osculateConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/osculate)
export(EXPORT osculateTargets NAMESPACE osculate:: FILE ${CMAKE_CURRENT_BINARY_DIR}/osculateTargets.cmake)
