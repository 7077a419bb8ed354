# Installs BUILD_DIR to PREFIX, by way of another place, so that users of PREFIX show that the tree
# may be moved. With SOURCE_DIR given, that is configured with OPTIONS and built first.

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

if(DEFINED SOURCE_DIR)
  run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${BUILD_DIR} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} ${OPTIONS})
  run(${CMAKE_COMMAND} --build ${BUILD_DIR} --parallel 2)
endif()

file(REMOVE_RECURSE ${PREFIX} ${PREFIX}.first)
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX}.first)
file(RENAME ${PREFIX}.first ${PREFIX})
