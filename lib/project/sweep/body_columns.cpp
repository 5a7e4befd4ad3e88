#include "lib/project/sweep/body_columns.hpp"

#include "lib/project/run/calculator_step.hpp"
#include "lib/project/run/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

bool is_size_found(const SharedSize::Of& one) { return !one.is_given; }

const Entry* entry_of(const std::vector<Entry>& entries, const std::string& path) {
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.path == path; });
  return entry == entries.end() ? nullptr : &*entry;
}

/// Whether an input is not the same at every point: it is varied, computed, given by a row, or found.
bool is_varying_input(const Step& step, const std::string& path, const std::set<std::string>& affected) {
  const auto is_it = [&](const auto& one) { return one.path == path; };
  const Reading& reading = step.input().reading;
  const auto is_of_affected = [&](const Expression::Reference& reference) {
    return affected.contains(split_step(reference.path).first);
  };
  const auto is_computed = [&](const Operand& operand) {
    return is_it(operand) && std::ranges::any_of(operand.expression.references(), is_of_affected);
  };
  if (std::ranges::any_of(reading.varied, is_it) || std::ranges::any_of(reading.operands, is_computed)) return true;
  const auto* const calculator = dynamic_cast<const CalculatorStep*>(&step);
  return calculator == nullptr || !reading.taken.empty() || std::ranges::any_of(calculator->provided(), is_it) ||
         std::ranges::any_of(calculator->searches(), is_it);
}

/// Whether a search of the step has no result: at another point it may have one.
bool has_open_search(const Step& step) {
  const auto* const calculator = dynamic_cast<const CalculatorStep*>(&step);
  return calculator == nullptr || std::ranges::any_of(calculator->searches(), [&](const Search& search) {
           const Entry* const entry = entry_of(step.account().inputs, search.path);
           return entry == nullptr || std::isnan(largest_magnitude(entry->values()));
         });
}

}  // namespace

std::set<std::string> affected_with_bodies(const Project& project, const std::vector<SweptInput>& inputs) {
  std::set<std::string> affected = affected_steps(project, inputs);
  const std::vector<SharedSize> sizes = shared_sizes(project);
  for (std::size_t before = 0; before != affected.size();) {
    before = affected.size();
    for (const SharedSize& size : sizes) {
      const bool is_sought_again = std::ranges::any_of(size.of, [&](const SharedSize::Of& one) {
        return is_size_found(one) && affected.contains(one.step->name());
      });
      for (const SharedSize::Of& one : size.of) {
        if (is_sought_again && is_size_found(one)) affected.insert(one.step->name());
      }
    }
    add_takers(project, affected);
  }
  return affected;
}

const std::vector<Step*>* body_with(const Step& step, const Bodies& bodies) {
  const auto has_it = [&](const auto& body) { return std::ranges::find(body, &step) != body.end(); };
  const auto found = std::ranges::find_if(bodies, has_it);
  return found == bodies.end() ? nullptr : &*found;
}

Bodies separable_bodies(const Project& project, const std::set<std::string>& affected) {
  Bodies bodies;
  for (const auto& [name, members] : bodies_of(project)) {
    const auto is_affected = [&](const Step* step) { return affected.contains(step->name()); };
    if (std::ranges::none_of(members, is_affected)) continue;
    std::set<std::string> takers;
    for (const Step* const step : members) takers.insert(step->name());
    add_takers(project, takers);
    std::vector<Step*>& ordered = bodies.emplace_back();
    bool has_taker = false;
    for (const std::size_t i : project.order) {
      Step* const step = project.steps[i].get();
      const bool is_member = std::ranges::find(members, step) != members.end();
      if (is_member && has_taker) return {};
      if (is_member) ordered.push_back(step);
      has_taker = has_taker || (!is_member && takers.contains(step->name()));
    }
  }
  return bodies;
}

bool BodyColumns::lay_out(const Project& project, const std::set<std::string>& affected) {
  *this = {};
  for (const auto& [body, members] : bodies_of(project)) {
    for (Step* const step : members) {
      if (affected.contains(step->name()) && has_open_search(*step)) return false;
      kept_.push_back({step, step->body_sizes(), step->body_facts()});
    }
  }
  affected_ = &affected;
  const bool is_possible = add_sizes(project) && add_facts(project) && is_sound_;
  affected_ = nullptr;
  return is_possible;
}

/// Nothing if it is the same at every point. Values that the columns have under another meaning are not compared.
std::optional<BodyColumns::Number> BodyColumns::number(const Project& project, const Step& step, const std::string& key,
                                                       bool is_result) {
  if (!affected_->contains(step.name()) || (!is_result && !is_varying_input(step, key, *affected_)))
    return std::nullopt;
  const Entry* const entry = entry_of(is_result ? step.account().results : step.account().inputs, key);
  std::string path = step.name() + "." + key;
  const Value* const value = project.value(path);
  if (entry == nullptr || value == nullptr || value->si != entry->values().si) {
    is_sound_ = false;
    return std::nullopt;
  }
  paths_.insert(path);
  members_.insert(step.name());
  return Number{std::move(path), {value->signature, {}}};
}

/// A size that some steps give and others look for is one of a single design.
bool BodyColumns::add_sizes(const Project& project) {
  for (const SharedSize& shared : shared_sizes(project)) {
    std::vector<Size> all;
    for (const SharedSize::Of& one : shared.of)
      all.push_back({one.step, shared.key, number(project, *one.step, shared.key, false), one.si, !one.is_given});
    const auto varies = [](const Size& size) { return size.number.has_value(); };
    if (std::ranges::none_of(all, varies)) continue;
    const auto found = std::ranges::count_if(all, [](const Size& size) { return size.is_found; });
    if (found != 0 && found != std::ssize(all)) return false;
    sizes_.push_back(std::move(all));
  }
  return true;
}

std::optional<BodyColumns::Fact> BodyColumns::fact_of(const Project& project, const std::string& name,
                                                      const Statement& stated) {
  const Step& step = *stated.step;
  Fact fact{{}, {}, {}, 1.0};
  if (stated.input != nullptr && stated.input->type != FieldInfo::Type::choice)
    fact.input = number(project, step, stated.input->key, false);
  if (step.input().calculator->result == nullptr) return fact;
  for (const FieldInfo& field : step.input().calculator->result->fields) {  // one without a value here may get one
    const auto names = listed_keys(field.shared_as);
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    if (&field != stated.result) return std::nullopt;
    fact.result = number(project, step, field.key, true);
    break;
  }
  if (stated.result == nullptr && stated.input != nullptr && stated.input->is_load) {
    fact.factor = number(project, step, "K_A", false);
    if (stated.value != 0.0) fact.same_factor = stated.measure / std::abs(stated.value);
  }
  return fact;
}

/// False if steps contradict one another at this point already: that holds back modes here, and elsewhere perhaps not.
bool BodyColumns::add_facts(const Project& project) {
  for (BodyStatements& stated : statements_of_bodies(project)) {
    Compared compared;
    bool varies = false;
    for (const Statement& one : stated.all) {
      auto fact = fact_of(project, stated.name, one);
      if (!fact) return false;
      varies = varies || fact->input || fact->result || fact->factor;
      compared.facts.push_back(std::move(*fact));
    }
    if (!varies) continue;
    if (!agree(stated)) return false;
    compared.stated = std::move(stated);
    compared_.push_back(std::move(compared));
  }
  return true;
}

bool BodyColumns::take(const Step& step, PointStep* kernel) {
  if (!members_.contains(step.name())) return true;
  auto* const columns = dynamic_cast<ColumnStep*>(kernel);
  if (columns == nullptr) return false;
  for (std::vector<Size>& all : sizes_) {
    for (Size& size : all) {
      if (size.step != &step || !size.is_found) continue;
      if (!columns->seeks(size.key)) return false;
      size.kernel = columns;
    }
  }
  return true;
}

void BodyColumns::start() {
  for (const Kept& kept : kept_) {  // a single design may have left others
    kept.step->forget_body();
    for (const auto& [path, size] : kept.sizes) kept.step->set_body_size(path, size);
    if (kept.facts) kept.step->set_body_facts(*kept.facts);
  }
  for (std::vector<Size>& all : sizes_) {
    for (Size& size : all) {
      size.least.clear();
      if (size.kernel != nullptr) size.kernel->keep_to({});
    }
  }
}

double BodyColumns::read(std::optional<Number>& number, double same, std::size_t point, PointColumns& points) {
  if (!number) return same;
  points.read(number->path, point, number->value);
  return largest_magnitude(number->value);
}

bool BodyColumns::require_sizes(PointColumns& points) {
  bool changed = false;
  for (std::vector<Size>& all : sizes_) {
    if (!all.front().is_found) continue;
    for (std::size_t point = 0; point < points.count; ++point) {
      if (points.is_other[point] != 0) continue;
      double whole = 0.0;
      for (Size& size : all) whole = std::max(whole, size.si = read(size.number, size.si, point, points));
      for (Size& size : all) {
        if (is_one_size(size.si, whole) || size.kernel == nullptr) continue;
        size.least.resize(points.count, 0.0);
        size.least[point] = whole;
        changed = true;
      }
    }
    for (Size& size : all) {
      if (size.kernel != nullptr) size.kernel->keep_to(size.least);
    }
  }
  return changed;
}

bool BodyColumns::is_one_body(std::size_t point, PointColumns& points) {
  for (std::vector<Size>& all : sizes_) {
    for (Size& size : all) size.si = read(size.number, size.si, point, points);
    for (const Size& size : all) {
      if (!is_one_size(size.si, all.front().si)) return false;
    }
  }
  for (Compared& compared : compared_) {
    for (std::size_t i = 0; i < compared.facts.size(); ++i) {
      Fact& fact = compared.facts[i];
      Statement& one = compared.stated.all[i];
      one.value = read(fact.input, one.value, point, points);
      if (one.result != nullptr)
        one.measure = std::abs(read(fact.result, one.measure, point, points));
      else
        one.measure = std::abs(one.value) * read(fact.factor, fact.same_factor, point, points);
      if (std::isnan(one.measure)) return false;
    }
    if (!agree(compared.stated)) return false;
  }
  return true;
}

void BodyColumns::leave_contradicting(PointColumns& points) {
  if (sizes_.empty() && compared_.empty()) return;
  for (std::size_t point = 0; point < points.count; ++point) {
    if (points.is_other[point] == 0 && !is_one_body(point, points)) points.is_other[point] = 1;
  }
}

}  // namespace loadpath::project
