#include "lib/embedded.hpp"
#include "lib/report/base64.hpp"
#include "lib/report/html.hpp"

#include <algorithm>

namespace loadpath::report::page {
namespace {

constexpr std::string_view colours = R"css(
:root{color-scheme:light dark;--ink:#1a1d21;--muted:#5b626b;--grid:#d9dde2;--rule:#1a1d21;--paper:#fff;--tint:#f5f6f8;
--accent:#0b5fa5;--accent2:#b4451c;--accent3:#2a7a48;--pass:#1f7a3d;--fail:#b3261e;--open:#8a5a00;--mark:#fff}
@media screen and (prefers-color-scheme:dark){:root{--ink:#e4e6e9;--muted:#a2a9b2;--grid:#3a4048;--rule:#aab0b8;
--paper:#15181c;--tint:#1f2429;--accent:#7db8ec;--accent2:#f0986f;--accent3:#7cc795;--pass:#7cc795;--fail:#ff8a80;
--open:#e6b455;--mark:#15181c}}
)css";

constexpr std::string_view text = R"css(
*{box-sizing:border-box}
html{font:17px/1.5 "Source Serif 4",Charter,"Iowan Old Style",Cambria,"STIX Two Text",STIX,"Liberation Serif","Times New Roman",serif;
color:var(--ink);background:var(--paper);-webkit-text-size-adjust:100%}
body{margin:0}
main{max-width:50rem;margin:0 auto;padding:3.5rem 1.5rem 5rem}
p{margin:.6rem 0;max-width:40rem;overflow-wrap:anywhere}
h1,h2,h3{line-height:1.2;font-weight:600;text-wrap:balance;overflow-wrap:anywhere;break-after:avoid}
h1{font-size:2rem;margin:0 0 1rem}
h2{font-size:1.4rem;margin:3rem 0 .8rem}
h3{font-size:1.1rem;margin:1.9rem 0 .5rem}
.no{margin-right:.45em;color:var(--muted);font-variant-numeric:lining-nums}
a{color:var(--accent);text-decoration:none}
a:hover{text-decoration:underline}
small,.note,.why,figcaption,.caption,nav,.meta{font-size:.86rem}
small,.note,.why,.bound{color:var(--muted)}
code{font:.86em ui-monospace,"DejaVu Sans Mono",Menlo,Consolas,monospace;overflow-wrap:anywhere}
.meta{display:flex;flex-wrap:wrap;gap:.2rem 2.2rem;margin:0 0 1.6rem;padding:.6rem 0;border:solid var(--grid);border-width:1px 0}
.meta div{display:flex;gap:.5em}
.meta dt{color:var(--muted)}
.meta dd{margin:0;overflow-wrap:anywhere}
nav{margin:2rem 0}
nav ol{list-style:none;margin:0;padding:0;columns:18rem 2;column-gap:2rem}
.warning{border-left:3px solid var(--open);padding:.15rem 0 .15rem .9rem}
.warning b{color:var(--open)}
)css";

constexpr std::string_view tables = R"css(
.table{margin:1.2rem 0 1.5rem}
.caption{margin:0 0 .35rem;break-after:avoid}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:.92rem;line-height:1.35;font-variant-numeric:lining-nums tabular-nums}
.scroll>table{border:solid var(--rule);border-width:1.6px 0}
thead th{border-bottom:1px solid var(--rule)}
th{font-weight:400;font-style:italic;text-align:left;vertical-align:bottom}
th,td{padding:.32rem 1rem .32rem 0}
td{vertical-align:baseline}
.dense{font-size:.86rem}
.dense th,.dense td{padding-right:.65rem}
th:last-child,td:last-child{padding-right:0}
tbody tr+tr td{border-top:1px solid var(--grid)}
tbody td:empty{height:2.4rem;min-width:6rem}
.number{text-align:right}
.quantity,.state,.where{white-space:nowrap}
.where{color:var(--muted);font-size:.86em}
.verdicts{margin:.4rem 0}
.verdicts .bound{font-size:.86rem}
.bar{display:block;position:relative;width:8rem;height:.42rem;margin:.3rem 0 .15rem auto;background:var(--grid)}
.bar>span{display:block;height:100%;max-width:100%}
.bar::after{content:"";position:absolute;left:80%;top:-.2rem;bottom:-.2rem;border-left:1.5px solid var(--ink)}
.bar .pass{background:var(--pass)}
.bar .fail{background:repeating-linear-gradient(135deg,var(--fail) 0 5px,transparent 5px 7px)}
.shapes{position:absolute}
.shape{width:1em;height:1em;margin-right:.4em;vertical-align:-.13em}
.body{fill:currentColor}
.mark{fill:none;stroke:var(--mark);stroke-width:1.9;stroke-linecap:round;stroke-linejoin:round}
.ring,.dash{fill:none;stroke:currentColor;stroke-width:1.5}
.ring{stroke-dasharray:2.4 2}
.state.pass{color:var(--pass)}
.state.fail{color:var(--fail);font-weight:600}
.state.not-covered{color:var(--open)}
.state.not-available{color:var(--muted)}
.conclusion{display:flex;flex-wrap:wrap;gap:.1rem 1rem;align-items:baseline;max-width:none;margin:0 0 1.2rem}
.conclusion .state{font-size:1.3rem;font-weight:600}
)css";

constexpr std::string_view formulas = R"css(
math{font-family:"Loadpath Math","STIX Two Math","Cambria Math",math}
mtable.cases mtd{text-align:left;padding:.14em .6em .14em 0}
.derivation{margin:.9rem 0 1.3rem}
.step{display:grid;grid-template-columns:minmax(0,1fr) 11.5rem;column-gap:1.8rem;align-items:baseline;padding:.34rem 0;
break-inside:avoid}
.step.wide{grid-template-columns:minmax(0,1fr)}
.wide .why{padding-left:3.75rem}
.formula{display:grid;grid-template-columns:minmax(3.4rem,max-content) minmax(0,1fr);column-gap:.35rem;align-items:baseline}
.left{text-align:right;white-space:nowrap}
.right{overflow-x:auto;overflow-y:hidden}
.right math{margin-block:.18rem}
.numbers{display:inline-block;max-width:100%}
.why{margin:0;line-height:1.35}
figure{margin:1.8rem 0;break-inside:avoid}
figure svg{display:block;max-width:100%;height:auto}
figcaption{margin-top:.5rem;max-width:40rem}
.pictures{display:flex;flex-wrap:wrap;gap:.4rem 1.2rem;align-items:flex-start}
.scheme{flex:2 1 26rem;min-width:0}
.plan{flex:1 1 14rem;min-width:0;max-width:19rem}
.scheme svg{width:100%}
.plan-of{margin:0;font-size:.86rem;color:var(--muted)}
.plan-of span{color:var(--ink)}
.numbers-now{width:auto;margin-top:.5rem}
.numbers-now td{padding:.14rem .7rem .14rem 0}
.numbers-now .number{min-width:4.5rem}
.controls{display:flex;flex-wrap:wrap;gap:.5rem 1.1rem;align-items:center;margin-bottom:.8rem;
font:.82rem "Helvetica Neue",Arial,"Liberation Sans",sans-serif}
.controls[hidden]{display:none}
.controls label{display:flex;gap:.5em;align-items:center}
.controls .slide{flex:1 1 14rem}
.controls input{flex:1;min-width:6rem;accent-color:var(--accent)}
.controls button,.controls select{font:inherit;color:var(--ink);background:var(--tint);border:1px solid var(--muted);
border-radius:3px;padding:.3em .7em}
.controls button{min-width:4.6em}
)css";

constexpr std::string_view narrow = R"css(
@media screen and (max-width:46rem){
html{font-size:16px}
main{padding:1.6rem 1rem 3rem}
h1{font-size:1.6rem}
h2{font-size:1.25rem;margin-top:2.3rem}
.step{grid-template-columns:minmax(0,1fr)}
.step .why{padding:0 0 .25rem}
.formula{grid-template-columns:minmax(2rem,max-content) minmax(0,1fr)}
.left{text-align:left}
.table table{width:auto;min-width:100%}
.verdicts thead{display:none}
.verdicts tr{display:grid;grid-template-columns:minmax(0,1fr) auto;padding:.45rem 0;column-gap:1rem}
.verdicts tr+tr{border-top:1px solid var(--grid)}
.verdicts tbody td{padding:.1rem 0;border:0}
.verdicts .subject{grid-column:1/3}
.verdicts .number{text-align:left;grid-row:2}
.verdicts .bar{display:inline-block;width:6.5rem;margin:0 0 .1rem .7rem}
.verdicts .bound{grid-row:3;grid-column:1/3}
.plan{max-width:14rem}
}
)css";

constexpr std::string_view print = R"css(
@media print{
html{font-size:10.5pt}
main{max-width:none;padding:0}
h2{margin-top:1.8rem}
a{color:inherit}
.scroll,.right{overflow:visible}
.bar,.bar span,.shape{print-color-adjust:exact;-webkit-print-color-adjust:exact}
.small .formula{font-size:.8em}
thead{display:table-header-group}
tr,.caption,.warning{break-inside:avoid}
p{orphans:3;widows:3}
figure{max-width:13cm}
figure.moving{max-width:none}
.controls{display:none!important}
}
)css";

/// A CSS string: whatever is not a letter or digit is written as its code, so that nothing ends the string or the
/// sheet.
std::string quoted(std::string_view words) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ';
    if (letter || byte >= 0x80) {
      out += c;
    } else if (byte >= 0x20 && byte != 0x7f) {
      out += std::string("\\") + digits[byte >> 4] + digits[byte & 15] + " ";
    }
  }
  return out + "\"";
}

std::string page_rules(std::string_view header, std::string_view footer) {
  const std::string face =
      "font:9pt Cambria,\"STIX Two Text\",STIX,\"Liberation Serif\",\"Times New Roman\",serif;color:#5b626b;";
  return "@page{size:A4;margin:21mm 19mm 20mm;@top-left{" + face + "content:" + quoted(header) + "}@bottom-left{" +
         face + "content:" + quoted(footer) + "}@bottom-right{" + face +
         "content:counter(page) \" / \" counter(pages)}}\n@page:first{@top-left{content:none}}\n";
}

std::string math_font() {
  const auto files = embedded::fonts();
  if (files.empty()) return {};
  return "@font-face{font-family:\"Loadpath Math\";src:url(data:font/woff2;base64," + base64(files.front().text) +
         ") format(\"woff2\")}\n";
}

}  // namespace

std::string style(std::string_view header, std::string_view footer) {
  std::string css = math_font();
  for (const std::string_view part : {colours, text, tables, formulas, narrow, print}) css += part.substr(1);
  return css + page_rules(header, footer);
}

}  // namespace loadpath::report::page
