#include "tests/host/run/solved_run.hpp"

#include <fstream>
#include <sstream>

#include "host/run/make_simulation.hpp"
#include "host/run/run.hpp"
#include "tests/device/tested_device.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole::testing {

Simulation simulation_of(const std::string& case_text) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "case.toml";
  std::ofstream(path) << case_text;
  return make_simulation(read_case(path));
}

SolvedRun solve(const Simulation& simulation, const Device& device, int threads) {
  const TemporaryFolder folder;
  RunOptions options;
  options.device = device;
  options.threads = threads;
  options.folder = folder.path();
  options.check = true;
  SolvedRun run{run_simulation(simulation, options).summary, {}};
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    if (name != "summary.json") run.files[name] = folder.read(name);
  }
  return run;
}

SolvedRun solve(const std::string& case_text, const Device& device, int threads) {
  return solve(simulation_of(case_text), device, threads);
}

std::vector<Device> test_devices() {
  std::vector<Device> devices{host_device()};
  if (const std::optional<Device> device = tested_device()) devices.push_back(*device);
  return devices;
}

Table read_table(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, entry;
  std::getline(lines, line);
  std::vector<std::string> names;
  for (std::istringstream header(line); std::getline(header, entry, ',');) names.push_back(entry);
  Table table;
  while (std::getline(lines, line)) {
    std::istringstream row(line);
    for (const std::string& name : names) {
      std::getline(row, entry, ',');
      table[name].push_back(std::stod(entry));
    }
  }
  return table;
}

void give_second_material(Simulation& simulation, double position, const Material& material) {
  SpaceMesh& mesh = simulation.mesh;
  mesh.region_names.push_back("second");
  simulation.materials.push_back(material);
  simulation.scaled_materials.push_back(simulation.scaling.scaled(material));
  for (int cell = 0; cell < mesh.num_cells(); ++cell) {
    double centroid = 0;
    for (int corner = 0; corner < mesh.num_corners(); ++corner)
      centroid += mesh.corner_position(cell, corner)[0] / mesh.num_corners();
    if (centroid * simulation.scaling.length < position) continue;
    mesh.cell_region[cell] = 1;
    simulation.cell_wave_speed[cell] = simulation.scaled_materials[1].dilatational_speed();
  }
}

}  // namespace tentpole::testing
