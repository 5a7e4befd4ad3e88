#include "calculators/mechanism/step.hpp"

#include "calculators/mechanism/aspects.hpp"
#include "calculators/mechanism/aspects/assemblies.hpp"
#include "calculators/mechanism/completion/courses.hpp"
#include "calculators/mechanism/completion/cylinders.hpp"
#include "calculators/mechanism/completion/masses.hpp"
#include "calculators/mechanism/cycle/idle.hpp"
#include "calculators/mechanism/cycle/redundant.hpp"
#include "calculators/mechanism/expansion.hpp"
#include "calculators/mechanism/input/checks.hpp"
#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/loads.hpp"
#include "calculators/mechanism/input/model.hpp"
#include "calculators/mechanism/input/profiles.hpp"
#include "calculators/mechanism/results/modes.hpp"
#include "calculators/mechanism/results/values.hpp"
#include "calculators/mechanism/templates/template.hpp"
#include "lib/calculator/calculator.hpp"
#include "lib/calculator/record_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace loadpath::planar {

/// Whether the value of an expression depends on another step.
static bool is_pending(const project::Operand& operand) { return std::isnan(operand.early); }

void MechanismStep::prepare(const project::Declared& declared, const project::Companions&, std::vector<Issue>& issues) {
  const auto is_own = [&](const Issue& issue) {
    return issue.severity == Severity::error && (issue.key + ".").starts_with(name() + ".");
  };
  check_operands(input().reading, name(), false, declared, issues);
  for (const project::Taken& taken : input().reading.taken) {
    issues.push_back({taken.place, name() + "." + taken.path,
                      say("give '{1}' of a mechanism as a value: its parts depend on it", taken.path),
                      say("share values of several steps in [values]: \"=values.{1}\"", taken.path), Severity::error});
  }
  if (input().from != nullptr) add_faults(check_overrides(*input().from, input().reading), issues);
  add_faults(faults_whatever_comes(issues), issues);
  const auto typed = [this](const std::string& path) { return is_typed(path); };
  if (std::none_of(issues.begin(), issues.end(), is_own)) add_faults(name_mass_centres(data(), typed), issues);
  const bool known = is_known();
  if (known && !std::any_of(issues.begin(), issues.end(), is_own)) expand_template(true, issues);
  if (std::any_of(issues.begin(), issues.end(), is_own)) return;  // the model has holes: nothing more can be said of it
  complete();
  mechanism::Model model = model_of(in_);
  outputs_ = outputs_of(in_, model);
  const std::string axis = axis_name(in_);
  if (!axis.empty()) {
    const double period = is_whole_turn(in_) ? 2.0 * pi : 0.0;  // its sense is known when the cycle is solved
    const char* const unit = axis == "time" ? "s" : axis == "stroke" ? "mm" : "deg";
    axis_ = std::make_unique<Axis>(Axis{name(), axis, unit, {}, {}, period});
  }
  if (known && diagnose_model(model, issues)) add_faults(choose_assembly(in_, structure_, model), issues);
}

bool MechanismStep::is_known() const {
  const auto& operands = input().reading.operands;
  return input().reading.varied.empty() && std::none_of(operands.begin(), operands.end(), is_pending);
}

/// Objects behind names must see that a value is given; its number is known when the project is solved. A fault is
/// reported early only if it is one for all values: small or large, rising or falling, zero.
std::vector<FieldFault> MechanismStep::faults_whatever_comes(const std::vector<Issue>& issues) {
  for (const project::Operand& operand : input().reading.operands)
    if (!is_pending(operand)) operand.leaf.set(operand.early);
  std::vector<const project::Operand*> pending;
  for (const project::Operand& operand : input().reading.operands)
    if (is_pending(operand)) pending.push_back(&operand);
  const auto put = [&](const auto& in_unit) {
    for (std::size_t k = 0; k < pending.size(); ++k) {
      const FieldInfo& field = *pending[k]->leaf.field;
      const double value = in_unit(static_cast<double>(k)) * field.factor;
      if (field.bounds.holds(value)) pending[k]->leaf.set(value);
    }
  };
  put([](double) { return 2.0; });
  std::vector<FieldFault> faults = faults_of_values(issues);
  if (pending.empty()) return faults;
  const auto keep_those_of = [&](const std::vector<FieldFault>& others) {
    std::erase_if(faults, [&](const FieldFault& fault) {
      return std::none_of(others.begin(), others.end(), [&](const FieldFault& other) {
        return other.path == fault.path && other.message.id == fault.message.id;
      });
    });
  };
  const auto count = static_cast<double>(pending.size());
  put([](double k) { return 3.0 + k; });
  keep_those_of(faults_of_values(issues));
  put([&](double k) { return 3.0 + count - k; });
  keep_those_of(faults_of_values(issues));
  put([](double) { return 0.0; });
  keep_those_of(faults_of_values(issues));
  put([](double) { return 1e6; });
  keep_those_of(faults_of_values(issues));
  put([](double) { return 2.0; });
  return faults;
}

/// Faults of names and drives, with the values as they are.
std::vector<FieldFault> MechanismStep::faults_of_values(const std::vector<Issue>& issues) const {
  std::vector<FieldFault> faults = faults_of_names(issues);
  append(idle_fields(data(), [this](const std::string& path) { return is_typed(path); }), faults);
  return faults;
}

void MechanismStep::add_faults(const std::vector<FieldFault>& faults, std::vector<Issue>& issues) const {
  for (const FieldFault& fault : faults) issues.push_back(issue_at(input(), fault.path, fault.message, fault.hint));
}

/// A step may be solved again, with other values: what the template and the bars made of the last ones is taken back.
void MechanismStep::restore() {
  const Record& record = input().reading.record;
  if (as_read_.type == nullptr) {
    as_read_ = record.clone();
    return;
  }
  std::vector<double> values;
  for (const project::Varied& varied : input().reading.varied) values.push_back(varied.leaf.get());
  record.type->copy(as_read_.data.get(), record.data.get());
  for (std::size_t i = 0; i < values.size(); ++i) input().reading.varied[i].leaf.set(values[i]);
}

void MechanismStep::complete() {
  set_bar_inertia(data(), [this](const std::string& path) { return is_typed(path); });
  in_ = with_cylinders(with_mass_centres(data()));
}

bool MechanismStep::expand_template(bool in_words, std::vector<Issue>& issues) {
  if (input().from == nullptr) return true;
  const auto faults = expand(*input().from, input().reading, data(), in_words);
  add_faults(faults, issues);
  return faults.empty();
}

/// Faults of names and points, except those that follow from an error already present.
std::vector<FieldFault> MechanismStep::faults_of_names(const std::vector<Issue>& issues) const {
  std::vector<std::string> wrong;
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::error && issue.key.starts_with(name() + "."))
      wrong.push_back(issue.key.substr(name().size() + 1));
  }
  for (const char* list : {"ground", "links", "joints"}) {
    if (std::find(wrong.begin(), wrong.end(), list) != wrong.end()) return {};  // any name may be missing
  }
  // The middle of a bar is not a point of it before the mechanism is completed.
  const Mechanism::Input as_typed =
      without_named_centres(data(), [this](const std::string& path) { return is_typed(path); });
  NameFaults faults(as_typed);
  check_names(faults);
  ask_all(&Aspect::check_names, faults);
  if (faults.none()) check_shared_points(faults);
  std::vector<FieldFault> found = faults.take();
  std::erase_if(found, [&](const FieldFault& fault) {
    return std::any_of(wrong.begin(), wrong.end(), [&](const std::string& path) {
      return (path + ".").starts_with(fault.path + ".") || (fault.path + ".").starts_with(path + ".");
    });
  });
  return found;
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

/// Places of a series must follow one another, so that the motion between them is defined.
static bool in_order(const planar::Crank& crank) {
  const auto rising = [](const auto& a, const auto& b) { return a.angle >= b.angle; };
  const auto falling = [](const auto& a, const auto& b) { return a.angle <= b.angle; };
  return std::adjacent_find(crank.at.begin(), crank.at.end(), rising) == crank.at.end() ||
         std::adjacent_find(crank.at.begin(), crank.at.end(), falling) == crank.at.end();
}

/// False where values contradict each other: nothing more can be said of the model.
bool MechanismStep::check_values(const mechanism::Model& model, std::vector<Issue>& issues) const {
  auto faults = check_drawing(in_, model);
  append(check_bars(data()), faults);
  for (const auto check : {&check_gravity, &check_shares, &check_courses, &check_profiles, &check_laws})
    append(check(in_), faults);
  ask_all(&Aspect::check_values, in_, model, faults);
  add_faults(faults, issues);
  return faults.empty();
}

bool MechanismStep::diagnose_model(const mechanism::Model& model, std::vector<Issue>& issues) {
  if (!in_order(in_.crank)) {
    issues.push_back(issue_at(input(), "crank.at", say("the crank angles must rise, or fall, from each to the next")));
    return false;
  }
  if (!check_values(model, issues)) return false;
  for (const FieldFault& warning : overshooting_laws(in_)) {
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
  std::vector<FieldFault> uncovered;
  ask_all(&Aspect::check_structure, in_, model, structure_, uncovered);
  add_faults(uncovered, issues);
  return findings.empty() && uncovered.empty();
}

/// The loads move the mechanism wherever it is, or nowhere.
static Message no_equilibrium(const Equilibria& sought, const Axis& axis) {
  if (sought.everywhere)
    return say(
        "nothing moves the mechanism: it is in equilibrium at every position; give its loads, weights or springs");
  if (std::isnan(sought.least)) return say("the mechanism closes at no position where it could be in equilibrium");
  return say(
      "no position of equilibrium: it needs at least {1} of its drive, at {2}; give other loads or springs, or "
      "a wider range",
      format_quantity(std::abs(sought.least), axis.unit == "deg" ? "N*m" : "N", 4),
      format_quantity(sought.least_at, axis.unit, 4));
}

void MechanismStep::solve(const project::Known& known, const project::Wanted& wanted, std::vector<Issue>& issues) {
  const std::size_t before = issues.size();
  restore();
  for (const project::Operand& operand : input().reading.operands) {
    if (const auto value = evaluate_operand(operand, name(), known, issues)) operand.leaf.set(value->si[0]);
  }
  if (has_errors({issues.begin() + static_cast<std::ptrdiff_t>(before), issues.end()})) return;
  if (!is_known()) {
    const auto faults = faults_of_values({});
    add_faults(faults, issues);
    if (!faults.empty()) return;
  }
  if (!expand_template(wanted.words, issues)) return;
  complete();
  mechanism::Model model = model_of(in_);
  if (solve_ordinary(model, wanted)) return;
  if (!is_known() && !diagnose_model(model, issues)) return;
  add_faults(choose_assembly(in_, structure_, model), issues);
  if (has_errors({issues.begin() + static_cast<std::ptrdiff_t>(before), issues.end()})) return;
  const bool redundant = !structure_.redundant.empty();
  set_axis_speed();
  const Cycle proved = solve_cycle(in_, model, redundant, axis_.get());
  if (proved.positions.empty()) {
    issues.push_back(issue_at(input(), "analysis", no_equilibrium(proved.equilibria, *axis_)));
    return;
  }
  const mechanism::Model released = redundant ? determinate(model, proved) : mechanism::Model();
  const Cycle shown = redundant ? without_what_is_not_unique(proved) : Cycle();
  const mechanism::Model& free = redundant ? released : model;
  const Cycle& cycle = redundant ? shown : proved;
  const Kinematics kinematics = kinematics_of(free, cycle, axis_.get(), !has_law(in_));
  Solved solved{name(), in_, structure_, model, free, proved, cycle, kinematics, axis_.get()};
  solved.in_words = wanted.words;
  ask_all(&Aspect::find, solved, solved.found);
  write_account(solved, wanted);
  if (wanted.words || stays_in_equilibrium(in_)) return ordinary_.reset();
  ordinary_ = Ordinary::of(solved, account(), asked(wanted));
  ordinary_for_ = wanted;
}

/// A step may be solved again: a crank that gains speed has not the constant one of the point before.
void MechanismStep::set_axis_speed() {
  if (axis_ == nullptr || axis_->quantity != "crank angle") return;
  axis_->speed = in_si(in_.crank.acceleration) == 0.0 ? std::abs(in_si(in_.crank.speed)) : 0.0;
}

bool MechanismStep::solve_ordinary(const mechanism::Model& model, const project::Wanted& wanted) {
  const bool is_same = wanted.taken == ordinary_for_.taken && wanted.compared == ordinary_for_.compared;
  if (wanted.words || ordinary_ == nullptr || !is_same) return false;
  set_axis_speed();
  std::vector<Issue> found;
  return in_order(in_.crank) && check_values(model, found) && ordinary_->solve(in_, model, *axis_, own_account());
}

/// Its own paths that expressions refer to, and those of values to compare with that it has.
std::set<std::string> MechanismStep::asked(const project::Wanted& wanted) const {
  std::set<std::string> paths;
  const auto add = [&](const std::set<std::string>& all, bool known_only) {
    for (const std::string& path : all) {
      if (!path.starts_with(name() + ".")) continue;
      std::string own = path.substr(name().size() + 1);
      if (!known_only || signature(own)) paths.insert(std::move(own));
    }
  };
  add(wanted.taken, false);
  add(wanted.compared, true);
  return paths;
}

void MechanismStep::write_account(const Solved& solved, const project::Wanted& wanted) {
  account::Account& account = own_account();
  account = {};
  ask_all(&Aspect::judge, solved, account.verdicts);
  outputs_ = outputs_of(in_, solved.given);
  const auto wants = [&](const std::string& path) { return wanted.holds(name(), path); };
  // Released parts of the given model are read from the solved one.
  fill_results(outputs_, outputs_of(in_, solved.model), solved, magnitudes_of(solved.given, solved.cycle), wants,
               account);
  fill_inputs();
  account.modes = modes_of(*this, in_, wanted);
  account.sources = sources_used(in_, structure_);
  if (leaves_out_weights(in_) && !is_typed("gravity"))
    warn(say("gravity not given: own weights of the links are not included"));
  if (wanted.pictures) illustrate(solved);
}

void MechanismStep::illustrate(const Solved& solved) {
  account::Account& account = own_account();
  if (input().from != nullptr)
    account.input_blocks.emplace_back(template_table(*input().from, input().reading.parameters));
  const Results results(outputs_, account.results);
  ask_all(&Aspect::show_input, in_, account.input_blocks);
  ask_all(&Aspect::show, solved, results, account.blocks);
  ask_all(&Aspect::draw, solved, results, account.figures);
}

/// Where the value of an input comes from: typed, from the template (what that has `laid`), a default.
account::Origin MechanismStep::origin_of(const Record* laid, const std::string& path, const Leaf& leaf) const {
  if (!is_typed(path)) {
    if (laid != nullptr && is_given_in(*laid, path)) return {say("template {1}", input().from->id), {}, false};
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
    c.synonyms = planar::Mechanism::synonyms;
    c.source = planar::Mechanism::source;
    c.used_sources = &planar::occasional_sources;
    c.example = planar::Mechanism::example;
    c.headline = planar::Mechanism::headline;
    c.input = &record_type<planar::Mechanism::Input, planar::Mechanism::inputs>;
    c.patterns = &planar::result_patterns;
    c.templates = planar::templates::all();
    c.modes = mode_infos<planar::Mechanism>;
    c.applies = &applies_of<planar::Mechanism>;
    c.turns = true;
    return c;
  }();
  return calculator;
}

}  // namespace loadpath
