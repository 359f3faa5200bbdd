#include "approximation/coordinate_entropy.hpp"

#include "support/random.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

TEST(CoordinateEntropy, IsThatOfAHistogram) {
  // On x two places of the same share, on y one, on z four.
  std::vector<Vector3f> points;
  for (int i = 0; i < 400; ++i) {
    points.emplace_back(static_cast<float>(i % 2), 7.0F, static_cast<float>(i % 4));
  }
  const CoordinateEntropy entropy(points, 1000);
  const double expected = std::log(2) + std::log(4);
  EXPECT_NEAR(entropy.of(Eigen::Matrix3d::Identity(), 1), expected, 1e-12);
  // Of every third point hardly another one.
  EXPECT_NEAR(CoordinateEntropy(points, 134).of(Eigen::Matrix3d::Identity(), 1), expected, 0.05);
}

TEST(CoordinateEntropy, WideOnesAreTheSameAsNarrowOnes) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  std::vector<Vector3f> near;
  std::vector<Vector3f> far;
  for (int i = 0; i < 2000; ++i) {
    const Vector3f point = random.point(0, 8).cast<float>();
    near.push_back(point);
    near.push_back(point + Vector3f::Constant(16));
    far.push_back(point);
    far.push_back(point + Vector3f::Constant(1 << 21));  // too many bins for a vector
  }
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  EXPECT_NEAR(CoordinateEntropy(near, 10000).of(axes, 1), CoordinateEntropy(far, 10000).of(axes, 1),
              0.01);
}

TEST(CoordinateEntropy, CrowdingSumsTheSquaresOfLayers) {
  const std::vector<Vector3f> points{{0.2F, 0, 0}, {0.7F, 0, 0}, {0.9F, 0, 0}, {1.6F, 0, 0}};
  const Lattice lattice(1);
  const Pose frame = Pose::Identity();
  EXPECT_EQ(crowding(points, frame, 0, lattice, 0), 9 + 1);
  EXPECT_EQ(crowding(points, frame, 0, lattice, 0.35), 1 + 9);
  EXPECT_EQ(crowding(points, frame, 0, lattice, 0.2), 4 + 4);
  EXPECT_EQ(crowding(points, frame, 1, lattice, 0), 16);
}

}  // namespace
}  // namespace rmap
