#include "tests/host/run/sample_cases.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace tentpole {
namespace {

namespace fs = std::filesystem;

const char* bar = R"toml(
[domain]
dimension = 1
min = [0.0]
max = [1.0]
cells = [60]
[material.all]
density = 1.0
youngs_modulus = 1.0
poisson_ratio = 0.0
[boundary.left]
normal_velocity = "-sin(5*t)"
ramp = 0.1
[boundary.right]
absorbing = true
[initial]
displacement = ["0.01*sin(2*pi*x)"]
[exact]
displacement = ["0.01*sin(2*pi*x)*cos(2*pi*t)"]
[time]
end = 0.7
[discretization]
degree = 4
[output]
snapshots = 5
[[output.probe]]
name = "middle"
point = [0.5]
interval = 0.01
)toml";

const char* plate = R"toml(
[domain]
dimension = 2
min = [0.0, 0.0]
max = [1.0, 0.5]
cells = [9, 5]
pattern = "unstructured"
[material.all]
density = 2700.0
youngs_modulus = 70e9
poisson_ratio = 0.3
[boundary.left]
normal_traction = "1e6*cos(x+t*1e4)"
tangential_velocity = "y"
[boundary.right]
absorbing = true
[boundary.bottom]
periodic = "top"
[body_force]
acceleration = ["0", "-9.81"]
[time]
end = 1.5e-4
[discretization]
degree = 2
[output]
snapshots = 4
fields = ["displacement", "stress", "strain_energy_density"]
[[output.probe]]
name = "inside"
point = [0.3, 0.2]
)toml";

const char* block = R"toml(
[domain]
dimension = 3
min = [0.0, 0.0, 0.0]
max = [1.0, 1.0, 1.0]
cells = [4, 3, 3]
[material.all]
density = 1.0
youngs_modulus = 1.0
poisson_ratio = 0.25
[boundary.left]
velocity = ["sin(9*t)", "0", "y*t"]
[boundary.right]
traction = ["0", "0", "0"]
[boundary.bottom]
traction = ["0", "0", "0"]
[boundary.top]
traction = ["0", "0", "0"]
[boundary.back]
absorbing = true
[boundary.front]
normal_velocity = "0"
tangential_traction = "0"
[time]
end = 0.7
[discretization]
degree = 2
[output]
snapshots = 3
[[output.probe]]
name = "corner"
point = [1.0, 1.0, 1.0]
)toml";

std::string lasting_part(const std::string& summary) {
  auto json = nlohmann::json::parse(summary);
  for (const char* key : {"time_s", "percent", "rates", "traffic", "machine", "threads"}) json.erase(key);
  json["counts"].erase("batches");
  return json.dump(1);
}

}  // namespace

std::string sample_case(int dimension) {
  return dimension == 1 ? bar : dimension == 2 ? plate : block;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return (std::ostringstream() << stream.rdbuf()).str();
}

std::vector<std::pair<std::string, std::string>> results_in(const fs::path& folder) {
  std::vector<std::pair<std::string, std::string>> results;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string(), bytes = bytes_of(entry.path());
    results.emplace_back(name, name == "summary.json" ? lasting_part(bytes) : bytes);
  }
  std::sort(results.begin(), results.end());
  return results;
}

}  // namespace tentpole
