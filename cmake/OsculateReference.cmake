# The target `reference`: Doxygen's pages of the public headers, a warning being an error.
find_program(OSCULATE_DOXYGEN doxygen)
if(OSCULATE_DOXYGEN)
  configure_file(docs/Doxyfile.in Doxyfile @ONLY)
  add_custom_target(reference COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/reference
    COMMAND ${OSCULATE_DOXYGEN} ${CMAKE_CURRENT_BINARY_DIR}/Doxyfile
    COMMENT "Writing the reference to ${PROJECT_BINARY_DIR}/reference/html" VERBATIM)
endif()
