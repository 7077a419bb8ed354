# Compiles golden_check as a user would, with a compiler and flags of their own, links it to the
# library as it was built, and runs it: what is inline in the headers must give the same bits.
#
#   cmake -DCXX=compiler -DLAUNCHER=ccache-or-nothing "-DFLAGS=-O1;..." "-DINCLUDE_DIRS=...;..."
#         -DLIBRARY=file -DSOURCE_DIR=folder -DPROGRAM=result -P user_flags.cmake

list(TRANSFORM INCLUDE_DIRS PREPEND -I)
cmake_path(GET LIBRARY PARENT_PATH library_dir)
set(object ${PROGRAM}.o)
execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND ${LAUNCHER} ${CXX} -std=c++17 ${FLAGS} ${INCLUDE_DIRS}
    -c ${SOURCE_DIR}/golden_check.cpp -o ${object})
execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND ${CXX} ${FLAGS} ${object} ${LIBRARY} -Wl,-rpath,${library_dir} -o ${PROGRAM})
execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND ${PROGRAM} ${SOURCE_DIR}/samples.txt ${SOURCE_DIR}/joint.txt ${SOURCE_DIR}/long.txt
    ${SOURCE_DIR}/blue.txt)
