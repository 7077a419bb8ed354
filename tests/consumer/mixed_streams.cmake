# A program that was compiled with the headers of one stream must not run with a library of another,
# which has other samples: linking fails, or if the libraries are shared, loading does. The library
# of another stream is made of a copy of SOURCE_DIR in FOLDER.

set(stream stream1)
set(other_stream stream2)

file(REMOVE_RECURSE ${FOLDER}/tree)
file(COPY ${SOURCE_DIR}/CMakeLists.txt ${SOURCE_DIR}/LICENSE ${SOURCE_DIR}/cmake
  ${SOURCE_DIR}/include ${SOURCE_DIR}/src DESTINATION ${FOLDER}/tree)
file(GLOB_RECURSE files ${FOLDER}/tree/include/* ${FOLDER}/tree/src/*)
foreach(file IN LISTS files)
  file(READ ${file} text)
  string(REPLACE ${stream} ${other_stream} text "${text}")
  file(WRITE ${file} "${text}")
endforeach()
foreach(shared OFF ON)
  execute_process(COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET
    COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${FOLDER}/tree -DBUILD_DIR=${FOLDER}/${shared}
      -DPREFIX=${FOLDER}/prefix_${shared} -DCXX=${CXX} -DLAUNCHER=${LAUNCHER}
      -DOPTIONS=-DBUILD_SHARED_LIBS=${shared} -P ${CMAKE_CURRENT_LIST_DIR}/install.cmake)
endforeach()

# link(FOLDER RESULT): links the program with the library in a folder.
function(link library_dir result)
  execute_process(COMMAND ${CXX} ${FOLDER}/program.o -L${library_dir} -lwellstrat -Wl,-z,now
      -o ${FOLDER}/program
    RESULT_VARIABLE status ERROR_VARIABLE output)
  set(${result} ${status} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

# fails_by_name(WHAT STATUS): the last thing that was tried failed, and its output names the stream.
function(fails_by_name what status)
  if(status EQUAL 0 OR NOT output MATCHES "undefined[^\n]*wellstrat[^\n]*${stream}")
    message(SEND_ERROR "${what} ends with ${status} and should name ${stream}:\n${output}")
  endif()
endfunction()

execute_process(COMMAND ${CXX} -std=c++17 -O2 -I${PREFIX}/include -c ${PROGRAM}
    -o ${FOLDER}/program.o COMMAND_ERROR_IS_FATAL ANY)
foreach(shared OFF ON)
  link(${FOLDER}/prefix_${shared}/${LIBDIR} status)
  fails_by_name("Linking with another stream's library (shared: ${shared})" ${status})
endforeach()

link(${PREFIX}/${LIBDIR} status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "The program does not link with its own library:\n${output}")
endif()
set(ENV{LD_LIBRARY_PATH} ${PREFIX}/${LIBDIR})
execute_process(COMMAND ${FOLDER}/program COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
set(ENV{LD_LIBRARY_PATH} ${FOLDER}/prefix_ON/${LIBDIR})
execute_process(COMMAND ${FOLDER}/program RESULT_VARIABLE status ERROR_VARIABLE output OUTPUT_QUIET)
fails_by_name("Running with another stream's library" ${status})
message(STATUS "${output}")
