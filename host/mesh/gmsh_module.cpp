#include "host/mesh/gmsh_module.h"

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <gmsh.h>

namespace {

/// Keeps what the C structs point to; deques, so that addresses stay.
struct Storage {
  std::string error;
  std::vector<std::int64_t> vertex_number;
  std::vector<double> position;
  std::deque<std::string> names;
  std::deque<std::vector<std::int64_t>> numbers;
  std::deque<std::vector<const char*>> name_lists;
  std::vector<TentpoleGmshBlock> blocks;
};

/// A session of the Gmsh library with its messages collected instead of printed.
class GmshSession {
 public:
  GmshSession() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::logger::start();
  }
  ~GmshSession() {
    gmsh::logger::stop();
    gmsh::finalize();
  }
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// The first error of the log, or nothing.
  static std::string first_error() {
    std::vector<std::string> log;
    gmsh::logger::get(log);
    for (const std::string& line : log)
      if (line.rfind("Error", 0) == 0) return line;
    return "";
  }
};

std::vector<const char*> group_names(Storage& storage, int dimension, int entity) {
  std::vector<int> groups;
  gmsh::model::getPhysicalGroupsForEntity(dimension, entity, groups);
  std::vector<const char*> list;
  for (int group : groups) {
    group = group < 0 ? -group : group;  // the sign tells the orientation in MSH 2
    std::string name;
    gmsh::model::getPhysicalName(dimension, group, name);
    storage.names.push_back(name.empty() ? std::to_string(group) : name);
    list.push_back(storage.names.back().c_str());
  }
  return list;
}

const std::int64_t* keep(Storage& storage, const std::vector<std::size_t>& numbers) {
  return storage.numbers.emplace_back(numbers.begin(), numbers.end()).data();
}

void read_entity(Storage& storage, int dimension, int entity) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> element_tags, node_tags;
  gmsh::model::mesh::getElements(types, element_tags, node_tags, dimension, entity);
  const auto& names = storage.name_lists.emplace_back(group_names(storage, dimension, entity));
  for (std::size_t i = 0; i < types.size(); ++i) {
    std::string type_name;
    int type_dimension = 0, order = 0, num_nodes = 0, num_primary_nodes = 0;
    std::vector<double> local_coordinates;
    gmsh::model::mesh::getElementProperties(types[i], type_name, type_dimension, order, num_nodes, local_coordinates,
                                            num_primary_nodes);
    storage.names.push_back(type_name);
    TentpoleGmshBlock block{};
    block.dimension = type_dimension;
    block.is_linear_simplex = num_nodes == type_dimension + 1;
    block.type_name = storage.names.back().c_str();
    block.num_corners = num_nodes;
    block.num_elements = static_cast<std::int64_t>(element_tags[i].size());
    block.number = keep(storage, element_tags[i]);
    block.corner = keep(storage, node_tags[i]);
    block.num_groups = static_cast<int>(names.size());
    block.group_name = names.data();
    storage.blocks.push_back(block);
  }
}

void read_model(Storage& storage, const char* path) {
  const GmshSession session;
  try {
    gmsh::open(path);
    std::vector<std::size_t> tags;
    std::vector<double> parametric;
    gmsh::model::mesh::getNodes(tags, storage.position, parametric);
    storage.vertex_number.assign(tags.begin(), tags.end());
    gmsh::vectorpair entities;
    gmsh::model::getEntities(entities);
    for (const auto& [dimension, entity] : entities) read_entity(storage, dimension, entity);
    storage.error = GmshSession::first_error();
  } catch (...) {
    // The library throws different things in different versions; its log says what happened in all of them.
    storage.error = GmshSession::first_error();
    if (storage.error.empty()) storage.error = "the Gmsh library gave up without a message";
  }
}

}  // namespace

TentpoleGmshMesh tentpole_gmsh_read(const char* path) {
  auto storage = std::make_unique<Storage>();
  read_model(*storage, path);
  TentpoleGmshMesh mesh{};
  mesh.error = storage->error.empty() ? nullptr : storage->error.c_str();
  mesh.num_vertices = static_cast<std::int64_t>(storage->vertex_number.size());
  mesh.vertex_number = storage->vertex_number.data();
  mesh.position = storage->position.data();
  mesh.num_blocks = static_cast<int>(storage->blocks.size());
  mesh.block = storage->blocks.data();
  mesh.owner = storage.release();
  return mesh;
}

void tentpole_gmsh_release(TentpoleGmshMesh mesh) {
  delete static_cast<Storage*>(mesh.owner);
}
