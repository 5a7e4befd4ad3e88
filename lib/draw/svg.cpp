#include "lib/draw/canvas/picture.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::draw {

std::string svg(const Figure& figure) {
  const Picture drawn = std::visit([](const auto& content) { return picture(content); }, figure.content);
  return drawn.svg.document(drawn.height, say(figure.caption).text(), drawn.description);
}

}  // namespace loadpath::draw
