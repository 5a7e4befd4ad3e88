// A report as data: three pages to decide, to check and to recompute, then an appendix that proves. Writers (html,
// markdown, latex) decide on the layout.
#pragma once

#include "lib/account/block.hpp"
#include "lib/account/conclusion.hpp"
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
using account::Sized;
using account::State;
using account::Step;
using account::Symbol;
using account::Table;
using account::Utilisation;
using account::Verdict;
using account::Verdicts;

/// The title block of page 1. A field without text reads "not given".
struct TitleBlock {
  struct Field {
    Message name;
    std::string text;
  };
  /// The writer leaves room for the signature.
  struct Signature {
    Message role;
    std::string name, date;
  };
  std::vector<Field> subject;  // company, project, load case
  std::vector<Field> number;   // number, revision, date, file, input
  std::vector<Signature> signatures;
  /// Date of the run, on pages that are signed where the project gives none; texts that are compared do without it.
  std::string printed = {};
};

/// The verdict of page 1: the headline, and what it is about in one or two sentences.
struct Finding {
  account::Headline headline = account::Headline::pass;
  State state = State::pass;  // the mark of the headline
  Message text;
};

/// A part of a page: blocks under a heading.
struct Panel {
  Message title;   // may be empty
  Message remark;  // small, next to the title; may be empty
  std::vector<Block> blocks;
};
/// Panels one below the other.
struct Stack {
  double share = 1.0;  // of the width of its band
  std::vector<Panel> panels;
};
/// Stacks side by side.
using Band = std::vector<Stack>;
/// A printed page, from top to bottom.
struct Page {
  std::vector<Band> bands;
  bool is_numbered = true;  // its headings
};

struct Document {
  std::string title;
  std::vector<std::pair<Message, std::string>> meta;  // "Project file" "lever.toml", "Program" "loadpath 0.2.0"...
  std::string paper = "A4";                           // paper for printing; or "letter"
  std::string program;                                // in the footers: "loadpath 0.2.0"
  Modes summary;                                      // states of all failure modes

  TitleBlock heading;
  Finding finding;
  std::vector<Page> pages;  // none: a list of blocks without a verdict, of a sweep

  bool has_appendix = true;  // otherwise what follows is not written
  Table chosen;              // the sizes of parts, and their governing modes
  draw::Flow path;           // flow of loads
  std::vector<Block> blocks;
  std::string input;  // last page: the project as it was typed; may be empty
};

/// Whether the appendix is folded on the screen, or open: for printing.
enum class Folding { folded, open };

/// One self-contained page: no network; embedded math font; light, dark and print. It is complete without its
/// scripts, which animate mechanisms, show points of charts and let keys scroll wide content.
std::string html(const Document& document, Folding folding = Folding::folded);
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
