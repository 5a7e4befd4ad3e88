#include "lib/report/why.hpp"

#include "lib/report/conclusion.hpp"

#include <algorithm>
#include <set>

namespace loadpath::report {

namespace {

using account::Account;
using account::Derived;
using account::Entry;

std::string joined(const std::string& scope, const std::string& name) {
  return scope.empty() ? name : scope + "." + name;
}

/// The scopes that a name can be of, from the inner one outwards: "segments[2]", "".
std::vector<std::string> scopes_from(std::string scope) {
  std::vector<std::string> scopes{scope};
  while (!scope.empty()) {
    const std::size_t dot = scope.rfind('.');
    scope.resize(dot == std::string::npos ? 0 : dot);
    scopes.push_back(scope);
  }
  return scopes;
}

/// ".key_end" of "safeties.key_end", "[2]" of "segments[2]".
std::string name_within(const std::string& element) {
  const std::size_t at = element.find_first_of("[.");
  return at == std::string::npos ? element : element.substr(at);
}

/// Follows names from a line back to the lines and inputs that they come from.
class Tracing {
 public:
  explicit Tracing(const Account& account) : account_(account) {}

  void add(const std::string& path) {
    for (std::size_t i = account_.derivation.size(); i-- > 0;) {
      const Derived& line = account_.derivation[i];
      if (joined(line.scope, line.step.symbol) == path || joined(line.element, line.step.symbol) == path)
        return follow(i);
    }
  }

  [[nodiscard]] bool has(std::size_t line) const { return lines_.contains(line); }

  [[nodiscard]] Reasons reasons() const {
    Reasons reasons;
    for (const std::size_t i : lines_) reasons.lines.push_back(account_.derivation[i]);
    for (const Entry& entry : account_.inputs) {
      if (inputs_.contains(entry.path)) reasons.inputs.push_back(&entry);
    }
    return reasons;
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

  /// An element takes from others of its own name, or from the whole: not from a neighbour with the same number.
  static bool may_take(const Derived& line, const Derived& from) {
    return line.scope.empty() || from.scope.empty() || line.scope == from.scope ||
           name_within(line.element) == name_within(from.element);
  }

  /// A line that takes the value of another over, "sigma_F" of "sigma_F1", or of the method that decides.
  void follow_taken(std::size_t i) {
    const account::Step& taken = account_.derivation[i].step;
    for (std::size_t k = i; k-- > 0;) {
      const account::Step& other = account_.derivation[k].step;
      const bool named_so = other.symbol.starts_with(taken.symbol) || taken.symbol.starts_with(other.symbol);
      if (named_so && may_take(account_.derivation[i], account_.derivation[k]) && !other.formula.empty() &&
          other.value.si == taken.value.si)
        return follow(k);
    }
  }

  /// The last line before that gave the name this value.
  bool follow_line(std::size_t before, const std::string& from, const account::Step::Given& given) {
    for (const std::string& scope : scopes_from(from)) {
      for (std::size_t i = before; i-- > 0;) {
        const Derived& line = account_.derivation[i];
        if (line.scope != scope || line.step.symbol != given.name || line.step.value.si != given.si) continue;
        follow(i);
        return true;
      }
    }
    return false;
  }

  void add_input(const Derived& line, const std::string& name) {
    for (const std::string& scope : {line.scope, line.element, std::string()}) inputs_.insert(joined(scope, name));
  }

  const Account& account_;
  std::set<std::size_t> lines_;
  std::set<std::string> inputs_;
};

}  // namespace

Reasons reasons_of(const Account& account, const std::string& path) {
  Tracing tracing(account);
  tracing.add(path);
  return tracing.reasons();
}

std::vector<Derived> deciding_lines(const Account& account) {
  Tracing tracing(account);
  std::set<std::string> judged;  // elements
  for (const Entry& result : account.results) {
    const std::size_t dot = result.path.rfind('.');
    if (result.role == Role::check && dot != std::string::npos) judged.insert(result.path.substr(0, dot));
    if (result.role == Role::check || dot == std::string::npos) tracing.add(result.path);
  }
  std::vector<Derived> lines;
  for (std::size_t i = 0; i < account.derivation.size(); ++i) {
    const Derived& line = account.derivation[i];
    const bool of_judged = judged.contains(line.scope) || judged.contains(line.element);
    if (!of_judged || tracing.has(i)) lines.push_back(line);
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
    return a.utilisation.value_or(-1.0) < b.utilisation.value_or(-1.0);
  });
  return worst == modes.end() ? std::nullopt : std::optional(*worst);
}

std::optional<account::Mode> telling(const account::Modes& modes) {
  const auto worst = deciding(modes);
  if (worst && worst->state == account::State::fail) return worst;
  const account::Mode* const most = most_utilised(modes);
  return most == nullptr ? std::nullopt : std::optional(*most);
}

}  // namespace loadpath::report
