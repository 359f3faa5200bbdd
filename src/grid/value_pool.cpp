#include "grid/value_pool.hpp"

#include <cassert>
#include <cstring>

namespace rmap {

ValuePool::ValuePool() : pages_(std::size_t{kPageGranules} * kGranule) { free_.fill(kNone); }

ValuePool::Handle ValuePool::allocate(std::uint32_t count) {
  const std::uint32_t wanted = granules(count);
  assert(wanted >= 1 && wanted <= kMaxGranules);
  for (std::uint32_t length = wanted; length <= kMaxGranules; ++length) {
    if (!has_free_[length]) continue;
    const Handle run = pop_free(length);
    if (length > wanted) push_free(run + wanted, length - wanted);
    return run;
  }
  if (tail_length_ < wanted) add_page();
  const Handle run = tail_;
  tail_ += wanted;
  tail_length_ -= wanted;
  return run;
}

void ValuePool::release(Handle run, std::uint32_t count) { push_free(run, granules(count)); }

void ValuePool::add_page() {
  if (tail_length_ > 0) push_free(tail_, tail_length_);
  tail_ = pages_.allocate() * kPageGranules;
  tail_length_ = kPageGranules;
}

void ValuePool::push_free(Handle run, std::uint32_t length) {
  std::memcpy(at(run), &free_[length], sizeof(Handle));
  free_[length] = run;
  has_free_[length] = true;
  free_granules_ += length;
}

ValuePool::Handle ValuePool::pop_free(std::uint32_t length) {
  const Handle run = free_[length];
  std::memcpy(&free_[length], at(run), sizeof(Handle));
  has_free_[length] = free_[length] != kNone;
  free_granules_ -= length;
  return run;
}

}  // namespace rmap
