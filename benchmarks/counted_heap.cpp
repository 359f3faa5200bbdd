#include "counted_heap.hpp"

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace rmap::bench {

namespace {

std::atomic<bool> counts = false;
std::atomic<std::size_t> taken_bytes = 0;
std::atomic<std::size_t> peak_bytes = 0;

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  if (!counts.load(std::memory_order_relaxed)) return memory;
  const std::size_t size = malloc_usable_size(memory);
  const std::size_t now = taken_bytes.fetch_add(size) + size;
  std::size_t peak = peak_bytes.load();
  while (now > peak && !peak_bytes.compare_exchange_weak(peak, now)) {
  }
  return memory;
}

void uncounted(void* memory) {
  if (memory != nullptr && counts.load(std::memory_order_relaxed)) {
    taken_bytes.fetch_sub(malloc_usable_size(memory));
  }
  std::free(memory);
}

}  // namespace

HeapCount::HeapCount() {
  taken_bytes = 0;
  peak_bytes = 0;
  counts = true;
}
HeapCount::~HeapCount() { counts = false; }
std::size_t HeapCount::in_use() const { return taken_bytes.load(); }
std::size_t HeapCount::peak() const { return peak_bytes.load(); }

}  // namespace rmap::bench

void* operator new(std::size_t size) { return rmap::bench::counted(std::malloc(size)); }
void* operator new[](std::size_t size) { return rmap::bench::counted(std::malloc(size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return rmap::bench::counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return operator new(size, alignment);
}
void operator delete(void* memory) noexcept { rmap::bench::uncounted(memory); }
void operator delete[](void* memory) noexcept { rmap::bench::uncounted(memory); }
void operator delete(void* memory, std::size_t) noexcept { rmap::bench::uncounted(memory); }
void operator delete[](void* memory, std::size_t) noexcept { rmap::bench::uncounted(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { rmap::bench::uncounted(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { rmap::bench::uncounted(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  rmap::bench::uncounted(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  rmap::bench::uncounted(memory);
}
