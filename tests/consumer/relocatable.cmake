# No text file below one of PREFIXES names that prefix or one of the FORBIDDEN folders.

foreach(prefix IN LISTS PREFIXES)
  file(GLOB_RECURSE files ${prefix}/*.cmake ${prefix}/*.pc ${prefix}/*.h)
  foreach(file IN LISTS files)
    file(READ ${file} text)
    foreach(folder ${prefix} ${FORBIDDEN})
      string(FIND "${text}" "${folder}" position)
      if(NOT position EQUAL -1)
        message(SEND_ERROR "${file} names ${folder}")
      endif()
    endforeach()
  endforeach()
endforeach()
