# The same questions to shaders, of the source that is installed. What finds no device on this machine
# is skipped, and says so.
find_package(Vulkan QUIET)
find_package(OpenCL QUIET)
find_program(GLSLANG glslangValidator)
mark_as_advanced(GLSLANG)
set(shaders ${PROJECT_SOURCE_DIR}/include/wellstrat/shaders)
file(GLOB shader_sources CONFIGURE_DEPENDS ${shaders}/*
  ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*)

# shader_check(NAME SOURCES... [LINK libraries...]): gpu_check for another device.
function(shader_check name)
  cmake_parse_arguments(arg "" "" "LINK" ${ARGN})
  add_executable(${name} golden_questions.cpp gpu_check.cpp host.cpp ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE wellstrat::wellstrat Threads::Threads ${arg_LINK})
  add_test(NAME gpu.${name} COMMAND ${name} 1000000
    ${golden}/samples.txt ${golden}/joint.txt ${golden}/long.txt ${golden}/blue.txt)
  set_tests_properties(gpu.${name} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 120 LABELS gpu)
endfunction()

# spirv_check(NAME SOURCE OPTIONS...): a compute shader on Vulkan.
function(spirv_check name source)
  set(spirv ${CMAKE_CURRENT_BINARY_DIR}/${name}.spv)
  add_custom_command(OUTPUT ${spirv}
    COMMAND ${GLSLANG} ${ARGN} --target-env vulkan1.1 --quiet -I${PROJECT_SOURCE_DIR}/include
            ${CMAKE_CURRENT_SOURCE_DIR}/shaders/${source} -o ${spirv}
    DEPENDS ${shader_sources} VERBATIM)
  shader_check(${name} vulkan.cpp ${spirv} LINK Vulkan::Vulkan)
  target_compile_definitions(${name} PRIVATE WELLSTRAT_ANSWER_SPIRV="${spirv}")
endfunction()

if(Vulkan_FOUND AND GLSLANG)
  spirv_check(glsl_check answer.comp -V)
  spirv_check(hlsl_check answer.hlsl -D -S comp -e main)
else()
  message(STATUS "No Vulkan or glslangValidator: GLSL and HLSL are not tested")
endif()

if(OpenCL_FOUND)
  shader_check(opencl_check opencl.cpp LINK OpenCL::OpenCL)
  target_compile_definitions(opencl_check PRIVATE WELLSTRAT_SOURCES="${PROJECT_SOURCE_DIR}")
else()
  message(STATUS "No OpenCL: its kernels are not tested")
endif()

if(TARGET wellstrat_cli)
  add_executable(questions golden_questions.cpp host.cpp questions.cpp)
  target_link_libraries(questions PRIVATE wellstrat::wellstrat Threads::Threads)
  add_test(NAME gpu.browser COMMAND Python3::Interpreter -B -m unittest -v test_browser
           WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  # A browser is the same for all compilers: one preset is enough.
  set_tests_properties(gpu.browser PROPERTIES TIMEOUT 300 LABELS gpu_code ENVIRONMENT
    "WELLSTRAT=$<TARGET_FILE:wellstrat_cli>;WELLSTRAT_QUESTIONS=$<TARGET_FILE:questions>")
endif()
