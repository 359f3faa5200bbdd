// Every cut and every flipped bit of small files: an error that names the file, or a
// reading that the format cannot tell from a sound one; never anything else.
#include "io/files.hpp"
#include "support/random.hpp"

#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

const std::string kLayout = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 4\nHEIGHT 1\nPOINTS 4\n";

struct Sample {
  std::string name;
  std::string bytes;
  std::size_t least_cut_errors;  // of all cuts, those that must be noticed
};

std::vector<Sample> samples() {
  const std::string values(48, '\x3f');
  // 1 byte as it is, then 47 from 1 back.
  const std::string lzf = std::string("\0\x3f", 2) + "\xe0\x26" + std::string(1, '\0');
  const std::string ascii = kLayout + "DATA ascii\n1 2 3\n4 5 6\n7 8 9\nnan nan nan\n";
  const std::string compressed = kLayout + "DATA binary_compressed\n" +
                                 test::raw(static_cast<std::uint32_t>(lzf.size())) +
                                 test::raw(std::uint32_t{48}) + lzf;
  const std::string poses = "1 0 0 0 0 1 0 0 0 0 1 0\n# x\n1 0 0 5 0 1 0 6 0 0 1 7\n";
  const std::string bin = std::string(64, '\x3f');
  return {{"a.bin", bin, 61},
          {"ascii.pcd", ascii, ascii.size() - 1},
          {"binary.pcd", kLayout + "DATA binary\n" + values, kLayout.size() + 60},
          {"compressed.pcd", compressed, compressed.size()},
          {"poses.txt", poses, poses.size() / 2}};
}

// Reads the file as what its name says; whether it was sound. An error must be about it.
bool reads(const std::filesystem::path& file) {
  try {
    if (file.extension() == ".txt") {
      EXPECT_LE(read_poses(file).size(), 2u);
    } else {
      EXPECT_LE(read_points(file).size(), 4u);
    }
    return true;
  } catch (const Error& error) {
    EXPECT_TRUE(std::string_view(error.what()).find(file.string()) != std::string_view::npos)
        << error.what();
    return false;
  }
}

TEST(DamagedFiles, samples_are_sound) {
  const test::TemporaryFolder folder;
  for (const Sample& sample : samples()) {
    test::write_text(folder / sample.name, sample.bytes);
    EXPECT_TRUE(reads(folder / sample.name)) << sample.name;
  }
}

TEST(DamagedFiles, cuts_are_noticed) {
  const test::TemporaryFolder folder;
  for (const Sample& sample : samples()) {
    std::size_t errors = 0;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      test::write_text(folder / sample.name, sample.bytes.substr(0, size));
      errors += reads(folder / sample.name) ? 0 : 1;
    }
    EXPECT_GE(errors, sample.least_cut_errors) << sample.name << " of " << sample.bytes.size();
  }
}

TEST(DamagedFiles, flipped_bits_do_no_harm) {
  const test::TemporaryFolder folder;
  std::size_t cases = 0;
  std::size_t errors = 0;
  for (const Sample& sample : samples()) {
    for (std::size_t bit = 0; bit < 8 * sample.bytes.size(); ++bit, ++cases) {
      std::string bytes = sample.bytes;
      bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
      test::write_text(folder / sample.name, bytes);
      errors += reads(folder / sample.name) ? 0 : 1;
    }
  }
  EXPECT_EQ(cases, 3488u);
  EXPECT_GT(errors, 2000u);
}

TEST(DamagedFiles, garbage_does_no_harm) {
  test::Random random(14);
  SCOPED_TRACE(random.trace());
  const test::TemporaryFolder folder;
  int cases = 0;
  for (; cases < 2000; ++cases) {
    Sample sample = samples()[static_cast<std::size_t>(random.integer(0, 4))];
    for (int changes = random.integer(1, 20); changes > 0; --changes) {
      const auto place = static_cast<std::size_t>(
          random.integer(0, static_cast<std::int32_t>(sample.bytes.size()) - 1));
      // Digits and blanks lead deeper than other bytes do.
      sample.bytes[place] = random.chance(0.5) ? "0123456789 \n-e"[random.integer(0, 13)]
                                               : static_cast<char>(random.integer(0, 255));
    }
    test::write_text(folder / sample.name, sample.bytes);
    try {
      if (sample.name == "poses.txt") {
        read_poses(folder / sample.name);
      } else {
        ASSERT_LE(read_points(folder / sample.name).size(), sample.bytes.size());
      }
    } catch (const Error&) {
      continue;
    }
  }
  EXPECT_EQ(cases, 2000);
}

}  // namespace
}  // namespace rmap
