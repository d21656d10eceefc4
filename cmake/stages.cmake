# The list of stages, stages/list.txt, is the one place where a stage is entered. From it come RAYLAB_STAGES and the header
# "stages/stages.hpp" with all contracts, RAYLAB_STAGES(STAGE) and RAYLAB_TASKS(TASK).

set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/stages/list.txt)
file(STRINGS ${PROJECT_SOURCE_DIR}/stages/list.txt RAYLAB_STAGES REGEX "^[0-9]")

set(includes "")
set(stages "")
set(tasks "")
foreach(folder IN LISTS RAYLAB_STAGES)
  if(NOT folder MATCHES "^([0-9][0-9])_([a-z0-9_]+)$")
    message(FATAL_ERROR "stages/list.txt: '${folder}' is not like 05_reflections: two digits, _, a lower-case name")
  endif()
  math(EXPR number "${CMAKE_MATCH_1}")
  string(REPLACE "_" "-" name "${CMAKE_MATCH_2}")
  string(TOUPPER ${folder} macro)
  string(APPEND includes "#include \"stages/${folder}/stage.hpp\"\n")
  string(APPEND stages " \\\n  STAGE(${number}, \"${name}\", \"${folder}\")")
  string(APPEND tasks " \\\n  RAYLAB_TASKS_${macro}(TASK)")
endforeach()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/stages/stages.hpp CONTENT [[
// Generated from stages/list.txt.
#pragma once

@includes@
#define RAYLAB_STAGES(STAGE)@stages@

#define RAYLAB_TASKS(TASK)@tasks@
]])

# raylab_add_implementation(NAME FILE...): an object library raylab_NAME with an implementation of all stages, each in its
# own namespace raylab::NAME, and the one C symbol raylab_tasks_NAME that gives them out.
function(raylab_add_implementation name)
  add_library(raylab_${name} OBJECT ${ARGN} ${PROJECT_SOURCE_DIR}/stages/export_tasks.cpp)
  target_compile_definitions(raylab_${name} PRIVATE RAYLAB_IMPLEMENTATION=${name})
  target_link_libraries(raylab_${name} PRIVATE raylab_math)
endfunction()

# raylab_add_submission(NAME FOLDER): the same of a submission's folder. What has no file there is the solution's.
function(raylab_add_submission name folder)
  file(GLOB present CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.cpp)
  set(files "")
  foreach(stage IN LISTS RAYLAB_STAGES)
    if("${stage}.cpp" IN_LIST present)
      list(APPEND files ${folder}/${stage}.cpp)
    else()
      list(APPEND files ${PROJECT_SOURCE_DIR}/reference/solution/${stage}.cpp)
    endif()
  endforeach()
  raylab_add_implementation(${name} ${files})
endfunction()
