// Torques that change their sense over a turn, where a step says that they do not.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A slider with only inertia load: the moment of the crank is as large in both directions.
const std::string press = R"([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "600 rpm", positions = 90 }
links.slider.mass = "60 kg"

)";

std::string key_with(const std::string& T, const std::string& torque) {
  return press + "[key]\ncalculator = \"shaft.key\"\nT = \"" + T + "\"\ntorque = \"" + torque +
         "\"\nd = \"50 mm\"\nkey = \"14x9\"\nl = \"70 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\nR_e_k = \"420 "
         "MPa\"\n";
}

bool tells(const std::string& text, const std::string& words) {
  return first_error_of(text).find(words) != std::string::npos;
}

}  // namespace

TEST_SUITE("found senses") {
  TEST_CASE("a torque that reverses is not one-way, in full or by its peak") {
    for (const char* T : {"=press.drive.M", "=peak(press.drive.M)", "=1.2*press.drive.M"}) {
      CHECK(tells(key_with(T, "one_way"), "T reverses: 'press.drive.M'"));
      CHECK(tells(key_with(T, "one_way"), "write torque = \"reversing\""));
    }
    CHECK(first_error_of(key_with("=press.drive.M", "reversing") + "f_W = 0.5\n") == "");
  }

  TEST_CASE("this is known behind a shaft that takes its peak, too") {
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"=peak(press.drive.M)\"\ntau_adm = \"30 MPa\"\n\n";
    std::string text = key_with("=shaft.T", "one_way");
    text.insert(press.size(), shaft);
    CHECK(tells(text, "T reverses: 'press.drive.M'"));
  }

  TEST_CASE("a torque that keeps its direction is one-way") {
    const std::string lifting =
        "loads = [{ name = \"Q\", link = \"crank\", M = \"-400 N*m\" }]\n";  // more than the inertia gives back
    std::string text = key_with("=press.drive.M", "one_way");
    text.insert(text.find("links.slider.mass"), lifting);
    CHECK(first_error_of(text) == "");
  }

  TEST_CASE("teeth that a reversing torque bends both ways are idlers on both gears") {
    const auto pair = [](const std::string& idler) {
      return press +
             "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"4 mm\"\nb = \"40 mm\"\n"
             "T_1 = \"=peak(press.drive.M)\"\n" +
             idler;
    };
    CHECK(tells(pair(""), "T_1 reverses"));
    CHECK(tells(pair("idler = \"gear_1\"\n"), "write idler = \"both\""));
    CHECK(first_error_of(pair("idler = \"both\"\n")) == "");
  }

  TEST_CASE("r_T of a shaft is that of its torque") {
    const auto shaft = [](const std::string& r_T) {
      return press +
             "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\nn = \"600 rpm\"\n"
             "pieces = [{ l = \"200 mm\", d = \"60 mm\" }]\n"
             "supports = [{ x = \"45 mm\", holds = \"both\" }, { x = \"185 mm\" }]\n"
             "seats = [{ name = \"coupling\", x = \"0 mm\", way = \"balances\" }, "
             "{ name = \"gear\", x = \"150 mm\", T = \"=peak(press.drive.M)\" }]\n"
             "S_F = 1.5\nS_D = 1.5\nr_T = " +
             r_T + "\n";
    };
    CHECK(tells(shaft("1"), "r_T = 1, but seats.gear.T reverses"));
    CHECK(tells(shaft("0"), "reverses"));
    CHECK(first_error_of(shaft("-1")) == "");
  }
}
