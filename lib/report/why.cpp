#include "lib/report/why.hpp"

#include "lib/numerics/magnitude.hpp"
#include "lib/report/conclusion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <unordered_map>
#include <unordered_set>

namespace loadpath::report {

namespace {

using account::Account;
using account::Derived;
using account::Entry;

std::string joined(const std::string& scope, const std::string& name) {
  return scope.empty() ? name : scope + "." + name;
}

/// Whether the path is `joined` of the scope and the name.
bool is_path(std::string_view path, std::string_view scope, std::string_view name) {
  if (scope.empty()) return path == name;
  return path.size() == scope.size() + 1 + name.size() && path.starts_with(scope) && path[scope.size()] == '.' &&
         path.ends_with(name);
}

/// The scope outside of a scope: "segments[2]" of "segments[2].left", "" of "segments[2]".
std::string_view outside_of(std::string_view scope) {
  const std::size_t dot = scope.rfind('.');
  return scope.substr(0, dot == std::string_view::npos ? 0 : dot);
}

/// The name after the element: ".key_end" in "safeties.key_end", "[2]" in "segments[2]".
std::string name_within(const std::string& element) {
  const std::size_t at = element.find_first_of("[.");
  return at == std::string::npos ? element : element.substr(at);
}

/// "safeties.key_end" for "safeties.key_end.u_D", empty for a path outside elements.
std::string element_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? std::string() : path.substr(0, dot);
}

/// The entries and derivations of a part that belong to elements of lists.
class Elements {
 public:
  explicit Elements(const Account& account) {
    std::set<std::string> all, written;
    for (const Entry& result : account.results) {
      const std::string element = element_of(result.path);
      if (result.role == Role::check && !element.empty()) judged_.insert(element);
      if (all.insert(element).second) ++more_[list_of(element)];
    }
    for (const Derived& line : account.derivation) {
      if (written.insert(line.scope).second) --more_[list_of(line.scope)];
    }
  }

  [[nodiscard]] bool are_judged(const Derived& line) const {
    return judged_.contains(line.scope) || judged_.contains(line.element);
  }
  /// Whether the calculation has some elements of the list only.
  [[nodiscard]] bool are_chosen(const std::string& element) const {
    const auto found = more_.find(list_of(element));
    return !element.empty() && found != more_.end() && found->second > 0;
  }

 private:
  static std::string list_of(const std::string& element) { return element.substr(0, element.find_first_of("[.")); }

  std::set<std::string> judged_;
  std::map<std::string, int> more_;  // elements of a list than are written out
};

/// Traces names from a line back to the lines and inputs that they come from.
class Tracing {
 public:
  explicit Tracing(const Account& account) : account_(account) {
    for (std::size_t i = account.derivation.size(); i-- > 0;)
      last_first_[account.derivation[i].step.symbol].push_back(i);
  }

  /// Whether a line gives the value at the path.
  bool add(std::string_view path) {
    for (const std::size_t i : lines_of(path.substr(path.rfind('.') + 1))) {
      const Derived& line = account_.derivation[i];
      if (!is_path(path, line.scope, line.step.symbol) && !is_path(path, line.element, line.step.symbol)) continue;
      follow(i);
      return true;
    }
    return false;
  }

  [[nodiscard]] bool has(std::size_t line) const { return lines_.contains(line); }

  [[nodiscard]] Reasons reasons() const {
    Reasons reasons;
    for (const std::size_t i : lines_) reasons.lines.push_back(account_.derivation[i]);
    reasons.inputs = inputs();
    return reasons;
  }
  [[nodiscard]] std::vector<const Entry*> inputs() const {
    std::vector<const Entry*> inputs;
    for (const Entry& entry : account_.inputs) {
      if (inputs_.contains(entry.path)) inputs.push_back(&entry);
    }
    return inputs;
  }

 private:
  void follow(std::size_t i) {
    if (!lines_.insert(i).second) return;
    const Derived& line = account_.derivation[i];
    for (const account::Step::Given& given : line.step.given) {
      if (!follow_line(i, line.scope, given)) add_input(line, given.name);
    }
    if (line.step.formula.empty()) follow_taken(i);
  }

  /// An element takes from others of its own name, or from the part: not from a neighbour with the same number.
  static bool may_take(const Derived& line, const Derived& from) {
    return line.scope.empty() || from.scope.empty() || line.scope == from.scope ||
           name_within(line.element) == name_within(from.element);
  }

  /// A line that takes the value of another over, "sigma_F" of "sigma_F1", or of the governing method.
  void follow_taken(std::size_t i) {
    const account::Step& taken = account_.derivation[i].step;
    for (std::size_t k = i; k-- > 0;) {
      const account::Step& other = account_.derivation[k].step;
      if (std::abs(other.value.si) != std::abs(taken.value.si)) continue;  // most: the rest is slower to compare
      const bool named_so = other.symbol.starts_with(taken.symbol) || taken.symbol.starts_with(other.symbol);
      if (named_so && may_take(account_.derivation[i], account_.derivation[k]) && !other.formula.empty())
        return follow(k);
    }
  }

  /// The last line before that gave the name this value, of the inner scope or else of those outside of it.
  bool follow_line(std::size_t before, std::string_view scope, const account::Step::Given& given) {
    while (true) {
      for (const std::size_t i : lines_of(given.name)) {
        const Derived& line = account_.derivation[i];
        if (i >= before || line.step.value.si != given.si || line.scope != scope) continue;
        follow(i);
        return true;
      }
      if (scope.empty()) return false;
      scope = outside_of(scope);
    }
  }

  void add_input(const Derived& line, const std::string& name) {
    inputs_.insert(name);
    if (!line.scope.empty()) inputs_.insert(joined(line.scope, name));
    if (line.element != line.scope && !line.element.empty()) inputs_.insert(joined(line.element, name));
  }

  /// The lines of a symbol, the last one first.
  [[nodiscard]] std::span<const std::size_t> lines_of(std::string_view symbol) const {
    const auto found = last_first_.find(symbol);
    return found == last_first_.end() ? std::span<const std::size_t>() : found->second;
  }

  const Account& account_;
  std::unordered_map<std::string_view, std::vector<std::size_t>> last_first_;
  std::set<std::size_t> lines_;
  std::unordered_set<std::string> inputs_;
};

}  // namespace

Reasons reasons_of(const Account& account, const std::string& path) {
  Tracing tracing(account);
  tracing.add(path);
  return tracing.reasons();
}

std::vector<const Entry*> deciding_inputs(const Account& account) {
  Tracing tracing(account);
  for (const account::Verdict& row : account.verdicts) tracing.add(row.symbol);
  return tracing.inputs();
}

std::vector<Derived> deciding_lines(const Account& account) {
  const Elements elements(account);
  Tracing tracing(account);
  for (const Entry& result : account.results) {
    const std::string element = element_of(result.path);
    const bool is_check = result.role == Role::check && !elements.are_chosen(element);
    if (element.empty() || is_check) tracing.add(result.path);
  }
  for (const account::Mode& mode : account::in_order(account.modes)) {
    if (elements.are_chosen(element_of(mode.governs)) && tracing.add(mode.governs)) break;
  }
  std::vector<Derived> lines;
  for (std::size_t i = 0; i < account.derivation.size(); ++i) {
    if (!elements.are_judged(account.derivation[i]) || tracing.has(i)) lines.push_back(account.derivation[i]);
  }
  return lines;
}

std::vector<const Entry*> chosen(const Account& account) {
  std::vector<const Entry*> found;
  for (const Entry& entry : account.inputs) {
    if (entry.origin.searched) found.push_back(&entry);
  }
  return found;
}

std::optional<account::Mode> deciding(const account::Modes& modes) {
  const auto badness = [](const account::Mode& m) { return m.state == account::State::open ? -1 : rank(m.state); };
  const auto worst = std::max_element(modes.begin(), modes.end(), [&](const account::Mode& a, const account::Mode& b) {
    if (a.state != b.state) return badness(a) < badness(b);
    return numerics::exceeds(b.utilisation.value_or(-1.0), a.utilisation.value_or(-1.0));
  });
  return worst == modes.end() ? std::nullopt : std::optional(*worst);
}

std::optional<account::Mode> explaining(const account::Modes& modes) {
  const auto worst = deciding(modes);
  if (worst && worst->state == account::State::fail) return worst;
  if (const account::Mode* const most = most_utilised(modes); most != nullptr) return *most;
  const auto is_alone = [](const account::Mode& mode) { return mode.is_limit && mode.utilisation; };
  const auto limit = std::ranges::find_if(modes, is_alone);
  return limit == modes.end() ? std::nullopt : std::optional(*limit);
}

}  // namespace loadpath::report
