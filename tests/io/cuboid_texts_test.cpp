// What the formats of text for other programs hold: .json, .urdf, .sdf, .xml, .scene.

#include "io/cuboid_samples.hpp"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <rmap/cuboid_files.hpp>

namespace rmap {
namespace {

constexpr double kTolerance = 1e-6;
constexpr int kBoxes = 300;

// Takes a text apart piece by piece; anything else than what is expected is a failure.
class Scanner {
 public:
  explicit Scanner(const std::string& text) : text_(text) {}

  void expect(const std::string& piece) {
    ASSERT_EQ(text_.substr(at_, piece.size()), piece) << "at " << at_;
    at_ += piece.size();
  }
  bool sees(const std::string& piece) const { return text_.compare(at_, piece.size(), piece) == 0; }
  bool at_end() const { return at_ == text_.size(); }

  // `count` numbers, then `end`.
  std::vector<double> numbers(std::size_t count, const std::string& end) {
    const std::size_t stop = text_.find(end, at_);
    EXPECT_NE(stop, std::string::npos);
    std::istringstream words(text_.substr(at_, stop - at_));
    std::vector<double> numbers;
    for (double number = 0; words >> number;) numbers.push_back(number);
    EXPECT_TRUE(words.eof());
    EXPECT_EQ(numbers.size(), count);
    numbers.resize(count);
    at_ = stop + end.size();
    return numbers;
  }
  Vector3d vector(const std::string& end) {
    const auto values = numbers(3, end);
    return {values[0], values[1], values[2]};
  }

 private:
  std::string text_;
  std::size_t at_ = 0;
};

Eigen::Matrix3d matrix_of(const Vector3d& roll_pitch_yaw) {
  return (Eigen::AngleAxisd(roll_pitch_yaw.z(), Vector3d::UnitZ()) *
          Eigen::AngleAxisd(roll_pitch_yaw.y(), Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll_pitch_yaw.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

using Boxes = std::vector<test::Corners>;

// Each box stands there twice: as it is touched and as it is seen.
Boxes parsed_urdf(const std::string& text) {
  Scanner scanner(text);
  Boxes boxes;
  scanner.expect("<?xml version=\"1.0\"?>\n<robot name=\"cuboids\">\n<link name=\"cuboids\">\n");
  while (scanner.sees("<collision")) {
    for (const std::string element : {"collision", "visual"}) {
      scanner.expect("<" + element + " name=\"cuboid_" + std::to_string(boxes.size() / 2) + "\">");
      scanner.expect("<origin xyz=\"");
      const Vector3d center = scanner.vector("\" rpy=\"");
      const Vector3d turn = scanner.vector("\"/><geometry><box size=\"");
      const Vector3d size = scanner.vector("\"/></geometry></" + element + ">\n");
      boxes.push_back(test::corners_of(center, matrix_of(turn), size));
    }
  }
  scanner.expect("</link>\n</robot>\n");
  EXPECT_TRUE(scanner.at_end());
  return boxes;
}

Boxes parsed_sdf(const std::string& text) {
  Scanner scanner(text);
  Boxes boxes;
  scanner.expect("<?xml version=\"1.0\"?>\n<sdf version=\"1.6\">\n<model name=\"cuboids\">\n");
  scanner.expect("<static>true</static>\n<link name=\"cuboids\">\n");
  while (scanner.sees("<collision")) {
    for (const std::string element : {"collision", "visual"}) {
      scanner.expect("<" + element + " name=\"" + element + "_" + std::to_string(boxes.size() / 2));
      scanner.expect("\"><pose>");
      const auto pose = scanner.numbers(6, "</pose><geometry><box><size>");
      const Vector3d size = scanner.vector("</size></box></geometry></" + element + ">\n");
      boxes.push_back(test::corners_of({pose[0], pose[1], pose[2]},
                                       matrix_of({pose[3], pose[4], pose[5]}), size));
    }
  }
  scanner.expect("</link>\n</model>\n</sdf>\n");
  EXPECT_TRUE(scanner.at_end());
  return boxes;
}

Boxes parsed_mjcf(const std::string& text) {
  Scanner scanner(text);
  Boxes boxes;
  scanner.expect("<?xml version=\"1.0\"?>\n<mujoco model=\"cuboids\">\n<worldbody>\n");
  while (scanner.sees("<geom")) {
    scanner.expect("<geom name=\"cuboid_" + std::to_string(boxes.size()) +
                   "\" type=\"box\" pos=\"");
    const Vector3d center = scanner.vector("\" quat=\"");
    const auto turn = scanner.numbers(4, "\" size=\"");
    const Vector3d half = scanner.vector("\"/>\n");
    boxes.push_back(test::corners_of(
        center, Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]).toRotationMatrix(),
        2 * half));
  }
  scanner.expect("</worldbody>\n</mujoco>\n");
  EXPECT_TRUE(scanner.at_end());
  return boxes;
}

Pose next_pose(Scanner& scanner) {
  const Vector3d translation = scanner.vector("\n");
  const auto turn = scanner.numbers(4, "\n");
  return make_pose(translation, Eigen::Quaterniond(turn[3], turn[0], turn[1], turn[2]));
}

// As PlanningScene::loadGeometryFromStream of MoveIt goes through it.
Boxes parsed_scene(const std::string& text) {
  Scanner scanner(text);
  Boxes boxes;
  scanner.expect("cuboids\n");
  while (scanner.sees("*")) {
    scanner.expect("* cuboid_" + std::to_string(boxes.size()) + "\n");
    const Pose object = next_pose(scanner);
    scanner.expect("1\nbox\n");
    const Vector3d size = scanner.vector("\n");
    const Pose shape = object * next_pose(scanner);
    scanner.expect("0 0 0 0\n0\n");
    boxes.push_back(test::corners_of(shape.translation(), shape.linear(), size));
  }
  scanner.expect(".\n");
  EXPECT_TRUE(scanner.at_end());
  return boxes;
}

void expect_boxes(const Boxes& boxes, const CuboidList& list, std::size_t times) {
  ASSERT_EQ(boxes.size(), times * list.cuboids.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    ASSERT_LT(test::distance(boxes[i], test::corners_of(list, list.cuboids[i / times])), kTolerance)
        << i;
  }
}

void expect_boxes_in_all(const CuboidList& list) {
  expect_boxes(parsed_urdf(test::written(".urdf", list)), list, 2);
  expect_boxes(parsed_sdf(test::written(".sdf", list)), list, 2);
  expect_boxes(parsed_mjcf(test::written(".xml", list)), list, 1);
  expect_boxes(parsed_scene(test::written(".scene", list)), list, 1);
}

TEST(CuboidTexts, of_robots_hold_the_boxes_in_any_frame) {
  test::Random random(41);
  SCOPED_TRACE(random.trace());
  for (int i = 0; i < 20; ++i) expect_boxes_in_all(test::near_cuboids(random, kBoxes / 20));
  CuboidList far = test::near_cuboids(random, kBoxes);
  far.frame.translation() = Vector3d(4.5e5, -5.8e6, 300);
  expect_boxes_in_all(far);
}

TEST(CuboidTexts, of_robots_hold_the_boxes_turned_by_right_angles) {
  test::Random random(42);
  SCOPED_TRACE(random.trace());
  CuboidList list = test::near_cuboids(random, 3);
  int cases = 0;
  for (int turn = 0; turn < 64; ++turn) {
    // Pitches of a right angle, too, where roll and yaw are the same turn; and all but one.
    for (const double off : {0.0, 1e-9, -1e-7}) {
      const Vector3d angles = M_PI / 2 * Vector3d(turn % 4, turn / 4 % 4, turn / 16);
      list.frame.linear() = matrix_of(angles + Vector3d::Constant(off));
      expect_boxes_in_all(list);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 192);
}

TEST(CuboidTexts, of_nothing_are_complete) {
  EXPECT_TRUE(parsed_urdf(test::written(".urdf", {})).empty());
  EXPECT_TRUE(parsed_sdf(test::written(".sdf", {})).empty());
  EXPECT_TRUE(parsed_mjcf(test::written(".xml", {})).empty());
  EXPECT_EQ(test::written(".scene", {}), "cuboids\n* cuboids\n0 0 0\n0 0 0 1\n0\n0\n.\n");
}

TEST(CuboidTexts, of_scenes_are_what_moveit_reads) {
  CuboidList list = test::small_list();
  list.frame = Pose::Identity();
  list.cuboids.pop_back();
  EXPECT_EQ(test::written(".scene", list),
            "cuboids\n* cuboid_0\n0.5 0.25 0.35000000000000003\n0 0 0 1\n1\nbox\n3 0.5 0.1\n"
            "0 0 0\n0 0 0 1\n0 0 0 0\n0\n.\n");
}

TEST(CuboidTexts, of_json_hold_the_list) {
  test::Random random(43);
  SCOPED_TRACE(random.trace());
  for (const int count : {0, 1, 2, 300}) {
    const CuboidList list = test::random_cuboids(random, count);
    const auto json = nlohmann::json::parse(test::written(".json", list));
    EXPECT_EQ(json.size(), 5U);
    EXPECT_EQ(json["format"], "rmap cuboids");
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["resolution"], list.resolution);
    const auto& turn = json["frame"]["quaternion"];
    const auto& move = json["frame"]["translation"];
    const Pose frame =
        make_pose(Vector3d(move[0].get<double>(), move[1].get<double>(), move[2].get<double>()),
                  Eigen::Quaterniond(turn[3], turn[0], turn[1], turn[2]));
    EXPECT_LT((frame.matrix() - list.frame.matrix()).cwiseAbs().maxCoeff(), 1e-12);
    ASSERT_EQ(json["cuboids"].size(), list.cuboids.size());
    for (std::size_t i = 0; i < list.cuboids.size(); ++i) {
      const Cuboid& cuboid = list.cuboids[i];
      const auto& row = json["cuboids"][i];
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(row["min"][static_cast<std::size_t>(axis)],
                  cuboid.cells.min[axis] * list.resolution);
        ASSERT_EQ(row["max"][static_cast<std::size_t>(axis)],
                  cuboid.cells.max[axis] * list.resolution);
      }
      ASSERT_EQ(row["points"].get<std::uint64_t>(), cuboid.points);
      ASSERT_EQ(row["density"], cuboid.density());
    }
  }
}

}  // namespace
}  // namespace rmap
