#include "evaluation/tables.hpp"

namespace rmap::evaluation {

namespace {

std::string field(const Json& value) {
  if (value.is_null()) return {};
  if (!value.is_string()) return value.dump();
  const std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string{letter};
  return quoted + "\"";
}

}  // namespace

std::string csv_of(const std::vector<Json>& rows) {
  if (rows.empty()) return {};
  std::string text;
  for (const auto& [key, value] : rows.front().items()) text += (text.empty() ? "" : ",") + key;
  text += "\n";
  for (const Json& row : rows) {
    std::string line;
    bool first = true;
    for (const auto& [key, value] : row.items()) {
      if (!first) line += ",";
      line += field(value);
      first = false;
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace rmap::evaluation
