#include <iostream>

#include "device/measure_device.hpp"
#include "host/command_line/commands.hpp"
#include "host/command_line/quantity.hpp"
#include "host/command_line/text_table.hpp"

namespace tentpole {
namespace {

std::vector<std::string> row(const Device& device) {
  const DeviceRates rates = measure_device(device);
  return {device.is_host ? "-" : std::to_string(device.number),
          device.name,
          count_text(device.num_threads),
          bytes_text(rates.to_device) + "/s",
          bytes_text(rates.from_device) + "/s",
          short_number(rates.launch * 1e6) + " us"};
}

}  // namespace

int devices_command() {
  std::vector<std::vector<std::string>> rows{{"number", "device", "threads", "copy to", "copy from", "launch"}};
  rows.push_back(row(host_device()));
  const std::vector<Device> devices = available_devices();
  for (const Device& device : devices) rows.push_back(row(device));
  std::cout << text_table(rows, "rlrrrr");
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
