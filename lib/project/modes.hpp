// From checks and limits to failure modes: the checks of a mode decide it, and missing ones are reported.
#pragma once

#include "lib/account/fold.hpp"
#include "lib/account/mode.hpp"
#include "lib/project/project.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// The rows of the account that assess a mode. A key of its checks names a row, "u_tau", that of every element,
/// "segments.u_tau", or all that begin so, "contact_*".
std::vector<const account::Verdict*> rows_of(const ModeInfo& mode, const std::vector<account::Verdict>& all);
/// Whether the key names the row.
bool names_row(std::string_view key, std::string_view symbol);

/// The requirements of the checks of a mode.
struct CheckNeeds {
  bool needs_checks = false;  // rows that are only limits do not assess it
  std::string wants;          // inputs without which a check is missing
};
/// `is_asked`: whether a check has its inputs.
CheckNeeds needs_of(const ModeInfo& mode, const RecordType& result,
                    const std::function<bool(const FieldInfo&)>& is_asked);

/// The state of the mode if its rows do not decide it, regardless of acceptances.
account::Unjudged unjudged_of(const Step& step, const ModeInfo& mode, const CheckNeeds& needs);

/// A typed value that decides a mode and is more favourable than the row or record for its field: `wants` names the
/// missing justification, and holds the mode back; if empty, the user has justified it, with the reason in `why`. An
/// empty `why` means there is no such value.
struct LessConservative {
  std::string wants;
  Message why;
};

/// The assessment of a mode by the step; empty if the mode does not concern the part.
std::optional<account::Mode> judged(const Step& step, const ModeInfo& mode, Applies applies,
                                    const std::vector<const account::Verdict*>& rows, const CheckNeeds& needs = {},
                                    const LessConservative& bolder = {});

/// Gives a mode the state of the worst of the modes that assess it.
void settle(account::Mode& mode, const std::vector<const account::Mode*>& judges);

/// After all steps are solved: modes assessed by another calculator get the state from its steps that have taken the
/// complete records.
void settle_left(Project& project);

}  // namespace loadpath::project
