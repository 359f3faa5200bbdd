#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/simulation/sensor.hpp>

namespace rmap {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

double azimuth_of(const Vector3d& direction) {
  return std::atan2(direction.y(), direction.x()) * kDegrees;
}

double elevation_of(const Vector3d& direction) {
  return std::atan2(direction.z(), std::hypot(direction.x(), direction.y())) * kDegrees;
}

TEST(Sensor, every_named_sensor_is_sound_and_its_beams_have_length_one) {
  EXPECT_EQ(sensor_names().size(), 6u);
  for (const std::string& name : sensor_names()) {
    SCOPED_TRACE(name);
    const SensorModel model = make_sensor(name);
    EXPECT_NO_THROW(check_sensor({.model = model}));
    const auto beams = beam_directions(model, 3);
    EXPECT_GE(beams.size(), 10000u);
    for (const Vector3d& beam : beams) ASSERT_NEAR(beam.norm(), 1, 1e-15);
  }
}

TEST(Sensor, names_that_are_none_are_refused_with_the_list) {
  try {
    make_sensor("radar");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), testing::HasSubstr("'radar'"));
    for (const std::string& name : sensor_names()) {
      EXPECT_THAT(error.what(), testing::HasSubstr(name));
    }
  }
}

TEST(Sensor, spinning_lidar_turns_left_and_spreads_its_channels_evenly) {
  const SpinningLidar lidar{
      .channels = 5, .min_elevation = -20, .max_elevation = 40, .azimuth_steps = 8};
  const auto beams = beam_directions(lidar, 0);
  ASSERT_EQ(beams.size(), 40u);
  for (int step = 0; step < 8; ++step) {
    for (int channel = 0; channel < 5; ++channel) {
      const Vector3d& beam =
          beams[5 * static_cast<std::size_t>(step) + static_cast<std::size_t>(channel)];
      EXPECT_NEAR(elevation_of(beam), -20 + 15 * channel, 1e-12);
      const double turned = std::remainder(azimuth_of(beam) - 45 * step, 360);
      EXPECT_NEAR(turned, 0, 1e-12);
    }
  }
  EXPECT_EQ(beams, beam_directions(lidar, 7));
}

TEST(Sensor, one_channel_has_the_lower_elevation) {
  const auto beams = beam_directions(SpinningLidar{.channels = 1, .min_elevation = -10}, 0);
  ASSERT_EQ(beams.size(), 1024u);
  for (const Vector3d& beam : beams) EXPECT_NEAR(elevation_of(beam), -10, 1e-12);
}

TEST(Sensor, depth_camera_looks_through_the_centres_of_its_pixels) {
  const DepthCamera camera{.width = 7, .height = 5, .fx = 10, .fy = 20, .cx = 3, .cy = 1.5};
  const auto beams = beam_directions(camera, 0);
  ASSERT_EQ(beams.size(), 35u);
  for (int v = 0; v < 5; ++v) {
    for (int u = 0; u < 7; ++u) {
      const Vector3d& beam = beams[7 * static_cast<std::size_t>(v) + static_cast<std::size_t>(u)];
      EXPECT_GT(beam.z(), 0);
      EXPECT_NEAR(beam.x() / beam.z() * 10 + 3, u, 1e-13);
      EXPECT_NEAR(beam.y() / beam.z() * 20 + 1.5, v, 1e-13);
    }
  }
}

TEST(Sensor, solid_state_lidar_fills_its_field_of_view_scan_by_scan) {
  const SolidStateLidar lidar{.beams = 2000, .horizontal_fov = 90, .vertical_fov = 50};
  std::set<std::pair<int, int>> bins;
  std::size_t after_first = 0;
  std::vector<Vector3d> all;
  for (std::uint64_t scan = 0; scan < 10; ++scan) {
    for (const Vector3d& beam : beam_directions(lidar, scan)) {
      const double azimuth = azimuth_of(beam);
      const double elevation = elevation_of(beam);
      // Within the ellipse that the prisms can reach.
      ASSERT_LE(std::hypot(azimuth / 45, elevation / 25), 1 + 1e-12);
      bins.insert(
          {static_cast<int>(std::floor(azimuth / 2)), static_cast<int>(std::floor(elevation / 2))});
      all.push_back(beam);
    }
    if (scan == 0) after_first = bins.size();
  }
  // The ellipse has an area of 883 bins.
  EXPECT_LT(after_first, 700u);
  EXPECT_GT(bins.size(), 850u);
  std::sort(all.begin(), all.end(), [](const Vector3d& a, const Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end()) << "no beam comes twice";
}

TEST(Sensor, solid_state_scans_go_on_where_the_last_one_ended) {
  const auto whole = beam_directions(SolidStateLidar{.beams = 300}, 0);
  for (std::uint64_t scan = 0; scan < 3; ++scan) {
    const auto part = beam_directions(SolidStateLidar{.beams = 100}, scan);
    const auto first = whole.begin() + static_cast<std::ptrdiff_t>(scan * 100);
    EXPECT_TRUE(std::equal(part.begin(), part.end(), first));
  }
}

TEST(Sensor, cameras_look_ahead_and_lidars_share_the_axes_of_the_body) {
  EXPECT_TRUE(body_from_sensor(SpinningLidar{}).isApprox(Pose::Identity(), 0));
  EXPECT_TRUE(body_from_sensor(SolidStateLidar{}).isApprox(Pose::Identity(), 0));
  const Pose camera = body_from_sensor(DepthCamera{});
  EXPECT_NO_THROW(check_pose(camera));
  EXPECT_EQ(rotated(camera, {0, 0, 1}), Vector3d(1, 0, 0));   // ahead
  EXPECT_EQ(rotated(camera, {1, 0, 0}), Vector3d(0, -1, 0));  // right
  EXPECT_EQ(rotated(camera, {0, 1, 0}), Vector3d(0, 0, -1));  // down
}

void expect_refused(const Sensor& sensor, const std::string& field) {
  try {
    check_sensor(sensor);
    ADD_FAILURE() << field << " was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), testing::HasSubstr(field));
  }
  EXPECT_THROW(simulate_scan(Scene(), sensor, Pose::Identity(), 0, 0), Error);
}

TEST(Sensor, options_out_of_range_are_refused_by_name) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expect_refused({.noise = -0.1}, "noise");
  expect_refused({.noise = nan}, "noise");
  expect_refused({.dropped = 1.1}, "dropped");
  expect_refused({.dropped = -0.1}, "dropped");
  expect_refused({.model = SpinningLidar{.channels = 0}}, "channels is 0");
  expect_refused({.model = SpinningLidar{.azimuth_steps = -4}}, "azimuth_steps is -4");
  expect_refused({.model = SpinningLidar{.channels = 1 << 14, .azimuth_steps = 1 << 14}},
                 "channels and azimuth_steps");
  expect_refused({.model = SpinningLidar{.min_elevation = -91}}, "min_elevation");
  expect_refused({.model = SpinningLidar{.min_elevation = 20}}, "max_elevation");
  expect_refused({.model = SpinningLidar{.min_range = -1}}, "min_range");
  expect_refused({.model = SpinningLidar{.max_range = 0.5}}, "max_range");
  expect_refused({.model = SpinningLidar{.max_range = infinity}}, "max_range");
  expect_refused({.model = SolidStateLidar{.beams = 0}}, "beams");
  expect_refused({.model = SolidStateLidar{.horizontal_fov = 0}}, "horizontal_fov");
  expect_refused({.model = SolidStateLidar{.horizontal_fov = 361}}, "horizontal_fov");
  expect_refused({.model = SolidStateLidar{.vertical_fov = 181}}, "vertical_fov");
  expect_refused({.model = SolidStateLidar{.min_range = nan}}, "min_range");
  expect_refused({.model = DepthCamera{.width = 0}}, "width");
  expect_refused({.model = DepthCamera{.height = -1}}, "height");
  expect_refused({.model = DepthCamera{.width = 1 << 20, .height = 1 << 20}}, "width and height");
  expect_refused({.model = DepthCamera{.fx = 0}}, "fx");
  expect_refused({.model = DepthCamera{.fy = nan}}, "fy");
  expect_refused({.model = DepthCamera{.cx = infinity}}, "cx");
  expect_refused({.model = DepthCamera{.cy = nan}}, "cy");
  expect_refused({.model = DepthCamera{.depth_noise = -1}}, "depth_noise");
  expect_refused({.model = DepthCamera{.max_range = 0.1}}, "max_range");
}

}  // namespace
}  // namespace rmap
