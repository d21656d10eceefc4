#pragma once

namespace raylab {

/// The processor time of the calling thread, in seconds: what else its core does meanwhile does not count. Where the system
/// does not tell, the time that passes.
double thread_seconds();

}  // namespace raylab
