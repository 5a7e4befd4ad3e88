// A solved project in short: what the terminal answers first, as data.
#pragma once

#include "lib/account/conclusion.hpp"
#include "lib/project/project.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::report {

/// A step, or the steps of one body.
struct Component {
  std::string name;                // "line shaft"
  std::vector<std::string> sizes;  // "d = 100 mm", "left seat 40 mm"
  bool is_sized = false;           // by a search
  std::string details;             // "d_1 = 80 mm, L = 1400 mm": what a user expects after the size
  std::optional<account::Mode> governing;
  [[nodiscard]] double utilisation() const;  // NaN without one
  [[nodiscard]] bool fails() const { return governing && governing->state == account::State::fail; }
};

/// The candidate before a size that was found.
struct NextOf {
  std::string name;  // "line shaft", "left seat"
  account::TriedSize size;
};

/// A search without a solution.
struct FailedSearch {
  std::string text;                       // what was searched, and the nearest candidate
  std::vector<account::TriedSize> tried;  // the candidates next to it; empty where sizes are searched together
};

/// One thing to do: as it is typed, "give seats[].beta_adm", and for readers of a report, "give the allowable slope of
/// the shaft there β_adm".
struct Remedy {
  std::string typed, spoken;
};

/// One thing to do, and the modes that it would let be assessed.
struct Gap {
  std::vector<std::pair<std::string, std::vector<std::string>>> modes;  // by step
  Remedy action;
};

/// Modes that were not considered.
struct NotConsidered {
  std::vector<std::string> names;  // strength modes, with their steps if there are several: "belt slip (belts)"
  std::size_t others = 0;
  std::vector<std::string> other_names;  // titles of the others, in the same way
  std::vector<Remedy> hints;             // "give mu (belts, belt slip)"
};

struct Summary {
  account::Modes modes;
  std::string subject;  // subject of the only step: "torsion"
  std::string title;    // "Line shaft: 2 pass, highest utilisation 0.859"
  std::vector<Component> components;
  std::vector<NextOf> next;
  std::vector<FailedSearch> searches;
  std::vector<std::string> failures;  // failing modes without a utilisation, with the reason
  std::vector<Gap> gaps;
  std::vector<Gap> outside;  // modes outside the scope; without an action
  NotConsidered open;
  std::string governing_step;  // as the file names it
};
Summary summarise(const project::Project& project);
/// Of one of its steps.
Summary summarise(const project::Project& project, const project::Step& step);

std::vector<Component> components_of(const project::Project& project, const account::Modes& modes);
std::vector<NextOf> next_sizes(const project::Step& step);
/// "key, key size for the shaft diameter: ...", for failing modes that no utilisation explains.
std::vector<std::string> failures_of(const project::Project& project, const account::Modes& modes);
std::vector<Gap> gaps_of(const project::Project& project, const account::Modes& modes, account::Group group);
/// `several`: whether the modes are of several steps, which are named with them.
NotConsidered not_considered(const project::Project& project, const account::Modes& modes, bool several);

/// "deflection, abutment height, wear; 6 more": the modes of service, shape and special cases, the first by name.
std::string other_modes(const NotConsidered& open);

/// "crankshaft, crank end: fatigue, bending; key: shear"; steps with different modes are separate.
std::string modes_text(const Gap& gap);
/// "95 mm fails: angle of twist per unit length 1.055".
std::string failure_text(const account::TriedSize& tried);
/// "angle of twist per unit length 1.055".
std::string failed_mode_text(const account::TriedSize& tried);

/// The subject of the only step's modes; empty if there are several steps, or it is not declared.
std::string subject_of(const project::Project& project);
/// The sizes of a step: what a search has found, else the headline that its calculator declares.
std::vector<std::string> short_sizes(const project::Step& step);
/// The details that its calculator declares; may be empty.
std::string details_of(const project::Step& step);
bool is_sized(const project::Step& step);
/// Whether that headline names a size: a safety factor or a stress that follows from others is none.
bool describes_size(const project::Step& step);
/// The name of a mode where several share a line: its title without parentheses.
std::string plain_title(const account::Mode& mode);
/// "left seat" of "pieces.left_seat.d"; empty of a size of the step itself.
std::string owner_of(const std::string& path);
/// The sizes that a step was given where a search might have found them: "pulley seat 32 mm".
std::vector<std::string> given_sizes(const project::Step& step);
/// The given sizes that the headline, unless it is shown, and the details of its calculator name: "b = 28 mm".
std::vector<std::string> declared_sizes(const project::Step& step);
/// The name of a step's component: its body, else the step.
std::string component_name(const project::Step& step);
/// Whether the utilisation of a mode counts: of its own step, and no ratio of shapes unless it fails.
bool is_told(const account::Mode& mode);
/// The element or the position where a mode governs: "key end", "210°"; may be empty.
std::string location_of(const account::Mode& mode);

}  // namespace loadpath::report
