// An error in an input: its place, the violated rule, and the remedy.
//
// A Message is an id (the English literal, with arguments {1}, {2}...) and its arguments, never a finished sentence,
// so that other languages can be added without touching the places that speak.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace loadpath {

class Argument;

/// Nearly every source has messages: what they are made of is compiled once, in the source.
struct Message {
  Message();
  Message(std::string_view literal, std::span<Argument> taken);  // which are moved from
  Message(const Message&);
  Message(Message&&) noexcept;
  Message& operator=(const Message&);
  Message& operator=(Message&&) noexcept;
  ~Message();

  std::string_view id;         // a string literal
  std::vector<Argument> args;  // {1} is args[0]

  [[nodiscard]] bool empty() const { return id.empty(); }
  [[nodiscard]] std::string text() const;
};

/// A name or a number; or a message that is a part of another.
class Argument {
 public:
  // NOLINTBEGIN(google-explicit-constructor): what `say` takes
  Argument(std::string part);
  Argument(std::string_view part);
  Argument(const char* part);
  Argument(Message part);
  // NOLINTEND(google-explicit-constructor)
  Argument(const Argument&);
  Argument(Argument&&) noexcept;
  Argument& operator=(const Argument&);
  Argument& operator=(Argument&&) noexcept;
  ~Argument();

  [[nodiscard]] std::string text() const;

 private:
  std::variant<std::string, Message> part_;
};

/// A message from its id and arguments: say("unknown unit '{1}'", unit). Few arguments need no template.
Message say(std::string_view id);
Message say(std::string_view id, Argument first);
Message say(std::string_view id, Argument first, Argument second);
Message say(std::string_view id, Argument first, Argument second, Argument third);
template <class... Args>
Message say(std::string_view id, Argument first, Argument second, Argument third, Args&&... further) {
  Argument all[] = {std::move(first), std::move(second), std::move(third), Argument(std::forward<Args>(further))...};
  return {id, all};
}

/// A range of characters in a file, both counted from 1 in code points; line 0: the file in general.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  int length = 1;
};

/// A fault found by a parser of one string: a byte range of that string, the rule, and the remedy.
struct Fault {
  std::size_t at = 0;
  std::size_t length = 1;
  Message message;
  Message hint;
};

/// A value, or the reason why it is missing.
template <class T>
class Outcome {
 public:
  Outcome(T value) : value_(std::move(value)), ok_(true) {}  // NOLINT(google-explicit-constructor)
  Outcome(Fault fault) : fault_(std::move(fault)) {}         // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return ok_; }
  const T& operator*() const { return value_; }
  T& operator*() { return value_; }
  const T* operator->() const { return &value_; }
  T* operator->() { return &value_; }
  [[nodiscard]] const Fault& fault() const { return fault_; }

 private:
  T value_{};
  Fault fault_;
  bool ok_ = false;
};

/// A fault in values that were read: the path of the field ("joints.A.links"), rule and remedy.
struct FieldFault {
  std::string path;
  Message message;
  Message hint;
};

enum class Severity { error, warning };

/// What is wrong with a key itself. Others look for it: a step with several unknown keys may be that of another
/// calculator.
enum class KeyFault { none, missing, unknown };

struct Issue {
  Place place;
  std::string key;  // the path of the field, "crankshaft.tau_adm"; empty if there is none
  Message message;
  Message hint;
  Severity severity = Severity::error;
  KeyFault key_fault = KeyFault::none;
};

/// Whether one of them is an error, not only a warning.
inline bool has_errors(const std::vector<Issue>& issues) {
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::error) return true;
  }
  return false;
}

/// Issues in the order of their places, as `file:line:column`, the source line, a caret and the hint.
/// `source(file)` gives the text of a file that an issue names, or an empty text.
std::string render(std::vector<Issue> issues, const std::function<std::string(const std::string& file)>& source);

/// The candidate nearest to `word` (Damerau-Levenshtein, ignoring case first), or an empty string where none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);
/// All that are as near as the nearest one, this one first.
std::vector<std::string> all_nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "did you mean '{1}'?" with the nearest candidate after `prefix`; `otherwise` if none is near.
Message did_you_mean(std::string_view word, const std::vector<std::string>& candidates, Message otherwise = {},
                     const std::string& prefix = {});
/// "available: a, b, c"; "none is defined here"
Message there_is(const std::vector<std::string>& candidates);

}  // namespace loadpath
