#pragma once

#include <string>
#include <vector>

namespace tentpole::testing {

/// Isotropic solid by the constants that the wave equation knows; E and nu of the case file follow from them.
struct Solid {
  double density = 1;  ///< [kg/m^3]
  double lambda = 1;   ///< [Pa]
  double mu = 1;       ///< [Pa]

  double dilatational_speed() const;  ///< [m/s]
  double shear_speed() const;         ///< [m/s]
};

/// The sections that every case of these tests has.
struct CaseText {
  int dimension = 1;
  int degree = 2;
  std::vector<int> cells;            ///< per direction
  std::vector<double> max{1, 1, 1};  ///< the box is [0, max]
  bool structured = false;
  double end = 1;
  double causality = 0.95;
  int batch_size = 64;
  int snapshots = 0;
  int history_rows = 1;  ///< equal intervals
  Solid solid;
  std::string rest;  ///< further sections

  std::string text() const;
};

/// "[a, b]" of numbers, `["a", "b"]` of expressions.
std::string number_list(const std::vector<double>& values);
std::string expression_list(const std::vector<std::string>& expressions);

/// 17 digits: the text gives the number back.
std::string digits(double value);

}  // namespace tentpole::testing
