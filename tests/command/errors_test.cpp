#include "command/command.hpp"

#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>

namespace rmap::test {

namespace {

using testing::HasSubstr;

constexpr int kFailed = 1;
constexpr int kUsage = 2;

struct WrongCall {
  int exit_code;
  std::vector<std::string> arguments;
  std::vector<std::string> parts;  ///< of the sentence
};

class Errors : public CommandTest {
 protected:
  Errors() { simulate_room("room", 1); }

  void expect(const std::vector<WrongCall>& calls) const {
    const auto before = listing();
    for (const WrongCall& call : calls) {
      SCOPED_TRACE(testing::PrintToString(call.arguments));
      const std::string sentence = rmap_refused(call.exit_code, call.arguments);
      for (const std::string& part : call.parts) EXPECT_THAT(sentence, HasSubstr(part));
      EXPECT_EQ(listing(), before);
    }
  }
};

TEST_F(Errors, OfUsage) {
  expect({
      {kUsage, {}, {"a verb is missing", "rmap --help"}},
      {kUsage, {"bild", "room"}, {"\"bild\" is no verb", "rmap --help"}},
      {kUsage, {"build"}, {"SCANS", "rmap build --help"}},
      {kUsage, {"build", "room"}, {"--resolution is missing"}},
      {kUsage, {"build", "room", "--resolution", "0.1"}, {"-o is missing"}},
      {kUsage, {"build", "room", "--resolution", "0.1", "-o"}, {"--output: 1 required FILE"}},
      {kUsage, {"build", "room", "--resolution", "0.1", "-o", "m.rmap", "--fast"}, {"--fast"}},
      {kUsage,
       {"build", "room", "-o", "m.rmap", "--resolution", "0.1m"},
       {"--resolution is \"0.1m\"", "must be a number"}},
      {kUsage, {"build", "room", "-o", "m.rmap", "--resolution", "0,1"}, {"\"0,1\""}},
      {kUsage, {"build", "room", "-o", "m.rmap", "--resolution", ""}, {"--resolution"}},
      {kUsage,
       {"build", "room", "-o", "m.rmap", "--resolution", "0.1", "--layout", "octree"},
       {"--layout is \"octree\"", "blocks or cells"}},
      {kUsage,
       {"build", "room", "-o", "m.rmap", "--resolution", "0.1", "--every", "0"},
       {"--every is \"0\"", "from 1 to 2147483647"}},
      {kUsage,
       {"build", "room", "-o", "m.rmap", "--resolution", "0.1", "--every", "1000000000000"},
       {"--every is \"1000000000000\"", "from 1 to 2147483647"}},
      {kUsage,
       {"build", "room", "-o", "m.rmap", "--resolution", "0.1", "--threads", "two"},
       {"--threads is \"two\"", "whole number"}},
      {kUsage,
       {"build", "room", "-o", "m.rmap", "--resolution", "0.1", "--crop", "0,0,0,1,1"},
       {"--crop is \"0,0,0,1,1\"", "six numbers"}},
      {kUsage,
       {"build", "room", "-o", "m.rmap", "--resolution", "0.1", "--ignore", "0,0,0,1,1,x"},
       {"--ignore", "six numbers"}},
      {kUsage,
       {"build", "room", "-o", "m.rmap", "--resolution", "0.1", "--history", "all"},
       {"--history is \"all\"", "complete or first_hit"}},
      {kUsage, {"info"}, {"FILE"}},
      {kUsage, {"query"}, {"a verb is missing", "rmap query --help"}},
      {kUsage, {"query", "m.rmap"}, {"a verb is missing", "rmap query --help"}},
      {kUsage, {"query", "m.rmap", "corner", "1,2,3"}, {"\"corner\" is no verb"}},
      {kUsage, {"query", "point", "1,2,3"}, {"MAP is missing", "rmap query --help"}},
      {kUsage, {"query", "m.rmap", "point"}, {"nothing is asked", "x,y,z"}},
      {kUsage, {"query", "m.rmap", "point", "1,2"}, {"\"1,2\"", "three numbers"}},
      {kUsage, {"query", "m.rmap", "point", "1,2,3,4"}, {"\"1,2,3,4\""}},
      {kUsage, {"query", "m.rmap", "point", "1,,2"}, {"\"1,,2\""}},
      {kUsage, {"query", "m.rmap", "box", "1,2,3"}, {"six numbers"}},
      {kUsage, {"query", "m.rmap", "cast", "0,0,0"}, {"has no direction"}},
      {kUsage, {"query", "m.rmap", "cells", "--sphere", "0,0,0,-1"}, {"radius not negative"}},
      {kUsage, {"query", "m.rmap", "cells", "--growth", "0.1"}, {"need --center"}},
      {kUsage,
       {"query", "m.rmap", "cells", "--center", "0,0,0", "--growth", "-1"},
       {"--growth is -1"}},
      {kUsage,
       {"query", "m.rmap", "cells", "--center", "0,0,0", "--box", "0,0,0,1,1,1"},
       {"--center cannot go with"}},
      {kUsage, {"simulate"}, {"SCENE is missing"}},
      {kUsage, {"simulate", "room"}, {"-o is missing"}},
      {kUsage, {"simulate", "room", "-o", "x", "--scans", "-3"}, {"--scans is \"-3\""}},
      {kUsage, {"simulate", "room", "-o", "x", "--seed", "-1"}, {"--seed is \"-1\""}},
      {kUsage, {"compare", "a.rmap"}, {"B is required"}},
      {kUsage, {"convert", "a.rmap"}, {"OUT is required"}},
      {kUsage, {"merge", "a.rmap", "b.rmap"}, {"--output is required"}},
  });
}

TEST_F(Errors, OfInputAndRequest) {
  write("no.rmap", "this is no map");
  write("empty.rmap", "");
  write("note.txt", "a note");
  std::filesystem::create_directory(folder() / "bare");
  std::filesystem::create_directory(folder() / "folder.rmap");
  write("c.ply", "ply\n");
  write("c.csv", "x,y,z\n");
  rmap_done({"build", "room", "-o", "m.rmap", "--resolution", "0.2"});
  expect({
      {kFailed, {"build", "gone", "-o", "n.rmap", "--resolution", "0.1"}, {"gone", "No such file"}},
      {kFailed, {"build", "bare", "-o", "n.rmap", "--resolution", "0.1"}, {"bare"}},
      {kFailed, {"build", "note.txt", "-o", "n.rmap", "--resolution", "0.1"}, {"note.txt"}},
      {kFailed,
       {"build", "room", "-o", "n.csv", "--resolution", "0.1"},
       {"n.csv", ".rmap", "convert"}},
      {kFailed,
       {"build", "room", "-o", "gone/n.rmap", "--resolution", "0.1"},
       {"gone/n.rmap", "No such file"}},
      // Before the scans are looked for.
      {kFailed,
       {"build", "gone", "-o", "folder.rmap", "--resolution", "0.1"},
       {"folder.rmap: it is a folder"}},
      {kFailed,
       {"build", "gone", "-o", "n.rmap", "--resolution", "0.1", "--crop", "0,3,0,1,2,1"},
       {"--crop is an empty box: y runs from 3 to 2 m"}},
      {kFailed,
       {"build", "gone", "--dry-run", "--resolution", "0.1", "--ignore", "0,0,0,1,1,1", "--ignore",
        "0,0,5,1,1,5"},
       {"--ignore is an empty box: z runs from 5 to 5 m"}},
      {kFailed, {"build", "room", "-o", "n.rmap", "--resolution", "0"}, {"resolution is 0"}},
      {kFailed,
       {"build", "room", "-o", "n.rmap", "--resolution", "nan"},
       {"resolution is nan m: it must lie in 1e-06 to 1000000 m"}},
      {kFailed,
       {"build", "room", "-o", "n.rmap", "--resolution", "0.1", "--max-range", "nan"},
       {"max_range is nan m: it must be above min_range"}},
      {kFailed, {"simulate", "room", "-o", "x", "--noise", "nan"}, {"noise is nan", "0 to 1000"}},
      {kFailed,
       {"build", "room", "-o", "n.rmap", "--resolution", "0.1", "--prob-hit", "0.3"},
       {"prob_hit"}},
      {kFailed,
       {"build", "room", "-o", "n.rmap", "--resolution", "0.1", "--max-branches", "3"},
       {"max_branches"}},
      {kFailed, {"build", "room", "-o", "n.rmap", "--onto", "gone.rmap"}, {"gone.rmap"}},
      {kFailed, {"info", "gone.rmap"}, {"gone.rmap", "No such file"}},
      {kFailed, {"info", "no.rmap"}, {"no.rmap", "is not an rmap file"}},
      {kFailed, {"info", "empty.rmap"}, {"empty.rmap"}},
      {kFailed, {"info", "note.txt"}, {"note.txt"}},
      {kFailed, {"info", "bare"}, {"bare"}},
      {kFailed, {"info", "c.ply"}, {"c.ply", "line 1", "end_header"}},
      {kFailed, {"info", "c.csv"}, {"c.csv", "holds no point"}},
      {kFailed, {"query", "no.rmap", "point", "0,0,0"}, {"no.rmap"}},
      {kFailed,
       {"query", "m.rmap", "cast", "0,0,0", "1,0,0", "--max-range", "nan"},
       {"range of the ray is nan"}},
      {kFailed, {"convert", "m.rmap", "m.xyz"}, {"m.xyz", ".csv"}},
      {kFailed, {"convert", "note.txt", "m.csv"}, {"note.txt", "neither a point"}},
      {kFailed, {"convert", "m.rmap", "gone/m.csv"}, {"gone", "No such file"}},
      {kFailed, {"convert", "gone.rmap", "bare"}, {"bare: it is a folder"}},
      {kFailed, {"convert", "gone.rmap", ""}, {"the output has no name"}},
      {kFailed, {"convert", "m.rmap", "p.rmap", "--prune", "1.5"}, {"1.5"}},
      {kFailed, {"convert", "gone.rmap", "p.rmap", "--crop", "1,1,1,0,0,0"}, {"--crop", "empty"}},
      {kFailed, {"compare", "m.rmap", "note.txt"}, {"note.txt"}},
      {kFailed, {"compare", "m.rmap", "gone.pcd"}, {"gone.pcd"}},
      {kFailed, {"merge", "m.rmap", "no.rmap", "-o", "s.rmap"}, {"no.rmap"}},
      {kFailed, {"merge", "m.rmap", "m.rmap", "-o", "s.ply"}, {"s.ply", ".rmap"}},
  });
}

TEST_F(Errors, AFileThatMustNotBeReplacedIsNamedBeforeTheWork) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  write("m.rmap", "");
  ASSERT_EQ(::chmod((folder() / "m.rmap").c_str(), 0400), 0);
  expect({{kFailed,
           {"build", "gone", "-o", "m.rmap", "--resolution", "0.1"},
           {"m.rmap: Permission denied"}}});
}

TEST_F(Errors, OfDamagedMaps) {
  rmap_done({"build", "room", "-o", "m.rmap", "--resolution", "0.2"});
  const std::string sound = bytes("m.rmap");
  const std::size_t middle = sound.size() / 2;
  std::string flipped = sound;
  flipped[middle] = static_cast<char>(flipped[middle] ^ 1);
  for (const std::string& damaged : {flipped, sound.substr(0, middle), sound + "x"}) {
    write("d.rmap", damaged);
    for (const std::vector<std::string>& call :
         {std::vector<std::string>{"info", "d.rmap"},
          {"query", "d.rmap", "point", "0,0,0"},
          {"convert", "d.rmap", "d.csv"},
          {"build", "room", "--onto", "d.rmap", "-o", "e.rmap"},
          {"merge", "m.rmap", "d.rmap", "-o", "e.rmap"}}) {
      EXPECT_THAT(rmap_refused(kFailed, call), HasSubstr("d.rmap"));
    }
  }
  EXPECT_THAT(listing(), testing::ElementsAre("d.rmap", "m.rmap", "room"));
}

// A verb's name is a name like others where files are meant.
TEST_F(Errors, FilesMayBeCalledAsVerbs) {
  std::filesystem::rename(folder() / "room", folder() / "info");
  rmap_done({"build", "info", "-o", "query.rmap", "--resolution", "0.2"});
  rmap_done({"info", "info", "query.rmap"});
}

}  // namespace

}  // namespace rmap::test
