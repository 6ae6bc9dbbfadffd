#include "tests/support/scarce_memory.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

// Compiled for each program (CMakeLists.txt, add_program): one without threads may keep nothing per thread.
#ifdef DOCTEST_CONFIG_NO_MULTITHREADING
#define PER_THREAD
#else
#define PER_THREAD thread_local
#endif

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
PER_THREAD std::size_t limit = kNoLimit;
PER_THREAD std::size_t given = 0;
std::atomic<std::size_t> live = 0, most = 0;

void* tryAllocate(std::size_t size) noexcept {
  if (size >= limit) return nullptr;
  given += size;
  void* memory = std::malloc(size > 0 ? size : 1);
  const std::size_t now = live += malloc_usable_size(memory);
  std::size_t before = most;
  while (before < now && !most.compare_exchange_weak(before, now)) {
  }
  return memory;
}

void release(void* memory) noexcept {
  live -= malloc_usable_size(memory);
  std::free(memory);
}

void* allocate(std::size_t size) {
  if (void* memory = tryAllocate(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// The program's allocation functions, all forms of unaligned memory, so that none is freed by
// another family than it came from.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return tryAllocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return tryAllocate(size); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

namespace spineloft::testing {

ScarceMemory::ScarceMemory(std::size_t bytes) { limit = bytes; }
ScarceMemory::~ScarceMemory() { limit = kNoLimit; }
std::size_t allocatedBytes() { return given; }
std::size_t liveBytes() { return live; }
std::size_t mostLiveBytes() { return most; }
void forgetMostLiveBytes() { most = live.load(); }

}  // namespace spineloft::testing
