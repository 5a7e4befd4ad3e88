#include "lib/figure/drawing.hpp"

namespace loadpath::figure {

Drawing::View::View() = default;
Drawing::View::View(const View&) = default;
Drawing::View::View(View&&) noexcept = default;
Drawing::View& Drawing::View::operator=(const View&) = default;
Drawing::View& Drawing::View::operator=(View&&) noexcept = default;
Drawing::View::~View() = default;

}  // namespace loadpath::figure
