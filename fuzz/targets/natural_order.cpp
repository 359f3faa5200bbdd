// Three lines as names: the order of names must be one, or sorting by it is undefined.
#include "io/natural_order.hpp"

#include "support/input.hpp"

#include <array>
#include <string_view>

namespace rmap::fuzz {
namespace {

void check_pair(std::string_view a, std::string_view b) {
  const int orders = (natural_less(a, b) ? 1 : 0) + (natural_less(b, a) ? 1 : 0);
  if (orders != (a == b ? 0 : 1)) fail("two names have no order, or both");
}

void fuzz_order(std::string_view text) {
  std::array<std::string_view, 3> names;
  for (std::string_view& name : names) {
    name = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(name.size() + 1, text.size()));
  }
  for (const auto a : names) {
    for (const auto b : names) {
      check_pair(a, b);
      for (const auto c : names) {
        if (natural_less(a, b) && natural_less(b, c) && !natural_less(a, c)) {
          fail("the order is not transitive");
        }
      }
    }
  }
}

}  // namespace
}  // namespace rmap::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rmap::fuzz::fuzz_order(rmap::fuzz::text_of(data, size));
  return 0;
}
