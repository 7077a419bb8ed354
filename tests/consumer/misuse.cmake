# misuse.cpp must compile as it is, and must not with any of its MISUSE cases.

function(compile case result)
  execute_process(COMMAND ${CXX} -std=c++17 -fsyntax-only -I${INCLUDE_DIR} -DMISUSE=${case} ${SOURCE}
    RESULT_VARIABLE status ERROR_VARIABLE output)
  set(${result} ${status} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

compile(0 status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "The correct use does not compile:\n${output}")
endif()

file(READ ${SOURCE} text)
string(REGEX MATCHALL "MISUSE == [1-9][0-9]*" cases "${text}")
list(LENGTH cases count)
if(count EQUAL 0)
  message(FATAL_ERROR "${SOURCE} has no cases")
endif()
foreach(case IN LISTS cases)
  string(REPLACE "MISUSE == " "" case "${case}")
  compile(${case} status)
  if(status EQUAL 0)
    message(SEND_ERROR "MISUSE == ${case} compiles")
  endif()
endforeach()
message(STATUS "${count} misuses rejected")
