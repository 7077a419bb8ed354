# Compares the files below PREFIX with the list in EXPECTED, where the library folder is "lib". With
# WITHOUT given, files whose names fit that expression must not be there.

file(GLOB_RECURSE found RELATIVE ${PREFIX} ${PREFIX}/*)
list(TRANSFORM found REPLACE "^${LIBDIR}/" "lib/")
list(SORT found)
file(STRINGS ${EXPECTED} expected)
if(DEFINED WITHOUT)
  list(FILTER expected EXCLUDE REGEX "${WITHOUT}")
endif()
list(SORT expected)

set(missing ${expected})
list(REMOVE_ITEM missing ${found})
set(surplus ${found})
list(REMOVE_ITEM surplus ${expected})
if(missing OR surplus)
  list(JOIN missing "\n  " missing)
  list(JOIN surplus "\n  " surplus)
  message(FATAL_ERROR "Not installed, but in ${EXPECTED}:\n  ${missing}\n"
    "Installed, but not in that list:\n  ${surplus}")
endif()
