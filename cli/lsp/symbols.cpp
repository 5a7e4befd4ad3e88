#include "cli/lsp/symbols.hpp"

#include "cli/lsp/target.hpp"
#include "cli/lsp/words.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/table/names.hpp"

#include <algorithm>

namespace loadpath::cli::lsp {

namespace {

std::string joined(const Path& path, std::size_t from) {
  std::string all;
  for (std::size_t i = from; i < path.size(); ++i)
    all += (all.empty() || path[i].starts_with('[') ? "" : ".") + path[i];
  return all;
}

/// The reference of an expression that the offset is in; empty if there is none.
Expression::Reference reference_at(std::string_view expression, std::size_t offset) {
  const auto parsed = Expression::parse(expression);
  if (!parsed) return {};
  for (const auto& reference : parsed->references()) {
    if (reference.at <= offset && offset <= reference.at + reference.path.size()) return reference;
  }
  return {};
}

/// The parts of a reference; one in quotes is a part without them.
Path parts_of(std::string_view path) {
  Path parts(1);
  bool in_quotes = false;
  for (const char c : path) {
    if (c == '"') in_quotes = !in_quotes;
    if (c == '"') continue;
    if (c == '.' && !in_quotes)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

Range header_range(const OpenFile& file, const Header& header) {
  return file.document.range_of(header.begin, header.end);
}

/// A row of the project's own, by any spelling of its name.
std::optional<Range> row_range(const OpenFile& file, const std::string& group, std::string_view name) {
  const auto is_row = [&](const Path& path) {
    return path.size() > 2 && path[0] == "tables" && is_of_group(path[1], group) &&
           table::folded(path[2]) == table::folded(name);
  };
  for (const Header& header : file.outline.headers) {
    if (is_row(header.path)) return header_range(file, header);
  }
  for (const Item& item : file.outline.items) {
    if (is_row(item.path)) return file.document.range_of(item.key_begin, item.key_end);
  }
  return std::nullopt;
}

/// The longest part of a path that is in the file itself: a key, else the header of the step.
std::optional<Range> path_range(const OpenFile& file, Path path) {
  if (path[0] == "tables" && path.size() > 2) return row_range(file, path[1].substr(0, path[1].size() - 1), path[2]);
  for (; path.size() > 1; path.pop_back()) {
    const Item* const item = file.outline.find(path);
    if (item != nullptr) return file.document.range_of(item->key_begin, item->key_end);
    for (const Header& header : file.outline.headers) {
      if (header.path == path) return header_range(file, header);
    }
  }
  const Header* const header = file.outline.find_header(path[0]);
  return header == nullptr ? std::nullopt : std::optional(header_range(file, *header));
}

}  // namespace

std::vector<Symbol> symbols_of(const OpenFile& file) {
  std::vector<Symbol> symbols;
  const auto& headers = file.outline.headers;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    const Header& header = headers[i];
    const std::size_t end = i + 1 < headers.size() ? headers[i + 1].begin : file.document.text().size();
    const Range all = file.document.range_of(header.begin, end);
    const bool is_within = header.path.size() > 1 && !symbols.empty() && symbols.back().name == header.path[0];
    const std::string name = joined(header.path, is_within ? 1 : 0);
    Symbol symbol{name.empty() ? "?" : name, "", all, header_range(file, header), {}};
    if (is_within) {
      symbols.back().all.end = all.end;
      symbols.back().within.push_back(std::move(symbol));
      continue;
    }
    const Calculator* const calculator = calculator_of(file.outline, file.document.text(), header.path[0]);
    if (calculator != nullptr) symbol.detail = calculator->id;
    symbols.push_back(std::move(symbol));
  }
  return symbols;
}

std::optional<Range> definition_at(const OpenFile& file, std::size_t offset) {
  const Item* const item = file.outline.at(offset);
  if (item == nullptr || !item->is_text || offset < item->begin || offset > item->end) return std::nullopt;
  const std::string_view text = item->in(file.document.text());
  const bool is_expected = item->path[0] == "expect" && item->path.back() == "value";
  const std::size_t skipped = text.starts_with('=') ? 1 : 0;
  if (skipped == 0 && !is_expected) {
    const Target target = target_of(file.outline, file.document.text(), item->path);
    return target.group.empty() ? std::nullopt : row_range(file, target.group, text);
  }
  const std::size_t within = std::max(offset - item->begin, skipped) - skipped;
  const Expression::Reference reference = reference_at(text.substr(skipped), within);
  if (reference.path.empty()) return std::nullopt;
  Path parts = parts_of(reference.path);
  const bool on_step = within - reference.at <= parts[0].size();
  if (on_step && parts[0] != "values" && parts[0] != "tables") parts.resize(1);
  return path_range(file, std::move(parts));
}

}  // namespace loadpath::cli::lsp
