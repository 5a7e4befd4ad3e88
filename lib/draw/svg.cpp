#include "lib/draw/figure.hpp"
#include "lib/draw/picture.hpp"
#include "lib/issue.hpp"

namespace loadpath::draw {

std::string svg(const Figure& figure) {
  const Picture drawn = std::visit([](const auto& content) { return picture(content); }, figure.content);
  return drawn.svg.document(drawn.height, say(figure.caption).text(), drawn.description);
}

}  // namespace loadpath::draw
