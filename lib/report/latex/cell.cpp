#include "lib/account/conclusion.hpp"
#include "lib/formula/formula.hpp"
#include "lib/report/latex/tex.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/latex.hpp"

namespace loadpath::report::tex {
namespace {

struct CellText {
  std::string operator()(const std::string& text) const { return latex_text(text); }
  std::string operator()(const Message& message) const { return latex_text(message.text()); }
  std::string operator()(const Quantity& q) const { return latex_text(formula::quantity_plain(written(q))); }
  std::string operator()(const Symbol& s) const { return symbol(s.name); }
  std::string operator()(State s) const { return state(s); }
  std::string operator()(const Utilisation& u) const { return latex_text(utilisation_text(u.value)); }
  std::string operator()(const Sized& s) const {
    return "\\textbf{" + latex_text(s.text) + "}*" + latex_text(s.behind());
  }
};

std::string_view colour_of(State state) {
  if (state == State::pass || state == State::accepted) return "lpaccent3";
  return state == State::open ? "lpmuted" : "lpaccent2";
}

}  // namespace

std::string symbol(std::string_view path) {
  const NamedSymbol named = named_symbol(path);
  const std::string where = named.where.empty() ? "" : latex_text(named.where) + " ";
  if (is_word(named.symbol)) return where + latex_text(named.symbol);
  return where + "$" + formula::symbol_tex(named.symbol) + "$";
}

std::string cell(const Cell& cell) { return std::visit(CellText{}, cell); }

namespace {

std::string marked(State state, const std::string& words) {
  return "\\lpstate{" + std::string(colour_of(state)) + "}{" + account::mark(state) + "}{" + latex_text(words) + "}";
}

}  // namespace

std::string state(State state) { return marked(state, account::shown(state).text()); }

std::string state_of(const Mode& mode) { return marked(mode.state, account::shown(mode).text()); }

std::string headline(const Modes& modes) {
  return marked(account::overall(modes), account::word(account::conclude(modes).headline));
}

std::string finding(const Finding& finding) {
  return "\\lpconclusion{" + marked(finding.state, account::word(finding.headline)) + ": " +
         latex_text(finding.text.text()) + "}\n\n";
}

}  // namespace loadpath::report::tex
