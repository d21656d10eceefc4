#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace raylab::fast {

/// Calls task(i) for each i below `count`, in no certain order, in up to `threads` threads, this one among them. Throws what
/// a task throws.
template <class Task>
void in_parallel(std::size_t count, unsigned threads, Task task) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      while (others.size() + 1 < std::min<std::size_t>(threads, count)) others.emplace_back(work);
    } catch (const std::system_error&) {  // the system gives no more of them: those that there are do the work
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

/// The share `i` of `parts` equal shares of 0..count.
struct Share {
  std::size_t begin, end;

  Share(std::size_t count, std::size_t i, std::size_t parts) : begin(count * i / parts), end(count * (i + 1) / parts) {}
};

}  // namespace raylab::fast
