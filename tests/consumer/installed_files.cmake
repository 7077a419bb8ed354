# Compares the files below PREFIX with the list in EXPECTED, where the library folder is "lib", but
# for those of NOT_BUILT.

file(GLOB_RECURSE found RELATIVE ${PREFIX} ${PREFIX}/*)
list(TRANSFORM found REPLACE "^${LIBDIR}/" "lib/")
list(SORT found)
file(STRINGS ${EXPECTED} expected)
if(NOT_BUILT)
  list(REMOVE_ITEM expected ${NOT_BUILT})
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
