#include "lib/draw/plan/picture.hpp"

#include "lib/draw/canvas/scale_bar.hpp"
#include "lib/draw/canvas/thin.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::draw {
namespace {

constexpr double room_x = 30.0, room_y = 22.0, title_height = 20.0, title_margin = 10.0, bar_height = 28.0,
                 least_height = 60.0;

/// The title in lines not wider than its panel.
std::vector<Text> title_lines(const std::string& title, double panel) {
  std::vector<Text> lines;
  std::string line;
  for (std::size_t begin = 0; begin < title.size();) {
    const std::size_t end = std::min(title.find(' ', begin), title.size());
    const std::string word = title.substr(begin, end - begin);
    std::string longer = line;
    if (!line.empty()) longer += ' ';
    longer += word;
    const bool full = !line.empty() && width(typeset(longer), text_size) > panel - 2.0 * title_margin;
    if (full) lines.push_back(typeset(line));
    line = full ? word : longer;
    begin = end + 1;
  }
  if (!line.empty()) lines.push_back(typeset(line));
  return lines;
}

double title_room(const figure::Plan& plan, double panel) {
  if (plan.title.empty()) return 0.0;
  return title_height + line_height * static_cast<double>(title_lines(plan.title, panel).size() - 1);
}

/// The area for names: without the title and the scale bars.
Box free_of_words(const figure::Plan& plan, const Box& area) {
  constexpr double bar_words = 22.0;
  return {area.left + 2.0, area.top + title_room(plan, area.width()) + 2.0, area.right - 2.0, area.bottom - bar_words};
}

/// The positions adjacent to a dot: a name further off could be read as that of another dot.
std::vector<Candidate> close_to(Point dot, double wide) {
  constexpr double far = 12.0;
  auto places = around(dot, 4.0, wide);
  std::erase_if(places, [](const Candidate& c) { return c.cost >= far; });
  return places;
}

/// Everything that must be seen, in the unit of the vectors and upwards; forces as arrows of `per_newton`.
Box extent(const figure::Plan& plan, double per_newton) {
  Box box;  // with the pole
  const auto include = [&](Point p) { box.include({p.x, p.y, p.x, p.y}); };
  for (const auto& v : plan.vectors) include(v.from), include(v.to);
  for (const auto& image : plan.images) {
    for (const Point p : image.points) include(p);
  }
  for (const auto& point : plan.points) include(point.at);
  for (const auto& trace : plan.traces) {
    for (const Point p : trace.points) include(p);
  }
  for (const auto& force : plan.forces) include(force.at), include(force.at + per_newton * force.force);
  for (const auto& moment : plan.moments) include(moment.at);
  return box;
}

double strongest(const figure::Plan& plan) {
  double most = 0.0;
  for (const auto& force : plan.forces) most = std::max(most, length(force.force));
  return most;
}

std::string speed_text(double si) { return format_quantity(si, "m/s", 4); }
std::string acceleration_text(double si) { return format_quantity(si, "m/s^2", 4); }
std::string (*text_in(const std::string& unit))(double) {
  return unit == "N" ? force_text : unit == "m/s" ? speed_text : acceleration_text;
}

class PlanPicture {
 public:
  PlanPicture(Canvas& canvas, const figure::Plan& plan, const PlanFit& fit, Findable findable)
      : canvas_(canvas),
        plan_(plan),
        fit_(fit),
        findable_(findable == Findable::yes),
        labels_(free_of_words(plan, fit.area)) {}

  void draw() {
    draw_title();
    draw_traces();
    draw_images();
    draw_vectors();
    draw_forces();
    draw_points();
    name_vectors();
    name_forces();
    name_marks();
  }

 private:
  void draw_title() {
    Point foot{fit_.area.left + title_margin, fit_.area.top + 14.0};
    for (const Text& line : title_lines(plan_.title, fit_.area.width())) {
      canvas_.text("quiet", foot, line);
      foot.y += line_height;
    }
  }

  /// Hodographs, on the axes that they are seen in.
  void draw_traces() {
    if (plan_.traces.empty()) return;
    const Point pole = fit_.at({});
    const double top = fit_.area.top + title_room(plan_, fit_.area.width());
    const Point left{fit_.area.left + 8.0, pole.y}, right{fit_.area.right - 8.0, pole.y};
    const Point high{pole.x, top + 2.0}, low{pole.x, fit_.area.bottom - bar_height};
    for (const auto& [from, to] : {std::pair(left, right), std::pair(high, low)}) {
      canvas_.line("axis", from, to);
      labels_.keep_off({from, to}, 1.0, 0.3);
    }
    for (const auto& trace : plan_.traces) {
      std::vector<Point> points;
      for (const Point p : trace.points) points.push_back(fit_.at(p));
      points = thin(points);
      canvas_.polyline("curve c1", points);
      for (const auto& mark : trace.marks) {
        canvas_.circle(mark.governing ? "f0" : "f1", fit_.at(mark.at), 2.6);
        labels_.keep_off(Box::around(fit_.at(mark.at), 6.0, 6.0));
      }
      labels_.keep_off(points, 2.0);
    }
  }

  /// The governing ones are always named, and first; the others if there is room.
  void name_marks() {
    for (const auto& trace : plan_.traces) {
      for (const auto& mark : trace.marks) {
        if (mark.governing) canvas_.centred_text("halo f0", labels_.place(places_of(mark)), typeset(mark.label));
      }
    }
    for (const auto& trace : plan_.traces) {
      for (const auto& mark : trace.marks) {
        if (mark.governing) continue;
        if (const auto free = labels_.place_free(places_of(mark)))
          canvas_.centred_text("quiet halo", *free, typeset(mark.label));
      }
    }
  }
  [[nodiscard]] std::vector<Candidate> places_of(const figure::Plan::Mark& mark) const {
    return close_to(fit_.at(mark.at), width(typeset(mark.label), text_size));
  }

  void draw_images() {
    for (const auto& image : plan_.images) {
      std::vector<Point> points;
      for (const Point p : image.points) points.push_back(fit_.at(p));
      points = convex_hull(points);
      if (points.size() > 2) canvas_.polygon("image", points);
      if (points.size() == 2) canvas_.line("light", points[0], points[1]);
      if (points.size() > 1) labels_.keep_off(points, 1.0);
    }
  }

  /// Two forces of a plan lie on one line: they are drawn side by side.
  [[nodiscard]] Point shift(const figure::Plan::Vector& v) const {
    if (plan_.vectors.size() != 2 || plan_.unit != "N") return {};
    const Point d = fit_.at(v.to) - fit_.at(v.from);
    return length(d) > 0.0 ? 3.0 * across(unit(d)) : Point{};
  }

  void draw_vectors() {
    for (std::size_t i = 0; i < plan_.vectors.size(); ++i) {
      const auto& v = plan_.vectors[i];
      const Point from = fit_.at(v.from) + shift(v), to = fit_.at(v.to) + shift(v);
      if (findable_) canvas_.begin_group({{"data-side", std::to_string(i)}});
      if (v.tone == figure::Plan::Tone::part) {
        const double head = std::min(8.0, 0.7 * length(to - from));
        canvas_.line("light dash", from, to);
        arrow_head(canvas_, "dot", to, unit(to - from), head);
      } else {
        arrow(canvas_, static_cast<int>(v.tone), from, to);
      }
      if (findable_) canvas_.end_group();
      labels_.keep_off({from, to}, 2.0);
    }
  }

  void draw_forces() {
    for (const auto& force : plan_.forces) {
      arrow(canvas_, force.load ? 1 : 0, fit_.at(force.at), tip(force));
      labels_.keep_off({fit_.at(force.at), tip(force)}, 2.0);
    }
    for (const auto& moment : plan_.moments) {
      couple(canvas_, fit_.at(moment.at), {0.0, 1.0}, moment.value > 0.0);
      labels_.keep_off(ring(fit_.at(moment.at), couple_radius), 2.0);
    }
  }

  /// The pole is a ring: points at rest are there.
  void draw_points() {
    for (const auto& point : plan_.points) {
      const bool pole = point.at.x == 0.0 && point.at.y == 0.0;
      pole ? canvas_.circle("pin", fit_.at({}), 3.6) : canvas_.circle("solid", fit_.at(point.at), 2.2);
    }
    for (const auto& point : plan_.points) {
      const Text text = typeset(point.name);
      canvas_.centred_text("halo", labels_.place(around(fit_.at(point.at), 3.5, width(text, 1.1 * text_size))), text);
    }
  }

  void name_vectors() {
    for (std::size_t i = 0; i < plan_.vectors.size(); ++i) {
      const auto& v = plan_.vectors[i];
      if (v.label.empty()) continue;
      const Text text = typeset(v.label);
      const double wide = width(text, 1.1 * text_size);
      const Point from = fit_.at(v.from), to = fit_.at(v.to), aside = shift(v);
      auto places = along_segment(from + aside, to + aside, 4.0, wide);
      for (Candidate& c : around(to, 4.0, wide)) places.push_back({c.box, 6.0 + c.cost});
      const std::string colour =
          v.tone == figure::Plan::Tone::part ? "quiet" : "f" + std::to_string(static_cast<int>(v.tone));
      if (findable_) canvas_.begin_group({{"data-side-name", std::to_string(i)}});
      canvas_.centred_text("halo " + colour, labels_.place(places), text);
      if (findable_) canvas_.end_group();
    }
  }

  void name_forces() {
    for (const auto& force : plan_.forces) {
      const Text text = typeset(force.label);
      const auto places = around(tip(force), 3.0, width(text, 1.1 * text_size));
      canvas_.centred_text(force.load ? "halo f1" : "halo f0", labels_.place(places), text);
    }
    for (const auto& moment : plan_.moments) {
      const Text text = typeset(moment.label);
      const auto places = around(fit_.at(moment.at), couple_radius + 3.0, width(text, text_size));
      canvas_.centred_text("halo f1", labels_.place(places), text);
    }
  }

  [[nodiscard]] Point tip(const figure::Scheme::Arrow& force) const {
    return fit_.at(force.at) + fit_.newton * Point{force.force.x, -force.force.y};
  }

  Canvas& canvas_;
  const figure::Plan& plan_;
  const PlanFit& fit_;
  bool findable_;
  Labels labels_;
};

}  // namespace

PlanFit fit(const figure::Plan& plan, Point corner, double width, double most_height) {
  constexpr double force_share = 0.35;
  const Box bare = extent(plan, 0.0);
  const double size = std::max(bare.width(), bare.height()), most = strongest(plan);
  const double per_newton = most > 0.0 ? force_share * size / most : 0.0;
  const Box box = extent(plan, per_newton);
  const double room = plan.moments.empty() ? 0.0 : couple_radius;
  const double free_x = width - 2.0 * (room_x + room), free_y = most_height - 2.0 * (room_y + room);
  PlanFit fit;
  fit.scale = size > 0.0
                  ? std::min(free_x / std::max(box.width(), 1e-9 * size), free_y / std::max(box.height(), 1e-9 * size))
                  : 1.0;
  fit.newton = per_newton * fit.scale;
  const double height = std::max(fit.scale * box.height() + 2.0 * (room_y + room), least_height);
  const double top = corner.y + title_room(plan, width);
  fit.origin = Point{corner.x + 0.5 * width, top + 0.5 * height} - fit.scale * Point{box.centre().x, -box.centre().y};
  fit.area = {corner.x, corner.y, corner.x + width, top + height + bar_height};
  return fit;
}

void draw_plan(Canvas& canvas, const figure::Plan& plan, const PlanFit& fit, Findable findable) {
  PlanPicture(canvas, plan, fit, findable).draw();
}

void draw_plan_scales(Canvas& canvas, const figure::Plan& plan, const PlanFit& fit) {
  const double y = fit.area.bottom - 12.0;
  const double x = scale_bar(canvas, {fit.area.left + 10.0, y}, fit.scale, text_in(plan.unit));
  if (fit.newton > 0.0) scale_bar(canvas, {x, y}, fit.newton, force_text);
}

std::string description(const figure::Plan& plan) {
  std::string text = plan.title;
  const auto add = [&](const std::string& label, const std::string& value) {
    if (!label.empty()) text += (text.empty() ? "" : "; ") + say("{1} = {2}", plain(label), value).text();
  };
  for (const auto& v : plan.vectors) add(v.label, text_in(plan.unit)(length(v.to - v.from)));
  for (const auto& p : plan.points) add(p.name, text_in(plan.unit)(length(p.at)));
  for (const auto& f : plan.forces) add(f.label, force_text(length(f.force)));
  return text;
}

}  // namespace loadpath::draw
