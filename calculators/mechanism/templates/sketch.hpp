// Draws a mechanism at its first position: where the pins are follows from lengths, never from rough angles.
//
// Template sources use it. Links lie in axes of their own: the origin is the first pin, the x axis runs to the second.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/text/issue.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace loadpath::planar::templates {

using mechanism::Vec;

/// Choice between the two assemblies of two lengths. Each template states its meaning.
enum class Assembly { open, crossed };

/// A pin of a link, and where it is on paper.
struct Pin {
  const char* name;
  Vec at;
};

/// A link as far as it decides where others are.
struct PlacedLink {
  const char* link;
  Vec from;
  Length l;
};

/// The straight line of a guide.
struct Line {
  Vec through;
  Vec along;  // unit
};

Vec polar(Length r, double angle);
Vec cartesian(Length x, Length y);
/// The direction from one point to another, rad.
double direction(Vec from, Vec to);
/// "120 mm"
std::string text_of(Length l);

/// Advice for a crank that cannot rotate fully.
Message part_of_a_turn();
/// With the part: "between 15 deg and 74 deg".
Message part_of_a_turn(const Message& part);
/// Advice for a first position that does not close.
Message start_elsewhere();
/// With the part in which the mechanism closes.
Message start_elsewhere(const Message& part);
/// A crank as long as the distance of the pin that it turns something about: its own pin comes to lie on that one.
std::optional<FieldFault> pin_runs_through(const char* pin, Length r, Length d);
/// A slotted lever about B that is shorter than the crank's pin is far; `path`: the parameter that is its length.
FieldFault leaves_slot(const char* path, Length lever, Length farthest);

class Sketch {
 public:
  /// `angle`: the crank's at the first position, rad; NaN where there is none.
  Sketch(Mechanism::Input& in, double angle) : in_(in), angle_(angle) {}

  /// The point where two links meet; left of the line between them where `open`, right where `crossed`.
  Vec meet(const PlacedLink& one, const PlacedLink& other, Assembly assembly);
  /// The place where a link meets a line, ahead of its foot on the line where `open`, behind it where `crossed`.
  Vec meet(const PlacedLink& link, const Line& line, Assembly assembly);

  /// The crank OA of this length, driven about the fixed pin O at the origin: its pin A.
  Pin crank_arm(Length r);
  /// The link "cam", driven about the fixed pin O at the origin.
  void turning_cam();

  void fixed(const Pin& pin);
  /// A bar with two pins; its mass centre is the point S_LINK in the middle.
  void bar(const char* link, const Pin& from, const Pin& to, Length l);
  /// One more pin on the link drawn last, in its axes.
  void point(const char* name, Vec at);
  /// A link with one pin that slides or turns in place; its mass centre is the pin.
  void block(const char* link, const Pin& pin, double angle);

  void revolute(const char* joint, const char* first, const char* second, const char* point = "");
  /// The point of the first link on the line through that of the second, at `angle` in the axes of the second.
  void prismatic(const char* joint, std::pair<const char*, const char*> links,
                 std::pair<const char*, const char*> points, double angle = 0.0);
  void slot(const char* joint, std::pair<const char*, const char*> links, std::pair<const char*, const char*> points,
            double angle = 0.0);
  /// The follower's point on the profile of the cam, whose axis is the cam's point; the profile's x axis at `angle`
  /// in the axes of the cam. Faults of the profile are reported under its own fields, as named by the template.
  void cam(const char* joint, std::pair<const char*, const char*> links, std::pair<const char*, const char*> points,
           const CamProfile& profile, double angle, planar::Type type = planar::Type::cam);
  /// Where the follower's point is: a roller's centre, the middle of a flat face.
  [[nodiscard]] Vec follower_at(const CamProfile& profile, double angle) const;
  void cylinder(const char* name, const char* joint);

  /// The first pair of links that does not meet; consequent faults are not reported.
  [[nodiscard]] const std::optional<FieldFault>& fault() const { return fault_; }
  /// The bars and their lengths.
  [[nodiscard]] const std::vector<std::pair<std::size_t, Length>>& bars() const { return bars_; }

 private:
  void drive(const char* link);
  void link(const char* name, Vec origin, double angle);
  void joint(const char* name, planar::Type type, const planar::Pair& links, const planar::Pair& points, double angle);
  void refuse(Message message);
  [[nodiscard]] std::string where() const;

  Mechanism::Input& in_;
  double angle_;
  std::optional<FieldFault> fault_;
  std::vector<std::pair<std::size_t, Length>> bars_;
};

/// Zeros where the numbers of a drawing without lengths go: they are given, whatever they will be.
void put_zeros(Mechanism::Input& in);

constexpr auto choices_of(Assembly) {
  return std::array{ChoiceName<Assembly>{Assembly::open, "open", "usual assembly"},
                    ChoiceName<Assembly>{Assembly::crossed, "crossed", "mirrored assembly"}};
}

}  // namespace loadpath::planar::templates
