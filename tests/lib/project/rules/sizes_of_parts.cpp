// Each condition of the rules for sizes, numbers of teeth and masses of [values] under words of a part.
#include "lib/project/references/stated/sizes_of_parts.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

void check(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::sizes_of_parts_stated, steps, rows);
}

}  // namespace

TEST_SUITE("project: sizes of parts") {
  TEST_CASE("diameters and lengths of a state or a place of the part") {
    check(example_of("shaft.press_fit"), {{"D_hub = \"75 mm\"", "D"},  // D = 110 mm
                                          {"D_hub_outer = \"75 mm\"", "D"},
                                          {"D_hub = \"110 mm\"", ""},
                                          {"R_hub = \"55 mm\"", ""},
                                          {"D_hub_max = \"75 mm\"", ""},
                                          {"D_motor = \"75 mm\"", ""},
                                          {"D_hub = \"9 m\"", ""}});
    check(example_of("vessel.external"), {{"L_unsupported = \"4800 mm\"", "L"},  // L = 2400 mm
                                          {"L_unsupported = \"2400 mm\"", ""},
                                          {"L_pipe = \"4800 mm\"", ""}});
    check(example_of("vessel.thick"), {{"D_bore = \"230 mm\"", "p"}, {"D_bore = \"160 mm\"", ""}});  // R = 80 mm
  }

  TEST_CASE("words of the name of a step") {
    const std::string disc = example_of("machine.disc");  // [disc], D = 500 mm, b = 40 mm
    check(disc, {{"D_disc = \"650 mm\"", "D"},
                 {"D_disc = \"500 mm\"", ""},
                 {"D_casing = \"650 mm\"", ""},
                 {"b_disc = \"30 mm\"", ""}});
  }

  TEST_CASE("teeth, widths of gears, friction and inertias") {
    const std::string rating = example_of("gear.rating");  // z = 19, 104, b = 48 mm
    check(rating, {{"z_wheel = 140", "z_2"},
                   {"z_wheel = 104", ""},
                   {"z_bolts = 8", ""},
                   {"b_wheel = \"30 mm\"", "b"},
                   {"b_wheel = \"60 mm\"", ""}});
    check(example_of("shaft.press_fit"), {{"mu_oiled = 0.08", "mu"}, {"mu_oiled = 0.14", ""}});
    const std::string run = example_of("machine.run_up");  // J = 0.05 and 3.6 kg m^2
    check(run, {{"J_impeller = \"6 kg*m^2\"", "parts"}, {"J_impeller = \"3 kg*m^2\"", ""}});
  }

  TEST_CASE("a relief, a driving sprocket, the inertia of another part of the drive") {
    check(example_of("fatigue.din743"), {{"r_relief = \"0.4 mm\"", "r"}});  // r = 2.5 mm
    check(example_of("chain.roller"), {{"z_drive = 13", "z_1"}, {"z_drive = 21", ""}});
    check(example_of("machine.run_up"), {{"J_coupling = \"0.6 kg*m^2\"", "parts"}, {"J_fan = \"0.6 kg*m^2\"", ""}});
  }

  TEST_CASE("the wheel on a bearing, the way of a chain") {
    check(example_of("bearing.rolling", "title = \"Wheel bearing\""), {{"D_wheel = \"200 mm\"", ""}});
    check(example_of("chain.roller", "title = \"Chain of a conveyor\""), {{"L_conveyor = \"8 m\"", ""}});
  }

  TEST_CASE("the smaller pulley, and a neck with another word") {
    check(example_of("belt.flat"), {{"d_1_small = \"90 mm\"", "d_1"}, {"x_1_small = \"90 mm\"", ""}});
    check(example_of("shaft.press_fit"), {{"D_neck_nut = \"75 mm\"", "D"}, {"D_nut_max = \"75 mm\"", ""}});
  }
}
