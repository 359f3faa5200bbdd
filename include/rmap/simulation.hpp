#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include <rmap/scan.hpp>
#include <rmap/simulation/scenario.hpp>
#include <rmap/simulation/scene.hpp>
#include <rmap/simulation/sensor.hpp>
#include <rmap/simulation/shape.hpp>

namespace rmap {

/// What may be changed about a scene's simulation.
struct SimulationOptions {
  int scans = 0;                           ///< ScenarioOptions::scans; 0: the scene's own
  std::optional<SensorModel> sensor = {};  ///< without one, the scene's own
  std::optional<double> noise = {};        ///< Sensor::noise (m); without one, the scene's own
  double dropped = 0;                      ///< Sensor::dropped
  bool no_returns = true;                  ///< Sensor::no_returns
  std::uint64_t seed = 0;                  ///< Sensor::seed
};

/// Scans with poses of a scene whose truth is known, made when they are asked
/// for. Scan i is the same bits whatever was asked for before; const functions
/// are safe beside one another.
///
///     for (const Scan& scan : make_simulation("street", {.scans = 5})) grid.insert(scan);
class Simulation {
 public:
  class Iterator;

  /// Throws Error(input) by check_sensor, or when a pose is none (check_pose).
  explicit Simulation(Scenario scenario);

  const std::string& name() const { return scenario_.scene.name(); }
  const std::string& description() const { return scenario_.description; }
  const Scene& scene() const { return scenario_.scene; }
  const Sensor& sensor() const { return scenario_.sensor; }

  /// Number of scans; the functions below take an index below it.
  std::size_t size() const { return scenario_.trajectory.size(); }
  /// When scan `index` is taken, seconds.
  double time(std::size_t index) const;
  /// Where the sensor is at scan `index`, the pose of the scan.
  Pose map_from_sensor(std::size_t index) const;
  /// Simulates scan `index` anew at each call.
  Scan scan(std::size_t index) const;

  /// The scans in order, each simulated when its iterator is dereferenced.
  Iterator begin() const;
  Iterator end() const;

 private:
  Scenario scenario_;
};

class Simulation::Iterator {
 public:
  using iterator_concept = std::input_iterator_tag;
  using difference_type = std::ptrdiff_t;
  using value_type = Scan;

  Iterator() = default;
  Iterator(const Simulation& simulation, std::size_t index)
      : simulation_(&simulation), index_(index) {}

  Scan operator*() const { return simulation_->scan(index_); }
  Iterator& operator++() {
    ++index_;
    return *this;
  }
  Iterator operator++(int) {
    const Iterator before = *this;
    ++index_;
    return before;
  }
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }

 private:
  const Simulation* simulation_ = nullptr;
  std::size_t index_ = 0;
};

inline Simulation::Iterator Simulation::begin() const { return {*this, 0}; }
inline Simulation::Iterator Simulation::end() const { return {*this, size()}; }

/// The simulation of a scene by name (make_scene). Throws Error(input) that names
/// the scene or the option which is not as it must be.
Simulation make_simulation(std::string_view name, const SimulationOptions& options = {});

}  // namespace rmap
