#include <iostream>

#include "device/measure_device.hpp"
#include "host/case_file/input_error.hpp"
#include "host/command_line/commands.hpp"
#include "host/command_line/quantity.hpp"
#include "host/command_line/text_table.hpp"
#include "host/many_core/calibrate.hpp"
#include "host/many_core/row_sweep.hpp"
#include "host/many_core/write_machine.hpp"
#include "host/mesh/printable.hpp"
#include "host/output/atomic_file.hpp"
#include "host/output/machine_info.hpp"

namespace tentpole {
namespace {

/// A row for the device, of which `count` follow each other.
std::vector<std::string> row(const Device& device, int count) {
  const DeviceRates rates = measure_device(device);
  const std::string first = std::to_string(device.number), last = std::to_string(device.number + count - 1);
  return {device.is_host ? "-" : (count == 1 ? first : first + "-" + last),
          device.name,
          count_text(device.num_threads),
          bytes_text(rates.to_device) + "/s",
          bytes_text(rates.from_device) + "/s",
          short_number(rates.launch * 1e6) + " us"};
}

/// The runtime lists the processor several times as a virtual device: how many of them begin at `first`.
int same_processor(const std::vector<Device>& devices, std::size_t first) {
  std::size_t end = first + 1;
  if (devices[first].kind == DeviceKind::virtual_cpu)
    while (end < devices.size() && devices[end].kind == DeviceKind::virtual_cpu) ++end;
  return static_cast<int>(end - first);
}

/// Measured and modelled times of one loop on 1 to twice the hardware threads, side by side.
std::vector<std::vector<std::string>> sweep_rows(const Machine& machine) {
  std::vector<std::vector<std::string>> rows{{"threads", "measured", "modelled", "ratio"}};
  const std::vector<double> measured = measure_sweep(2 * machine.usable_cores() * machine.cores.threads);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const int threads = static_cast<int>(i) + 1;
    const double modelled = pass_time(machine, calibration_rows, threads);
    rows.push_back({std::to_string(threads), short_number(measured[i] * 1e6) + " us",
                    short_number(modelled * 1e6) + " us", short_number(modelled / measured[i])});
  }
  return rows;
}

int write_calibration(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file) ||
      (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path())))
    throw InputError("--calibrate " + file.string() + ": cannot be written. Give a file name in a folder that exists.");
  const BuildInfo build = build_info();
  const Machine machine = calibrate_machine();
  replace_text_file(file.parent_path(), file.filename(),
                    machine_text(machine, "Measured by tentpole " + build.version + " (" + build.git_revision + ", " +
                                              build.compiler + ")."));
  std::cout << printable(file.string()) << "\n" << text_table(sweep_rows(machine), "rrrr");
  return 0;
}

}  // namespace

int devices_command(const std::optional<std::filesystem::path>& calibrate) {
  if (calibrate) return write_calibration(calibrate->empty() ? "machine.toml" : *calibrate);
  std::vector<std::vector<std::string>> rows{{"number", "device", "threads", "copy to", "copy from", "launch"}};
  rows.push_back(row(host_device(), 1));
  const std::vector<Device> devices = available_devices();
  for (std::size_t i = 0; i < devices.size();) {
    const int count = same_processor(devices, i);
    rows.push_back(row(devices[i], count));
    i += count;
  }
  std::cout << text_table(rows, "rlrrrr");
  for (const std::string& reason : unused_gpus()) std::cout << reason << "\n";
  if (!devices.empty()) {
    std::cout << "`tentpole run CASE --offload` takes device " << select_device(std::nullopt).number << "\n";
    return 0;
  }
  try {
    select_device(std::nullopt);
  } catch (const std::runtime_error& reason) {
    std::cout << reason.what() << "\n";
  }
  return 0;
}

}  // namespace tentpole
