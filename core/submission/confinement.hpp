#pragma once

#include "core/math/fields.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace raylab {

/// What is taken from a program before it starts: the argument of raylab-confine, as JSON. Each layer holds by itself, so
/// that one that a machine lacks leaves the others.
struct Confinement {
  int uid = 0;                           ///< user and group to become, or 0: stays who it is. Only root can
  std::vector<std::string> environment;  ///< "NAME=VALUE": all that there is
  bool limits = false;                   ///< the next five; 0 is none at all
  std::int64_t address_space = 0;        ///< bytes
  std::int64_t processor_time = 0;       ///< seconds
  std::int64_t processes = 0;            ///< and threads of this user, if not 0
  std::int64_t file_size = 0;            ///< bytes of a file that is written
  std::int64_t open_files = 0;
  bool files = false;                 ///< by Landlock, nothing but these and what is in them
  std::vector<std::string> readable;  ///< and executable
  std::vector<std::string> writable;
  bool calls = false;  ///< by seccomp: no sockets, no other process's memory, no shared memory, no namespaces, no mounts
  bool alone = false;  ///< with `calls`: nor other processes or threads, which it can neither start nor signal
};
RAYLAB_FIELDS(Confinement,
              RAYLAB_OPTIONAL_FIELD(uid) RAYLAB_OPTIONAL_FIELD(environment) RAYLAB_OPTIONAL_FIELD(limits)
                  RAYLAB_OPTIONAL_FIELD(address_space) RAYLAB_OPTIONAL_FIELD(processor_time) RAYLAB_OPTIONAL_FIELD(processes)
                      RAYLAB_OPTIONAL_FIELD(file_size) RAYLAB_OPTIONAL_FIELD(open_files) RAYLAB_OPTIONAL_FIELD(files)
                          RAYLAB_OPTIONAL_FIELD(readable) RAYLAB_OPTIONAL_FIELD(writable) RAYLAB_OPTIONAL_FIELD(calls)
                              RAYLAB_OPTIONAL_FIELD(alone))

}  // namespace raylab
