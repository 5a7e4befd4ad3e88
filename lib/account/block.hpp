// The output of a step other than its numbers, as data: paragraphs, tables, worked formulas, figures. Writers
// (lib/report) decide on the layout.
#pragma once

#include "lib/account/verdict.hpp"
#include "lib/figure/figure.hpp"

#include <string>
#include <variant>
#include <vector>

namespace loadpath::account {

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

using Block = std::variant<Heading, Paragraph, Table, Derivation, Verdicts, figure::Figure>;

}  // namespace loadpath::account
