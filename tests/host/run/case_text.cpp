#include "tests/host/run/case_text.hpp"

#include <cmath>
#include <cstdio>

namespace tentpole::testing {

double Solid::dilatational_speed() const {
  return std::sqrt((lambda + 2 * mu) / density);
}
double Solid::shear_speed() const {
  return std::sqrt(mu / density);
}

std::string digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string number_list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + digits(value);
  return "[" + text + "]";
}

std::string expression_list(const std::vector<std::string>& expressions) {
  std::string text;
  for (const std::string& expression : expressions) text += (text.empty() ? "\"" : ", \"") + expression + "\"";
  return "[" + text + "]";
}

std::string CaseText::text() const {
  const std::vector<double> first(dimension, 0.0), last(max.begin(), max.begin() + dimension);
  const std::vector<double> intervals(cells.begin(), cells.begin() + dimension);
  const double youngs_modulus = solid.mu * (3 * solid.lambda + 2 * solid.mu) / (solid.lambda + solid.mu);
  const double poisson_ratio = solid.lambda / (2 * (solid.lambda + solid.mu));
  return "[domain]\ndimension = " + std::to_string(dimension) + "\nmin = " + number_list(first) +
         "\nmax = " + number_list(last) + "\ncells = " + number_list(intervals) + "\npattern = \"" +
         (structured ? "structured" : "unstructured") + "\"\n[material.all]\ndensity = " + digits(solid.density) +
         "\nyoungs_modulus = " + digits(youngs_modulus) + "\npoisson_ratio = " + digits(poisson_ratio) +
         "\n[time]\nend = " + digits(end) + "\n[discretization]\ndegree = " + std::to_string(degree) +
         "\n[front]\ncausality = " + digits(causality) + "\n[run]\nbatch_size = " + std::to_string(batch_size) +
         "\n[output]\nsnapshots = " + std::to_string(snapshots) + "\nhistory_interval = " + digits(end / history_rows) +
         "\n" + rest;
}

}  // namespace tentpole::testing
