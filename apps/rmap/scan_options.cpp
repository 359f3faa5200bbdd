#include "scan_options.hpp"

#include "arguments.hpp"

#include <array>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap::command {

namespace {

Pose pose_argument(const std::string& text, QuaternionOrder order) {
  std::array<double, 7> n;
  if (!parse_numbers(text, n)) {
    throw UsageError(
        fmt::format("--sensor-pose is \"{}\": it must be seven numbers X,Y,Z and a "
                    "quaternion, by default QX,QY,QZ,QW",
                    text));
  }
  try {
    return make_pose({n[0], n[1], n[2]}, quaternion_of(&n[3], order));
  } catch (const Error& error) {
    throw UsageError(fmt::format("--sensor-pose is \"{}\": {}", text, error.what()));
  }
}

}  // namespace

void ScanOptions::add_to(CLI::App& app) {
  const std::size_t before = app.get_options().size();
  frame_option_ =
      add_word(app, "--frame", frame_,
               "Frame of the points, where the files do not say: sensor or world (default sensor "
               "for scans with poses, world with --sensor-origin).");
  add_text(app, "--sensor-pose", sensor_pose_, "POSE",
           "Sensor to map, for a lone file: X,Y,Z,QX,QY,QZ,QW; its points are in the sensor's "
           "frame.");
  add_vector(app, "--sensor-origin", options_.sensor_origin,
             "Where the sensor stood, for a lone file in the world's frame, in its coordinates.");
  app.add_flag("--end-points", options_.end_points,
               "Points in the world's frame without a sensor: cells are hit, nothing is cleared.");
  add_vector(app, "--offset", offset_,
             "The map's origin in the coordinates of the files: taken off points, poses and "
             "origins, in double.");
  add_number(app, "--no-return", options_.no_return,
             "Points at this range (m) are directions without return, which only clear.");
  add_text(app, "--columns", columns_, "NAMES",
           "Columns of .bin files, float32 each or NAME:TYPE with f64, u16 and so on (default "
           "x,y,z,intensity).");
  add_path(app, "--trajectory", options_.trajectory,
           "Poses of the sensor in a file: TUM (time tx ty tz qx qy qz qw) or KITTI (3x4).");
  add_path(app, "--times", options_.times,
           "Times, one a line: of KITTI poses in a bag, of the scans in a folder (default its "
           "times.txt).");
  add_word(app, "--quaternion", options_.quaternion,
           "Order in poses of text and in --sensor-pose: xyzw or wxyz (default xyzw).");
  add_bag_options(app);
  const std::vector<CLI::Option*> all = app.get_options({});
  for (std::size_t i = before; i < all.size(); ++i) all[i]->group("Reading scans");
}

void ScanOptions::add_bag_options(CLI::App& app) {
  add_text(app, "--topic", options_.bag.topic, "NAME",
           "Bags: the topic of the clouds (default the only one).");
  add_text(app, "--pose-topic", options_.bag.pose_topic, "NAME",
           "Bags: the topic of the poses (default tf, else the only one).");
  add_text(app, "--map-frame", options_.bag.map_frame, "NAME",
           "Bags: the frame of the map (default the root of tf).");
  add_number(app, "--from", options_.bag.from,
             "Bags: scans from this many seconds after the first message on.");
  add_number(app, "--to", options_.bag.to, "Bags: scans up to so many seconds after it.");
}

ScanReadOptions ScanOptions::options() const {
  ScanReadOptions options = options_;
  if (frame_option_->count() > 0) options.frame = frame_;
  if (!sensor_pose_.empty()) {
    options.sensor_pose = pose_argument(sensor_pose_, options.quaternion);
  }
  if (offset_) options.offset = *offset_;
  if (!columns_.empty()) options.columns = split_at_commas(columns_);
  return options;
}

}  // namespace rmap::command
