// How the modes of failure of a part came out, and what may be said of all of them.
#pragma once

#include "lib/account/verdict.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/text/issue.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::account {

/// What a row among the modes is about.
enum class Subject {
  mode,    // a mode of failure of the part
  input,   // what the step needs to be assessed at all: a load, every input
  search,  // a search that has no result
};

struct Mode {
  std::string step;  // "gears"
  std::string id;    // "root_1": the key of `accept`
  Message title;     // "tooth root of gear 1 in bending"
  ModeKind kind = ModeKind::strength;
  State state = State::not_judged;
  std::optional<double> utilisation;  // of what governs
  std::string governs;                // the check or limit that decides: "u_F1", "segments[2].u_tau"
  Subject subject = Subject::mode;
  bool is_assessable = true;              // by some calculator of the catalogue
  std::string judge;                      // the calculator that it is left to
  std::string use, add;                   // calculators that assess it: in place of this one, beside it
  std::string wants;                      // inputs that would let it be judged: "sigma_adm_1"
  Message note;                           // where it governs, why it is accepted; may be empty
  std::optional<Compared> compared = {};  // of what governs
  std::optional<Quantity> at = {};        // the position of a series where it governs
  std::string takes = {};                 // what such a step takes: cycle = "=rod.cycle"
};
using Modes = std::vector<Mode>;

/// The worst of all; pass where there is none.
State worst(const Modes& modes);
/// What is said of all together: the worst, but for what is open or accepted, beside which the others pass; open where
/// nothing was judged at all.
State overall(const Modes& modes);
/// Whether nothing stands against the part: every mode passes, is accepted, or was not considered.
bool passes(const Modes& modes);
/// The modes where nothing may be left open: what is open counts as not judged.
Modes strictly(Modes modes);
/// Failures first, then what is not judged, then by utilisation; what is open comes last.
Modes in_order(Modes modes);
/// "fail", "not assessed", "outside the scope".
Message shown(const Mode& mode);
/// "fail: rod.buckling; not assessed: rod.bending; pass: rod.section": never a pass without what it covers.
Message scope(const Modes& modes);
/// The same below a list of all modes: of many that pass, or are open, their number.
Message brief_scope(const Modes& modes);
/// What stands behind the title: "u_F1 at 30 deg"; "give sigma_adm_1"; "no calculator assesses it".
Message reason(const Mode& mode);
/// Whether the mode is one of many that may concern the part, while nothing says so and no input or record of the step
/// would let it be assessed: worth no line of its own.
bool is_remote(const Mode& mode);

}  // namespace loadpath::account
