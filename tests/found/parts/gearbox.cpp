// Typical mistakes in examples/gearbox: none may pass, and the words name the cause.
#include "tests/found/modes.hpp"
#include "tests/pages.hpp"

#include <algorithm>
#include <string>
#include <string_view>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// The example with another text in one of its steps.
std::string gearbox_with(std::string_view step, const std::string& from, const std::string& to) {
  std::string text = text_of(LOADPATH_ROOT "/examples/gearbox/project.toml");
  const std::size_t head = text.find("\n[" + std::string(step) + "]\n");
  REQUIRE(head != std::string::npos);
  const std::size_t at = text.find(from, head);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// The state of a mode, as the mistake leaves it.
std::string state(std::string_view step, const std::string& from, const std::string& to, std::string_view of,
                  std::string_view mode) {
  return mode_of(solved_as_found(gearbox_with(step, from, to)), of, mode);
}

void refused(std::string_view step, const std::string& from, const std::string& to, const std::string& words) {
  const std::string error = first_error_of(gearbox_with(step, from, to));
  CHECK_MESSAGE(error.find(words) != std::string::npos, step, ": ", error);
}

/// Whether a mode of a step waits for a reason with these words.
bool waits(const std::string& text, std::string_view step, const std::string& words) {
  const auto modes = project::modes(solved_as_found(text));
  return std::any_of(modes.begin(), modes.end(), [&](const account::Mode& mode) {
    return mode.step == step && mode.note.text().find(words) != std::string::npos;
  });
}

const std::string right_mate = "load = \"=intermediate.bearings.right\", Y";

}  // namespace

TEST_SUITE("found gearbox") {
  TEST_CASE("a hand that reverses the axial force overloads a tapered roller bearing") {
    CHECK(state("stage_2", "hand = \"right\"", "hand = \"left\"", "intermediate_right", "fatigue") == "fail");
    CHECK(state("stage_1", "hand = \"left\"", "hand = \"right\"", "intermediate_left", "fatigue") == "fail");
  }

  TEST_CASE("exactly one bearing locates a shaft: neither two nor none") {
    refused("input", "x = \"90 mm\",", "x = \"90 mm\", holds = \"both\",", "only one bearing can be the locating");
    refused("input", ", holds = \"both\"", "", "exactly one bearing must take axial forces");
    refused("output", "x = \"14 mm\", holds = \"both\"", "x = \"14 mm\"", "exactly one bearing must take axial forces");
  }

  TEST_CASE("a bearing that cannot carry the thrust, or cannot carry a radial load") {
    CHECK(state("input_right", "\"6206\"", "\"NU 206 ECP\"", "input_right", "axial") == "fail");
    CHECK(state("output_right", "\"6212\"", "\"51112\"", "output_right", "radial") == "fail");
    CHECK(state("intermediate_left",
                "mate = { " + right_mate + " = \"=intermediate_right.Y\" }\narrangement = \"face_to_face\"", "",
                "intermediate_left", "axial") == "fail");
  }

  TEST_CASE("a bearing that does not fit its seat or its fillet") {
    CHECK(state("input_left", "\"NU 206 ECP\"", "\"NU 207 ECP\"", "input_left", "seat") == "fail");
    CHECK(state("output_left", "\"6211\"", "\"6212\"", "output_left", "seat") == "fail");
    CHECK(state("input_right", "\"6206\"", "\"61906\"", "input_right", "seat") == "fail");
    CHECK(state("input", "l = \"18 mm\", d = \"30 mm\"", "l = \"9 mm\", d = \"30 mm\"", "input_right", "seat") ==
          "fail");
  }

  TEST_CASE("the opposed bearing of a pair is on the same shaft") {
    refused("intermediate_left", right_mate, "load = \"=output.bearings.right\", Y", "at the speed of their shaft");
  }

  TEST_CASE("segments and bores that the gears do not fit") {
    refused("stage_1", "bore_2 = \"=values.d_w2\"", "bore_2 = \"55 mm\"", "must equal the shaft diameter");
    refused("stage_2", "bore_2 = \"=values.d_w4\"", "bore_2 = \"185 mm\"", "must equal the shaft diameter");
    refused("intermediate", "d = \"=stage_2.d_f1\"", "d = \"=stage_2.d_a1\"", "lies inside the shaft");
    refused("intermediate", "l = \"=stage_2.b + 2 mm\"", "l = \"=stage_2.b - 20 mm\"", "beyond the end of the shaft");
    refused("intermediate", "l = \"58 mm\"", "l = \"35 mm\"", "beyond the end of the shaft");
    refused("input_key", "d = \"=values.d_in\"", "d = \"38 mm\"", "the notch is for a shaft of 38 mm");
    CHECK(state("wheel_2_key", "l = \"36 mm\"", "l = \"50 mm\"", "wheel_2_key", "hub_length") ==
          "not-available");  // of no key
    refused("output", "values.c_2\"", "values.c_2 - 30 mm\"", "reaches beyond its segment of the shaft");
  }

  TEST_CASE("torques, speeds and directions that contradict each other") {
    refused("output", "T = \"=values.K_A*train.T_out\"", "T = \"=values.K_A*train.T_1\"", "torques do not balance");
    refused("intermediate", "way = \"drives\"", "way = \"takes\"", "torques do not balance");
    refused("stage_2", "n_1 = \"=train.shafts[2].n\"", "n_1 = \"=train.shafts[1].n\"", "must have the same speed");
    refused("stage_2", "T_1 = \"=abs(train.shafts[2].T)\"", "T_1 = \"=train.shafts[1].T\"", "contradicts");
  }

  TEST_CASE("a wheel that touches the next shaft or its bearing, or leaves less than its module or 2 mm") {
    CHECK(waits(
        gearbox_with("output", "d = \"64 mm\"", "d = \"69 mm\""), "intermediate",
        "gear 2 of 'stage_1' and segment 'shoulder' of 'output', diameters 179 mm and 69 mm, are 1.011 mm apart"));
    const std::string near = gearbox_with("values", "c_1 = \"41 mm\"", "c_1 = \"30 mm\"");
    CHECK(waits(near, "intermediate", "gear 2 of 'stage_1' and bearing 'output_left', diameters 179 mm and 100 mm, "));
    CHECK_FALSE(waits(gearbox_with("values", "P = \"11 kW\"", "P = \"11.1 kW\""), "intermediate", " apart"));
  }

  TEST_CASE("a gear that reaches into a bearing of its shaft") {
    CHECK(waits(gearbox_with("input", "values.c_1\", load", "values.c_1 - 14 mm\", load"), "input",
                "gear 1 of 'stage_1' and bearing 'input_left' overlap by 1 mm"));
  }

  TEST_CASE("two gears without a direction, and a bearing without the lubricant of the others") {
    std::string text = gearbox_with("intermediate", "angle = \"0 deg\", ", "");
    const std::size_t at = text.find("angle = \"180 deg\", ");
    CHECK(waits(text.erase(at, std::string("angle = \"180 deg\", ").size()), "intermediate", "have no angle"));
    CHECK(waits(gearbox_with("output_right", "nu = \"=values.nu\"\ne_C = \"=values.e_C\"\n", ""), "output_right",
                "'input_left' includes them: give nu and e_C"));
  }

  TEST_CASE("a shoulder that is not given as a notch is named, though a diameter is searched for") {
    refused("output", "  { name = \"right_shoulder\", x = \"191 mm\", r = \"1.4 mm\", h = \"4.5 mm\" },", "",
            "at 191 mm the diameter changes from 60 mm to 70 mm without a notch");
  }
}
