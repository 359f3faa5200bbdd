#include "approximation/task_order.hpp"

#include "grid/parallel.hpp"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <queue>

namespace rmap {

namespace {

/// Hands out tasks whose predecessors are done.
class TaskOrder {
 public:
  explicit TaskOrder(std::span<const std::vector<std::size_t>> before)
      : missing_(before.size()), behind_(before.size()), left_(before.size()) {
    for (std::size_t i = 0; i < before.size(); ++i) {
      missing_[i] = before[i].size();
      for (const std::size_t earlier : before[i]) behind_[earlier].push_back(i);
      if (missing_[i] == 0) ready_.push(i);
    }
  }

  /// Works until nothing is left for this thread.
  void work(FunctionRef<void(std::size_t)> task) {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [&] { return !ready_.empty() || left_ == 0; });
      if (left_ == 0) return;
      const std::size_t i = ready_.top();
      ready_.pop();
      lock.unlock();
      try {
        task(i);
      } catch (...) {
        lock.lock();
        left_ = 0;
        changed_.notify_all();
        throw;
      }
      lock.lock();
      finish(i);
    }
  }

 private:
  void finish(std::size_t i) {
    if (left_ == 0) return;  // another one failed
    --left_;
    for (const std::size_t later : behind_[i]) {
      if (--missing_[later] == 0) ready_.push(later);
    }
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::size_t> missing_;
  std::vector<std::vector<std::size_t>> behind_;
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready_;
  std::size_t left_;
};

}  // namespace

void run_in_order(int threads, std::span<const std::vector<std::size_t>> before,
                  FunctionRef<void(std::size_t)> task) {
  TaskOrder order(before);
  for_each_range(threads, before.size(),
                 [&](std::size_t, std::size_t, std::size_t) { order.work(task); });
}

}  // namespace rmap
