#pragma once

#include <stdexcept>
#include <string>

namespace tentpole {

/// A mesh that cannot be used. The message reads "FILE, ENTITY NUMBER: what is wrong, with values. The way out."
class MeshError : public std::runtime_error {
 public:
  /// `entity` may be empty where the whole file is meant.
  MeshError(const std::string& source, const std::string& entity, const std::string& problem)
      : std::runtime_error(source + (entity.empty() ? "" : ", " + entity) + ": " + problem) {}
};

}  // namespace tentpole
