#include "approximation/patch_normals.hpp"

#include "support/cell_sets.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

TEST(PatchNormals, OfAPlaneAllPointAcross) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  const Vector3d across = random.direction();
  const Vector3d u = across.unitOrthogonal();
  const Vector3d v = across.cross(u);
  std::vector<Vector3f> points;
  for (int i = 0; i < 30000; ++i) {
    const Vector3d point = random.real(-4, 4) * u + random.real(-4, 4) * v;
    points.push_back((point + random.gaussian(0.002) * across).cast<float>());
  }
  const auto normals = patch_normals(points, 0.1);
  ASSERT_GE(normals.size(), 150u);
  std::size_t near = 0;
  for (const PatchNormal& normal : normals) {
    ASSERT_NEAR(normal.direction.norm(), 1, 1e-9);
    ASSERT_GE(normal.weight, 0);
    ASSERT_LE(normal.weight, 1);
    near += std::abs(normal.direction.dot(across)) > std::cos(0.1) ? 1 : 0;
  }
  EXPECT_GE(static_cast<double>(near), 0.95 * static_cast<double>(normals.size()));
}

TEST(PatchNormals, LinesAndFewPointsHaveNone) {
  std::vector<Vector3f> line;
  for (int i = 0; i < 5000; ++i) line.emplace_back(0.001F * static_cast<float>(i), 0.0F, 0.0F);
  EXPECT_TRUE(patch_normals(line, 0.1).empty());
  EXPECT_TRUE(patch_normals({}, 0.1).empty());
  EXPECT_TRUE(patch_normals(std::vector<Vector3f>(7, Vector3f::Ones()), 0.1).empty());
  EXPECT_TRUE(patch_normals(std::vector<Vector3f>(700, Vector3f::Ones()), 0.1).empty());
}

}  // namespace
}  // namespace rmap
