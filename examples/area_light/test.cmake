# Runs area_light in small: the table must not depend on the number of threads, the images must be
# there, and bad arguments must end in one line and exit code 2.
# cmake -D PROGRAM=... -D OUTPUT=... -P test.cmake

file(REMOVE_RECURSE ${OUTPUT})

foreach(threads 1 3)
  execute_process(
    COMMAND ${PROGRAM} --size 32 --max-spp 16 --threads ${threads} ${OUTPUT}
    OUTPUT_VARIABLE table_${threads} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT table_1 STREQUAL table_3)
  message(FATAL_ERROR "1 and 3 threads differ:\n${table_1}\n${table_3}")
endif()
message(STATUS "${table_1}")

# Columns: branching, spp, rays, random, pmj, ratio. A ratio above 0.67 at 16 samples means that the
# samples are no longer stratified; it is a fixed number, for the samples are.
if(NOT table_1 MATCHES "\nplain +16 +16 +[0-9.]+ +[0-9.]+ +([0-9.]+)" OR CMAKE_MATCH_1 GREATER 0.67)
  message(FATAL_ERROR "pmj is not clearly better than random with 16 samples")
endif()

foreach(image reference plain_0016 split_0016 distribution_0016)
  if(NOT EXISTS ${OUTPUT}/${image}.png)
    message(FATAL_ERROR "${image}.png is missing")
  endif()
endforeach()

foreach(arguments "--size;0" "--size;big" "--max-spp;-4" "--colour" "a;b" "${PROGRAM}/folder")
  execute_process(COMMAND ${PROGRAM} ${arguments}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if(NOT code EQUAL 2 OR NOT output STREQUAL "" OR NOT error MATCHES "^area_light: [^\n]+\n$")
    message(FATAL_ERROR "area_light ${arguments}: exit code ${code}\n${output}${error}")
  endif()
endforeach()
