# As C++14, the first error in each of HEADERS (a list) is the one that says what is needed.

foreach(header IN LISTS HEADERS)
  execute_process(
    COMMAND ${CXX} -std=c++14 -fsyntax-only -Wfatal-errors -I${INCLUDE_DIR} -I${GENERATED_DIR}
      -include ${header} -x c++ /dev/null
    RESULT_VARIABLE status ERROR_VARIABLE output)
  if(status EQUAL 0 OR NOT output MATCHES "error: [^\n]*wellstrat needs C\\+\\+17")
    message(SEND_ERROR "${header} as C++14:\n${output}")
  endif()
endforeach()
list(LENGTH HEADERS count)
message(STATUS "${count} headers ask for C++17")
