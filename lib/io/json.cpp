#include "lib/io/json.hpp"

#include "lib/io/json_text.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/unit.hpp"
#include "lib/report/build.hpp"

#include <boost/json.hpp>

#include <algorithm>
#include <cmath>

namespace loadpath::io {

namespace {

namespace json = boost::json;
using project::Entry;

constexpr int schema_version = 1;

/// A state by its word in English, whatever the language of the report.
std::string word_of(report::State state) { return std::string(report::word(state).id); }

json::value number(double x) { return std::isfinite(x) ? json::value(x) : json::value(nullptr); }

json::array numbers(const std::vector<double>& list) {
  json::array array;
  array.reserve(list.size());
  for (const double x : list) array.push_back(number(x));
  return array;
}

/// The SI unit by its name where it has one: Pa, not kg/(m*s^2).
std::string unit_of(const Dimension& dimension) {
  for (const char* unit : {"N", "Pa", "N*m", "W", "N/m"}) {
    if (const auto parsed = parse_unit(unit); parsed && parsed->dimension == dimension) return unit;
  }
  return si_unit(dimension);
}

/// A value and what goes with it; a value that does not exist has its reason.
json::object valued(double si, json::object object, const Message& missing = {}) {
  object["value"] = number(si);
  if (std::isinf(si)) object["reason"] = "infinite";
  if (std::isnan(si)) object["reason"] = missing.empty() ? "not available" : missing.text();
  return object;
}

json::value entry(const Entry& e) {
  json::object object;
  if (!e.word.empty()) {
    object["value"] = e.word;
  } else if (e.value.is_series()) {
    json::array values = numbers(e.value.si);
    const bool complete = std::all_of(e.value.si.begin(), e.value.si.end(), [](double x) { return std::isfinite(x); });
    object = {{"unit", unit_of(e.value.signature.dimension)},
              {"axis", e.value.signature.axis->name()},
              {"values", std::move(values)}};
    if (!complete) object["reason"] = e.missing.empty() ? "not available where null" : e.missing.text();
  } else {
    object =
        valued(e.value.si.empty() ? NAN : e.value.si[0], {{"unit", unit_of(e.value.signature.dimension)}}, e.missing);
  }
  object["meaning"] = e.doc;
  if (!e.origin.text.empty()) object["from"] = e.origin.text.text();
  if (e.origin.recalled) object["recalled"] = true;
  return object;
}

json::object entries(const std::vector<Entry>& list) {
  json::object object;
  for (const Entry& e : list) object[e.path] = entry(e);
  return object;
}

json::array verdicts(const std::vector<report::Verdict>& list) {
  json::array array;
  for (const report::Verdict& v : list) {
    json::object object{{"step", v.step}, {"name", v.symbol}, {"meaning", v.meaning.text()}};
    const auto* value = std::get_if<report::Quantity>(&v.value);
    object["value"] = value == nullptr ? json::value(nullptr) : number(value->si);
    object["limit"] = v.bound.text();
    object["verdict"] = word_of(v.state);
    const bool known = !object["value"].is_null();
    if (!v.note.empty() || !known) object["reason"] = v.note.empty() ? word_of(v.state) : v.note.text();
    array.push_back(std::move(object));
  }
  return array;
}

json::array derivation(const std::vector<project::Derived>& lines) {
  json::array array;
  for (const auto& [scope, step] : lines) {
    json::object given;
    for (const auto& g : step.given) given[g.name] = valued(g.si, {{"shown_in", g.unit}});
    array.push_back(valued(step.value.si, {{"scope", scope},
                                           {"symbol", step.symbol},
                                           {"formula", step.formula},
                                           {"given", std::move(given)},
                                           {"shown_in", step.value.unit},
                                           {"why", step.why.text()}}));
  }
  return array;
}

/// The axes that the series of a step are given at, by name.
json::object axes(const project::Account& account) {
  json::object object;
  for (const Entry& e : account.results) {
    const Axis* axis = e.value.signature.axis;
    if (axis == nullptr || object.contains(axis->name())) continue;
    object[axis->name()] = json::object{{"shown_in", axis->unit}, {"period", axis->period}, {"at", numbers(axis->at)}};
  }
  return object;
}

json::object step_object(const project::Step& step) {
  const project::Account& account = step.account();
  json::object object{
      {"name", step.name()}, {"calculator", step.input().calculator->id}, {"title", step.input().title}};
  object["inputs"] = entries(account.inputs);
  if (json::object found = axes(account); !found.empty()) object["axes"] = std::move(found);
  object["results"] = entries(account.results);
  object["checks"] = verdicts(account.verdicts);
  if (!account.governing.empty()) object["derivation_for"] = account.governing.text();
  if (!account.derivation.empty()) object["derivation"] = derivation(account.derivation);
  return object;
}

}  // namespace

std::string json_of(const project::Project& project, std::string_view program) {
  json::object meta{{"file", project.file}, {"title", project.title}};
  for (const auto& [key, value] : project.meta) meta[key] = value;
  json::array steps;
  for (const auto& step : project.steps) steps.push_back(step_object(*step));
  return text_of(json::object{{"schema", schema_version},
                              {"program", program},
                              {"project", std::move(meta)},
                              {"verdict", word_of(report::worst(project::verdicts(project)))},
                              {"steps", std::move(steps)}});
}

std::string json_of(const std::vector<Issue>& issues) {
  json::array array;
  for (const Issue& i : issues) {
    array.push_back(json::object{{"file", i.place.file},
                                 {"line", i.place.line},
                                 {"column", i.place.column},
                                 {"key", i.key},
                                 {"severity", i.severity == Severity::error ? "error" : "warning"},
                                 {"message", i.message.text()},
                                 {"help", i.hint.text()}});
  }
  return text_of(json::object{{"schema", schema_version}, {"issues", std::move(array)}});
}

}  // namespace loadpath::io
