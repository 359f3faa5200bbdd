#include "io/memory.hpp"

#include "io/files.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::expect_error;

TEST(WithMemoryFor, names_the_file_that_does_not_fit) {
  const std::string sentence = "cannot read a.bin: there is not enough memory for it";
  expect_error(ErrorKind::io, sentence,
               [] { with_memory_for("a.bin", [] { throw std::bad_alloc(); }); });
  expect_error(ErrorKind::io, sentence, [] {
    with_memory_for("a.bin", [] { std::vector<int> all(static_cast<std::size_t>(-1)); });
  });
}

TEST(WithMemoryFor, passes_results_and_other_errors) {
  EXPECT_EQ(with_memory_for("a.bin", [] { return 7; }), 7);
  expect_error(ErrorKind::input, "no",
               [] { with_memory_for("a.bin", [] { throw Error(ErrorKind::input, "no"); }); });
}

}  // namespace
}  // namespace rmap
