// The overall result of all failure modes: the headline of an answer, the exit code, and a count for each group.
#pragma once

#include "lib/account/mode.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace loadpath::account {

/// The action that a mode requires of the engineer.
enum class Group { fails, needs_input, outside_scope, not_considered, accepted, passes };
constexpr std::array all_groups{Group::fails,          Group::needs_input, Group::outside_scope,
                                Group::not_considered, Group::accepted,    Group::passes};

Group group_of(const Mode& mode);
/// The name in JSON: "needs_input".
const char* key(Group group);

enum class Headline {
  pass,         // every mode that applies passes, or the user answers for it
  fail,         // at least one fails
  no_solution,  // nothing fails, but a search has no result
  incomplete,   // nothing fails, but a mode has not been assessed
};
/// "NO SOLUTION".
const char* word(Headline headline);

struct Conclusion {
  Headline headline = Headline::pass;
  std::array<std::size_t, all_groups.size()> counts{};  // number of failure modes by group; input checks are excluded

  [[nodiscard]] std::size_t count(Group group) const { return counts[static_cast<std::size_t>(group)]; }
  [[nodiscard]] std::size_t modes() const;
};
Conclusion conclude(const Modes& modes);

/// How the headline is explained: in so many characters where that is possible; `subject`: what the modes of the only
/// step cover, "torsion".
struct ExplanationOptions {
  std::size_t room = 120;
  std::string subject = {};
};
/// The reason for the headline: "3 of 56 failure modes are outside the scope of loadpath".
Message explanation(const Modes& modes, const ExplanationOptions& options = {});

/// Whether another step has assessed the mode, and has it among its own.
bool is_assessed_elsewhere(const Mode& mode);

/// Whether it is among the counts: a failure mode, decided by its own step or not decided at all.
bool is_counted(const Mode& mode);

/// Whether its utilisation may be the highest one: a limit of shape, such as a slenderness, only where it fails.
bool is_ranked(const Mode& mode);

/// "fatigue" of "fatigue (shoulders, keyways, press fits)".
std::string short_title(const Mode& mode);

}  // namespace loadpath::account
