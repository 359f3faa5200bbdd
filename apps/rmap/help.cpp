#include "help.hpp"

#include <memory>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace rmap::command {

namespace {

constexpr std::size_t kWidth = 88;
constexpr std::size_t kOptionIndent = 2;
constexpr std::size_t kTextColumn = 28;

std::string entry(const std::string& name, const std::string& text) {
  std::string line = std::string(kOptionIndent, ' ') + name;
  const std::string explained = wrapped(text, kTextColumn, kWidth);
  if (line.size() + 2 > kTextColumn) return line + "\n" + explained;
  return line + explained.substr(line.size());
}

std::string option_entry(const CLI::Option& option) {
  std::string name =
      option.get_positional() ? option.get_name(true, false) : option.get_name(false, true);
  if (name.find(',') != std::string::npos) name.insert(name.find(',') + 1, " ");
  const std::string& placeholder = option.get_option_text();
  if (option.get_positional()) {
    if (placeholder == "...") name += placeholder;
  } else if (!placeholder.empty()) {
    name += " " + placeholder;
  }
  return entry(name, option.get_description());
}

class HelpFormatter : public CLI::FormatterBase {
 public:
  explicit HelpFormatter(Help help) : help_(std::move(help)) {}

  std::string make_help(const CLI::App* app, std::string,
                        CLI::AppFormatMode /*mode*/) const override {
    std::string out = app->get_description() + "\n\nUsage: " + full_name(*app);
    if (!help_.usage.empty()) out += " " + help_.usage;
    out += "\n";
    for (const std::string& paragraph : help_.text) out += "\n" + wrapped(paragraph, 0, kWidth);
    out += verbs(*app) + arguments(*app) + options(*app);
    if (!help_.examples.empty()) {
      out += help_.examples.size() == 1 ? "\nExample:\n" : "\nExamples:\n";
      for (const std::string& example : help_.examples) out += "  " + example + "\n";
    }
    return out;
  }

 private:
  static std::string full_name(const CLI::App& app) {
    if (app.get_parent() == nullptr) return app.get_name();
    // A verb with verbs of its own takes its arguments before them.
    std::string name = full_name(*app.get_parent());
    if (app.get_parent()->get_parent() != nullptr) {
      for (const CLI::Option* option : app.get_parent()->get_options()) {
        if (option->get_positional()) name += " " + option->get_name(true, false);
      }
    }
    return name + " " + app.get_name();
  }

  static std::string verbs(const CLI::App& app) {
    std::string out;
    for (const CLI::App* verb : app.get_subcommands({})) {
      out += entry(verb->get_name(), verb->get_description());
    }
    return out.empty() ? out : "\nVerbs:\n" + out;
  }

  static std::string arguments(const CLI::App& app) {
    std::string out;
    for (const CLI::Option* option : app.get_options()) {
      if (option->get_positional()) out += option_entry(*option);
    }
    return out.empty() ? out : "\nArguments:\n" + out;
  }

  static std::string options(const CLI::App& app) {
    std::string out;
    for (const std::string& group : app.get_groups()) {
      std::string entries;
      for (const CLI::Option* option : app.get_options()) {
        if (option->get_group() == group && !option->get_positional()) {
          entries += option_entry(*option);
        }
      }
      if (!entries.empty()) out += fmt::format("\n{}:\n{}", group, entries);
    }
    return out;
  }

  Help help_;
};

}  // namespace

void set_help(CLI::App& app, Help help) {
  app.set_help_flag("-h,--help", "Show this text.");
  app.formatter(std::make_shared<HelpFormatter>(std::move(help)));
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::string out;
  std::string line(indent, ' ');
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() > indent && line.size() + 1 + word.size() > width) {
      out += line + "\n";
      line.assign(indent, ' ');
    }
    if (line.size() > indent) line += ' ';
    line += word;
  }
  return out + line + "\n";
}

}  // namespace rmap::command
