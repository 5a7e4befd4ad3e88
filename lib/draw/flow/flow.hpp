// The flow of values between parts: parts one below the other, in the order of their calculation, with the values
// that each takes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::draw {

struct Flow {
  enum class Tone { sound, doubtful, failing, quiet };
  struct Part {
    std::string name;   // "Crankshaft in torsion"
    std::string below;  // "d = 45 mm"; may be empty
    std::string state;  // "pass"; may be empty
    Tone tone = Tone::quiet;
  };
  struct Arrow {  // from a part to one further down
    std::size_t from = 0, to = 0;
    std::string label;  // "T = 86.1 N·m"
  };
  std::vector<Part> parts;
  std::vector<Arrow> arrows;
};

/// The flow as one <svg> element of a page, without its style sheet.
std::string flow_in_page(const Flow& flow, const std::string& title);
/// The same as a file.
std::string flow_file(const Flow& flow, const std::string& title);
/// The same in LaTeX, see lib/draw/tikz.hpp.
std::string flow_tikz(const Flow& flow);

}  // namespace loadpath::draw
