#include "io/bag/yaml_reader.hpp"

#include <new>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr int kMostLevels = 64;

bool begins_node_of_nodes(yaml_event_type_t type) {
  return type == YAML_SEQUENCE_START_EVENT || type == YAML_MAPPING_START_EVENT;
}

bool ends_node_of_nodes(yaml_event_type_t type) {
  return type == YAML_SEQUENCE_END_EVENT || type == YAML_MAPPING_END_EVENT;
}

const yaml_char_t* anchor_of(const yaml_event_t& event) {
  switch (event.type) {
    case YAML_ALIAS_EVENT:
      return event.data.alias.anchor;
    case YAML_SCALAR_EVENT:
      return event.data.scalar.anchor;
    case YAML_SEQUENCE_START_EVENT:
      return event.data.sequence_start.anchor;
    case YAML_MAPPING_START_EVENT:
      return event.data.mapping_start.anchor;
    default:
      return nullptr;
  }
}

std::string_view scalar_of(const yaml_event_t& event) {
  return {reinterpret_cast<const char*>(event.data.scalar.value), event.data.scalar.length};
}

}  // namespace

YamlReader::YamlReader(const std::filesystem::path& file, std::string_view text) : file_(file) {
  // Directives add up before any event is seen.
  if (text.starts_with('%') || text.find("\n%") != std::string_view::npos) {
    throw Error(ErrorKind::input,
                fmt::format("{}: a line begins with %: directives are not allowed", file.string()));
  }
  if (yaml_parser_initialize(&parser_) == 0) throw std::bad_alloc();
  yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()),
                               text.size());
  // Past the start of the stream and of the document, to its root.
  for (int events = 0; events < 3; ++events) advance();
}

bool YamlReader::enter_value(std::string_view key) {
  if (event_.type != YAML_MAPPING_START_EVENT) return false;
  advance();
  while (event_.type != YAML_MAPPING_END_EVENT) {
    const bool found = event_.type == YAML_SCALAR_EVENT && scalar_of(event_) == key;
    skip_node();
    if (found) return true;
    skip_node();
  }
  return false;
}

std::optional<std::vector<std::string>> YamlReader::read_texts() {
  if (event_.type != YAML_SEQUENCE_START_EVENT) return std::nullopt;
  std::vector<std::string> texts;
  for (advance(); event_.type == YAML_SCALAR_EVENT; advance())
    texts.emplace_back(scalar_of(event_));
  if (event_.type != YAML_SEQUENCE_END_EVENT) return std::nullopt;
  return texts;
}

void YamlReader::finish() {
  while (event_.type != YAML_STREAM_END_EVENT) advance();
}

void YamlReader::skip_node() {
  const int depth = depth_;
  if (begins_node_of_nodes(event_.type)) {
    do {
      advance();
    } while (depth_ > depth);
  }
  advance();
}

void YamlReader::advance() {
  // Behind the end there is nothing more.
  if (event_.type == YAML_STREAM_END_EVENT) return;
  if (begins_node_of_nodes(event_.type) && ++depth_ > kMostLevels) {
    fail(event_.start_mark.line, fmt::format("nodes lie in more than {} others", kMostLevels));
  }
  yaml_event_delete(&event_);
  if (yaml_parser_parse(&parser_, &event_) == 0) {
    if (parser_.error == YAML_MEMORY_ERROR) throw std::bad_alloc();
    if (parser_.error == YAML_READER_ERROR) {
      throw Error(ErrorKind::input, fmt::format("{}, byte {}: {}", file_.string(),
                                                parser_.problem_offset, parser_.problem));
    }
    fail(parser_.problem_mark.line,
         parser_.problem == nullptr ? "it cannot be read" : parser_.problem);
  }
  if (ends_node_of_nodes(event_.type)) --depth_;
  if (anchor_of(event_) != nullptr) {
    fail(event_.start_mark.line, "anchors and aliases are not allowed");
  }
}

void YamlReader::fail(std::size_t line, std::string_view problem) const {
  throw Error(ErrorKind::input, fmt::format("{}, line {}: {}", file_.string(), line + 1, problem));
}

}  // namespace rmap
