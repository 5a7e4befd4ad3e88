// From checks and limits to modes of failure: what was held against a mode decides it, and what was not is said.
#pragma once

#include "lib/account/mode.hpp"
#include "lib/project/project.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// The rows of the account that judge a mode. A key of its checks names a row, "u_tau", that of every element,
/// "segments.u_tau", or all that begin so, "contact_*".
std::vector<const account::Verdict*> rows_of(const ModeInfo& mode, const std::vector<account::Verdict>& all);
/// Whether the key names the row.
bool names_row(std::string_view key, std::string_view symbol);

/// Whether a mode of strength rests on a load that is less than its series (lib/project/references/reductions.hpp).
bool is_doubtful(const Step& step, const ModeInfo& mode);
/// How a mode comes out that applies, or may, by its worst row; nothing: it has none. `enough`: whether rows that pass
/// judge it. What the user accepts is not asked.
account::State state_of(const Step& step, const ModeInfo& mode, Applies applies, std::optional<account::State> worst,
                        bool enough);

/// A typed value that decides a mode, and that a row or a record beside it does not bear out: `wants` names what would
/// justify it, and holds the mode back; without it the user has, and `why` says how. Without `why` there is none.
struct Bolder {
  std::string wants;
  Message why;
};

/// What the step says of a mode that applies, or may. `wants`: inputs without which a check of it is missing; `enough`:
/// whether the rows judge it if they pass.
account::Mode judged(const Step& step, const ModeInfo& mode, Applies applies,
                     const std::vector<const account::Verdict*>& rows, std::string wants, bool enough,
                     const Bolder& bolder = {});

/// When all steps are solved: modes that parts leave to another calculator come out as in the steps of it that have
/// taken their records whole.
void settle_left(Project& project);

}  // namespace loadpath::project
