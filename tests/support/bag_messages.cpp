#include "support/bag_messages.hpp"

namespace rmap::test {

CdrWriter& CdrWriter::text(std::string_view text) {
  number(static_cast<std::uint32_t>(text.size() + 1));
  bytes_ += text;
  bytes_ += '\0';
  return *this;
}

CdrWriter& CdrWriter::raw(std::string_view raw) {
  number(static_cast<std::uint32_t>(raw.size()));
  bytes_ += raw;
  return *this;
}

CdrWriter& CdrWriter::header(std::int64_t stamp, std::string_view frame) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  number(static_cast<std::int32_t>(stamp / kSecond));
  number(static_cast<std::uint32_t>(stamp % kSecond));
  return text(frame);
}

CdrWriter& CdrWriter::pose(const Vector3d& translation, const Eigen::Quaterniond& rotation) {
  for (const double value : translation) number(value);
  return number(rotation.x()).number(rotation.y()).number(rotation.z()).number(rotation.w());
}

std::string transforms_message(const std::vector<TestTransform>& transforms, bool big_endian) {
  CdrWriter writer(big_endian);
  writer.number(static_cast<std::uint32_t>(transforms.size()));
  for (const TestTransform& transform : transforms) {
    writer.header(transform.stamp, transform.parent)
        .text(transform.child)
        .pose(transform.translation, transform.rotation);
  }
  return writer.bytes();
}

std::string odometry_message(const TestTransform& transform, bool big_endian) {
  CdrWriter writer(big_endian);
  writer.header(transform.stamp, transform.parent)
      .text(transform.child)
      .pose(transform.translation, transform.rotation);
  for (int i = 0; i < 36 + 6 + 36; ++i) writer.number(0.5);  // covariances and speeds
  return writer.bytes();
}

std::string pose_message(const TestTransform& transform, bool big_endian) {
  CdrWriter writer(big_endian);
  writer.header(transform.stamp, transform.parent).pose(transform.translation, transform.rotation);
  return writer.bytes();
}

std::string pose_with_covariance_message(const TestTransform& transform, bool big_endian) {
  CdrWriter writer(big_endian);
  writer.header(transform.stamp, transform.parent).pose(transform.translation, transform.rotation);
  for (int i = 0; i < 36; ++i) writer.number(0.25);
  return writer.bytes();
}

std::string TestCloud::message(bool big_endian) const {
  CdrWriter writer(big_endian);
  writer.header(stamp, frame).number(height).number(width);
  writer.number(static_cast<std::uint32_t>(fields.size()));
  for (const TestField& field : fields) {
    writer.text(field.name).number(field.offset).number(field.type).number(field.count);
  }
  writer.number(static_cast<std::uint8_t>(big_endian_data)).number(point_step).number(row_step);
  writer.raw(data).number(std::uint8_t{1});
  return writer.bytes();
}

TestCloud cloud_of(std::span<const Vector3f> points, std::int64_t stamp, std::string_view frame) {
  TestCloud cloud;
  cloud.stamp = stamp;
  cloud.frame = frame;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.assign(reinterpret_cast<const char*>(points.data()), points.size_bytes());
  return cloud;
}

}  // namespace rmap::test
