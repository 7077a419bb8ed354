# Builds programs of APP_DIR into FOLDER as a Makefile of a user would: one call of the compiler with
# what pkg-config says about PREFIX, which LIBDIR below it says where to find. Then runs them. KIND
# is that of the libraries, static or shared.

find_program(pkg_config NAMES pkg-config pkgconf REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/${LIBDIR}/pkgconfig)
set(ENV{LD_LIBRARY_PATH} ${PREFIX}/${LIBDIR})
set(static)
if(KIND STREQUAL "static")
  set(static --static)
endif()
file(MAKE_DIRECTORY ${FOLDER})

# build_and_run(PROGRAM PACKAGES packages... SOURCES files...)
function(build_and_run program)
  cmake_parse_arguments(arg "" "" "PACKAGES;SOURCES" ${ARGN})
  execute_process(COMMAND ${pkg_config} --cflags --libs ${static} ${arg_PACKAGES}
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  list(TRANSFORM arg_SOURCES PREPEND ${APP_DIR}/)
  execute_process(
    COMMAND ${CXX} -std=c++17 -O1 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
      -I${ALL_HEADERS_DIR} ${arg_SOURCES} ${flags} -o ${FOLDER}/${program}
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${FOLDER}/${program} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

build_and_run(app PACKAGES wellstrat SOURCES main.cpp second.cpp)
build_and_run(components PACKAGES wellstrat-analysis wellstrat-debug SOURCES components.cpp)
