include(CMakeFindDependencyMacro)
find_dependency(wellstrat)
include(${CMAKE_CURRENT_LIST_DIR}/samplerTargets.cmake)
