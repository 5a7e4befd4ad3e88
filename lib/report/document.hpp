// A report as data: its contents in order. Writers (html, markdown, latex) decide on the layout.
#pragma once

#include "lib/account/block.hpp"
#include "lib/account/mode.hpp"
#include "lib/draw/flow/flow.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::report {

// A document consists of the blocks of the steps.
using account::Block;
using account::Cell;
using account::Derivation;
using account::Heading;
using account::Mode;
using account::Modes;
using account::Paragraph;
using account::Quantity;
using account::State;
using account::Step;
using account::Symbol;
using account::Table;
using account::Verdict;
using account::Verdicts;

struct Document {
  std::string title;
  std::vector<std::pair<Message, std::string>> meta;  // "Project file" "lever.toml", "Program" "loadpath 0.2.0"...
  std::string paper = "A4";                           // paper for printing; or "letter"
  Table chosen;                                       // first page: the sizes of parts, and their governing modes
  draw::Flow path;                                    // first page: flow of loads
  Modes summary;                                      // first page
  std::vector<Block> blocks;
  std::string input;  // last page: the project as it was typed; may be empty
};

/// One self-contained page: no network; embedded math font; light, dark and print. It is complete without its
/// scripts, which animate mechanisms, show points of charts and let keys scroll wide content.
std::string html(const Document& document);
/// Markdown with $$ formulas; figures are named `figures[i].first` and hold SVG text, to be written to files next to
/// it.
struct Markdown {
  std::string text;
  std::vector<std::pair<std::string, std::string>> figures;
};
Markdown markdown(const Document& document, std::string_view stem);
/// One file for pdflatex, its figures in it.
std::string latex(const Document& document);

}  // namespace loadpath::report
