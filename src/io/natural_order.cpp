#include "io/natural_order.hpp"

#include <algorithm>
#include <cstddef>

namespace rmap {

namespace {

bool is_digit(char character) { return character >= '0' && character <= '9'; }

// Takes the run of digits off the front of `name`; without leading zeros.
std::string_view take_number(std::string_view& name) {
  const auto end = std::find_if_not(name.begin(), name.end(), is_digit);
  std::string_view number = name.substr(0, static_cast<std::size_t>(end - name.begin()));
  name.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a;
  const std::string_view whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view number_a = take_number(a);
      const std::string_view number_b = take_number(b);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
      if (number_a != number_b) return number_a < number_b;
    } else {
      if (a.front() != b.front()) {
        return static_cast<unsigned char>(a.front()) < static_cast<unsigned char>(b.front());
      }
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;  // 7 and 007
}

}  // namespace rmap
