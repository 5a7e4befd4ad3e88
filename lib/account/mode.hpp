// The state of each failure mode of a part, and their combined state.
#pragma once

#include "lib/account/verdict.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/text/issue.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::account {

/// The subject of a row among the modes.
enum class Subject {
  mode,    // a failure mode of the part
  input,   // an input needed for any assessment: a load, every input
  search,  // a search that has no result
};

struct Mode {
  std::string step;  // "gears"
  std::string id;    // "root_1": the key of `accept`
  Message title;     // "tooth root of gear 1 in bending"
  ModeKind kind = ModeKind::strength;
  bool is_limit = false;  // governs where it fails, or where nothing else does
  State state = State::not_judged;
  std::optional<double> utilisation;  // utilisation of the governing row
  std::string governs;                // the check or limit that decides: "u_F1", "segments[2].u_tau"
  Subject subject = Subject::mode;
  bool is_assessable = true;              // by some calculator of the catalogue
  std::string judge;                      // the calculator that it is left to
  std::string use, add;                   // calculators that assess it: as a replacement of this one, or in addition
  std::string wants;                      // inputs that permit an assessment: "sigma_adm_1"
  Message note;                           // for the governing mode, the reason for acceptance; may be empty
  std::optional<Compared> compared = {};  // demand and capacity of the governing row
  std::optional<Quantity> at = {};        // the position of a series where it governs
  std::string takes = {};                 // input of such a step: cycle = "=rod.cycle"
};
using Modes = std::vector<Mode>;

/// The worst of all; pass if there is none.
State worst(const Modes& modes);
/// The worst state, if worse than open; otherwise pass if any mode was assessed, else open.
State overall(const Modes& modes);
/// Whether the part passes: every mode passes, is accepted, or was not considered.
bool passes(const Modes& modes);
/// The modes in strict mode: modes not considered count as not assessed.
Modes strictly(Modes modes);
/// Failures first, then modes not assessed, then by utilisation; modes not considered come last.
Modes in_order(Modes modes);
/// "fail", "not assessed", "outside the scope".
Message shown(const Mode& mode);
/// "fail: rod.buckling; not assessed: rod.bending; pass: rod.section": never a pass without its modes.
Message scope(const Modes& modes);
/// The same below a list of all modes: of many that pass, or are open, their number.
Message brief_scope(const Modes& modes);
/// The reason shown after the title: "u_F1 at 30 deg"; "give sigma_adm_1"; "no calculator assesses it".
Message reason(const Mode& mode);
/// Whether the mode is one of many that may concern the part, without any sign that it does and without an input or
/// record of the step that would permit an assessment: not worth a line of its own.
bool is_remote(const Mode& mode);

}  // namespace loadpath::account
