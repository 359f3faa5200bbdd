#include "io/option_meaning.hpp"

#include "io/files.hpp"

#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::write_text;

const std::vector<ScanReadOptions> kOfBags = {{.bag = {.topic = "/points"}},
                                              {.bag = {.pose_topic = "/odom"}},
                                              {.bag = {.map_frame = "map"}},
                                              {.bag = {.from = 1}},
                                              {.bag = {.to = 1}}};

// Each of the options is refused with the name of what is read, and none of them is not.
void expect_refused(const std::string& path, const std::vector<ScanReadOptions>& refused,
                    const std::function<void(const ScanReadOptions&)>& read,
                    const ScanReadOptions& accepted = {}) {
  SCOPED_TRACE(path);
  for (std::size_t i = 0; i < refused.size(); ++i) {
    SCOPED_TRACE(i);
    try {
      read(refused[i]);
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), testing::HasSubstr(" has no meaning for " + path + ": "));
    }
  }
  EXPECT_NO_THROW(read(accepted));
}

std::vector<ScanReadOptions> with(std::vector<ScanReadOptions> options,
                                  std::initializer_list<ScanReadOptions> more) {
  options.insert(options.end(), more);
  return options;
}

class OptionMeaning : public testing::Test {
 protected:
  // A folder with one scan; `name` ends as its format does.
  std::string folder_with(const std::string& name) {
    const std::filesystem::path folder = folder_ / ("of_" + name);
    std::filesystem::create_directory(folder);
    write_points(folder / name, std::vector<Vector3f>{{1, 2, 3}});
    write_text(folder / "poses.txt", "0 0 0 0 0 0 1\n");
    return folder.string();
  }

  static void open(const std::string& path, const ScanReadOptions& options) {
    Scan scan;
    open_scans(path, options)->next(scan);
  }

  test::TemporaryFolder folder_;
};

TEST_F(OptionMeaning, of_folders) {
  const std::string pcd = folder_with("a.pcd");
  const std::string bin = folder_with("a.bin");
  const std::string poses = bin + "/poses.txt";
  expect_refused(pcd,
                 with(kOfBags, {{.columns = {"x", "y", "z", "i"}},
                                {.times = "t"},
                                {.end_points = true, .trajectory = poses}}),
                 [&](const ScanReadOptions& options) { open(pcd, options); });
  // The numbers of KITTI's poses are those of the scans.
  expect_refused(bin, with(kOfBags, {{.trajectory = poses, .times = poses}}),
                 [&](const ScanReadOptions& options) { open(bin, options); },
                 {.columns = {"x", "y", "z", "i"}, .trajectory = poses});
}

TEST_F(OptionMeaning, of_lone_files) {
  const std::string file = folder_with("a.pcd") + "/a.pcd";
  const std::string poses = std::filesystem::path(file).replace_filename("poses.txt");
  expect_refused(file,
                 with(kOfBags, {{.columns = {"x", "y", "z"}},
                                {.times = "t"},
                                {.sensor_pose = Pose::Identity(), .trajectory = poses},
                                {.sensor_origin = Vector3d(0, 0, 0), .trajectory = poses},
                                {.end_points = true, .trajectory = poses}}),
                 [&](const ScanReadOptions& options) { open(file, options); },
                 {.trajectory = poses});
}

TEST_F(OptionMeaning, of_graphs) {
  const std::string file = folder_ / "a.graph";
  write_text(file, std::string(8, '\0'));
  expect_refused(file,
                 with(kOfBags, {{.columns = {"x", "y", "z"}},
                                {.trajectory = "t"},
                                {.times = "t"},
                                {.sensor_pose = Pose::Identity()},
                                {.sensor_origin = Vector3d(0, 0, 0)},
                                {.end_points = true}}),
                 [&](const ScanReadOptions& options) { open(file, options); },
                 {.frame = Frame::map, .no_return = 5});
}

TEST_F(OptionMeaning, of_clouds) {
  const std::string file = folder_with("a.pcd") + "/a.pcd";
  expect_refused(file,
                 with(kOfBags, {{.columns = {"x", "y", "z"}},
                                {.trajectory = "t"},
                                {.times = "t"},
                                {.no_return = 5},
                                {.sensor_pose = Pose::Identity()},
                                {.sensor_origin = Vector3d(0, 0, 0)},
                                {.end_points = true}}),
                 [&](const ScanReadOptions& options) { read_points(file, options); },
                 {.frame = Frame::sensor, .offset = {1, 2, 3}});
}

}  // namespace
}  // namespace rmap
