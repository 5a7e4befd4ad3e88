// Results of a mechanism with cams in addition to those of every joint.
#include "calculators/mechanism/input/profiles.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/studies/cam_state.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace loadpath::planar {

namespace {

using account::Quantity;
using mechanism::CamContact;
using mechanism::JointKind;
using mechanism::Position;

struct Cam {
  std::string name;
  std::size_t index = 0;
  std::shared_ptr<const mechanism::Model> model;

  [[nodiscard]] const mechanism::Joint& joint() const { return model->joints[index]; }
  [[nodiscard]] mechanism::CamState at(const Position& p) const { return cam_state(*model, index, p); }
  static bool slides(const Cam& c) { return c.joint().contact == CamContact::flat || c.joint().radius_i == 0.0; }
  static bool is_guided(const Cam& c) { return guide_of(*c.model, c.index).has_value(); }
};

constexpr std::array cam_rows{
    row<Cam>(
        "joints.NAME.N", "contact force of the cam on the follower; negative: the follower lifts off", N,
        {.tabled = Tabled::always, .is_load = true}, [](const Cam& c, const Position& p) { return c.at(p).pressing; },
        nullptr, "cams"),
    row<Cam>(
        "joints.NAME.alpha", "pressure angle: of the contact's normal against the path of the follower", deg,
        {.kind = Kind::pressure_angle}, [](const Cam& c, const Position& p) { return *c.at(p).pressure_angle; },
        &Cam::is_guided, "cams whose follower slides or turns"),
    row<Cam>(
        "joints.NAME.v_s", "speed of sliding of the follower on the cam, counter-clockwise round it positive", m_per_s,
        [](const Cam& c, const Position& p) { return c.at(p).sliding; }, &Cam::slides, "edges and flat faces on cams")};

std::string angle_text(const mechanism::Joint& joint, double parameter) {
  return format_quantity(cam_angle(*joint.profile, parameter), "deg", 4);
}

void list_cams(std::vector<ResultPattern>& patterns) { list_patterns(cam_rows, patterns); }

void add_cams(const Mechanism::Input&, const mechanism::Model& model, std::vector<Output>& out) {
  const auto kept = std::make_shared<const mechanism::Model>(model);
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    if (model.joints[k].kind == JointKind::cam) add_outputs(Cam{model.joints[k].name, k, kept}, cam_rows, out);
  }
}

/// Steeper, the side thrust jams a follower in its guide; 30 deg are the custom of one that slides, 45 deg of one that
/// turns (recalled).
constexpr double steepest = 0.25 * pi;

/// That the cam does not jam its follower.
void judge_pressure_angle(const Solved& solved, std::size_t k, std::vector<account::Verdict>& verdicts) {
  if (!guide_of(solved.given, k)) return;
  double most = 0.0;
  std::size_t at = 0;
  const auto& positions = solved.proved.positions;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto alpha = cam_state(solved.given, k, positions[i]).pressure_angle;
    if (!alpha || !(std::abs(*alpha) > most)) continue;
    most = std::abs(*alpha);
    at = i;
  }
  const mechanism::Joint& joint = solved.given.joints[k];
  verdicts.push_back({.step = solved.step,
                      .symbol = "pressure_" + joint.name,
                      .meaning = say("maximum pressure angle of the cam, joint '{1}'", joint.name),
                      .value = Quantity{most, "deg"},
                      .bound = say("up to {1}", format_quantity(steepest, "deg")),
                      .state = account::pass_if(most <= steepest * (1.0 + 1e-9)),
                      .note = solved.axis == nullptr || at >= solved.axis->at.size()
                                  ? Message{}
                                  : say("at {1} ({2})", format_quantity(solved.axis->at[at], solved.axis->unit, 5),
                                        solved.axis->name())});
}

/// That the profile can be made, and the roller reaches all of it.
void judge_cams(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  for (std::size_t k = 0; k < solved.given.joints.size(); ++k) {
    const mechanism::Joint& joint = solved.given.joints[k];
    if (joint.kind != JointKind::cam) continue;
    judge_pressure_angle(solved, k, verdicts);
    const mechanism::Bends bends = mechanism::bends_of(*joint.profile);
    const bool flat = joint.contact == CamContact::flat;
    const std::string angle = angle_text(joint, bends.bulge_at);
    verdicts.push_back(
        {.step = solved.step,
         .symbol = "profile_" + joint.name,
         .meaning = say("minimum radius of curvature of the convex profile, joint '{1}': not undercut", joint.name),
         .value = Quantity{bends.bulge, "mm"},
         .bound = say("more than 0"),
         .state = account::pass_if(bends.bulge > 0.0),
         .note =
             bends.bulge > 0.0 ? say("at a cam angle of {1}", angle)
             : flat
                 ? say("undercut at a cam angle of {1}: make the base circle larger, or the segment longer", angle)
                 : say("undercut at a cam angle of {1}: make the base circle larger, or the roller smaller", angle)});
    if (!std::isfinite(bends.hollow) || flat || joint.radius_i == 0.0) continue;
    verdicts.push_back(
        {.step = solved.step,
         .symbol = "hollow_" + joint.name,
         .meaning =
             say("minimum radius of curvature of the concave profile: fit of the roller of joint '{1}'", joint.name),
         .value = Quantity{bends.hollow, "mm"},
         .bound = say("more than {1}", format_quantity(joint.radius_i, "mm")),
         .state = account::pass_if(bends.hollow > joint.radius_i),
         .note = say("at a cam angle of {1}", angle_text(joint, bends.hollow_at))});
  }
}

template <class Holds>
bool any_law(const Mechanism::Input& in, Holds holds) {
  return std::any_of(in.profiles.begin(), in.profiles.end(), [&](const CamProfile& profile) {
    return std::any_of(profile.segments.begin(), profile.segments.end(),
                       [&](const CamProfile::Segment& segment) { return holds(segment.law); });
  });
}

constexpr std::array cited{
    Citation{"Trajectories",
             [](const auto& in, const auto&) {
               return any_law(in, [](CamProfile::Law law) { return law != CamProfile::Law::dwell; });
             }},
    Citation{"Rothbart",
             [](const auto& in, const auto&) {
               return any_law(in, [](CamProfile::Law law) { return law == CamProfile::Law::modified_sine; });
             }},
    Citation{"SolidWorks", [](const auto& in, const auto&) {
               return any_law(in, [](CamProfile::Law law) { return law == CamProfile::Law::modified_trapezoid; });
             }}};

}  // namespace

constinit const Aspect aspects::cams{
    .list = &list_cams, .add_outputs = &add_cams, .judge = &judge_cams, .citations = cited};

}  // namespace loadpath::planar
