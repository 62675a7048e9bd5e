#include "device/thread_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <omp.h>

#include "device/core_quota.hpp"

namespace tentpole {
namespace {

std::string quota_text(double quota) {
  char number[32];
  std::snprintf(number, sizeof number, "%.3g", quota);
  return std::string("its control group grants it ") + number + (quota == 1 ? " core" : " cores");
}

}  // namespace

const ThreadSupply& thread_supply() {
  static const ThreadSupply supply = [] {
    const char* chosen = std::getenv("OMP_NUM_THREADS");
    return ThreadSupply{omp_get_max_threads(), chosen != nullptr && *chosen != '\0', omp_get_thread_limit(),
                        core_quota()};
  }();
  return supply;
}

ThreadChoice choose_threads(const ThreadSupply& supply, int requested) {
  ThreadChoice choice{requested > 0 ? requested : supply.usual, ""};
  if (supply.quota) {
    const int busy = static_cast<int>(std::ceil(std::min(*supply.quota, 1e6)));
    const bool is_free = requested <= 0 && !supply.is_chosen;
    if (choice.threads > busy || choice.threads > *supply.quota) choice.reason = quota_text(*supply.quota);
    if (is_free) choice.threads = std::min(choice.threads, std::max(busy, 1));
  }
  if (choice.threads > supply.limit) {
    choice.threads = std::max(supply.limit, 1);
    const bool exceeds_quota = supply.quota && choice.threads > *supply.quota;
    choice.reason = "OMP_THREAD_LIMIT" + (exceeds_quota ? "; " + choice.reason : "");
  }
  return choice;
}

}  // namespace tentpole
