#include "cli/lsp/text/document.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath::cli::lsp {

namespace {

/// The number of UTF-16 units of a character with so many bytes of UTF-8.
std::size_t units_of(std::size_t bytes) { return bytes == 4 ? 2 : 1; }

}  // namespace

Document::Document(std::string text) : text_(std::move(text)) { find_lines(); }

void Document::find_lines() {
  starts_.assign(1, 0);
  for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1))
    starts_.push_back(at + 1);
}

std::string_view Document::line(std::size_t number) const {
  const std::size_t end = number + 1 < starts_.size() ? starts_[number + 1] - 1 : text_.size();
  std::string_view all = std::string_view(text_).substr(starts_[number], end - starts_[number]);
  if (all.ends_with('\r')) all.remove_suffix(1);
  return all;
}

std::size_t Document::offset_of(const Position& position) const {
  if (position.line >= starts_.size()) return text_.size();
  const std::string_view all = line(position.line);
  std::size_t at = 0;
  for (std::size_t units = 0; at < all.size();) {
    const std::size_t bytes = character_length(all, at);
    units += units_of(bytes);
    if (units > position.character) break;
    at += bytes;
  }
  return starts_[position.line] + at;
}

std::size_t Document::offset_of(const Place& place) const {
  if (place.line < 1) return 0;
  if (static_cast<std::size_t>(place.line) > starts_.size()) return text_.size();
  const std::string_view all = line(static_cast<std::size_t>(place.line) - 1);
  std::size_t at = 0;
  for (int column = 1; column < place.column && at < all.size(); ++column) at += character_length(all, at);
  return starts_[static_cast<std::size_t>(place.line) - 1] + at;
}

Position Document::position_of(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto number = static_cast<std::size_t>(next - starts_.begin()) - 1;
  const std::string_view all = line(number);
  const std::size_t end = std::min(offset - starts_[number], all.size());
  std::size_t units = 0;
  for (std::size_t at = 0; at < end;) {
    const std::size_t bytes = character_length(all, at);
    units += units_of(bytes);
    at += bytes;
  }
  return {number, units};
}

Range Document::range_of(const Place& place) const {
  Place end = place;
  end.column += std::max(1, place.length);
  return range_of(offset_of(place), offset_of(end));
}

void Document::change(const Range& range, std::string_view text) {
  const std::size_t begin = offset_of(range.start), end = std::max(begin, offset_of(range.end));
  text_.replace(begin, end - begin, text);
  find_lines();
}

}  // namespace loadpath::cli::lsp
