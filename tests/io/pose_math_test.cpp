#include "io/pose_math.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

Eigen::Quaterniond any_rotation(test::Random& random) {
  return Eigen::Quaterniond(random.gaussian(1), random.gaussian(1), random.gaussian(1),
                            random.gaussian(1))
      .normalized();
}

Pose any_pose(test::Random& random) {
  return make_pose(random.point(-100, 100), any_rotation(random));
}

TEST(PoseMath, composes_and_inverts_as_matrices_do) {
  test::Random random(41);
  SCOPED_TRACE(random.trace());
  for (int i = 0; i < 200; ++i) {
    const Pose a = any_pose(random);
    const Pose b = any_pose(random);
    EXPECT_TRUE(composed(a, b).matrix().isApprox((a * b).matrix(), 1e-14));
    EXPECT_TRUE(inverted(a).matrix().isApprox(a.inverse().matrix(), 1e-14));
    EXPECT_EQ(composed(a, Pose::Identity()).matrix(), a.matrix());
  }
}

TEST(PoseMath, interpolates_as_slerp_does) {
  test::Random random(42);
  SCOPED_TRACE(random.trace());
  for (int i = 0; i < 1000; ++i) {
    const Pose a = any_pose(random);
    const Pose b =
        i % 3 == 0 ? composed(a, make_pose({0, 0, 0}, {1, 1e-9 * i, 0, 0})) : any_pose(random);
    const double share = random.real(0, 1);
    const Pose pose = between(a, b, share);
    const Eigen::Matrix3d expected = Eigen::Quaterniond(a.linear())
                                         .slerp(share, Eigen::Quaterniond(b.linear()))
                                         .toRotationMatrix();
    EXPECT_LT((pose.linear() - expected).cwiseAbs().maxCoeff(), 1e-13);
    const Vector3d place = a.translation() * (1 - share) + b.translation() * share;
    EXPECT_LT((pose.translation() - place).norm(), 1e-12);
  }
}

TEST(PoseMath, takes_the_shorter_arc) {
  const Pose a = make_pose({0, 0, 0}, {1, 0, 0, 0});
  const Pose b =
      make_pose({0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(-1.0, Vector3d::UnitZ())));
  const Eigen::Matrix3d half = Eigen::AngleAxisd(-0.5, Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_LT((between(a, b, 0.5).linear() - half).cwiseAbs().maxCoeff(), 1e-15);
}

}  // namespace
}  // namespace rmap
