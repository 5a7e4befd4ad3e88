// A mechanism that moves: pictures of the printed position, its numbers, and the controls if scripts run.
#include "lib/draw/motion/motion.hpp"

#include "lib/draw/motion/numbers.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/html/html.hpp"
#include "lib/text/markup.hpp"

namespace loadpath::report::page {
namespace {

using figure::Motion;

std::string number_row(const Motion::Number& number, std::size_t frame, const std::string& mark) {
  return "<tr title=\"" + escaped(say(number.meaning).text()) + "\"><td>" + symbol(number.symbol) +
         "</td><td class=\"number\" " + mark + ">" + draw::printed(draw::number_text(number, frame)) + "</td><td>" +
         escaped(pretty_unit(number.unit)) + "</td></tr>\n";
}

std::string numbers(const Motion& motion) {
  std::string out = "<table class=\"numbers-now\"><tbody>\n" + number_row(motion.axis, motion.shown, "data-axis");
  for (std::size_t n = 0; n < motion.numbers.size(); ++n)
    out += number_row(motion.numbers[n], motion.shown, "data-number=\"" + std::to_string(n) + "\"");
  return out + "</tbody></table>\n";
}

std::string plan_choice(const Motion& motion) {
  if (motion.plans.empty()) return {};
  std::string out = "<label>" + escaped(say("force plan of").text()) + " <select>";
  for (std::size_t k = 0; k < motion.plans.size(); ++k) {
    out += std::string("<option") + (k == motion.shown_plan ? " selected>" : ">") + escaped(motion.plans[k].link) +
           "</option>";
  }
  return out + "</select></label>";
}

/// Without scripts it stays hidden; it is not printed.
std::string controls(const Motion& motion) {
  const std::string axis = escaped(say(motion.axis.meaning).text());
  return "<div class=\"controls\" hidden><button type=\"button\" data-pause=\"" + escaped(say("Pause").text()) + "\">" +
         escaped(say("Play").text()) + "</button><label class=\"slide\">" + axis +
         " <input type=\"range\" min=\"0\" max=\"" + std::to_string(motion.axis.si.size() - 1) + "\" value=\"" +
         std::to_string(motion.shown) + "\" data-unit=\"" + escaped(with_unit({}, pretty_unit(motion.axis.unit))) +
         "\"></label>" + plan_choice(motion) + "</div>\n";
}

}  // namespace

std::string motion(const figure::Figure& figure) {
  const auto& content = std::get<Motion>(figure.content);
  const draw::MotionPictures pictures = draw::motion_pictures(figure);
  std::string out = "<div class=\"motion\">\n" + controls(content) + "<div class=\"pictures\"><div class=\"scheme\">" +
                    pictures.scheme + "</div>";
  out += "<div class=\"plan\">";
  if (!pictures.plan.empty()) {
    out += "<p class=\"plan-of\">" + escaped(say("Force plan of").text()) + " <span>" +
           escaped(content.plans[content.shown_plan].link) + "</span></p>" + pictures.plan;
  }
  return out + numbers(content) + "</div></div>\n<script type=\"application/json\">" + pictures.data +
         "</script>\n</div>\n";
}

}  // namespace loadpath::report::page
