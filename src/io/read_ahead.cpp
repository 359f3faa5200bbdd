#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include <rmap/scan_source.hpp>

namespace rmap {

namespace {

// Scans wait here, so many at most, until they are asked for.
constexpr std::size_t kAhead = 2;

class ReadAhead final : public ScanSource {
 public:
  explicit ReadAhead(std::unique_ptr<ScanSource> source)
      : source_(std::move(source)), size_(source_->size()) {}

  bool next(Scan& scan) override {
    if (!reader_.joinable()) {
      reader_ = std::jthread([this](const std::stop_token& stop) { read(stop); });
    }
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !results_.empty(); });
    if (results_.front().at_end) return false;
    Result result = std::move(results_.front());
    results_.pop_front();
    if (!result.error) {
      std::swap(scan, result.scan);
      spare_.push_back(std::move(result.scan));
    }
    lock.unlock();
    changed_.notify_all();
    if (result.error) std::rethrow_exception(result.error);
    return true;
  }

  void rewind() override {
    reader_ = {};
    results_.clear();
    source_->rewind();
  }

  std::optional<std::size_t> size() const override { return size_; }
  ScanNotes notes() const override { return source_->notes(); }

 private:
  // What a call of the source's `next` came to.
  struct Result {
    Scan scan = {};
    std::exception_ptr error = {};
    bool at_end = false;
  };

  void read(const std::stop_token& stop) {
    for (bool at_end = false; !at_end;) {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return results_.size() < kAhead; })) return;
      Result result;
      if (!spare_.empty()) {
        result.scan = std::move(spare_.back());
        spare_.pop_back();
      }
      lock.unlock();
      try {
        result.at_end = !source_->next(result.scan);
      } catch (...) {
        result.error = std::current_exception();
      }
      at_end = result.at_end;
      lock.lock();
      results_.push_back(std::move(result));
      lock.unlock();
      changed_.notify_all();
    }
  }

  std::unique_ptr<ScanSource> source_;  ///< the reader's while it runs
  std::optional<std::size_t> size_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Result> results_;  ///< in the order of the scans
  std::vector<Scan> spare_;     ///< buffers to use again
  std::jthread reader_;         ///< stops before the rest goes
};

}  // namespace

std::unique_ptr<ScanSource> read_ahead(std::unique_ptr<ScanSource> source) {
  return std::make_unique<ReadAhead>(std::move(source));
}

}  // namespace rmap
