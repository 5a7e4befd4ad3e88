#include "lib/project/run/search/candidates.hpp"

#include "lib/account/rows.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

namespace {

/// The kinds of the rows of a group, each once, in the order of the rows.
std::vector<std::string> kinds_of(const table::Tables& tables, const std::string& group) {
  std::vector<std::string> kinds;
  for (const table::Entry& row : tables.ordered_rows(group, "")) {
    if (std::find(kinds.begin(), kinds.end(), row.row->kind) == kinds.end()) kinds.push_back(row.row->kind);
  }
  return kinds;
}

}  // namespace

Candidates candidates_of(const Evaluation& evaluation, const Search& wanted) {
  const table::Tables& tables = *evaluation.step().input().tables;
  Candidates all{wanted, evaluation.inputs().leaf(wanted.path), {}, {}};
  if (evaluation.step().seeks_name(wanted)) {
    all.chosen = std::exchange(all.leaf, {});
    all.rows = kinds_of(tables, wanted.stock);
  } else if (all.leaf) {
    all.sizes = stock_values(tables, wanted.stock);
    const FieldInfo& field = *all.leaf.field;  // typed, an unusual size would be warned of: none is found
    std::erase_if(all.sizes, [&](double size) { return !field.bounds.holds(size) || !field.plausible.holds(size); });
  } else {
    const auto rows = tables.ordered_rows(wanted.path, wanted.stock, wanted.where);  // its text has been checked
    for (const table::Entry& row : *rows) all.rows.push_back(row.row->name);
  }
  return all;
}

Message Candidates::name(std::size_t i) const {
  return leaf ? say("{1}", format_quantity(sizes[i], leaf.field->unit)) : say("{1}", rows[i]);
}

const std::string& Candidates::source() const { return wanted.stock.empty() ? wanted.path : wanted.stock; }

void Candidates::take(Inputs& inputs, std::size_t i) const {
  if (leaf) return leaf.set(sizes[i]);
  if (chosen) return void(set_word(chosen, rows[i]));
  std::vector<Issue> lacks;
  inputs.take_row(wanted.path, rows[i], lacks);
}

void Candidates::keep_to_body(const BodySize& body) {
  std::erase_if(sizes, [&](double size) {
    const bool is_it = std::abs(size - body.si) <= 1e-9 * body.si;
    return body.is_given ? !is_it : size < account::least_candidate(body.si);
  });
}

void Candidates::leave_open(Inputs& inputs, Message why, std::vector<account::TriedSize> tried) const {
  if (leaf)
    inputs.leaf(wanted.path).set(std::nan(""));
  else if (chosen)
    set_word(chosen, "");
  else
    inputs.clear_row(wanted.path);
  inputs.set_origin(wanted.path, {.text = std::move(why), .sources = {}, .searched = true, .tried = std::move(tried)});
}

}  // namespace loadpath::project
