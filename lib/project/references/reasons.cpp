#include "lib/project/references/reasons.hpp"

#include "lib/project/because.hpp"

#include <cctype>
#include <set>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

/// "F_test" of a message "values.F_test = 50 kN acts on no step": the value that a reason names; empty if it has none.
std::string subject_of(const ReducedLoad& value) {
  constexpr std::string_view of_values = "values.";
  const std::string text = value.message.text();
  if (!text.starts_with(of_values)) return {};
  const std::size_t end = text.find_first_of(" ,:'", of_values.size());
  return text.substr(of_values.size(), end - of_values.size());
}

/// Whether a reason names a value, as a word of its own; a contradiction without a value needs no name.
bool names(const std::string& reason, const std::string& subject) {
  const auto is_of_name = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  if (subject.empty()) return true;
  for (std::size_t at = reason.find(subject); at != std::string::npos; at = reason.find(subject, at + 1)) {
    const std::size_t end = at + subject.size();
    if ((at == 0 || !is_of_name(reason[at - 1])) && (end == reason.size() || !is_of_name(reason[end]))) return true;
  }
  return false;
}

/// How many contradictions of an input its reason does not name. It answers one; of several it names the values of the
/// others.
std::size_t unnamed_for(const Step& step, const std::vector<ReducedLoad>& values, const std::string& path) {
  const Typed* const reason = reason_for(step.input(), path);
  std::set<std::string> unnamed;
  for (const ReducedLoad& value : values) {
    const std::string subject = subject_of(value);
    if (value.path == path && (subject.empty() || !names(reason->text, subject))) unnamed.insert(subject);
  }
  return unnamed.size();
}

}  // namespace

void hold_unless_justified(Step& step, const std::vector<ReducedLoad>& values) {
  for (const ReducedLoad& value : values) {
    const Typed* const reason = reason_for(step.input(), value.path);
    if (reason == nullptr) {
      step.loads().reduced.push_back(value);
      continue;
    }
    step.loads().justified.insert(value.path);
    const std::string subject = subject_of(value);
    if (names(reason->text, subject) || unnamed_for(step, values, value.path) <= 1) continue;
    step.loads().reduced.push_back(
        {value.path,
         say("{1}; the reason given answers another contradiction: name '{2}' in it, too", value.message, subject)});
  }
}

}  // namespace loadpath::project
