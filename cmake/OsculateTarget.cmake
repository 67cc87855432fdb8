# Warnings and processor options shared by every target of the project.
function(osculate_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    $<$<BOOL:${OSCULATE_WARNINGS_AS_ERRORS}>:-Werror> $<$<BOOL:${OSCULATE_NATIVE}>:-march=native>
    # errno and floating-point traps are not used; with them sqrt and select would not be one instruction.
    -fno-math-errno -fno-trapping-math)
  if(OSCULATE_NATIVE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 12 warns about its own AVX-512 header (GCC bug 105593).
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # A mask of one lane is a bool; the same formulas combine masks of many.
    target_compile_options(${target} PRIVATE -Wno-bitwise-instead-of-logical)
  endif()
  # Highway compiles the batched kernels for AVX-512, AVX2 and the portable baseline and picks at run time; the targets
  # between these would only cost compile time. For one machine there is one target, and nothing to pick.
  if(OSCULATE_NATIVE)
    target_compile_definitions(${target} PRIVATE HWY_COMPILE_ONLY_STATIC)
  else()
    target_compile_definitions(${target} PRIVATE "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_SSE4|HWY_AVX3_DL)")
  endif()
endfunction()

# Every source of a room, so that a new theory or shape is its own file and nothing else.
function(osculate_sources variable room)
  file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${room}/*.cpp)
  set(${variable} ${found} PARENT_SCOPE)
endfunction()
