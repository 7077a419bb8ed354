# Included by a build that may look for nothing: neither for packages nor for libraries.

macro(find_package name)
  message(FATAL_ERROR "The library alone looks for the package ${name}")
endmacro()

macro(find_library variable)
  message(FATAL_ERROR "The library alone looks for a library: ${ARGN}")
endmacro()
