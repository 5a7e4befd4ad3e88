#include "calculators/mechanism/cycle/idle.hpp"

#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/names.hpp"

#include <algorithm>

namespace loadpath::planar {

namespace {

class IdleFields {
 public:
  IdleFields(const Mechanism::Input& in, const std::function<bool(const std::string&)>& typed)
      : in_(in), typed_(typed) {}

  std::vector<FieldFault> run() {
    check_turn();
    check_law();
    check_senses();
    const bool crank = !in_.crank.joint.empty();
    if (crank && typed_("positions"))
      add("positions", say("'positions' belongs to strokes of cylinders, and a crank drives"),
          say("give the positions of a revolution in the crank: crank = { positions = 72 }"));
    for (const planar::Cylinder& cylinder : in_.cylinders) check_motion(cylinder);
    if (!crank && !has_law(in_)) check_strokes();
    return std::move(faults_);
  }

 private:
  void add(std::string path, Message message, Message hint) {
    faults_.push_back({std::move(path), std::move(message), std::move(hint)});
  }

  void check_turn() {
    for (const char* path : {"crank.start", "crank.positions"}) {
      if (!typed_("crank.at") || !typed_(path)) continue;
      add(path, say("'{1}' needs a full revolution, but 'crank.at' gives single crank angles", path),
          say("leave out one of the two"));
    }
  }

  void check_law() {
    const bool formula = !in_.crank.angle_of_t.empty();
    if (in_.crank.law.empty() && !formula) return;
    for (const char* const path : {"crank.speed", "crank.acceleration", "crank.start", "crank.at"}) {
      if (!typed_(path)) continue;
      add(path,
          say("'{1}' and '{2}' both define the motion of the crank", path, formula ? "crank.angle_of_t" : "crank.law"),
          say("leave out one of the two"));
    }
  }

  /// Friction of what moves has its sense from the motion.
  void check_senses() {
    const auto moves = [](const auto& drive) { return in_si(drive.speed) != 0.0; };
    const bool some_move =
        has_law(in_) || moves(in_.crank) || std::any_of(in_.cylinders.begin(), in_.cylinders.end(), moves);
    const auto check = [&](const auto& drive, const std::string& path) {
      const bool follows_law =
          typed_(path + ".law") || typed_(path + ".angle_of_t") || typed_(path + ".place_of_t");  // see the law
      if (drive.impending == planar::Impending::either || !some_move || follows_law) return;
      add(path + ".impending",
          moves(drive) ? say("'impending' belongs to a drive at rest, and '{1}' has a speed", path)
                       : say("'impending' belongs to a mechanism at rest, and another drive moves"),
          say("leave out one of the two"));
    };
    check(in_.crank, "crank");
    for (const auto& cylinder : in_.cylinders) check(cylinder, path_of("cylinders", cylinder.name));
  }

  /// A cylinder with a law has its places and speeds from it.
  void check_motion(const planar::Cylinder& cylinder) {
    if (cylinder.law.empty() && cylinder.place_of_t.empty()) return;
    const std::string law = path_of("cylinders", cylinder.name, cylinder.law.empty() ? "place_of_t" : "law");
    for (const char* const field : {"speed", "acceleration", "from", "to"}) {
      const std::string path = path_of("cylinders", cylinder.name, field);
      if (!typed_(path)) continue;
      add(path, say("'{1}' and '{2}' both define the motion of the cylinder", path, law),
          say("leave out one of the two"));
    }
  }

  /// A stroke needs both ends and a number of positions.
  void check_strokes() {
    const bool several = in_.positions > 1;
    if (several && !in_.cylinders.empty() && !is_set(in_.cylinders.front().to))
      add("positions",
          say("'positions' divides a stroke, and the cylinder '{1}' has no end position",
              text(in_.cylinders.front().name)),
          say("add 'to', the end position"));
    for (const auto& cylinder : in_.cylinders) {
      if (several || !is_set(cylinder.to)) continue;
      add(path_of("cylinders", cylinder.name, "to"),
          say("'to' is the end of a stroke, and only one position is solved"),
          say("add the number of positions, positions = 72, or leave out 'to'"));
    }
  }

  const Mechanism::Input& in_;
  const std::function<bool(const std::string&)>& typed_;
  std::vector<FieldFault> faults_;
};

}  // namespace

std::vector<FieldFault> idle_fields(const Mechanism::Input& in, const std::function<bool(const std::string&)>& typed) {
  return IdleFields(in, typed).run();
}

}  // namespace loadpath::planar
