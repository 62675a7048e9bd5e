#include "host/mesh/msh/element_type.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

int binomial(int n, int k) {
  int result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// Nodes of all complete polynomials of this order, by shape.
int complete_nodes(const std::string& shape, int order) {
  const int n = order + 1;
  if (shape == "Line") return n;
  if (shape == "Triangle") return binomial(order + 2, 2);
  if (shape == "Quadrilateral") return n * n;
  if (shape == "Tetrahedron") return binomial(order + 3, 3);
  if (shape == "Hexahedron") return n * n * n;
  if (shape == "Prism") return n * binomial(order + 2, 2);
  return n * (n + 1) * (2 * n + 1) / 6;  // pyramid: a stack of squares
}

/// Nodes on the edges alone.
int edge_nodes(const std::string& shape, int order) {
  const std::map<std::string, std::pair<int, int>> corners_and_edges{{"Triangle", {3, 3}},    {"Quadrilateral", {4, 4}},
                                                                     {"Tetrahedron", {4, 6}}, {"Hexahedron", {8, 12}},
                                                                     {"Prism", {6, 9}},       {"Pyramid", {5, 8}}};
  const auto [corners, edges] = corners_and_edges.at(shape);
  return corners + edges * (order - 1);
}

struct Family {
  std::string shape;
  int dimension;
  int first_order;
  std::vector<int> numbers;  ///< of ascending order
};

TEST(MshElementType, CompleteElementsHaveTheNodesOfTheirPolynomials) {
  const Family families[] = {{"Line", 1, 0, {84, 1, 8, 26, 27, 28, 62, 63, 64, 65, 66}},
                             {"Triangle", 2, 0, {85, 2, 9, 21, 23, 25, 42, 43, 44, 45, 46}},
                             {"Quadrilateral", 2, 0, {86, 3, 10, 36, 37, 38, 47, 48, 49, 50, 51}},
                             {"Tetrahedron", 3, 0, {87, 4, 11, 29, 30, 31, 71, 72, 73, 74, 75}},
                             {"Hexahedron", 3, 0, {88, 5, 12, 92, 93, 94, 95, 96, 97, 98}},
                             {"Prism", 3, 0, {89, 6, 13, 90, 91, 106, 107, 108, 109, 110}},
                             {"Pyramid", 3, 0, {132, 7, 14, 118, 119, 120, 121, 122, 123, 124}}};
  for (const Family& family : families)
    for (std::size_t i = 0; i < family.numbers.size(); ++i) {
      const MshElementType* type = find_msh_element_type(family.numbers[i]);
      ASSERT_NE(type, nullptr) << family.numbers[i];
      EXPECT_EQ(type->shape, family.shape) << family.numbers[i];
      EXPECT_EQ(type->dimension, family.dimension) << family.numbers[i];
      EXPECT_EQ(type->num_nodes, complete_nodes(family.shape, family.first_order + static_cast<int>(i)))
          << family.numbers[i];
    }
}

TEST(MshElementType, SerendipityElementsHaveTheNodesOfTheirEdges) {
  const Family families[] = {{"Triangle", 2, 3, {20, 22, 24, 52, 53, 54, 55, 56}},
                             {"Quadrilateral", 2, 2, {16, 39, 40, 41, 57, 58, 59, 60, 61}},
                             {"Tetrahedron", 3, 3, {137, 32, 33, 79, 80, 81, 82, 83}},
                             {"Hexahedron", 3, 2, {17, 99, 100, 101, 102, 103, 104, 105}},
                             {"Prism", 3, 2, {18, 111, 112, 113, 114, 115, 116, 117}},
                             {"Pyramid", 3, 2, {19, 125, 126, 127, 128, 129, 130, 131}}};
  for (const Family& family : families)
    for (std::size_t i = 0; i < family.numbers.size(); ++i) {
      const MshElementType* type = find_msh_element_type(family.numbers[i]);
      ASSERT_NE(type, nullptr) << family.numbers[i];
      EXPECT_EQ(type->shape, family.shape) << family.numbers[i];
      EXPECT_EQ(type->num_nodes, edge_nodes(family.shape, family.first_order + static_cast<int>(i)))
          << family.numbers[i];
    }
}

TEST(MshElementType, OnlyPointsLinesTrianglesAndTetrahedraOfOrderOneAreLinearSimplices) {
  for (int number = -1; number <= 150; ++number) {
    const MshElementType* type = find_msh_element_type(number);
    const bool expected = number == 15 || number == 1 || number == 2 || number == 4;
    EXPECT_EQ(type != nullptr && type->is_linear_simplex, expected) << number;
    if (expected) {
      EXPECT_EQ(type->num_nodes, type->dimension + 1) << number;
    }
  }
}

TEST(MshElementType, NamesAreThoseOfGmsh) {
  const std::pair<int, const char*> known[] = {{15, "Point"},          {2, "Triangle 3"},    {9, "Triangle 6"},
                                               {3, "Quadrilateral 4"}, {4, "Tetrahedron 4"}, {17, "Hexahedron 20"},
                                               {34, "Polygon"},        {35, "Polyhedron"},   {137, "Tetrahedron 16"}};
  for (const auto& [number, name] : known) EXPECT_EQ(find_msh_element_type(number)->name(), name);
}

TEST(MshElementType, NumbersWithoutATypeAreUnknown) {
  for (const int number : {-2147483647, -1, 0, 76, 77, 78, 141, 1000, 2147483647})
    EXPECT_EQ(find_msh_element_type(number), nullptr) << number;
}

}  // namespace
}  // namespace tentpole
