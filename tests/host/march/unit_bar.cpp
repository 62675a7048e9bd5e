#include "tests/host/march/unit_bar.hpp"

#include <cmath>

namespace tentpole::testing {

CaseText unit_bar(int dimension, int degree, double cell_length, double end) {
  constexpr double poisson_ratio = 0.21;
  CaseText text;
  text.dimension = dimension;
  text.degree = degree;
  text.cells = {static_cast<int>(std::lround(bar_length / cell_length)),
                static_cast<int>(std::lround(bar_width / cell_length))};
  text.max = {bar_length, bar_width};
  text.structured = true;
  text.end = end;
  text.solid = dimension == 1
                   ? Solid{1, 0, 0.5}
                   : Solid{1, poisson_ratio / (1 - poisson_ratio), (1 - 2 * poisson_ratio) / (2 * (1 - poisson_ratio))};
  return text;
}

std::string bar_sides(int dimension, const std::string& left, const std::string& right) {
  const std::string tangential = dimension == 2 ? "tangential_traction = \"0\"\n" : "";
  std::string text = "[boundary.left]\n" + left + "\n" + tangential + "[boundary.right]\n" + right + "\n" + tangential;
  if (dimension == 2)
    for (const char* side : {"bottom", "top"})
      text += std::string("[boundary.") + side + "]\nnormal_velocity = \"0\"\ntangential_traction = \"0\"\n";
  return text;
}

std::string fracture_section(const FractureText& text) {
  return "[fracture]\nenabled = true\nthreshold = " + digits(text.threshold) + "\nstrength = " + digits(text.strength) +
         "\nrelaxation_time = " + digits(text.relaxation_time) + "\nfriction = " + digits(text.friction) +
         "\nmax_damage_step = " + digits(text.max_damage_step) + "\n";
}

std::string crack_across(int dimension, double x, double damage) {
  const std::string point = "[" + digits(x);
  const std::string points =
      dimension == 1 ? "[" + point + "]]" : "[" + point + ", 0.0], " + point + ", " + digits(bar_width) + "]]";
  return "[[fracture.crack]]\npoints = " + points + "\ndamage = " + digits(damage) + "\n";
}

std::string bar_probe(int dimension, const std::string& name, double x, double interval) {
  return "[[output.probe]]\nname = \"" + name + "\"\npoint = [" + digits(x) +
         (dimension == 2 ? ", " + digits(0.5 * bar_width) : "") + "]\ninterval = " + digits(interval) + "\n";
}

}  // namespace tentpole::testing
