#include "counted_allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

// The linker sends every call of malloc, calloc and realloc in this program here (--wrap); operator
// new of the shared library is replaced, for it would not be seen.
namespace {

std::atomic<long long> allocated{0};

}  // namespace

extern "C" {

void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t items, std::size_t size);
void* __real_realloc(void* old, std::size_t size);

void* __wrap_malloc(std::size_t size) {
  ++allocated;
  return __real_malloc(size);
}

void* __wrap_calloc(std::size_t items, std::size_t size) {
  ++allocated;
  return __real_calloc(items, size);
}

void* __wrap_realloc(void* old, std::size_t size) {
  ++allocated;
  return __real_realloc(old, size);
}

}  // extern "C"

void* operator new(std::size_t size) {
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size > 0 ? size : 1);
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

namespace graze::cost {

long long allocations() { return allocated; }

}  // namespace graze::cost
