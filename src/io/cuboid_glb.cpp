#include "io/bytes.hpp"
#include "io/color_map.hpp"
#include "io/cuboid_formats.hpp"
#include "io/input_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

// glTF 2.0 in one file: a header, a chunk of JSON and one with what the JSON describes.
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

// Sides have corners of their own, since each side has its own normal.
constexpr std::size_t kVertices = 24;
constexpr std::size_t kIndices = 36;
constexpr std::size_t kPositionSize = 3 * sizeof(float);
constexpr std::size_t kColorSize = 4 * sizeof(std::uint16_t);
constexpr std::size_t kBytesPerBox =
    kVertices * (2 * kPositionSize + kColorSize) + kIndices * sizeof(std::uint32_t);

// The four corners of a side from its two triangles (a, b, c) and (a, c, d).
std::array<unsigned, 4> corners_of_side(std::size_t side) {
  const auto& first = kBoxTriangles[2 * side];
  return {first[0], first[1], first[2], kBoxTriangles[2 * side + 1][2]};
}

Vector3f outward(std::size_t side) {
  return Vector3f::Unit(static_cast<int>(side / 2)) * (side % 2 == 0 ? -1.0F : 1.0F);
}

template <class T, std::size_t kCount>
std::array<std::byte, kCount * sizeof(T)> bytes_of(const std::array<T, kCount>& numbers) {
  std::array<std::byte, kCount * sizeof(T)> bytes;
  auto next = bytes.begin();
  for (const T number : numbers) next = std::ranges::copy(little_endian(number), next).out;
  return bytes;
}

// glTF wants light, of which sRGB is a curve.
std::uint16_t linear(std::uint8_t srgb) {
  const double part = srgb / 255.0;
  const double light = part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  return static_cast<std::uint16_t>(std::lround(65535 * light));
}

class GlbWriter {
 public:
  GlbWriter(AtomicFile& file, const CuboidList& list) : file_(file), list_(list), boxes_(list) {
    measure();
  }

  void write() {
    std::string json = list_.cuboids.empty() ? empty_json() : mesh_json();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t binary = kBytesPerBox * list_.cuboids.size();
    const std::size_t total = 12 + 8 + json.size() + (binary == 0 ? 0 : 8 + binary);
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorKind::limit,
                  fmt::format("{} cannot hold {} cuboids: the file would have {} bytes, and a .glb "
                              "file can have 4294967295",
                              file_.target().string(), list_.cuboids.size(), total));
    }
    number(kMagic);
    number(std::uint32_t{2});
    number(static_cast<std::uint32_t>(total));
    number(static_cast<std::uint32_t>(json.size()));
    number(kJsonChunk);
    file_.write(json);
    if (binary == 0) return;  // buffers of no bytes are not allowed
    number(static_cast<std::uint32_t>(binary));
    number(kBinaryChunk);
    write_positions();
    write_normals();
    write_colors();
    write_indices();
  }

 private:
  // The range of heights, the origin of the positions, and their range as the floats they become.
  void measure() {
    if (list_.cuboids.empty()) return;
    CellBox bounds = list_.cuboids.front().cells;
    for (const Cuboid& cuboid : list_.cuboids) {
      bounds = united(bounds, cuboid.cells);
      for (unsigned i = 0; i < 8; ++i) scale_.add(boxes_.corner(cuboid.cells, i).z());
    }
    origin_ = bounds.min + bounds.extent().cast<std::int32_t>() / 2;
    low_ = position(bounds.min);
    high_ = position(bounds.max);
  }

  // From positions, which are cells beside the origin, to metres in the input's frame with y up as
  // glTF has it: a matrix, column by column.
  std::string root_json() const {
    Eigen::Matrix3d y_up;
    y_up << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    for (int axis = 0; axis < 3; ++axis) {
      matrix.block<3, 1>(0, axis) =
          y_up * boxes_.direction(Vector3d::Unit(axis)) * list_.resolution;
    }
    matrix.block<3, 1>(0, 3) = y_up * boxes_.corner({.min = origin_, .max = origin_}, 0);
    return fmt::format(R"("nodes":[{{"name":"cells","matrix":[{}])",
                       joined(matrix.reshaped(), ","));
  }

  static std::string start_json() {
    return R"({"asset":{"version":"2.0","generator":"rmap"},"scene":0,"scenes":[{"nodes":[0]}],)";
  }

  std::string empty_json() const { return start_json() + root_json() + "}]}"; }

  std::string mesh_json() const {
    const std::size_t vertices = kVertices * list_.cuboids.size();
    const std::size_t positions = kPositionSize * vertices;
    const std::size_t colors = kColorSize * vertices;
    const std::size_t indices = kIndices * list_.cuboids.size();
    std::string json = start_json();
    json += root_json() + R"(,"mesh":0}],)";
    json += R"("materials":[{"name":"height","pbrMetallicRoughness":{"metallicFactor":0,)"
            R"("roughnessFactor":1}}],)"
            R"("meshes":[{"name":"cuboids","primitives":[{"attributes":{"POSITION":0,"NORMAL":1,)"
            R"("COLOR_0":2},"indices":3,"material":0}]}],)";
    json += fmt::format(
        R"("accessors":[)"
        R"({{"bufferView":0,"componentType":5126,"count":{0},"type":"VEC3","min":[{1}],"max":[{2}]}},)"
        R"({{"bufferView":1,"componentType":5126,"count":{0},"type":"VEC3"}},)"
        R"({{"bufferView":2,"componentType":5123,"normalized":true,"count":{0},"type":"VEC4"}},)"
        R"({{"bufferView":3,"componentType":5125,"count":{3},"type":"SCALAR"}}],)",
        vertices, joined(low_.cast<double>(), ","), joined(high_.cast<double>(), ","), indices);
    json += fmt::format(R"("bufferViews":[)"
                        R"({{"buffer":0,"byteOffset":0,"byteLength":{0},"target":34962}},)"
                        R"({{"buffer":0,"byteOffset":{0},"byteLength":{0},"target":34962}},)"
                        R"({{"buffer":0,"byteOffset":{1},"byteLength":{2},"target":34962}},)"
                        R"({{"buffer":0,"byteOffset":{3},"byteLength":{4},"target":34963}}],)"
                        R"("buffers":[{{"byteLength":{5}}}]}})",
                        positions, 2 * positions, colors, 2 * positions + colors,
                        sizeof(std::uint32_t) * indices, kBytesPerBox * list_.cuboids.size());
    return json;
  }

  // The bytes of each corner of a box, which it has on all of its three sides.
  template <class BytesOf>
  void write_corners(BytesOf&& bytes_at) {
    for (const Cuboid& cuboid : list_.cuboids) {
      std::array<std::invoke_result_t<BytesOf, CellBox, unsigned>, 8> corners;
      for (unsigned i = 0; i < 8; ++i) corners[i] = bytes_at(cuboid.cells, i);
      for (std::size_t side = 0; side < 6; ++side) {
        for (const unsigned corner : corners_of_side(side)) file_.write(corners[corner]);
      }
    }
  }

  Vector3f position(const Cell& corner) const {
    return (corner.cast<std::int64_t>() - origin_.cast<std::int64_t>()).cast<float>();
  }

  void write_positions() {
    write_corners([&](const CellBox& cells, unsigned index) {
      const Vector3f at = position(corner_of(cells, index));
      return bytes_of<float, 3>({at.x(), at.y(), at.z()});
    });
  }

  void write_colors() {
    write_corners([&](const CellBox& cells, unsigned index) {
      const Color color = viridis(scale_.share(boxes_.corner(cells, index).z()));
      return bytes_of<std::uint16_t, 4>(
          {linear(color[0]), linear(color[1]), linear(color[2]), 65535});
    });
  }

  void write_normals() {
    std::vector<std::byte> normals;
    for (std::size_t side = 0; side < 6; ++side) {
      const Vector3f normal = outward(side);
      const auto bytes = bytes_of<float, 3>({normal.x(), normal.y(), normal.z()});
      for (int corner = 0; corner < 4; ++corner) {
        normals.insert(normals.end(), bytes.begin(), bytes.end());
      }
    }
    for (std::size_t box = 0; box < list_.cuboids.size(); ++box) file_.write(normals);
  }

  void write_indices() {
    const std::size_t sides = 6 * list_.cuboids.size();
    for (std::size_t side = 0; side < sides; ++side) {
      const auto first = static_cast<std::uint32_t>(4 * side);
      file_.write(
          bytes_of<std::uint32_t, 6>({first, first + 1, first + 2, first, first + 2, first + 3}));
    }
  }

  template <class T>
  void number(T value) {
    file_.write(little_endian(value));
  }

  AtomicFile& file_;
  const CuboidList& list_;
  InputBoxes boxes_;
  HeightScale scale_;
  // Positions are floats, and cells are whole numbers: beside a corner of cells in their middle
  // they are exact within 16 million cells of it.
  Cell origin_ = Cell::Zero();
  Vector3f low_ = Vector3f::Zero();
  Vector3f high_ = Vector3f::Zero();
};

}  // namespace

void write_cuboid_glb(AtomicFile& file, const CuboidList& list) { GlbWriter(file, list).write(); }

}  // namespace rmap
