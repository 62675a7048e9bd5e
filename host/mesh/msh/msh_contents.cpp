#include "host/mesh/msh/msh_contents.hpp"

namespace tentpole {

std::string MshContents::name_of(int dimension, std::int64_t group) const {
  for (const int of_dimension : {dimension, static_cast<int>(none)})
    if (const auto found = group_name.find({of_dimension, group}); found != group_name.end()) return found->second;
  return std::to_string(group);
}

}  // namespace tentpole
