# RixRNG.h stays cheap to include: it takes under 0.2 s of compile time because it drags in little.
# Time varies with the machine; the number of lines that the compiler gets to see does not.

set(limit 6000)
execute_process(COMMAND ${CXX} -std=c++17 -E -P -I${INCLUDE_DIR} -include RixRNG.h -x c++ /dev/null
  OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n" lines "${text}")
list(LENGTH lines count)
message(STATUS "RixRNG.h: ${count} lines after preprocessing, at most ${limit}")
if(count GREATER limit)
  message(FATAL_ERROR "RixRNG.h includes too much")
endif()
