// Makes large allocations of the calling thread fail, so that OutOfMemory can be tested, and counts them; counts what
// all threads hold.
#pragma once

#include <cstddef>

namespace spineloft::testing {

/// While it lives, `operator new` of this thread throws std::bad_alloc for requests of `limit`
/// bytes or more. Do not nest.
class ScarceMemory {
 public:
  explicit ScarceMemory(std::size_t limit);
  ~ScarceMemory();
  ScarceMemory(const ScarceMemory&) = delete;
  ScarceMemory& operator=(const ScarceMemory&) = delete;
};

/// Bytes that `operator new` has given to this thread so far.
std::size_t allocatedBytes();
/// Bytes that `operator new` has given to all threads and that were not given back, and the most of them since the
/// program began or `forgetMostLiveBytes`.
std::size_t liveBytes();
std::size_t mostLiveBytes();
void forgetMostLiveBytes();

}  // namespace spineloft::testing
