#include "calculators/mechanism/step.hpp"

#include "calculators/mechanism/aspects/accuracy.hpp"
#include "calculators/mechanism/aspects/assemblies.hpp"
#include "calculators/mechanism/aspects/balance.hpp"
#include "calculators/mechanism/aspects/influence.hpp"
#include "calculators/mechanism/aspects/masses.hpp"
#include "calculators/mechanism/aspects/report.hpp"
#include "calculators/mechanism/aspects/sources.hpp"
#include "calculators/mechanism/cycle/either_way.hpp"
#include "calculators/mechanism/expansion.hpp"
#include "calculators/mechanism/outputs.hpp"
#include "calculators/mechanism/pictures/figures.hpp"
#include "calculators/mechanism/pictures/hodographs.hpp"
#include "calculators/mechanism/proof/proof.hpp"
#include "calculators/mechanism/proof/redundancy.hpp"
#include "calculators/mechanism/results/design.hpp"
#include "calculators/mechanism/results/governing.hpp"
#include "calculators/mechanism/results/values.hpp"
#include "calculators/mechanism/templates/template.hpp"
#include "calculators/mechanism/words/checks.hpp"
#include "calculators/mechanism/words/loads.hpp"
#include "calculators/mechanism/words/model.hpp"
#include "calculators/mechanism/words/profiles.hpp"
#include "lib/calculator/calculator.hpp"
#include "lib/calculator/record_of.hpp"
#include "lib/mechanism/structure/structure.hpp"

#include <algorithm>
#include <iterator>

namespace loadpath::planar {

void MechanismStep::prepare(const project::Declared& declared, const project::Companions&, std::vector<Issue>& issues) {
  const auto is_own = [&](const Issue& issue) {
    return issue.severity == Severity::error && (issue.key + ".").starts_with(name() + ".");
  };
  check_operands(input().reading, name(), false, declared, issues);
  // What names hang on must see that a value is given; which one is known when the project is solved.
  for (const project::Operand& operand : input().reading.operands) operand.leaf.set(operand.leaf.field->factor);
  if (input().from != nullptr) add_faults(check_overrides(*input().from, input().reading), issues);
  add_faults_of_names(issues);
  const bool known = input().reading.operands.empty();
  if (known && !std::any_of(issues.begin(), issues.end(), is_own)) expand_template(issues);
  if (std::any_of(issues.begin(), issues.end(), is_own)) return;  // the model has holes: nothing more can be said of it
  mechanism::Model model = model_of(data());
  outputs_ = mechanism_outputs(data(), model);
  const std::string axis = axis_name(data());
  if (!axis.empty()) {
    const double period = is_whole_turn(data()) ? 2.0 * pi : 0.0;  // its sense is known when the cycle is solved
    const char* const unit = axis == "time" ? "s" : axis == "stroke" ? "mm" : "deg";
    axis_ = std::make_unique<Axis>(Axis{name(), axis, unit, {}, {}, period});
  }
  add_idle_fields(issues);
  if (known && diagnose_model(model, issues)) add_faults(choose_assembly(data(), structure_, model), issues);
}

void MechanismStep::add_faults(const std::vector<FieldFault>& faults, std::vector<Issue>& issues) const {
  for (const FieldFault& fault : faults) issues.push_back(issue_at(input(), fault.path, fault.message, fault.hint));
}

bool MechanismStep::expand_template(std::vector<Issue>& issues) {
  if (input().from == nullptr) return true;
  const auto faults = expand(*input().from, input().reading, data());
  add_faults(faults, issues);
  return faults.empty();
}

/// Fields that would do nothing beside the drive that is given.
void MechanismStep::add_idle_fields(std::vector<Issue>& issues) const {
  const auto typed = [&](const char* path) { return input().reading.typed.count(path) != 0; };
  for (const char* path : {"crank.start", "crank.positions"}) {
    if (!typed("crank.at") || !typed(path)) continue;
    issues.push_back(issue_at(input(), path,
                              say("'{1}' is of a whole turn, and 'crank.at' gives the crank angles", path),
                              say("leave out one of the two")));
  }
  const bool formula = !data().crank.angle_of_t.empty();
  for (const char* const path : {"crank.speed", "crank.acceleration", "crank.start", "crank.at"}) {
    if ((data().crank.law.empty() && !formula) || !typed(path)) continue;
    issues.push_back(
        issue_at(input(), path,
                 say("'{1}' and '{2}' both say how the crank moves", path, formula ? "crank.angle_of_t" : "crank.law"),
                 say("leave out one of the two")));
  }
  add_idle_senses(issues);
  const bool crank = !data().crank.joint.empty();
  if (crank && typed("positions")) {
    issues.push_back(issue_at(input(), "positions", say("'positions' is of strokes of cylinders, and a crank drives"),
                              say("the positions of a turn stand in the crank: crank = { positions = 72 }")));
  }
  add_idle_motions(issues);
  if (!crank) add_idle_strokes(issues);
}

/// A cylinder with a law has its places and speeds from it.
void MechanismStep::add_idle_motions(std::vector<Issue>& issues) const {
  for (const auto& cylinder : data().cylinders) {
    if (cylinder.law.empty() && cylinder.place_of_t.empty()) continue;
    const std::string law = path_of("cylinders", cylinder.name, cylinder.law.empty() ? "place_of_t" : "law");
    for (const char* const field : {"speed", "acceleration", "from", "to"}) {
      const std::string path = path_of("cylinders", cylinder.name, field);
      if (input().reading.typed.count(path) == 0) continue;
      issues.push_back(issue_at(input(), path, say("'{1}' and '{2}' both say how the cylinder moves", path, law),
                                say("leave out one of the two")));
    }
  }
}

/// Friction of what moves has its sense from the motion.
void MechanismStep::add_idle_senses(std::vector<Issue>& issues) const {
  const auto moves = [](const auto& drive) { return in_si(drive.speed) != 0.0; };
  const auto& cylinders = data().cylinders;
  const bool some_move =
      has_law(data()) || moves(data().crank) || std::any_of(cylinders.begin(), cylinders.end(), moves);
  const auto check = [&](const auto& drive, const std::string& path) {
    const auto& typed = input().reading.typed;
    const auto has = [&](const char* field) { return typed.count(path + field) != 0; };
    const bool follows_law = has(".law") || has(".angle_of_t") || has(".place_of_t");  // told with the law
    if (drive.impending == planar::Impending::either || !some_move || follows_law) return;
    issues.push_back(issue_at(input(), path + ".impending",
                              moves(drive) ? say("'impending' is of a drive that rests, and '{1}' has a speed", path)
                                           : say("'impending' is of a mechanism that rests, and another drive moves"),
                              say("leave out one of the two")));
  };
  check(data().crank, "crank");
  for (const auto& cylinder : data().cylinders) check(cylinder, path_of("cylinders", cylinder.name));
}

/// A stroke needs both ends and a number of positions.
void MechanismStep::add_idle_strokes(std::vector<Issue>& issues) const {
  const bool several = data().positions > 1;
  if (has_law(data())) return;
  if (several && !data().cylinders.empty() && !is_set(data().cylinders.front().to)) {
    issues.push_back(issue_at(input(), "positions",
                              say("'positions' is of a stroke, and the cylinder '{1}' has no end of it",
                                  std::string(data().cylinders.front().name.view())),
                              say("add 'to', the place at the last position")));
  }
  for (const auto& cylinder : data().cylinders) {
    if (several || !is_set(cylinder.to)) continue;
    issues.push_back(issue_at(input(), path_of("cylinders", cylinder.name, "to"),
                              say("'to' is the end of a stroke, and only one position is solved"),
                              say("add the number of positions, positions = 72, or leave out 'to'")));
  }
}

/// What is wrong with names and points, but for what follows from an error that is there already.
void MechanismStep::add_faults_of_names(std::vector<Issue>& issues) const {
  std::vector<std::string> wrong;
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::error && issue.key.starts_with(name() + "."))
      wrong.push_back(issue.key.substr(name().size() + 1));
  }
  for (const char* list : {"ground", "links", "joints"}) {
    if (std::find(wrong.begin(), wrong.end(), list) != wrong.end()) return;  // any name may be missing
  }
  NameFaults faults(data());
  check_names(faults);
  for (const auto& link : data().links) check_mass_points(link, faults);
  check_accuracy(faults);
  check_balance(faults);
  check_hodographs(faults);
  if (faults.none()) check_shared_points(faults);
  for (const FieldFault& fault : faults.take()) {
    const bool follows = std::any_of(wrong.begin(), wrong.end(), [&](const std::string& path) {
      return (path + ".").starts_with(fault.path + ".") || (fault.path + ".").starts_with(path + ".");
    });
    if (!follows) issues.push_back(issue_at(input(), fault.path, fault.message, fault.hint));
  }
}

Outcome<Signature> MechanismStep::signature(const std::string& path) const {
  if (outputs_.empty()) return Fault{};  // the model has holes, which are told
  const auto found = std::find_if(outputs_.begin(), outputs_.end(), [&](const auto& o) { return o.path == path; });
  if (found != outputs_.end()) return Signature{found->dimension, found->is_single ? nullptr : axis_.get()};
  std::vector<std::string> paths;
  for (const auto& o : outputs_) paths.push_back(o.path);
  return Fault{
      0, path.size(), say("'{1}' has no result '{2}'", name(), path),
      did_you_mean(path, paths, say("`loadpath describe {1}` lists them", input().calculator->id), name() + ".")};
}

std::vector<std::string> MechanismStep::companions_of(const std::string& path) const {
  if (!path.starts_with("drive.M") && !path.starts_with("drive.P")) return {};
  return {name() + ".joints." + std::string(data().crank.joint.view()) + ".F"};
}

/// The field of the project file that a finding is about.
static std::string path_of(const mechanism::Finding& finding, const mechanism::Model& model) {
  using About = mechanism::Finding::About;
  switch (finding.about) {
    case About::model:
      return "";
    case About::link:
      return path_of("links", model.links[finding.index].name);
    case About::joint:
      return path_of("joints", model.joints[finding.index].name);
    case About::driver:
      return model.drivers[finding.index].kind == mechanism::Driver::Kind::rotary
                 ? "crank"
                 : path_of("cylinders", model.drivers[finding.index].name);
    case About::load:
      return "loads";
    case About::spring:
      return path_of("springs", model.springs[finding.index].name);
  }
  return "";
}

/// Places of a series must follow one another, so that what lies between them can be told.
static bool in_order(const planar::Crank& crank) {
  const auto rising = [](const auto& a, const auto& b) { return a.angle >= b.angle; };
  const auto falling = [](const auto& a, const auto& b) { return a.angle <= b.angle; };
  return std::adjacent_find(crank.at.begin(), crank.at.end(), rising) == crank.at.end() ||
         std::adjacent_find(crank.at.begin(), crank.at.end(), falling) == crank.at.end();
}

bool MechanismStep::diagnose_model(const mechanism::Model& model, std::vector<Issue>& issues) {
  if (!in_order(data().crank)) {
    issues.push_back(issue_at(input(), "crank.at", say("the crank angles must rise, or fall, from each to the next")));
    return false;
  }
  auto drawing = check_drawing(data(), model);
  for (FieldFault& fault : check_shares(data())) drawing.push_back(std::move(fault));
  for (FieldFault& fault : check_profiles(data())) drawing.push_back(std::move(fault));
  for (FieldFault& fault : check_laws(data())) drawing.push_back(std::move(fault));
  for (FieldFault& fault : check_rest(data(), model)) drawing.push_back(std::move(fault));
  for (FieldFault& fault : check_mass_lines(data(), model)) drawing.push_back(std::move(fault));
  for (FieldFault& fault : check_reductions(data())) drawing.push_back(std::move(fault));
  for (FieldFault& fault : check_half_widths(data())) drawing.push_back(std::move(fault));
  add_faults(drawing, issues);
  if (!drawing.empty()) return false;
  for (const FieldFault& warning : overshooting_laws(data())) {
    issues.push_back(issue_at(input(), warning.path, warning.message, warning.hint));
    issues.back().severity = Severity::warning;
  }
  const auto findings = mechanism::diagnose(model, structure_);
  std::string said;
  for (const mechanism::Finding& f : findings) {
    if (f.message.text() == said) continue;  // a pin that is there twice holds two freedoms too many
    said = f.message.text();
    issues.push_back(issue_at(input(), path_of(f, model), f.message, f.hint));
  }
  if (!structure_.redundant.empty() && !data().accuracy.empty()) {
    issues.push_back(
        issue_at(input(), "accuracy",
                 say("errors are not covered where joints hold too much: with other dimensions they would "
                     "not close"),
                 say("leave out what repeats the others: {1}", names_of(model.joints, structure_.redundant[0]))));
    return false;
  }
  return findings.empty();
}

void MechanismStep::solve(const project::Known& known, const project::Wanted& wanted, std::vector<Issue>& issues) {
  const std::size_t before = issues.size();
  for (const project::Operand& operand : input().reading.operands) {
    if (const auto value = evaluate_operand(operand, name(), known, issues)) operand.leaf.set(value->si[0]);
  }
  if (issues.size() != before || !expand_template(issues)) return;
  mechanism::Model model = model_of(data());
  if (!input().reading.operands.empty() && !diagnose_model(model, issues)) return;
  add_faults(choose_assembly(data(), structure_, model), issues);
  if (issues.size() != before) return;
  const bool redundant = !structure_.redundant.empty();
  Cycle cycle = solve_cycle(data(), model, redundant, axis_.get());
  outputs_ = mechanism_outputs(data(), model);
  account::Account& account = own_account();
  account.verdicts = proof(name(), data(), model, cycle, axis_.get());
  const mechanism::Model given = model;
  if (redundant) {
    for (auto& v : redundancies(name(), model, structure_)) account.verdicts.push_back(std::move(v));
    hide_what_is_not_unique(cycle);
    model = determinate(model, cycle);
  }
  const Kinematics kinematics = kinematics_of(model, cycle, axis_.get(), !has_law(data()));
  const Errors errors = errors_of(data(), model, cycle);
  const Balanced balanced = balance_of(data(), model, cycle);
  const Solved solved{cycle, kinematics, errors, balanced};
  // What was released of the given model is read from what was solved.
  const auto wants = [&](const std::string& path) { return wanted.holds(name(), path); };
  fill_results(data(), given, outputs_, mechanism_outputs(data(), model), solved, axis_.get(), wants, account);
  for (auto& v : changes_of_assembly(name(), model, cycle, kinematics, axis_.get()))
    account.verdicts.push_back(std::move(v));
  fill_inputs();
  own_account().sources = sources_used(data(), structure_);
  if (wanted.pictures) illustrate(given, model, solved);
}

void MechanismStep::illustrate(const mechanism::Model& given, const mechanism::Model& model, const Solved& solved) {
  account::Account& account = own_account();
  const Cycle& cycle = solved.cycle;
  const Axis* const axis = axis_.get();
  account.input_blocks = model_tables(data());
  if (input().from != nullptr)
    account.input_blocks.insert(account.input_blocks.begin(),
                                template_table(*input().from, input().reading.parameters));
  account.blocks = result_tables(account, model, structure_, cycle, axis);
  for (auto& b : motion_tables(account, model, cycle, solved.kinematics, axis)) account.blocks.push_back(std::move(b));
  const bool statics = data().analysis == Mechanism::Analysis::statics;
  for (auto& b : influence_tables(model, cycle, governing_position(cycle, account), statics))
    account.blocks.emplace_back(std::move(b));
  for (auto& b : error_tables(data(), solved.errors, axis)) account.blocks.emplace_back(std::move(b));
  for (auto& b : balance_tables(data(), solved.balanced)) account.blocks.emplace_back(std::move(b));
  for (auto& note : missing_hodographs(data(), cycle, axis)) account.blocks.emplace_back(std::move(note));
  account.figures = mechanism_figures(data(), given, cycle, account, axis);
}

/// Where the value of an input comes from: typed, from the template (what that has `laid`), a default.
account::Origin MechanismStep::origin_of(const Record* laid, const std::string& path, const Leaf& leaf) const {
  if (laid != nullptr && input().reading.typed.count(path) == 0) {
    if (is_given_in(*laid, path)) return {say("template {1}", input().from->id), {}, false};
    if (path.ends_with(".J") && leaf.get() > 0.0) return {say("slender bar"), {}, false};
  }
  return project::plain_origin(input().reading, path, leaf);
}

void MechanismStep::fill_inputs() {
  account::Account& account = own_account();
  const Record laid = input().from == nullptr ? Record() : laid_out(*input().from);
  const auto origin = [&](const std::string& path, const Leaf& leaf) {
    return origin_of(input().from == nullptr ? nullptr : &laid, path, leaf);
  };
  account.inputs = project::input_entries(input().reading.record, origin);
  if (input().from == nullptr) return;
  const Record& parameters = input().reading.parameters;
  auto entries = project::input_entries(parameters, origin);
  std::move(entries.begin(), entries.end(), std::inserter(account.inputs, account.inputs.begin()));
}

std::unique_ptr<project::Step> make_step(project::StepInput&& input) {
  return std::make_unique<MechanismStep>(std::move(input));
}

}  // namespace loadpath::planar

namespace loadpath {

template <>
const Calculator& erased<planar::Mechanism>() {
  static const Calculator calculator = [] {
    Calculator c;
    c.id = planar::Mechanism::id;
    c.title = planar::Mechanism::title;
    c.scope = planar::Mechanism::scope;
    c.source = planar::Mechanism::source;
    c.used_sources = planar::occasional_sources();
    c.example = planar::Mechanism::example;
    c.input = &record_type<planar::Mechanism::Input, planar::Mechanism::inputs>();
    c.patterns = planar::mechanism_result_patterns();
    c.templates = planar::templates::all();
    return c;
  }();
  return calculator;
}

}  // namespace loadpath
