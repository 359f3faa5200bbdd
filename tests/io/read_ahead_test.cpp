#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

constexpr int kScans = 40;

// Scan i holds i points; every seventh cannot be read.
class Numbered : public ScanSource {
 public:
  bool next(Scan& scan) override {
    if (next_ == kScans) return false;
    const int number = next_++;
    if (number % 7 == 6) throw Error(ErrorKind::input, std::to_string(number));
    scan.points.assign(static_cast<std::size_t>(number), Vector3f(1, 2, 3));
    scan.map_from_sensor.translation() = Vector3d(number, 0, 0);
    return true;
  }
  void rewind() override { next_ = 0; }
  std::optional<std::size_t> size() const override { return kScans; }

 private:
  int next_ = 0;
};

// What `calls` calls of `next` come to: points of a scan, "error ..." or "end".
std::vector<std::string> results(ScanSource& source, int calls) {
  std::vector<std::string> results;
  Scan scan;
  for (int i = 0; i < calls; ++i) {
    try {
      results.push_back(source.next(scan) ? std::to_string(scan.points.size()) : "end");
    } catch (const Error& error) {
      results.push_back(std::string("error ") + error.what());
    }
  }
  return results;
}

TEST(ReadAhead, GivesWhatTheSourceGives) {
  Numbered plain;
  const auto expected = results(plain, kScans + 3);
  const auto ahead = read_ahead(std::make_unique<Numbered>());
  EXPECT_EQ(ahead->size(), kScans);
  EXPECT_EQ(results(*ahead, kScans + 3), expected);
  EXPECT_EQ(expected.back(), "end");
  EXPECT_EQ(expected[6], "error 6");
}

TEST(ReadAhead, CanBeRewoundAndDroppedAtAnyTime) {
  Numbered plain;
  const auto expected = results(plain, kScans + 1);
  const auto ahead = read_ahead(std::make_unique<Numbered>());
  ahead->rewind();
  for (int calls = 0; calls <= kScans + 1; ++calls) {
    const auto some = results(*ahead, calls);
    ASSERT_TRUE(std::equal(some.begin(), some.end(), expected.begin()));
    ahead->rewind();
    const auto dropped = read_ahead(std::make_unique<Numbered>());
    ASSERT_EQ(results(*dropped, calls), some);
  }
}

}  // namespace
}  // namespace rmap
