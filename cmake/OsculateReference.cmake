# The target `reference`: Doxygen's pages of the public headers, a warning being an error.
find_program(OSCULATE_DOXYGEN doxygen)
# doxygen 1.9.4 reads beyond its strings (valgrind shows it); in a UTF-8 locale that ends it in some folders.
if(OSCULATE_DOXYGEN)
  configure_file(docs/Doxyfile.in Doxyfile @ONLY)
  add_custom_target(reference COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/reference
    COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${OSCULATE_DOXYGEN} ${CMAKE_CURRENT_BINARY_DIR}/Doxyfile
    COMMENT "Writing the reference to ${PROJECT_BINARY_DIR}/reference/html" VERBATIM)
endif()
