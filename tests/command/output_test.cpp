#include "command/command.hpp"

#include <gmock/gmock.h>

namespace rmap::test {

namespace {

using testing::HasSubstr;

class Output : public CommandTest {
 protected:
  Output() { simulate_room("room", 2); }

  void build(const std::string& name) const {
    rmap_done({"build", "room", "-o", name, "--resolution", "0.1"});
  }
};

TEST_F(Output, AFullDiskIsAnError) {
  EXPECT_THAT(rmap_refused(1, {"build", "room", "-o", "/dev/full", "--resolution", "0.1"}),
              testing::AllOf(HasSubstr("/dev/full"), HasSubstr("No space left")));
  build("room.rmap");
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"info", "room.rmap", "--json"},
        {"query", "room.rmap", "cells"},
        {"build", "--help"},
        {"--version"}}) {
    EXPECT_THAT(rmap_refused(1, call, {.output = "/dev/full"}),
                testing::AllOf(HasSubstr("standard output"), HasSubstr("No space left")));
  }
}

TEST_F(Output, AFormerFileSurvivesAFailedWrite) {
  build("room.rmap");
  const std::string before = bytes("room.rmap");
  const auto names = listing();
  const Start small{.largest_file = before.size() / 2};
  EXPECT_THAT(rmap_refused(1, {"build", "room", "-o", "room.rmap", "--resolution", "0.1"}, small),
              testing::AllOf(HasSubstr("room.rmap"), HasSubstr("File too large")));
  EXPECT_THAT(rmap_refused(1, {"convert", "room.rmap", "room.csv"}, small),
              HasSubstr("File too large"));
  EXPECT_THAT(rmap_refused(1, {"simulate", "room", "-o", "new"}, small),
              HasSubstr("cannot write new/000000.bin: File too large"));
  EXPECT_THAT(rmap_refused(1, {"convert", "room", "new"}, small),
              HasSubstr("cannot write new/000000.bin: File too large"));
  EXPECT_EQ(bytes("room.rmap"), before);
  EXPECT_EQ(listing(), names);
}

TEST_F(Output, AClosedPipeIsAnError) {
  build("room.rmap");
  EXPECT_THAT(rmap_refused(1, {"query", "room.rmap", "cells"}, {.into_closed_pipe = true}),
              testing::AllOf(HasSubstr("standard output"), HasSubstr("Broken pipe")));
}

TEST_F(Output, ProgressIsForTerminalsOnly) {
  EXPECT_EQ(rmap_done({"build", "room", "-o", "a.rmap", "--resolution", "0.1"}).err, "");
  RunningCommand running(folder(), {"build", "room", "-o", "b.rmap", "--resolution", "0.1"});
  EXPECT_EQ(running.wait(), 0);
  EXPECT_THAT(running.terminal(), HasSubstr("preparing: 1 of 2 scans"));
  EXPECT_THAT(running.terminal(), HasSubstr("inserting: 1 of 2 scans"));
  EXPECT_THAT(running.terminal(), HasSubstr("scans/s"));
  EXPECT_THAT(running.terminal(), HasSubstr(" s left"));
}

}  // namespace

}  // namespace rmap::test
