// Lists for the option --from.
#include "rmap/number_lines.hpp"

#include "support/input.hpp"

#include <algorithm>
#include <array>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = rmap::fuzz::text_of(data, size);
  const auto file = rmap::fuzz::write_file(text, "lines.txt");
  const auto most = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  std::array<double, 6> numbers{};
  for (const std::size_t count : {3U, 6U}) {
    const bool sound = rmap::fuzz::is_sound(file, [&] {
      rmap::command::NumberLines lines(file);
      std::size_t read = 0;
      while (lines.next(std::span(numbers).first(count))) ++read;
      if (read > most) rmap::fuzz::fail("more rows than lines");
    });
    if (sound && text.find('\0') != std::string_view::npos) {
      rmap::fuzz::fail("bytes behind a zero are passed over");
    }
  }
  return 0;
}
