#include "io/bytes.hpp"
#include "io/color_map.hpp"
#include "io/cuboid_samples.hpp"
#include "io/files.hpp"

#include <cmath>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <rmap/cuboid_files.hpp>

namespace rmap {
namespace {

template <class T>
T number_at(const std::string& bytes, std::size_t offset) {
  return load_little<T>(
      std::as_bytes(std::span(std::string_view(bytes).substr(offset, sizeof(T)))).data());
}

// What both formats come to: triangles over vertices of the input's frame, z up.
struct Mesh {
  std::vector<Vector3d> vertices;
  std::vector<Vector3d> colors;  // sRGB, 0 to 255
  std::vector<Vector3d> normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Mesh parsed_ply(const std::string& text) {
  std::istringstream header(text);
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::string properties;
  std::string line;
  std::getline(header, line);
  EXPECT_EQ(line, "ply");
  std::getline(header, line);
  EXPECT_EQ(line, "format binary_little_endian 1.0");
  while (std::getline(header, line) && line != "end_header") {
    if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
    if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
    if (line.starts_with("property ")) properties += line.substr(9) + ';';
  }
  EXPECT_EQ(properties,
            "double x;double y;double z;uchar red;uchar green;uchar blue;"
            "list uchar int vertex_indices;");
  auto offset = static_cast<std::size_t>(header.tellg());
  EXPECT_EQ(text.size(), offset + 27 * vertices + 13 * faces);
  Mesh mesh;
  for (std::size_t i = 0; i < vertices; ++i, offset += 27) {
    mesh.vertices.emplace_back(number_at<double>(text, offset), number_at<double>(text, offset + 8),
                               number_at<double>(text, offset + 16));
    mesh.colors.emplace_back(number_at<std::uint8_t>(text, offset + 24),
                             number_at<std::uint8_t>(text, offset + 25),
                             number_at<std::uint8_t>(text, offset + 26));
  }
  for (std::size_t i = 0; i < faces; ++i, offset += 13) {
    EXPECT_EQ(number_at<std::uint8_t>(text, offset), 3);
    mesh.triangles.push_back({number_at<std::uint32_t>(text, offset + 1),
                              number_at<std::uint32_t>(text, offset + 5),
                              number_at<std::uint32_t>(text, offset + 9)});
  }
  return mesh;
}

// The chunks of a .glb file.
struct Glb {
  nlohmann::json json;
  std::string binary;
};

Glb parsed_glb(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 4), 2U);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 8), bytes.size());
  const auto json_size = number_at<std::uint32_t>(bytes, 12);
  EXPECT_EQ(json_size % 4, 0U);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  Glb glb{.json = nlohmann::json::parse(bytes.substr(20, json_size)), .binary = {}};
  const std::size_t end = 20 + json_size;
  if (end == bytes.size()) return glb;
  const auto size = number_at<std::uint32_t>(bytes, end);
  EXPECT_EQ(size % 4, 0U);
  EXPECT_EQ(bytes.substr(end + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(end + 8 + size, bytes.size());
  glb.binary = bytes.substr(end + 8, size);
  return glb;
}

// The numbers of an accessor, as they are in the file.
std::vector<double> accessor(const Glb& glb, std::size_t index) {
  const auto& json = glb.json["accessors"][index];
  const auto& view = glb.json["bufferViews"][json["bufferView"].get<std::size_t>()];
  const std::map<std::string, std::size_t> widths = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
  const std::size_t count = json["count"].get<std::size_t>() * widths.at(json["type"]);
  const int type = json["componentType"];
  const std::size_t size = type == 5123 ? 2 : 4;
  std::size_t offset = view["byteOffset"];
  EXPECT_EQ(view["byteLength"], size * count);
  EXPECT_EQ(offset % 4, 0U);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i, offset += size) {
    if (type == 5126) numbers.push_back(number_at<float>(glb.binary, offset));
    if (type == 5125) numbers.push_back(number_at<std::uint32_t>(glb.binary, offset));
    if (type == 5123) numbers.push_back(number_at<std::uint16_t>(glb.binary, offset));
  }
  EXPECT_EQ(numbers.size(), count);
  return numbers;
}

double srgb(double light) {
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

Vector3d vector_of(const nlohmann::json& numbers) {
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

Mesh mesh_of(const Glb& glb) {
  const auto& nodes = glb.json["nodes"];
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], nlohmann::json({0}));
  EXPECT_EQ(nodes.size(), 1U);
  // glTF has y up: x, z, -y of the input.
  Eigen::Matrix3d z_up;
  z_up << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const auto numbers = nodes[0]["matrix"].get<std::vector<double>>();
  EXPECT_EQ(numbers.size(), 16U);
  const Eigen::Affine3d placed(z_up *
                               Eigen::Map<const Eigen::Matrix4d>(numbers.data()).topRows<3>());
  const auto& primitive = glb.json["meshes"][nodes[0]["mesh"].get<std::size_t>()]["primitives"][0];
  EXPECT_FALSE(primitive.contains("mode"));
  const auto positions = accessor(glb, primitive["attributes"]["POSITION"]);
  const auto normals = accessor(glb, primitive["attributes"]["NORMAL"]);
  const auto colors = accessor(glb, primitive["attributes"]["COLOR_0"]);
  const auto indices = accessor(glb, primitive["indices"]);
  EXPECT_EQ(positions.size() / 3, colors.size() / 4);
  Mesh mesh;
  Vector3d low = Vector3d::Constant(INFINITY);
  Vector3d high = -low;
  for (std::size_t i = 0; 3 * i < positions.size(); ++i) {
    const Vector3d position(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
    mesh.vertices.push_back(placed * position);
    const Vector3d normal(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
    mesh.normals.push_back((placed.linear() * normal).normalized());
    mesh.colors.emplace_back(srgb(colors[4 * i] / 65535), srgb(colors[4 * i + 1] / 65535),
                             srgb(colors[4 * i + 2] / 65535));
    EXPECT_EQ(colors[4 * i + 3], 65535);
  }
  const auto& bounds =
      glb.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(vector_of(bounds["min"]), low);
  EXPECT_EQ(vector_of(bounds["max"]), high);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    mesh.triangles.push_back({static_cast<std::uint32_t>(indices[i]),
                              static_cast<std::uint32_t>(indices[i + 1]),
                              static_cast<std::uint32_t>(indices[i + 2])});
  }
  return mesh;
}

// Each box of `list` must be a closed surface of 12 triangles in the mesh, in its order.
void expect_boxes(const Mesh& mesh, const CuboidList& list, double tolerance) {
  const std::size_t boxes = list.cuboids.size();
  ASSERT_EQ(mesh.triangles.size(), 12 * boxes);
  const std::size_t each = mesh.vertices.size() / boxes;
  double lowest = INFINITY;
  double highest = -INFINITY;
  for (const Cuboid& cuboid : list.cuboids) {
    for (const Vector3d& corner : test::corners_of(list, cuboid)) {
      lowest = std::min(lowest, corner.z());
      highest = std::max(highest, corner.z());
    }
  }
  for (std::size_t box = 0; box < boxes; ++box) {
    const test::Corners corners = test::corners_of(list, list.cuboids[box]);
    Vector3d center = Vector3d::Zero();
    for (const Vector3d& corner : corners) center += corner / 8;
    const Vector3d edges((corners[1] - corners[0]).norm(), (corners[2] - corners[0]).norm(),
                         (corners[4] - corners[0]).norm());
    double volume = 0;
    std::map<std::pair<std::size_t, std::size_t>, int> half_edges;
    for (std::size_t t = 12 * box; t < 12 * box + 12; ++t) {
      std::array<Vector3d, 3> at;
      std::array<std::size_t, 3> which{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t vertex = mesh.triangles[t][k];
        ASSERT_EQ(vertex / each, box);
        at[k] = mesh.vertices[vertex];
        while (which[k] < 8 && (corners[which[k]] - at[k]).norm() > tolerance) ++which[k];
        ASSERT_LT(which[k], 8U) << at[k].transpose();
        const Color color = viridis((at[k].z() - lowest) / (highest - lowest));
        for (int part = 0; part < 3; ++part) {
          ASSERT_NEAR(mesh.colors[vertex][part], color[static_cast<std::size_t>(part)], 1.1);
        }
      }
      const Vector3d across = (at[1] - at[0]).cross(at[2] - at[0]);
      volume += across.dot(at[0] - center) / 6;
      for (std::size_t k = 0; k < 3; ++k) {
        ++half_edges[{which[k], which[(k + 1) % 3]}];
        if (mesh.normals.empty()) continue;
        ASSERT_LT((mesh.normals[mesh.triangles[t][k]] - across.normalized()).norm(), 1e-4);
      }
    }
    // Outward and closed: the volume is that of the box, and each edge is passed both ways.
    ASSERT_NEAR(volume, edges.prod(), 1e-4 * edges.prod());
    ASSERT_EQ(half_edges.size(), 36U);
    for (const auto& [edge, times] : half_edges) {
      ASSERT_EQ(times, 1);
      ASSERT_TRUE(half_edges.contains({edge.second, edge.first}));
    }
  }
}

TEST(CuboidMeshes, of_ply_are_the_boxes) {
  test::Random random(31);
  SCOPED_TRACE(random.trace());
  for (const int count : {1, 2, 300}) {
    const CuboidList list = test::near_cuboids(random, count);
    const Mesh mesh = parsed_ply(test::written(".ply", list));
    EXPECT_EQ(mesh.vertices.size(), 8U * list.cuboids.size());
    expect_boxes(mesh, list, 1e-9);
  }
}

TEST(CuboidMeshes, of_glb_are_the_boxes) {
  test::Random random(32);
  SCOPED_TRACE(random.trace());
  for (const int count : {1, 2, 300}) {
    // Positions are whole numbers of cells: floats hold them as they are.
    const CuboidList list = test::near_cuboids(random, count, 10'000);
    const Mesh mesh = mesh_of(parsed_glb(test::written(".glb", list)));
    EXPECT_EQ(mesh.vertices.size(), 24U * list.cuboids.size());
    expect_boxes(mesh, list, 1e-9);
  }
}

TEST(CuboidMeshes, stay_exact_far_from_the_origin) {
  test::Random random(33);
  SCOPED_TRACE(random.trace());
  CuboidList list = test::near_cuboids(random, 50, 10);
  list.frame.translation() = Vector3d(4.5e5, -5.8e6, 300);
  // What 24 bits hold within some meters, and the rounding of doubles at 5800 km.
  expect_boxes(parsed_ply(test::written(".ply", list)), list, 1e-8);
  expect_boxes(mesh_of(parsed_glb(test::written(".glb", list))), list, 1e-8);
}

TEST(CuboidMeshes, of_nothing_are_valid) {
  const Mesh ply = parsed_ply(test::written(".ply", {}));
  EXPECT_TRUE(ply.vertices.empty());
  EXPECT_TRUE(ply.triangles.empty());
  const Glb glb = parsed_glb(test::written(".glb", {}));
  EXPECT_EQ(glb.binary, "");
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  EXPECT_EQ(glb.json["nodes"].size(), 1U);
  for (const char* name : {"meshes", "accessors", "buffers", "bufferViews"}) {
    EXPECT_FALSE(glb.json.contains(name)) << name;
  }
}

}  // namespace
}  // namespace rmap
