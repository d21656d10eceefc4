#pragma once

namespace raylab {

/// Keeps a worker from what harms its user: it ends when raylab ends, and takes no more than 4 GiB of memory (but under the
/// address sanitizer, which reserves far more than it uses).
void limit_this_process();

}  // namespace raylab
