# Builds the program in APP_DIR as a Makefile of a user would: one call of the compiler with what
# pkg-config says about PREFIX, which LIBDIR below it says where to find. Then runs it.

find_program(pkg_config NAMES pkg-config pkgconf REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/${LIBDIR}/pkgconfig)
execute_process(COMMAND ${pkg_config} --cflags --libs wellstrat
  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")

cmake_path(GET PROGRAM PARENT_PATH folder)
file(MAKE_DIRECTORY ${folder})
execute_process(
  COMMAND ${CXX} -std=c++17 -O1 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
    -I${ALL_HEADERS_DIR} ${APP_DIR}/main.cpp ${APP_DIR}/second.cpp ${flags} -o ${PROGRAM}
  COMMAND_ERROR_IS_FATAL ANY)
set(ENV{LD_LIBRARY_PATH} ${PREFIX}/${LIBDIR})
execute_process(COMMAND ${PROGRAM} COMMAND_ERROR_IS_FATAL ANY)
