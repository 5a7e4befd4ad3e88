#include "lib/text/issue.hpp"

#include "lib/text/utf8.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>

namespace loadpath {
namespace {

constexpr std::size_t widest_line = 100;  // length of a displayed source line, in code points

struct Lines {
  std::string text;
  std::vector<std::string_view> lines;

  explicit Lines(std::string source) : text(std::move(source)) {
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t end = std::min(text.find('\n', from), text.size());
      lines.push_back(std::string_view(text).substr(from, end - from));
      from = end + 1;
    }
  }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
};

std::string position(const Place& place) {
  std::string text = place.file;
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (place.line > 0 && place.column > 0) text += ":" + std::to_string(place.column);
  return text.empty() ? text : text + ": ";
}

/// A line that a terminal shows unchanged: one cell per tab, nothing that moves the cursor.
std::u32string printable(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::u32string points = code_points(line);
  for (char32_t& p : points) {
    if (p == U'\t') p = U' ';
    if (p < 0x20 || (p >= 0x7F && p < 0xA0)) p = 0xFFFD;
  }
  return points;
}

/// The part of a line around the caret, and the caret's place in it.
struct Excerpt {
  std::u32string text;
  std::size_t caret = 0;
  std::size_t length = 1;
};

Excerpt excerpt(std::u32string line, std::size_t caret, std::size_t length) {
  caret = std::min(caret, line.size());
  std::size_t from = 0, cut = 0;  // range cut off at the line's end, replaced by dots
  if (line.size() > widest_line) {
    const std::size_t before = widest_line / 3;
    from = std::min(caret > before ? caret - before : 0, line.size() - widest_line);
    const bool cut_after = from + widest_line < line.size();
    line = line.substr(from, widest_line);
    if (from > 0) line.replace(0, 3, U"...");
    if (cut_after) {
      cut = 3;
      line.replace(widest_line - cut, cut, U"...");
    }
  }
  caret -= from;
  const std::size_t end = line.size() - cut;
  const std::size_t room = end > caret ? end - caret : 1;
  return {std::move(line), caret, std::clamp<std::size_t>(length, 1, room)};
}

std::size_t positive(int number) { return number > 0 ? static_cast<std::size_t>(number) : 1; }

/// The source line with its number, and the caret below; the width of the number is the gutter's.
std::string quote(const Place& place, std::string_view line) {
  const auto [text, caret, length] = excerpt(printable(line), positive(place.column) - 1, positive(place.length));
  const std::string number = std::to_string(place.line);
  std::string lines = number + " | " + utf8(text) + "\n" + std::string(number.size(), ' ') + " | ";
  return lines + std::string(caret, ' ') + std::string(length, '^') + "\n";
}

std::string render_one(const Issue& issue, const Lines& source) {
  std::string text = position(issue.place) + (issue.severity == Severity::error ? "error: " : "warning: ");
  if (issue.place.line <= 0 && !issue.key.empty()) text += issue.key + ": ";
  text += issue.message.text() + "\n";
  std::size_t gutter = 1;
  if (const auto line = static_cast<std::size_t>(std::max(issue.place.line, 0));
      line > 0 && line <= source.lines.size()) {
    text += quote(issue.place, source.lines[line - 1]);
    gutter = std::to_string(line).size();
  }
  if (!issue.hint.empty()) text += std::string(gutter, ' ') + " = help: " + issue.hint.text() + "\n";
  return text;
}

std::u32string lower(std::u32string word) {
  std::transform(word.begin(), word.end(), word.begin(), lower_case);
  return word;
}

/// Insertions, deletions, replacements and swaps of neighbours that lead from `a` to `b`.
std::size_t distance(std::u32string_view a, std::u32string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> cell((a.size() + 1) * width);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return cell[i * width + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = i;
  for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      at(i, j) = std::min({replaced, at(i - 1, j) + 1, at(i, j - 1) + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  }
  return at(a.size(), b.size());
}

}  // namespace

Message::Message() = default;
Message::Message(std::string_view literal, std::span<Argument> taken)
    : id(literal), args(std::move_iterator(taken.begin()), std::move_iterator(taken.end())) {}
Message::Message(const Message&) = default;
Message::Message(Message&&) noexcept = default;
Message& Message::operator=(const Message&) = default;
Message& Message::operator=(Message&&) noexcept = default;
Message::~Message() = default;

Argument::Argument(std::string part) : part_(std::move(part)) {}
Argument::Argument(std::string_view part) : part_(std::string(part)) {}
Argument::Argument(const char* part) : part_(std::string(part)) {}
Argument::Argument(Message part) : part_(std::move(part)) {}
Argument::Argument(const Argument&) = default;
Argument::Argument(Argument&&) noexcept = default;
Argument& Argument::operator=(const Argument&) = default;
Argument& Argument::operator=(Argument&&) noexcept = default;
Argument::~Argument() = default;

Message say(std::string_view id) { return {id, {}}; }
Message say(std::string_view id, Argument first) { return {id, {&first, 1}}; }
Message say(std::string_view id, Argument first, Argument second) {
  Argument all[] = {std::move(first), std::move(second)};
  return {id, all};
}
Message say(std::string_view id, Argument first, Argument second, Argument third) {
  Argument all[] = {std::move(first), std::move(second), std::move(third)};
  return {id, all};
}

std::string Argument::text() const {
  const auto* const message = std::get_if<Message>(&part_);
  return message == nullptr ? std::get<std::string>(part_) : message->text();
}

std::string Message::text() const {
  if (id == "{1}" && args.size() == 1) return args.front().text();
  std::string out;
  std::size_t copied = 0;
  for (std::size_t i = id.find('{'); i != std::string_view::npos; i = id.find('{', i + 1)) {
    const bool argument = i + 2 < id.size() && id[i + 2] == '}' && id[i + 1] >= '1' && id[i + 1] <= '9';
    const auto index = argument ? static_cast<std::size_t>(id[i + 1] - '1') : args.size();
    if (index >= args.size()) continue;
    out.append(id, copied, i - copied) += args[index].text();
    copied = i + 3;
  }
  return out.append(id, copied);
}

std::string render(std::vector<Issue> issues, const std::function<std::string(const std::string& file)>& source) {
  std::stable_sort(issues.begin(), issues.end(), [](const Issue& a, const Issue& b) {
    return std::tie(a.place.file, a.place.line, a.place.column) < std::tie(b.place.file, b.place.line, b.place.column);
  });
  std::string text;
  for (std::size_t i = 0; i < issues.size();) {
    const std::string& file = issues[i].place.file;
    const Lines lines(file.empty() ? std::string() : source(file));
    std::string before;
    for (; i < issues.size() && issues[i].place.file == file; ++i) {
      const std::string one = render_one(issues[i], lines);
      if (one != before) text += one;  // two readers of one value say the same
      before = one;
    }
  }
  return text;
}

namespace {

/// Without underscores.
std::u32string letters_of(std::u32string text) {
  std::erase(text, U'_');
  return text;
}

}  // namespace

std::vector<std::string> all_nearest(std::string_view word, const std::vector<std::string>& candidates) {
  const std::u32string exact = code_points(word), wanted = lower(exact);
  const std::size_t reach =
      std::min(std::max<std::size_t>(1, wanted.size() / 3), wanted.size() - (wanted.empty() ? 0 : 1));
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  std::tuple best{most, most, most, most};
  std::vector<std::string> found;
  for (const std::string& candidate : candidates) {
    const std::u32string points = code_points(candidate);
    const std::size_t longer = std::max(points.size(), wanted.size()), shorter = std::min(points.size(), wanted.size());
    if (longer - shorter > reach) continue;
    const bool has_digit_more = exact.size() > points.size() && exact.starts_with(points) &&
                                exact[points.size()] >= U'0' && exact[points.size()] <= U'9';
    const std::size_t is_other = has_digit_more ? 0 : 1;                          // 6208 before 6200 for 62080
    const std::size_t is_more = letters_of(exact) == letters_of(points) ? 0 : 1;  // v_x before x for vx
    const std::tuple far{distance(wanted, lower(points)), is_more, distance(exact, points), is_other};
    if (std::get<0>(far) > reach || std::get<0>(far) > std::get<0>(best)) continue;
    if (std::get<0>(far) < std::get<0>(best)) found.clear();
    found.insert(far < best ? found.begin() : found.end(), candidate);
    best = std::min(best, far);
  }
  return found;
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  const auto all = all_nearest(word, candidates);
  return all.empty() ? std::string() : all.front();
}

Message did_you_mean(std::string_view word, const std::vector<std::string>& candidates, Message otherwise,
                     const std::string& prefix) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? std::move(otherwise) : say("did you mean '{1}'?", prefix + near);
}

Message there_is(const std::vector<std::string>& candidates) {
  if (candidates.empty()) return say("none is defined here");
  std::string all;
  for (const std::string& candidate : candidates) all += (all.empty() ? "" : ", ") + candidate;
  return say("available: {1}", all);
}

}  // namespace loadpath
