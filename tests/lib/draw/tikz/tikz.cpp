#include "lib/draw/tikz/style.hpp"
#include "lib/draw/tikz/writer.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <string>

using namespace loadpath::draw;
using namespace loadpath::figure;

namespace {

/// The text between the frame of a picture and its end.
std::string drawn(const Canvas& canvas) {
  const std::string all = tikz({canvas, 100.0, ""});
  const std::string frame =
      "\\begin{tikzpicture}[lp picture]\n\\path[use as bounding box,clip] (0,0) rectangle (480,100);\n";
  const std::string foot = "\\end{tikzpicture}";
  REQUIRE(all.starts_with(frame));
  REQUIRE(all.ends_with(foot));
  return all.substr(frame.size(), all.size() - frame.size() - foot.size());
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("figures in LaTeX") {
  TEST_CASE("every element of a picture has its command") {
    Canvas canvas;
    canvas.line("light dash", {0.0, 1.5}, {10.0, 20.25});
    canvas.polygon("pin", {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}});
    canvas.circle("dot", {5.0, 6.0}, 2.5);
    canvas.arc("c1 force", {10.0, 10.0}, 4.0, 0.0, std::numbers::pi / 2.0);
    canvas.rectangle("image", {1.0, 2.0, 3.0, 4.0});
    canvas.dots("front", {{7.0, 8.0}});
    CHECK(drawn(canvas) ==
          "\\path[lp light,lp dash] (0,1.5) -- (10,20.25);\n"
          "\\path[lp pin] (0,0) -- (1,0) -- (1,1) -- cycle;\n"
          "\\path[lp dot] (5,6) circle[radius=2.5];\n"
          "\\path[lp force,lp c1] (14,10) arc[start angle=0,delta angle=-90,radius=4];\n"
          "\\path[lp image] (1,2) rectangle (3,4);\n"
          "\\path[lp front] (7,8) -- (7,8);\n");
  }

  TEST_CASE("symbols are mathematics, words are not read as markup, a halo goes around them") {
    Canvas canvas;
    canvas.text("quiet", {1.0, 2.0}, typeset("tau_adm"), Anchor::end);
    canvas.text("halo f1", {3.0, 4.0}, typeset("5 % {a}"), Anchor::middle, true);
    CHECK(drawn(canvas) ==
          "\\node[lp words,lp words quiet,anchor=base east] at (1,2) {$τ$\\textsubscript{adm}};\n"
          "\\node[lp words,lp words f1,anchor=base,rotate=90] at (3,4) {\\lphalo{5 \\% \\{a\\}}};\n");
  }

  TEST_CASE("elements that are hidden until a script shows them are not drawn") {
    Canvas canvas;
    canvas.begin_group({{"visibility", "hidden"}});
    canvas.begin_group({{"data-at", "1"}});
    canvas.circle("dot", {}, 1.0);
    canvas.text("", {}, typeset("a"));
    canvas.end_group();
    canvas.line("thin", {}, {1.0, 1.0});
    canvas.end_group();
    canvas.begin_group({{"visibility", "visible"}});
    canvas.circle("solid", {}, 1.0);
    canvas.end_group();
    CHECK(drawn(canvas) == "\\path[lp solid] (0,0) circle[radius=1];\n");
  }

  TEST_CASE("no path and no length is too long for TeX") {
    Canvas canvas;
    canvas.dots("front", std::vector<Point>(450, {1.0, 1.0}));
    canvas.line("thin", {-1e9, 0.0}, {1e9, 0.0});
    const std::string text = drawn(canvas);
    std::size_t paths = 0;
    for (std::size_t at = text.find("\\path"); at != std::string::npos; at = text.find("\\path", at + 1)) ++paths;
    CHECK(paths == 4);
    CHECK(contains(text, "(-5000,0) -- (5000,0)"));
  }

  TEST_CASE("the styles agree with the style sheet of pages") {
    const std::string styles = tikz_styles();
    for (const std::string_view line :
         {"\\definecolor{lpaccent2}{HTML}{B4451C}\n",
          "  lp bound/.style={draw=lpink,line width=.98bp,dash pattern=on 5.25bp off 3bp},\n",
          "  lp area/.style={draw=none,fill opacity=.13},\n",
          "  lp words quiet/.style={text=lpmuted,font=\\sffamily\\fontsize{9bp}{10.8bp}\\selectfont},\n",
          " w 1 j 1 Tr}"}) {
      CAPTURE(line);
      CHECK(contains(styles, line));
    }
  }
}
