# Builds the release preset if sources changed: cmake -P cmake/build.cmake. A lock lets only one run build at a time.
cmake_minimum_required(VERSION 3.25)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
set(build ${root}/build/release)

file(LOCK ${build} DIRECTORY GUARD PROCESS TIMEOUT 1800)

macro(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${root} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "raylab: building failed: the reason stands above")
  endif()
endmacro()

if(NOT EXISTS ${build}/build.ninja)
  run(${CMAKE_COMMAND} --preset release --log-level=WARNING)
endif()
execute_process(COMMAND ninja -C ${build} -n OUTPUT_VARIABLE plan)
if(NOT plan MATCHES "no work to do")
  run(ninja -C ${build})
endif()
