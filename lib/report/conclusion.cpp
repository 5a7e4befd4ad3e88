#include "lib/report/conclusion.hpp"

#include <algorithm>

#include "lib/formula/formula.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/worked.hpp"

namespace loadpath::report {
namespace {

int severity(State state) {
  switch (state) {
    case State::pass: return 0;
    case State::not_covered: return 1;
    case State::not_available: return 2;
    case State::fail: return 3;
  }
  return 3;
}

std::string name(const Verdict& row) {
  const NamedSymbol named = named_symbol(row.symbol);
  std::string text = row.step;
  if (!named.where.empty()) text += (text.empty() ? "" : ", ") + std::string(named.where);
  return text + (text.empty() ? "" : ", ") + formula::symbol_plain(named.symbol);
}

Message count(const Verdicts& verdicts) {
  const auto& rows = verdicts.rows;
  const State worst = outcome(verdicts);
  const auto such = std::count_if(rows.begin(), rows.end(), [&](const Verdict& row) { return row.state == worst; });
  const std::string all = std::to_string(rows.size()), some = std::to_string(such);
  switch (worst) {
    case State::pass: return rows.size() == 1 ? say("The one check passes.") : say("All {1} checks pass.", all);
    case State::fail: return say("{1} of {2} checks not met.", some, all);
    case State::not_covered: return say("{1} of {2} checks outside of what the method covers.", some, all);
    case State::not_available: return say("{1} of {2} checks without a result.", some, all);
  }
  return {};
}

}  // namespace

Message word(State state) {
  switch (state) {
    case State::pass: return say("pass");
    case State::fail: return say("fail");
    case State::not_covered: return say("not covered");
    case State::not_available: return say("not available");
  }
  return {};
}

State outcome(const Verdicts& verdicts) {
  State worst = State::pass;
  for (const Verdict& row : verdicts.rows) {
    if (severity(row.state) > severity(worst)) worst = row.state;
  }
  return worst;
}

std::vector<Message> reasons(const Verdicts& verdicts) {
  if (verdicts.rows.empty()) return {};
  std::vector<Message> sentences = {count(verdicts)};
  const auto highest = std::max_element(
      verdicts.rows.begin(), verdicts.rows.end(),
      [](const Verdict& a, const Verdict& b) { return a.utilisation.value_or(-1.0) < b.utilisation.value_or(-1.0); });
  if (highest->utilisation) {
    sentences.push_back(
        say("The highest utilisation is {1} ({2}).", format_number(*highest->utilisation, 3), name(*highest)));
  }
  return sentences;
}

std::string Numbering::heading(int level) {
  if (level <= 2) {
    parts_ = 0;
    return std::to_string(++sections_);
  }
  return std::to_string(sections_) + "." + std::to_string(++parts_);
}

}  // namespace loadpath::report
