# find_package and pkg_check_modules that say what to install when something is missing.
macro(osculate_missing name package purpose)
  message(FATAL_ERROR "${name} was not found; it is needed for ${purpose}. "
    "On Debian: apt-get install ${package}, or scripts/install-packages scripts/packages.txt for everything.")
endmacro()

# osculate_find(<name> <Debian package> <what it is for> [arguments of find_package]...)
macro(osculate_find name package purpose)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    osculate_missing(${name} ${package} ${purpose})
  endif()
endmacro()

# osculate_find_module(<prefix> <pkg-config module> <Debian package> <what it is for>): PkgConfig::<prefix>
macro(osculate_find_module prefix module package purpose)
  osculate_find(PkgConfig pkg-config ${purpose})
  pkg_check_modules(${prefix} QUIET IMPORTED_TARGET ${module})
  if(NOT ${prefix}_FOUND)
    osculate_missing(${module} ${package} ${purpose})
  endif()
endmacro()
