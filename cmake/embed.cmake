# raylab_embed(TARGET FILE SYMBOL): builds a text file, named relative to the folder, into a target. The target's sources
# include "FOLDER/SYMBOL.hpp", which declares `raylab::SYMBOL`, a std::string_view. An edit of the file builds it anew.
#
# This file is its own script too: called with -P, it writes the two sources.

if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(RAYLAB_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

  function(raylab_embed target file symbol)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
    set(output ${PROJECT_BINARY_DIR}/generated/${folder}/${symbol})
    add_custom_command(
      OUTPUT ${output}.hpp ${output}.cpp
      COMMAND ${CMAKE_COMMAND} -D FILE=${CMAKE_CURRENT_SOURCE_DIR}/${file} -D NAME=${folder}/${file} -D SYMBOL=${symbol} -D
              OUTPUT=${output} -D INCLUDED=${folder}/${symbol}.hpp -P ${RAYLAB_EMBED_SCRIPT}
      DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${RAYLAB_EMBED_SCRIPT}
      VERBATIM)
    target_sources(${target} PRIVATE ${output}.hpp ${output}.cpp)
  endfunction()
  return()
endif()

# One character at a time: compilers limit how long a string literal may be.
file(READ ${FILE} bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")

file(
  WRITE ${OUTPUT}.hpp
  "#pragma once

#include <string_view>

namespace raylab {

/// The text of ${NAME}.
extern const std::string_view ${SYMBOL};

}  // namespace raylab
")
file(
  WRITE ${OUTPUT}.cpp
  "#include \"${INCLUDED}\"

namespace raylab {
namespace {

const char text[] = {
${bytes}};

}  // namespace

const std::string_view ${SYMBOL}(text, sizeof text);

}  // namespace raylab
")
