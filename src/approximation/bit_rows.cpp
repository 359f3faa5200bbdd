#include "approximation/bit_rows.hpp"

#include <cstdlib>
#include <new>

namespace rmap {

BitRows::BitRows(const Cell& size, int axis)
    : size_(size), axis_(axis), words_in_row_((size[axis] + 63) / 64) {
  std::ptrdiff_t stride = words_in_row_;
  for (int other = 0; other < 3; ++other) {
    if (other == axis) continue;
    stride_[static_cast<std::size_t>(other)] = stride;
    stride *= size[other];
  }
  // calloc, since the system gives pages of zeros on their first use only.
  words_.reset(static_cast<Word*>(std::calloc(static_cast<std::size_t>(stride), sizeof(Word))));
  if (!words_) throw std::bad_alloc();
}

void BitRows::Free::operator()(Word* words) const { std::free(words); }

}  // namespace rmap
