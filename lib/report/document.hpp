// A report as data: what is said, in which order. Writers (html.cpp, markdown.cpp) decide how it looks.
#pragma once

#include "lib/draw/figure.hpp"
#include "lib/issue.hpp"
#include "lib/report/state.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace loadpath::report {

/// A value in a unit; NaN is printed as "not available".
struct Quantity {
  double si = 0.0;
  std::string unit;  // "N*m"
  int digits = 5;
};
/// A symbol of a formula: "tau_adm".
struct Symbol {
  std::string name;
};
/// Text of the user or of a message: escaped by the writer.
using Cell = std::variant<std::string, Message, Quantity, Symbol, State>;

struct Heading {
  int level = 2;  // 2: a step; 3: a part of it
  std::string text;
  std::string anchor;  // "crankshaft"
};
struct Paragraph {
  Message text;
  enum class Tone { plain, note, warning } tone = Tone::plain;
};
struct Table {
  Message caption;            // may be empty
  std::vector<Message> head;  // may be empty
  std::vector<std::vector<Cell>> rows;
};

/// One formula with its numbers: symbol = formula = substituted = value, and why.
struct Step {
  std::string symbol;
  std::string formula;  // STEP's text; empty: a value that is taken from elsewhere
  struct Given {
    std::string name;
    double si = 0.0;
    std::string unit;
  };
  std::vector<Given> given;  // every name of the formula that is a quantity
  Quantity value;
  Message why;
};
/// Formulas in order. Steps of list elements with equal formulas are folded by the builder into one Step and a Table.
struct Derivation {
  std::vector<Step> steps;
};
/// A check or a limit and how it came out; the writer draws a bar for a utilisation.
struct Verdict {
  std::string step;    // "crankshaft"
  std::string symbol;  // "u_tau"
  Message meaning;
  std::optional<double> utilisation;  // none for a limit
  Cell value;                         // what is compared
  Message bound;                      // "passes at 1 or less", "0 to 0.9"
  State state = State::not_available;
  Message note;  // where it governs, why it is not covered; may be empty
};
struct Verdicts {
  std::vector<Verdict> rows;
};
/// The state of all of them: the worst.
State worst(const std::vector<Verdict>& verdicts);

using Block = std::variant<Heading, Paragraph, Table, Derivation, Verdicts, draw::Figure>;

struct Document {
  std::string title;
  std::vector<std::pair<Message, std::string>> meta;  // "Project file" "lever.toml", "Program" "loadpath 0.1.0"...
  Verdicts summary;                                   // first page
  std::vector<Block> blocks;
};

/// One self-contained page: no network; embedded math font; light, dark and print. A script only where a mechanism
/// moves, and the page reads without it.
std::string html(const Document& document);
/// Markdown with $$ formulas; figures are named `figures[i].first` and hold SVG text, to be written beside it.
struct Markdown {
  std::string text;
  std::vector<std::pair<std::string, std::string>> figures;
};
Markdown markdown(const Document& document, std::string_view stem);

}  // namespace loadpath::report
