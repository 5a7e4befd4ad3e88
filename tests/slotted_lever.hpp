// The mechanism of examples/slotted-lever with its crankshaft in two steps of one body: in torsion, and on its
// overhang.
#pragma once

#include "lib/toml/tree.hpp"

#include <doctest/doctest.h>

#include <string>

namespace loadpath::test {

inline std::string slotted_lever_with_two_shafts() {
  std::string text;
  REQUIRE(toml::read_file(LOADPATH_ROOT "/examples/slotted-lever/project.toml", text));
  const std::size_t values = text.find("[values]"), lever = text.find("[lever]"), shaft = text.find("[crankshaft]");
  REQUIRE(values < lever);
  REQUIRE(lever < shaft);
  REQUIRE(shaft != std::string::npos);
  return text.substr(0, values) + text.substr(lever, shaft - lever) +
         "[crankshaft]\ncalculator = \"shaft.torsion\"\nbody = \"crankshaft\"\nT = \"=peak(lever.drive.M)\"\n"
         "K_A = 1.4\nmaterial = \"C45E\"\ntau_adm = \"30 MPa\"\ntheta_adm = \"0.25 deg/m\"\n\n"
         "[crank_end]\ncalculator = \"shaft.overhung\"\nbody = \"crankshaft\"\nload = \"=lever.drive\"\n"
         "a = \"50 mm\"\nK_A = 1.4\nsigma_adm = \"60 MPa\"\ntau_adm = \"30 MPa\"\n";
}

}  // namespace loadpath::test
