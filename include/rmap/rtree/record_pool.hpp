#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <rmap/error.hpp>

namespace rmap {

/// Records of a fixed number of T each, named by 32-bit ids, in pages of about
/// 16 KiB. A record never moves, so growth copies nothing and memory never
/// doubles. A released record is used again before a new one; its page is kept.
///
/// A copy is deep, has the same ids and costs one block copy a page.
template <class T>
class RecordPool {
  static_assert(std::is_trivially_copyable_v<T>, "records are copied as bytes");

 public:
  /// No record has this id.
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// `stride`: number of T in a record; a record takes at least 4 bytes.
  explicit RecordPool(std::size_t stride) : stride_(stride) {
    // A released record holds the id of the next one that is free.
    assert(stride * sizeof(T) >= sizeof(std::uint32_t));
    const std::size_t records = std::max<std::size_t>(1, kPageBytes / (stride * sizeof(T)));
    page_shift_ = static_cast<std::uint32_t>(std::bit_width(records) - 1);
  }

  RecordPool(const RecordPool& other)
      : stride_(other.stride_),
        page_shift_(other.page_shift_),
        slots_(other.slots_),
        size_(other.size_),
        first_free_(other.first_free_) {
    // Pages that are only reserved are not worth a copy.
    const std::size_t used = (slots_ + records_per_page() - 1) >> page_shift_;
    pages_.reserve(used);
    for (std::size_t i = 0; i < used; ++i) {
      add_page();
      std::memcpy(pages_[i].get(), other.pages_[i].get(), page_bytes());
    }
  }
  RecordPool(RecordPool&& other) noexcept
      : stride_(other.stride_),
        page_shift_(other.page_shift_),
        pages_(std::move(other.pages_)),
        slots_(std::exchange(other.slots_, 0)),
        size_(std::exchange(other.size_, 0)),
        first_free_(std::exchange(other.first_free_, kNone)) {
    other.pages_.clear();
  }
  RecordPool& operator=(const RecordPool& other) {
    if (this != &other) *this = RecordPool(other);
    return *this;
  }
  RecordPool& operator=(RecordPool&& other) noexcept {
    if (this == &other) return *this;
    stride_ = other.stride_;
    page_shift_ = other.page_shift_;
    pages_ = std::move(other.pages_);
    other.pages_.clear();
    slots_ = std::exchange(other.slots_, 0);
    size_ = std::exchange(other.size_, 0);
    first_free_ = std::exchange(other.first_free_, kNone);
    return *this;
  }
  ~RecordPool() = default;

  /// The id of a record whose content is unspecified: the one released last, or a new one.
  /// Throws Error(limit) when all 2^32 - 1 ids are taken.
  std::uint32_t allocate() {
    if (first_free_ != kNone) {
      const std::uint32_t id = first_free_;
      first_free_ = next_free(id);
      ++size_;
      return id;
    }
    reserve(1);
    ++size_;
    return slots_++;
  }
  /// Gives a record back. Its content is lost.
  void release(std::uint32_t id) {
    assert(id < slots_ && size_ > 0);
    std::memcpy(static_cast<void*>(record(id)), &first_free_, sizeof(first_free_));
    first_free_ = id;
    --size_;
  }
  /// The next `count` calls of allocate() do not throw.
  void reserve(std::size_t count) {
    const std::size_t free = slots_ - size_;
    if (count <= free) return;
    const std::size_t needed = slots_ + (count - free);
    if (needed > kNone) {
      throw Error(ErrorKind::limit, "the pool is full: it holds at most 4294967295 records");
    }
    while (pages_.size() << page_shift_ < needed) add_page();
  }
  /// Releases all records and all memory.
  void clear() { *this = RecordPool(stride_); }

  T* record(std::uint32_t id) {
    assert(id < slots_);
    return pages_[id >> page_shift_].get() + (id & (records_per_page() - 1)) * stride_;
  }
  const T* record(std::uint32_t id) const {
    assert(id < slots_);
    return pages_[id >> page_shift_].get() + (id & (records_per_page() - 1)) * stride_;
  }

  /// Number of T in a record.
  std::size_t stride() const { return stride_; }
  /// Number of records in a page, a power of two.
  std::size_t records_per_page() const { return std::size_t{1} << page_shift_; }
  /// Number of records in use.
  std::size_t size() const { return size_; }
  /// One more than the highest id that was ever in use.
  std::size_t slots() const { return slots_; }
  /// Memory taken: all pages and the table of pages.
  std::size_t bytes_in_use() const {
    return pages_.size() * page_bytes() + pages_.capacity() * sizeof(pages_[0]);
  }

  /// For each id below slots() whether it is in use; nothing when the list of free records
  /// is damaged: it leads outside, in a circle, or does not hold all that are free.
  std::optional<std::vector<bool>> slots_in_use() const {
    std::vector<bool> in_use(slots_, true);
    std::size_t free = 0;
    for (std::uint32_t id = first_free_; id != kNone; id = next_free(id), ++free) {
      if (id >= slots_ || !in_use[id]) return std::nullopt;
      in_use[id] = false;
    }
    if (free + size_ != slots_) return std::nullopt;
    return in_use;
  }

 private:
  static constexpr std::size_t kPageBytes = std::size_t{1} << 14;

  std::size_t page_bytes() const { return (stride_ * sizeof(T)) << page_shift_; }
  void add_page() { pages_.push_back(std::make_unique_for_overwrite<T[]>(stride_ << page_shift_)); }
  std::uint32_t next_free(std::uint32_t id) const {
    std::uint32_t next = kNone;
    std::memcpy(&next, record(id), sizeof(next));
    return next;
  }

  std::size_t stride_;
  std::uint32_t page_shift_;
  std::vector<std::unique_ptr<T[]>> pages_;
  std::uint32_t slots_ = 0;
  std::uint32_t size_ = 0;
  std::uint32_t first_free_ = kNone;
};

}  // namespace rmap
