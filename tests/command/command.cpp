#include "command/command.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace rmap::test {

namespace {

namespace fs = std::filesystem;

constexpr int kCannotStart = 127;

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

void store(const fs::path& file, const std::string& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + file.string());
}

int exit_code_of(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw std::runtime_error("waitpid failed");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

// In the child: from here to the command nothing may fail silently.
void connect(int descriptor, const fs::path& file, int flags) {
  const int opened = ::open(file.c_str(), flags, 0600);
  if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(kCannotStart);
}

void close_reader_of_output() {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0 || ::dup2(ends[1], STDOUT_FILENO) < 0) ::_exit(kCannotStart);
  ::close(ends[0]);
  ::close(ends[1]);
}

[[noreturn]] void become_command(const fs::path& folder,
                                 const std::vector<std::string>& arguments) {
  std::vector<char*> argv{const_cast<char*>("rmap")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  if (::chdir(folder.c_str()) == 0) ::execv(RMAP_COMMAND, argv.data());
  ::_exit(kCannotStart);
}

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "rmap-command-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  return name;
}

}  // namespace

nlohmann::json Outcome::json() const { return nlohmann::json::parse(out); }

std::vector<nlohmann::json> Outcome::json_lines() const {
  std::vector<nlohmann::json> objects;
  std::istringstream lines(out);
  for (std::string line; std::getline(lines, line);) objects.push_back(nlohmann::json::parse(line));
  return objects;
}

RunningCommand::RunningCommand(const fs::path& folder, const std::vector<std::string>& arguments) {
  descriptor_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (descriptor_ < 0 || ::grantpt(descriptor_) != 0 || ::unlockpt(descriptor_) != 0) {
    throw std::runtime_error("cannot open a terminal");
  }
  const fs::path terminal = ::ptsname(descriptor_);
  process_ = ::fork();
  if (process_ == 0) {
    connect(STDIN_FILENO, "/dev/null", O_RDONLY);
    connect(STDOUT_FILENO, "/dev/null", O_WRONLY);
    connect(STDERR_FILENO, terminal, O_RDWR | O_NOCTTY);
    become_command(folder, arguments);
  }
}

RunningCommand::~RunningCommand() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  ::close(descriptor_);
}

bool RunningCommand::read_some() {
  std::array<char, 4096> buffer{};
  ssize_t count = 0;
  do {
    count = ::read(descriptor_, buffer.data(), buffer.size());
  } while (count < 0 && errno == EINTR);
  // A terminal that its last user has closed answers with an error.
  if (count <= 0) return false;
  terminal_.append(buffer.data(), static_cast<std::size_t>(count));
  return true;
}

bool RunningCommand::wait_for(const std::string& text) {
  while (terminal_.find(text) == std::string::npos) {
    if (!read_some()) return false;
  }
  return true;
}

void RunningCommand::send(int signal) const { ::kill(process_, signal); }

int RunningCommand::wait() {
  while (read_some()) {
  }
  return exit_code_of(std::exchange(process_, -1));
}

CommandTest::CommandTest() : folder_(new_folder()) {}

CommandTest::~CommandTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Outcome CommandTest::rmap(const std::vector<std::string>& arguments, const Start& start) const {
  // Beside the folder, which tests list.
  const fs::path streams = new_folder();
  store(streams / "in", start.input);
  const fs::path out = start.output.empty() ? streams / "out" : start.output;
  const pid_t process = ::fork();
  if (process == 0) {
    connect(STDIN_FILENO, streams / "in", O_RDONLY);
    connect(STDOUT_FILENO, out, O_WRONLY | O_CREAT);
    connect(STDERR_FILENO, streams / "err", O_WRONLY | O_CREAT);
    if (start.into_closed_pipe) close_reader_of_output();
    if (start.largest_file) {
      const rlimit limit{*start.largest_file, *start.largest_file};
      if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(kCannotStart);
    }
    become_command(folder_, arguments);
  }
  Outcome outcome;
  outcome.exit_code = exit_code_of(process);
  if (start.output.empty()) outcome.out = contents(streams / "out");
  outcome.err = contents(streams / "err");
  fs::remove_all(streams);
  return outcome;
}

Outcome CommandTest::rmap_done(const std::vector<std::string>& arguments,
                               const Start& start) const {
  Outcome outcome = rmap(arguments, start);
  EXPECT_EQ(outcome.exit_code, 0) << testing::PrintToString(arguments);
  EXPECT_EQ(outcome.err, "") << testing::PrintToString(arguments);
  return outcome;
}

nlohmann::json CommandTest::rmap_json(std::vector<std::string> arguments) const {
  arguments.emplace_back("--json");
  return rmap_done(arguments).json();
}

std::string CommandTest::rmap_refused(int exit_code, const std::vector<std::string>& arguments,
                                      const Start& start) const {
  const Outcome outcome = rmap(arguments, start);
  EXPECT_EQ(outcome.exit_code, exit_code) << testing::PrintToString(arguments) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("rmap: ")) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with("\n")) << outcome.err;
  return outcome.err;
}

void CommandTest::simulate_room(const std::string& name, int scans) const {
  rmap_done({"simulate", "room", "--scans", std::to_string(scans), "--sensor", "lidar16",
             "--spacing", "0.2", "-o", name});
}

std::string CommandTest::bytes(const fs::path& name) const { return contents(folder_ / name); }

void CommandTest::write(const fs::path& name, const std::string& bytes) const {
  store(folder_ / name, bytes);
}

std::vector<std::string> CommandTest::listing(const fs::path& name) const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_ / name)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace rmap::test
