// From checks and limits to modes of failure: what was held against a mode decides it, and what was not is said.
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

/// The rows of the account that judge a mode. A key of its checks names a row, "u_tau", that of every element,
/// "segments.u_tau", or all that begin so, "contact_*".
std::vector<const account::Verdict*> rows_of(const ModeInfo& mode, const std::vector<account::Verdict>& all);
/// Whether the key names the row.
bool names_row(std::string_view key, std::string_view symbol);

/// What the checks of a mode need.
struct CheckNeeds {
  bool needs_checks = false;  // rows that are limits alone do not judge it
  std::string wants;          // inputs without which a check is missing
};
/// `is_asked`: whether a check has what it needs.
CheckNeeds needs_of(const ModeInfo& mode, const RecordType& result,
                    const std::function<bool(const FieldInfo&)>& is_asked);

/// How the mode comes out where its rows do not decide it. What the user accepts is not asked.
account::Unjudged unjudged_of(const Step& step, const ModeInfo& mode, const CheckNeeds& needs);

/// A typed value that decides a mode, and that a row or a record beside it does not bear out: `wants` names what would
/// justify it, and holds the mode back; without it the user has, and `why` says how. Without `why` there is none.
struct Bolder {
  std::string wants;
  Message why;
};

/// What the step says of a mode; nothing where the mode does not concern the part.
std::optional<account::Mode> judged(const Step& step, const ModeInfo& mode, Applies applies,
                                    const std::vector<const account::Verdict*>& rows, const CheckNeeds& needs = {},
                                    const Bolder& bolder = {});

/// When all steps are solved: modes that parts leave to another calculator come out as in the steps of it that have
/// taken their records whole.
void settle_left(Project& project);

}  // namespace loadpath::project
