#include "host/mesh/msh/element_type.hpp"

#include <array>

namespace tentpole {

namespace {

constexpr MshElementType line(int num_nodes) {
  return {"Line", 1, num_nodes, false};
}
constexpr MshElementType triangle(int num_nodes) {
  return {"Triangle", 2, num_nodes, false};
}
constexpr MshElementType quadrilateral(int num_nodes) {
  return {"Quadrilateral", 2, num_nodes, false};
}
constexpr MshElementType tetrahedron(int num_nodes) {
  return {"Tetrahedron", 3, num_nodes, false};
}
constexpr MshElementType hexahedron(int num_nodes) {
  return {"Hexahedron", 3, num_nodes, false};
}
constexpr MshElementType prism(int num_nodes) {
  return {"Prism", 3, num_nodes, false};
}
constexpr MshElementType pyramid(int num_nodes) {
  return {"Pyramid", 3, num_nodes, false};
}
constexpr MshElementType varying(const char* shape, int dimension) {
  return {shape, dimension, 0, false};
}
constexpr MshElementType linear_simplex(const char* shape, int dimension) {
  return {shape, dimension, dimension + 1, true};
}
constexpr MshElementType no_type{};

/// By number, ten a row: all types that Gmsh 4.15 has (its header GmshDefines.h), of any order.
constexpr std::array<MshElementType, 141> types{
    // clang-format off
    no_type, linear_simplex("Line", 1), linear_simplex("Triangle", 2), quadrilateral(4), linear_simplex("Tetrahedron", 3),
    hexahedron(8), prism(6), pyramid(5), line(3), triangle(6),
    // 10
    quadrilateral(9), tetrahedron(10), hexahedron(27), prism(18), pyramid(14),
    linear_simplex("Point", 0), quadrilateral(8), hexahedron(20), prism(15), pyramid(13),
    // 20
    triangle(9), triangle(10), triangle(12), triangle(15), triangle(15),
    triangle(21), line(4), line(5), line(6), tetrahedron(20),
    // 30
    tetrahedron(35), tetrahedron(56), tetrahedron(22), tetrahedron(28), varying("Polygon", 2),
    varying("Polyhedron", 3), quadrilateral(16), quadrilateral(25), quadrilateral(36), quadrilateral(12),
    // 40
    quadrilateral(16), quadrilateral(20), triangle(28), triangle(36), triangle(45),
    triangle(55), triangle(66), quadrilateral(49), quadrilateral(64), quadrilateral(81),
    // 50
    quadrilateral(100), quadrilateral(121), triangle(18), triangle(21), triangle(24),
    triangle(27), triangle(30), quadrilateral(24), quadrilateral(28), quadrilateral(32),
    // 60
    quadrilateral(36), quadrilateral(40), line(7), line(8), line(9),
    line(10), line(11), {"Line Border", 1, 2, false}, {"Triangle Border", 2, 3, false}, varying("Polygon Border", 2),
    // 70
    {"Line Child", 1, 2, false}, tetrahedron(84), tetrahedron(120), tetrahedron(165), tetrahedron(220),
    tetrahedron(286), no_type, no_type, no_type, tetrahedron(34),
    // 80
    tetrahedron(40), tetrahedron(46), tetrahedron(52), tetrahedron(58), line(1),
    triangle(1), quadrilateral(1), tetrahedron(1), hexahedron(1), prism(1),
    // 90
    prism(40), prism(75), hexahedron(64), hexahedron(125), hexahedron(216),
    hexahedron(343), hexahedron(512), hexahedron(729), hexahedron(1000), hexahedron(32),
    // 100
    hexahedron(44), hexahedron(56), hexahedron(68), hexahedron(80), hexahedron(92),
    hexahedron(104), prism(126), prism(196), prism(288), prism(405),
    // 110
    prism(550), prism(24), prism(33), prism(42), prism(51),
    prism(60), prism(69), prism(78), pyramid(30), pyramid(55),
    // 120
    pyramid(91), pyramid(140), pyramid(204), pyramid(285), pyramid(385),
    pyramid(21), pyramid(29), pyramid(37), pyramid(45), pyramid(53),
    // 130
    pyramid(61), pyramid(69), pyramid(1), varying("Point Xfem", 0), varying("Line Xfem", 1),
    varying("Triangle Xfem", 2), varying("Tetrahedron Xfem", 3), tetrahedron(16), {"Triangle Mini", 2, 4, false},
    {"Tetrahedron Mini", 3, 5, false},
    // 140
    {"Trihedron", 3, 4, false}
    // clang-format on
};

}  // namespace

std::string MshElementType::name() const {
  return num_nodes == 0 || dimension == 0 ? shape : std::string(shape) + " " + std::to_string(num_nodes);
}

const MshElementType* find_msh_element_type(int number) {
  if (number < 1 || number >= static_cast<int>(types.size()) || types[number].shape == nullptr) return nullptr;
  return &types[number];
}

}  // namespace tentpole
