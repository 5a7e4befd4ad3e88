// The load flow, drawn.
#include "lib/draw/flow/flow.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using namespace loadpath::draw;

/// Three parts; the last takes what the label says.
std::string drawn(const std::string& label) {
  Flow flow;
  for (const char* name : {"belt", "gears", "shaft"}) flow.parts.push_back({name, "", "pass", Flow::Tone::sound});
  flow.arrows = {{0, 1, "n"}, {0, 2, label}};
  return flow_file(flow, "load path");
}

bool shows(const std::string& label, const std::string& text) {
  return drawn(label).find(">" + text + "</text>") != std::string::npos;
}

}  // namespace

TEST_SUITE("draw flow") {
  TEST_CASE("a number is shown in full, whatever else its label loses") {
    const std::string value = "\u00A0=\u00A0up\u00A0to\u00A0181.7\u00A0N·m";
    CHECK(shows("T" + value, "T" + value));
    CHECK(shows("seats.pulley.T" + value, "pulley.T" + value));
    CHECK(shows("seats.second_pulley_of_all.T" + value, "…T" + value));
    CHECK(shows("F" + value + ", …", "F" + value + ", …"));
    CHECK(shows("sigma_vM" + value + ", …", "sigma_vM" + value));
    CHECK(shows("seats.pinion.J\u00A0=\u00A00.0001557\u00A0kg·m²", "pinion.J\u00A0=\u00A00.0001557\u00A0kg·m²"));
    CHECK(drawn("a_name_that_is_far_too_long_for_it" + value).find("…" + value + "<") != std::string::npos);
  }
}
