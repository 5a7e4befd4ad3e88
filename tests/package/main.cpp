// Uses every part of the installed package; ends with 1 where a number is not what it must be.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <loadpath/loadpath.hpp>
#include <numbers>
#include <vector>

namespace api = loadpath::api;

namespace {

int faults = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "wrong: " << what << "\n";
  ++faults;
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

constexpr const char* shaft = R"(
[crankshaft]
calculator = "shaft.torsion"
T = ["1 kN*m", "2 kN*m", "-1 kN*m"]
d = "60 mm"
tau_adm = "40 MPa"
)";

/// A shaft of 60 mm under 1 kN*m: tau = 16 T / (pi d^3).
double tau_of(double T) { return 16.0 * T / (std::numbers::pi * std::pow(0.06, 3)); }

void use_project() {
  const auto project = api::Project::read(shaft, "shaft.toml");
  const api::Solution first = project.solve_point(0);
  expect(near(first["crankshaft.tau_max"].value, tau_of(1000.0)), "stress of one machine");
  expect(first["crankshaft.tau_max"].si_unit == "Pa" && first["crankshaft.tau_max"].kind == "stress", "unit and kind");
  std::cout << "tau = " << first["crankshaft.tau_max"].text << ", " << first.verdict << "\n";

  const api::Sweep sweep = project.sweep({.results = {"tau = crankshaft.tau_max"}, .jobs = 2});
  expect(sweep.points == 3 && near(sweep["tau"].values[1], tau_of(2000.0)), "stress of a sweep");
  expect(static_cast<api::State>(static_cast<int>(sweep["state"].values[1])) == api::State::fail, "2 kN*m is too much");
}

void read_what_is_wrong() {
  try {
    api::Project::read("[shaft]\ncalculator = \"shaft.torsion\"\nT = \"5 kN\"\ntau_adm = \"40 MPa\"\n", "wrong.toml");
    expect(false, "a force is no torque");
  } catch (const api::Error& error) {
    const api::Issue& issue = error.issues().front();
    expect(issue.file == "wrong.toml" && issue.line == 3 && issue.column == 6, "the place of an error");
    std::cout << error.what() << "\n";
  }
}

void use_calculator() {
  const auto torsion = api::Calculator::find("shaft.torsion");
  std::vector<double> T(1000);
  for (std::size_t i = 0; i < T.size(); ++i) T[i] = 10.0 * static_cast<double>(i) + 10.0;
  T[7] = std::nan("");
  const std::vector<api::Given> inputs{
      {"T", std::span<const double>(T)}, {"d", 60.0, "mm"}, {"tau_adm", std::string("40 MPa")}};
  const api::Sweep sweep = torsion.sweep(inputs, {.results = {"tau_max"}});
  expect(near(sweep["tau_max"].values[99], tau_of(1000.0)), "stress of a column");
  expect(std::isnan(sweep["tau_max"].values[7]) && sweep.refused.size() == 1 && sweep.refused[0].first == 7,
         "a row without a value is marked");
  const auto passes = std::count(sweep["state"].values.begin(), sweep["state"].values.end(), 0.0);
  std::cout << passes << " of " << sweep.points << " torques pass\n";
}

}  // namespace

int main() {
  try {
    use_project();
    read_what_is_wrong();
    use_calculator();
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return faults == 0 ? 0 : 1;
}
