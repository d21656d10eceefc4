# Writes OUTPUT, a header with the commit that SOURCE stands at: cmake -D SOURCE=... -D OUTPUT=... -P commit.cmake.
# Without git, or outside of a repository, the commit is empty.
find_program(git git)
set(commit "")
set(modified false)
if(git)
  execute_process(COMMAND ${git} -C ${SOURCE} rev-parse --short=10 HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${git} -C ${SOURCE} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
  if(changes)
    set(modified true)
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#pragma once

namespace raylab::bench {

/// The commit that this program was built from, and whether files differed from it; empty if that is not known.
inline constexpr const char* commit = "@commit@";
inline constexpr bool commit_modified = @modified@;

}  // namespace raylab::bench
]])
file(TOUCH ${OUTPUT})  # CONFIGURE leaves a file that would stay the same, and then it would be made at each build
