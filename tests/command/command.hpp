#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rmap::test {

/// What a command left behind.
struct Outcome {
  int exit_code = -1;  ///< minus the signal that ended it
  std::string out;
  std::string err;

  /// The one JSON object, or array, that it printed.
  nlohmann::json json() const;
  /// One object for each line.
  std::vector<nlohmann::json> json_lines() const;
};

/// How a command is started beside its arguments.
struct Start {
  std::string input = {};                        ///< standard input
  std::filesystem::path output = {};             ///< standard output goes to this file
  bool into_closed_pipe = false;                 ///< standard output is a pipe that nobody reads
  std::optional<std::size_t> largest_file = {};  ///< RLIMIT_FSIZE, bytes
};

/// A running `rmap` whose standard error is a terminal.
class RunningCommand {
 public:
  RunningCommand(const std::filesystem::path& folder, const std::vector<std::string>& arguments);
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;
  ~RunningCommand();

  /// Reads the terminal until `text` has appeared on it; false when the command ended before.
  bool wait_for(const std::string& text);
  void send(int signal) const;
  /// Waits for the end: the exit code, or minus the signal. `terminal()` is complete then.
  int wait();
  const std::string& terminal() const { return terminal_; }

 private:
  bool read_some();

  pid_t process_ = -1;
  int descriptor_ = -1;
  std::string terminal_;
};

/// A vector as JSON has it.
inline std::vector<double> numbers(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

/// A test with an empty folder of its own, in which commands run.
class CommandTest : public testing::Test {
 protected:
  CommandTest();
  ~CommandTest() override;

  const std::filesystem::path& folder() const { return folder_; }

  /// Runs `rmap` with the arguments in the folder.
  Outcome rmap(const std::vector<std::string>& arguments, const Start& start = {}) const;
  /// The same, expecting success and nothing on standard error.
  Outcome rmap_done(const std::vector<std::string>& arguments, const Start& start = {}) const;
  /// The same with --json, as its answer.
  nlohmann::json rmap_json(std::vector<std::string> arguments) const;
  /// Expects the exit code and one sentence on standard error, which it returns.
  std::string rmap_refused(int exit_code, const std::vector<std::string>& arguments,
                           const Start& start = {}) const;

  /// Makes `name` a folder of a few small scans of the room.
  void simulate_room(const std::string& name, int scans = 3) const;

  std::string bytes(const std::filesystem::path& name) const;
  void write(const std::filesystem::path& name, const std::string& bytes) const;
  /// Names of all that is in a folder, hidden files too, sorted.
  std::vector<std::string> listing(const std::filesystem::path& name = ".") const;

 private:
  std::filesystem::path folder_;
};

}  // namespace rmap::test
