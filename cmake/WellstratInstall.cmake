# What `cmake --install` installs: headers, libraries, the CMake package and the pkg-config files.
# (The command line tools install themselves.) No installed file holds an absolute path: the tree may
# be moved.

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/wellstrat)
set(installed_components wellstrat debug)
set(installed_libraries wellstrat wellstrat_debug)
set(headers_left_out PATTERN analysis EXCLUDE)
if(TARGET wellstrat_analysis)
  list(APPEND installed_components analysis)
  list(APPEND installed_libraries wellstrat_analysis)
  set(headers_left_out)
endif()

install(TARGETS ${installed_libraries} EXPORT wellstratTargets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h" ${headers_left_out})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/wellstrat/shaders
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/wellstrat)
install(FILES ${PROJECT_BINARY_DIR}/include/wellstrat/version.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/wellstrat)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Shared libraries find each other, and the tools find them, wherever the tree stands.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_FULL_BINDIR}
  OUTPUT_VARIABLE bin_to_lib)
set_target_properties(${installed_libraries} PROPERTIES INSTALL_RPATH "$ORIGIN")
foreach(tool wellstrat_cli wellstrat_render)
  if(TARGET ${tool})
    set_target_properties(${tool} PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
  endif()
endforeach()

install(EXPORT wellstratTargets NAMESPACE wellstrat:: DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/wellstratConfig.cmake.in
  ${PROJECT_BINARY_DIR}/wellstratConfig.cmake
  INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/wellstratConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/wellstratConfig.cmake
              ${PROJECT_BINARY_DIR}/wellstratConfigVersion.cmake
  DESTINATION ${package_dir})

# Relative to the file's own place, which pkg-config calls pcfiledir.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX
  BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig OUTPUT_VARIABLE pc_prefix)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}
  OUTPUT_VARIABLE pc_libdir)
cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_INCLUDEDIR BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}
  OUTPUT_VARIABLE pc_includedir)
set(pc_description_wellstrat "${PROJECT_DESCRIPTION}")
set(pc_description_wellstrat-debug "Finds the mistakes that integrators make with sample domains")
set(pc_description_wellstrat-analysis "Measures point sets and samples: nets, discrepancies, errors")
list(TRANSFORM WELLSTRAT_CXX_RUNTIME PREPEND -l OUTPUT_VARIABLE cxx_runtime)
list(JOIN cxx_runtime " " pc_libs_private_wellstrat)
set(pc_libs_private_wellstrat-analysis -lfftw3)
foreach(library IN LISTS installed_libraries)
  string(REPLACE _ - pc_name ${library})
  set(pc_description "${pc_description_${pc_name}}")
  set(pc_libs_private ${pc_libs_private_${pc_name}})
  set(pc_requires "wellstrat = ${PROJECT_VERSION}")
  if(library STREQUAL "wellstrat")
    set(pc_requires)
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/wellstrat.pc.in ${PROJECT_BINARY_DIR}/${pc_name}.pc
    @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc_name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
