#include "lib/draw/tikz.hpp"

#include "lib/draw/tikz/writer.hpp"

namespace loadpath::draw {

std::string tikz(const figure::Figure& figure) { return tikz(picture(figure)); }

}  // namespace loadpath::draw
