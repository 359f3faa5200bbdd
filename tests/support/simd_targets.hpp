#pragma once

#include <hwy/targets.h>

namespace rmap::test {

/// Calls use(name) once with each set of vector instructions that this machine has
/// and that the library was compiled for, the library using it.
template <class Use>
void for_each_simd_target(Use&& use) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    use(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
}

}  // namespace rmap::test
