// Input and result of section.thin_walled.
#pragma once

#include "calculators/load/shear_strength.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/strength_bounds.hpp"

#include <array>

namespace loadpath::section {

inline constexpr std::size_t most_cells = 12, most_walls = 40, most_corners = 24;

struct ThinWalledTypes {
  struct Corner {
    Length y = unset<Length>, z = unset<Length>;
    static constexpr Fields fields{Field{&Corner::y, "y", mm, "to the right"}, Field{&Corner::z, "z", mm, "upwards"}};
  };
  using Corners = List<Corner, most_corners>;

  struct Cell {
    Name name;
    Area A = unset<Area>;
    Corners points;
    static constexpr Fields fields{
        NameField{&Cell::name, "name", "name of the cell, used by its walls"},
        Field{&Cell::A, "A", mm2, "area inside of the middle lines of its walls"}.positive().may_be_missing(),
        ListField{&Cell::points, "points", "corners of these middle lines, in place of A"}
            .as_arrays()
            .may_be_missing()};
  };

  struct Wall {
    Name name, cell, beside;
    Length l = unset<Length>;
    Corners points;
    Length t = unset<Length>;
    Stress G = unset<Stress>, tau_adm = unset<Stress>;
    static constexpr Fields fields{
        NameField{&Wall::name, "name", "name of the wall"}.may_be_missing(),
        NameField{&Wall::cell, "cell", "cell bounded by the wall; none: open branch"}.may_be_missing(),
        NameField{&Wall::beside, "beside", "cell on the other side of the wall; none: the outside"}.may_be_missing(),
        Field{&Wall::l, "l", mm, "length of its middle line"}.positive().may_be_missing(),
        ListField{&Wall::points, "points", "corners of its middle line, in place of l"}.as_arrays().may_be_missing(),
        Field{&Wall::t, "t", mm, "thickness"}.positive().usually(0.1, 200),
        Field{&Wall::G, "G", GPa, "its own shear modulus"}.positive().usually(least_G, most_G).may_be_missing(),
        Field{&Wall::tau_adm, "tau_adm", MPa, "its own allowable shear stress"}
            .positive()
            .usually(1, 1000)
            .customarily_at_most(600)
            .may_be_missing()};
  };

  struct Input : ShearStrength {
    Moment T = unset<Moment>;
    double K_A = 1.0;
    List<Cell, most_cells> cells;
    List<Wall, most_walls> walls;
    Stress G = unset<Stress>;
    Twist theta_adm = unset<Twist>;
  };

  struct Flow {
    Name name;
    Area A = unset<Area>;
    Stiffness q = unset<Stiffness>;
    static constexpr Fields fields{NameField{&Flow::name, "name", "cell"},
                                   Field{&Flow::A, "A", mm2, "area inside of the middle lines"},
                                   Field{&Flow::q, "q", N_per_mm, "shear flow around the cell, positive like T"}};
  };
  struct Loaded {
    Name name;
    Length l = unset<Length>;
    Stiffness q = unset<Stiffness>;
    Stress tau_m = unset<Stress>, tau = unset<Stress>, tau_all = unset<Stress>;
    double u_tau = unset<double>;
    static constexpr Fields fields{
        NameField{&Loaded::name, "name", "wall"},
        Field{&Loaded::l, "l", mm, "length of its middle line"},
        Field{&Loaded::q, "q", N_per_mm, "shear flow of the wall: own cell less adjacent cell"},
        Field{&Loaded::tau_m, "tau_m", MPa, "mean shear stress, the flow over the thickness"},
        Field{&Loaded::tau, "tau", MPa, "shear stress at its surface"},
        Field{&Loaded::tau_all, "tau_all", MPa, "allowable shear stress"},
        Field{&Loaded::u_tau, "u_tau", ratio, "shear stress over the allowable one"}};
  };

  struct Result {
    SecondMoment I_B = unset<SecondMoment>, I_s = unset<SecondMoment>, I_t = unset<SecondMoment>;
    SectionModulus W_t = unset<SectionModulus>, W_s = unset<SectionModulus>;
    double r_I = unset<double>;
    Length t_max = unset<Length>;
    Stress tau_max = unset<Stress>, tau_s = unset<Stress>;
    Twist theta = unset<Twist>;
    double w = unset<double>, w_s = unset<double>, u_tau = unset<double>, u_theta = unset<double>;
    StressCycle cycle;
    List<Flow, most_cells> cells;
    List<Loaded, most_walls> walls;
  };
};

}  // namespace loadpath::section
