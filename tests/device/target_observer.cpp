#include "tests/device/target_observer.hpp"

#include <atomic>

#include <omp-tools.h>

namespace tentpole {

namespace {

std::atomic<std::int64_t> bytes_to_device{0}, bytes_from_device{0}, launches{0};
std::atomic<bool> both_callbacks_set{false};

void on_data_op(ompt_scope_endpoint_t endpoint, ompt_data_t*, ompt_data_t*, ompt_id_t*, ompt_target_data_op_t operation,
                void*, int, void*, int, size_t num_bytes, const void*) {
  if (endpoint == ompt_scope_end) return;
  const auto bytes = static_cast<std::int64_t>(num_bytes);
  if (operation == ompt_target_data_transfer_to_device || operation == ompt_target_data_transfer_to_device_async)
    bytes_to_device += bytes;
  if (operation == ompt_target_data_transfer_from_device || operation == ompt_target_data_transfer_from_device_async)
    bytes_from_device += bytes;
}

void on_submit(ompt_scope_endpoint_t endpoint, ompt_data_t*, ompt_id_t*, unsigned int) {
  if (endpoint == ompt_scope_begin) ++launches;
}

int initialize(ompt_function_lookup_t lookup, int, ompt_data_t*) {
  const auto set_callback = reinterpret_cast<ompt_set_callback_t>(lookup("ompt_set_callback"));
  const int data_op = set_callback(ompt_callback_target_data_op_emi, reinterpret_cast<ompt_callback_t>(&on_data_op));
  const int submit = set_callback(ompt_callback_target_submit_emi, reinterpret_cast<ompt_callback_t>(&on_submit));
  both_callbacks_set = data_op == ompt_set_always && submit == ompt_set_always;
  return 1;
}

void finalize(ompt_data_t*) {}

}  // namespace

ObservedTraffic observed_traffic() {
  return {bytes_to_device, bytes_from_device, launches};
}

bool is_observing() {
  return both_callbacks_set;
}

}  // namespace tentpole

/// The OpenMP runtime looks for this name in the program when it starts.
extern "C" ompt_start_tool_result_t* ompt_start_tool(unsigned int, const char*) {
  static ompt_start_tool_result_t result{tentpole::initialize, tentpole::finalize, {0}};
  return &result;
}
