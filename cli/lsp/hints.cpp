#include "cli/lsp/hints.hpp"

#include "cli/lsp/words.hpp"
#include "lib/project/verify.hpp"
#include "lib/quantity/format.hpp"

#include <map>

namespace loadpath::cli::lsp {

namespace {

class Hints {
 public:
  explicit Hints(const OpenFile& file) : file_(file) {}

  void add_step(const project::Step& step) {
    const project::Reading& reading = step.input().reading;
    for (const project::Operand& operand : reading.operands) {
      if (!operand.of_record)
        add(operand.place, value_of(*file_.project, operand.text, operand.leaf.field->unit), operand.text);
    }
    for (const project::Taken& taken : reading.taken) {
      if (!taken.of_record) add(taken.place, value_of(*file_.project, taken.source), taken.source);
    }
    for (const project::Search& search : reading.searches) add_found(step, search);
  }

  void add_expectation(const project::Comparison& comparison) {
    add(comparison.expectation->place, format_quantity(comparison.ours, comparison.expectation->unit), "");
  }

  /// Adds the value of a bare reference, "=values.P".
  void add_shared() {
    constexpr std::string_view prefix = "=values.";
    const std::string_view text = file_.document.text();
    for (const Item& item : file_.outline.items) {
      if (!item.is_text || !item.in(text).starts_with(prefix)) continue;
      const Item* const value = file_.outline.find({"values", std::string(item.in(text).substr(prefix.size()))});
      if (value != nullptr && !value->in(text).starts_with('=')) put(item, std::string(value->in(text)), "");
    }
  }

  std::map<std::size_t, Hint> all;

 private:
  void add_found(const project::Step& step, const project::Search& search) {
    for (const account::Entry& entry : step.account().inputs) {
      if (entry.path != search.path) continue;
      return add(search.place, entry.word.empty() ? text_of(entry.value, entry.unit) : entry.word,
                 entry.origin.text.text());
    }
    add(search.place, step.word(search.path), "");
  }

  void add(const Place& place, const std::string& value, const std::string& more) {
    if (value.empty() || place.file != file_.name || place.line < 1) return;
    const Item* const item = file_.outline.at(file_.document.offset_of(place));
    if (item != nullptr && item->is_text) put(*item, value, more);
  }

  void put(const Item& item, const std::string& value, const std::string& more) {
    all.try_emplace(item.end, Hint{file_.document.position_of(item.end + 1), "= " + value, more});
  }

  const OpenFile& file_;
};

}  // namespace

std::vector<Hint> hints_in(const OpenFile& file, const Range& range) {
  Hints hints(file);
  if (file.is_solved) {
    for (const auto& step : file.project->steps) hints.add_step(*step);
    for (const project::Comparison& comparison : project::compare(*file.project)) hints.add_expectation(comparison);
  }
  hints.add_shared();
  std::vector<Hint> within;
  for (auto& [offset, hint] : hints.all) {
    const bool inside = range.start.line <= hint.position.line && hint.position.line <= range.end.line;
    if (inside) within.push_back(std::move(hint));
  }
  return within;
}

}  // namespace loadpath::cli::lsp
