// Runs a kernel over so many blocks of points and does nothing else, for callgrind to count its instructions.
// Usage: loadpath_counted KERNEL BLOCKS; without words it lists the kernels with the points of a block.
#include "calculators/column/buckling.hpp"
#include "calculators/fatigue/cycle.hpp"
#include "calculators/gear/pair.hpp"
#include "calculators/shaft/torsion/torsion.hpp"
#include "calculators/vessel/cylinder.hpp"
#include "lib/mechanism/columns/cycle.hpp"
#include "lib/mechanism/groups/system.hpp"
#include "tests/bench/columns.hpp"
#include "tests/lib/mechanism/models.hpp"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>
#include <string>

namespace {

using namespace loadpath;
using namespace loadpath::bench;
namespace mech = loadpath::mechanism;

constexpr int positions = 720;

/// All results that are named, over columns that live as long as the program.
template <class C>
void sweep(int blocks, const typename C::Input& in, const std::map<std::string, std::vector<double>>& varied,
           const std::vector<std::string>& results) {
  std::vector<Sweep::Varied> columns;
  for (const auto& [key, column] : varied) columns.push_back({key, column});
  std::vector<std::vector<double>> found;
  const Sweep swept(erased<C>(), record_of<C>(in), columns, results, found);
  for (int k = 0; k < blocks; ++k) swept();
}

void torsion(int blocks) {
  shaft::Torsion::Input in;
  in.G = 80.0 * GPa, in.theta_adm = from_si<Twist>(0.004);
  sweep<shaft::Torsion>(blocks, in, {{"T", spread(50.0, 500.0, 1)}, {"tau_adm", spread(20e6, 60e6, 2)}},
                        {"d_strength", "d_stiffness", "d_min", "D_star", "tau_max", "theta_max", "u_tau", "u_theta"});
}

void stress_cycle(int blocks) {
  fatigue::Cycle::Input in;
  in.R_e = 355.0 * MPa;
  sweep<fatigue::Cycle>(blocks, in, {{"sigma_max", spread(100e6, 300e6, 3)}, {"sigma_min", spread(10e6, 90e6, 4)}},
                        {"sigma_m", "sigma_a", "r", "u_y"});
}

void column_buckling(int blocks) {
  column::Buckling::Input in;
  in.E = 210.0 * GPa, in.sigma_P = 270.0 * MPa, in.n_st = 3.0;
  in.ends = column::Ends::fixed_free, in.method = column::Method::euler;
  sweep<column::Buckling>(blocks, in,
                          {{"l", spread(0.8, 1.2, 9)}, {"d", spread(0.02, 0.05, 10)}, {"P", spread(5e3, 50e3, 11)}},
                          {"A", "lambda", "sigma_cr", "P_all", "u", "r_1"});
}

void vessel_cylinder(int blocks) {
  vessel::Cylinder::Input in;
  in.delta = 12.0 * mm, in.sigma_adm = 140.0 * MPa;
  sweep<vessel::Cylinder>(blocks, in, {{"p", spread(0.5e6, 2e6, 5)}, {"R", spread(0.5, 1.0, 6)}},
                          {"sigma_o", "sigma_v", "t_R", "delta_min", "p_max", "u_v", "sigma_L", "delta_L"});
}

void gear_pair(int blocks) {
  gear::Pair::Input in;
  in.z_1 = 20, in.z_2 = 57, in.m_n = 2.5 * mm, in.a_w = 100.0 * mm, in.b = 28.0 * mm, in.T_1 = 60.0 * N_m;
  in.K_A = 1.25, in.n_1 = 1450.0 * rpm, in.cutting = gear::Cutting::hobbed;
  in.sigma_adm_1 = 220.0 * MPa, in.sigma_adm_2 = 200.0 * MPa;
  sweep<gear::Pair>(
      blocks, in,
      {{"x_1", spread(0.1, 0.5, 12)}, {"beta", spread(0.17, 0.22, 13)}, {"alpha_n", spread(0.34, 0.36, 14)}},
      {"alpha_t", "alpha_wt", "x_0", "eps_alpha", "F_bn", "s_an1", "sigma_F1", "sigma_F2"});
}

mech::Drive drive_at(int position) { return {1.0 + position * 2.0 * std::numbers::pi / positions, 100.0, 0.0}; }

/// One position after another.
void by_groups(int blocks, const mech::Model& model) {
  mech::GroupSystem system(model);
  mech::Position at = mech::blank_position(model);
  bool closed = system.assemble() == mech::Status::closed;
  for (int k = 0; k < blocks * positions; ++k) {
    const mech::Drive drive = drive_at(k);
    closed = system.solve({&drive, 1}, at) == mech::Status::closed && closed;
  }
  if (!closed) std::exit(EXIT_FAILURE);
}

/// A full turn at once.
void in_lanes(int blocks, const mech::Model& model) {
  std::vector<mech::Drive> turn;
  for (int k = 0; k < positions; ++k) turn.push_back(drive_at(k));
  mech::CycleColumns columns(model, turn.size());
  bool closed = columns.take(model) == mech::Status::closed;
  for (int k = 0; k < blocks; ++k) closed = columns.solve(turn) == mech::Status::closed && closed;
  if (!closed || !columns.in_lanes()) std::exit(EXIT_FAILURE);
}

struct Kernel {
  std::size_t points;  // points of a block
  std::function<void(int)> run;
};

const std::map<std::string, Kernel>& kernels() {
  using namespace mech::models;
  static const std::map<std::string, Kernel> all{
      {"shaft.torsion", {points, torsion}},
      {"fatigue.cycle", {points, stress_cycle}},
      {"column.buckling", {points, column_buckling}},
      {"vessel.cylinder", {points, vessel_cylinder}},
      {"gear.pair", {points, gear_pair}},
      {"slider_crank", {positions, [](int n) { by_groups(n, slider_crank()); }}},
      {"four_bar", {positions, [](int n) { by_groups(n, four_bar()); }}},
      {"six_bar", {positions, [](int n) { by_groups(n, six_bar()); }}},
      {"slider_crank_in_lanes", {positions, [](int n) { in_lanes(n, slider_crank()); }}},
      {"four_bar_in_lanes", {positions, [](int n) { in_lanes(n, four_bar()); }}},
      {"six_bar_in_lanes", {positions, [](int n) { in_lanes(n, six_bar()); }}}};
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) {
    for (const auto& [name, kernel] : kernels()) std::printf("%s %zu\n", name.c_str(), kernel.points);
    return EXIT_SUCCESS;
  }
  const auto found = kernels().find(argv[1]);
  if (argc != 3 || found == kernels().end()) {
    std::fprintf(stderr, "usage: loadpath_counted [KERNEL BLOCKS]\n");
    return 2;
  }
  found->second.run(std::atoi(argv[2]));
}
