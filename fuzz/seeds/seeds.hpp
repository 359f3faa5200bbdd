#pragma once

#include "io/files.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>

namespace rmap::test {

/// The folder that seeds are written to.
class Seeds {
 public:
  explicit Seeds(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& target, const std::string& name, const std::string& bytes) {
    // Larger seeds slow the first mutations down and show no more.
    constexpr std::size_t kLargest = 4096;
    if (bytes.size() >= kLargest) throw std::runtime_error(target + "/" + name + " is too large");
    std::filesystem::create_directories(folder_ / target);
    write_text(folder_ / target / name, bytes);
  }

 private:
  std::filesystem::path folder_;
};

/// Files of points that others write.
void add_clouds(Seeds& seeds);
/// Recordings.
void add_bags(Seeds& seeds);

}  // namespace rmap::test
