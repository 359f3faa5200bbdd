# How every target of the project is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(rmap_compile_options INTERFACE)
# A fused multiply-add rounds once where the definition of a crossing rounds
# twice: without this, the same scans would give another map on another machine.
target_compile_options(rmap_compile_options INTERFACE -ffp-contract=off)
target_compile_options(rmap_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<BOOL:${RMAP_WARNINGS_AS_ERRORS}>:-Werror>)
# GCC 12 takes some code of the standard library for an overflow once it is inlined
# (GCC bug 105651 and its kin): these warnings are shown, but do not stop a build.
target_compile_options(rmap_compile_options INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-error=array-bounds -Wno-error=restrict
    -Wno-error=stringop-overflow -Wno-error=stringop-overread -Wno-error=maybe-uninitialized>)

# On 64-bit ARM, NEON: GCC 12 crashes on the other vector instructions, of unknown length.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
  target_compile_definitions(rmap_compile_options INTERFACE
    "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128)")
endif()

set(RMAP_SANITIZE "" CACHE STRING "Sanitizers to build with: address,undefined or thread")
if(RMAP_SANITIZE)
  add_compile_options(-fsanitize=${RMAP_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${RMAP_SANITIZE})
endif()
