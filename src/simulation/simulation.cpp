#include "simulation/exact_math.hpp"

#include <cassert>
#include <utility>

#include <rmap/simulation.hpp>

namespace rmap {

Simulation::Simulation(Scenario scenario) : scenario_(std::move(scenario)) {
  check_sensor(scenario_.sensor);
  for (const TimedPose& pose : scenario_.trajectory) check_pose(pose.map_from_body);
}

double Simulation::time(std::size_t index) const {
  assert(index < size());
  return scenario_.trajectory[index].time;
}

Pose Simulation::map_from_sensor(std::size_t index) const {
  assert(index < size());
  return simulation::chained(scenario_.trajectory[index].map_from_body,
                             body_from_sensor(scenario_.sensor.model));
}

Scan Simulation::scan(std::size_t index) const {
  return simulate_scan(scenario_.scene, scenario_.sensor, map_from_sensor(index), time(index),
                       index);
}

Simulation make_simulation(std::string_view name, const SimulationOptions& options) {
  Scenario scenario = make_scene(name, {.scans = options.scans});
  Sensor& sensor = scenario.sensor;
  sensor.model = options.sensor.value_or(sensor.model);
  sensor.noise = options.noise.value_or(sensor.noise);
  sensor.dropped = options.dropped;
  sensor.no_returns = options.no_returns;
  sensor.seed = options.seed;
  return Simulation(std::move(scenario));
}

}  // namespace rmap
