#include <iostream>

#include "device/device.hpp"

int main() {
  std::cout << "devices: " << tentpole::available_devices().size() << "\n";
  return 0;
}
