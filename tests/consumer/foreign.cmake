# The example quick_look of EXAMPLES in another LANGUAGE prints what README says, by the library that
# is installed in PREFIX and is of this KIND, static or shared. PROGRAM is the compiler or interpreter
# of the language. Programs are built in FOLDER, as a Makefile of a user would, or for the language
# `cmake` by a project in C.

if(NOT PROGRAM)
  message("skipped: ${LANGUAGE} needs a compiler that is not installed")
  return()
endif()

# The block of README's that scripts/check-doc-snippets compares with the program in C++.
file(READ ${README} text)
string(REGEX MATCH "output: quick_look -->\n```text\n([^`]*)```" block "${text}")
set(expected "${CMAKE_MATCH_1}")

find_program(pkg_config NAMES pkg-config pkgconf REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/${LIBDIR}/pkgconfig)
set(ENV{LD_LIBRARY_PATH} ${PREFIX}/${LIBDIR})
set(static)
if(KIND STREQUAL "static")
  set(static --static)
endif()
execute_process(COMMAND ${pkg_config} --cflags --libs ${static} wellstrat
  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
file(MAKE_DIRECTORY ${FOLDER})

# build(COMMAND...)
function(build)
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${FOLDER} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(run ${FOLDER}/quick_look)
if(LANGUAGE STREQUAL "c")
  build(${PROGRAM} -std=c99 -pedantic -Wall -Wextra -Werror ${EXAMPLES}/quick_look.c ${flags} -o ${run})
elseif(LANGUAGE STREQUAL "fortran")
  build(${PROGRAM} -std=f2008 -Wall -Wextra -Werror ${EXAMPLES}/quick_look.f90 ${flags} -o ${run})
elseif(LANGUAGE STREQUAL "python")
  set(run ${PROGRAM} -B ${EXAMPLES}/quick_look.py ${PREFIX}/${LIBDIR}/libwellstrat.so)
elseif(LANGUAGE STREQUAL "cmake")
  build(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/c_app -B ${FOLDER} -DEXAMPLES=${EXAMPLES}
    -DCMAKE_C_COMPILER=${PROGRAM} -DCMAKE_PREFIX_PATH=${PREFIX})
  build(${CMAKE_COMMAND} --build ${FOLDER})
endif()
execute_process(COMMAND ${run} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "${LANGUAGE} prints:\n${printed}and should print:\n${expected}")
endif()
