#include "lib/draw/flow/flow.hpp"

#include "lib/draw/canvas/svg_writer.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/tikz/writer.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace loadpath::draw {
namespace {

constexpr double label_room = 190.0, box_right = view_width - 2.0, row = 19.0, least_height = 42.0, between = 14.0,
                 margin = 4.0, lane_width = 9.0, first_lane = 8.0, head = 7.0, pad = 10.0;

/// Signs that are narrow, as letters of their width: blanks, dots and exponents of units.
std::string measured(std::string words) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> narrow{
      {{"\u00A0", "-"}, {"·", "."}, {"²", "-"}}};
  for (const auto& [sign, letter] : narrow) {
    for (std::size_t at = words.find(sign); at != std::string::npos; at = words.find(sign, at))
      words.replace(at, sign.size(), letter);
  }
  return words;
}

bool fits(const std::string& words, double room) { return width(typeset(measured(words)), text_size) <= room; }

void drop_last_letter(std::string& words) {
  while (!words.empty() && (static_cast<unsigned char>(words.back()) & 0xC0U) == 0x80U) words.pop_back();
  if (!words.empty()) words.pop_back();
}

/// The text, or its first words: a number is not cut. Of a single word its first letters.
std::string shortened(std::string words, double room) {
  if (fits(words, room)) return words;
  const std::string rest = "…";
  for (std::size_t end = words.rfind(' '); end != std::string::npos && end > 0; end = words.rfind(' ', end - 1)) {
    const std::string first = words.substr(0, words[end - 1] == ',' ? end + 1 : end);
    if (fits(first + rest, room)) return first + rest;
  }
  while (!words.empty() && !fits(words + rest, room)) drop_last_letter(words);
  return words + rest;
}

/// The label of an arrow, never without its number: load components are dropped first, then the list of its element
/// ("seats" of "seats.pinion.J"), then the element, then letters of its name.
std::string shortened_label(std::string label, double room) {
  const std::string_view more = ", …";
  if (!fits(label, room) && label.ends_with(more)) label.resize(label.size() - more.size());
  const std::string equals = "\u00A0=";
  const std::size_t end = std::min(label.find(equals), label.size());
  std::string name = label.substr(0, end), mark;
  const std::string value = label.substr(end);
  if (!fits(label, room) && std::count(name.begin(), name.end(), '.') > 1) name.erase(0, name.find('.') + 1);
  if (const std::size_t dot = name.rfind('.'); dot != std::string::npos && !fits(name + value, room))
    name.erase(0, dot + 1), mark = "…";
  if (fits(mark + name + value, room)) return mark + name + value;
  const std::string cut = "…" + value;
  while (!name.empty() && !fits(name + cut, room)) drop_last_letter(name);
  return name + cut;
}

struct Placed {
  Box box;
  std::vector<std::size_t> arriving;  // arrows, from the top
};

/// All arrows of one part leave it together, along a line of their own parallel to the other bundles.
struct Bundle {
  std::size_t from = 0, last = 0;
  std::size_t lane = 0;
};

class FlowPicture {
 public:
  explicit FlowPicture(const Flow& flow) : flow_(flow) {
    bundle();
    place();
  }

  [[nodiscard]] double height() const { return height_; }

  Canvas drawn() {
    for (const Bundle& bundle : bundles_) draw(bundle);
    for (std::size_t i = 0; i < flow_.parts.size(); ++i) draw(flow_.parts[i], placed_[i]);
    return std::move(canvas_);
  }

 private:
  void place() {
    placed_.resize(flow_.parts.size());
    for (std::size_t a = 0; a < flow_.arrows.size(); ++a) placed_[flow_.arrows[a].to].arriving.push_back(a);
    double top = margin;
    for (Placed& part : placed_) {
      std::stable_sort(part.arriving.begin(), part.arriving.end(),
                       [&](std::size_t a, std::size_t b) { return flow_.arrows[a].from < flow_.arrows[b].from; });
      const double tall = std::max(least_height, row * static_cast<double>(part.arriving.size()) + 16.0);
      part.box = {box_left(), top, box_right, top + tall};
      top += tall + between;
    }
    height_ = top - between + margin;
  }

  /// Each takes the free line that is nearest to the parts.
  void bundle() {
    for (std::size_t from = 0; from < flow_.parts.size(); ++from) {
      Bundle next{from, from, 0};
      for (const auto& arrow : flow_.arrows) {
        if (arrow.from == from) next.last = std::max(next.last, arrow.to);
      }
      if (next.last == from) continue;
      const auto is_taken = [&](const Bundle& b) { return b.lane == next.lane && b.last > next.from; };
      while (std::any_of(bundles_.begin(), bundles_.end(), is_taken)) ++next.lane;
      lanes_ = std::max(lanes_, next.lane + 1);
      bundles_.push_back(next);
    }
  }

  [[nodiscard]] double lanes_end() const { return first_lane + lane_width * static_cast<double>(lanes_); }
  [[nodiscard]] double box_left() const { return std::max(214.0, lanes_end() + label_room + pad); }
  [[nodiscard]] double lane_at(std::size_t lane) const {
    return first_lane + lane_width * static_cast<double>(lanes_ - 1 - lane);
  }
  [[nodiscard]] static double arrival(const Placed& part, std::size_t place) {
    return part.box.top + row * (static_cast<double>(place) + 1.0);
  }

  void draw(const Bundle& bundle) {
    const double x = lane_at(bundle.lane), left = box_left(), out = placed_[bundle.from].box.bottom - 6.0;
    double low = out;
    for (std::size_t to = bundle.from + 1; to <= bundle.last; ++to) {
      const Placed& part = placed_[to];
      for (std::size_t k = 0; k < part.arriving.size(); ++k) {
        const auto& arrow = flow_.arrows[part.arriving[k]];
        if (arrow.from != bundle.from) continue;
        low = arrival(part, k);
        canvas_.line("light", {x, low}, {left - head, low});
        arrow_head(canvas_, "dot", {left, low}, {1.0, 0.0}, head);
        canvas_.text("halo", {left - pad, low - 4.0}, typeset(shortened_label(arrow.label, left - pad - lanes_end())),
                     Anchor::end);
      }
    }
    canvas_.polyline("light", {{left, out}, {x, out}, {x, low}});
  }

  void draw(const Flow::Part& part, const Placed& placed) {
    constexpr std::array dots{"f2", "f1", "f1", "dot"};
    const Box& box = placed.box;
    canvas_.rectangle("image", box);
    const Point first{box.left + pad, box.top + 17.0}, second{box.left + pad, box.top + 33.0};
    canvas_.text("", first, {{shortened(part.name, box.width() - 2.0 * pad), Run::Face::words}});
    const double state = width({{part.state, Run::Face::words}}, text_size);
    if (!part.state.empty()) {
      canvas_.circle(dots[static_cast<std::size_t>(part.tone)], {box.right - pad - state - 8.0, second.y - 4.0}, 4.0);
      canvas_.text("quiet", {box.right - pad, second.y}, {{part.state, Run::Face::words}}, Anchor::end);
    }
    if (!part.below.empty())
      canvas_.text("quiet", second, typeset(shortened(part.below, box.width() - 3.0 * pad - state - 16.0)));
  }

  const Flow& flow_;
  std::vector<Placed> placed_;
  std::vector<Bundle> bundles_;
  std::size_t lanes_ = 1;
  double height_ = 0.0;
  Canvas canvas_;
};

/// A description for screen readers.
std::string description(const Flow& flow) {
  std::string all;
  for (const auto& arrow : flow.arrows) {
    all += (all.empty() ? "" : "; ") + flow.parts[arrow.from].name + " → " + flow.parts[arrow.to].name + ": " +
           plain(arrow.label);
  }
  return all;
}

Picture picture(const Flow& flow) {
  FlowPicture picture(flow);
  const double height = picture.height();
  return {picture.drawn(), height, description(flow)};
}

}  // namespace

std::string flow_in_page(const Flow& flow, const std::string& title) { return svg_part(picture(flow), title); }

std::string flow_file(const Flow& flow, const std::string& title) { return svg_file(picture(flow), title); }

std::string flow_tikz(const Flow& flow) { return tikz(picture(flow)); }

}  // namespace loadpath::draw
