#include <rmap/beam.hpp>

#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace rmap {
namespace {

TEST(Beam, DISABLED_placeholder) {}

}  // namespace
}  // namespace rmap
