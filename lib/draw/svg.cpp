#include "lib/draw/svg.hpp"

#include "lib/draw/canvas/svg_writer.hpp"
#include "lib/draw/page.hpp"
#include "lib/draw/shaft.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::draw {

Picture picture(const figure::Figure& figure) {
  return std::visit([](const auto& content) { return picture(content); }, figure.content);
}

std::string svg(const figure::Figure& figure) {
  const auto* const shaft = std::get_if<figure::Shaft>(&figure.content);
  return svg_file(shaft == nullptr ? picture(figure) : picture_in_file(*shaft), say(figure.caption).text());
}

double proportion(const figure::Figure& figure) {
  const Picture drawn = picture(figure);
  return drawn.height / drawn.width;
}

std::string svg_in_page(const figure::Figure& figure) { return svg_part(picture(figure), say(figure.caption).text()); }

}  // namespace loadpath::draw
