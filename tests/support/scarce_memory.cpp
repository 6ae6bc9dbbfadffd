#include "tests/support/scarce_memory.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
thread_local std::size_t limit = kNoLimit;

void* allocate(std::size_t size) {
  if (size >= limit) throw std::bad_alloc();
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// The program's allocation functions; array and nothrow forms call these.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace spineloft::testing {

ScarceMemory::ScarceMemory(std::size_t bytes) { limit = bytes; }
ScarceMemory::~ScarceMemory() { limit = kNoLimit; }

}  // namespace spineloft::testing
