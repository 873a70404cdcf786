// SPDX-License-Identifier: MIT
#include "tools/driver/report/cost_style.hpp"

#include <string_view>

#include "tools/driver/chart/paint.hpp"

namespace cobble::driver {
namespace {

constexpr std::string_view kLight = R"(:root {
  --paper: #ffffff; --ink: #1a1a1a; --soft: #555555; --line: #d0d0d0; --shade: #f2f4f7;
  --accent: #0072b2;
}
* { box-sizing: border-box }
body {
  margin: 0 auto; max-width: 76rem; padding: 1rem 1.25rem 3rem;
  background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial,
    "DejaVu Sans", sans-serif;
}
h1 { margin: .5rem 0 .25rem; font-size: 1.75rem; line-height: 1.2 }
h2 { margin: 2.5rem 0 .75rem; font-size: 1.3rem; line-height: 1.2 }
h3 { margin: 0; font-size: 1rem }
p { max-width: 70ch }
header p, .note, .missing { color: var(--soft) }
header p { margin-top: 0; overflow-wrap: anywhere }
a { color: var(--accent) }
#recommendation {
  margin-top: 1rem; padding: 1rem 1.25rem; background: var(--shade);
  border-left: .3rem solid var(--accent);
}
#recommendation h2 { margin: 0 0 .25rem; font-size: 1.1rem }
#recommendation p { margin: 0; font-size: 1.1rem }
nav ul { display: flex; flex-wrap: wrap; gap: .25rem 1.25rem; margin: 1rem 0 0; padding: 0 }
nav li { list-style: none }
figure { margin: 0 }
.chart, .scroll { overflow-x: auto }
/* Letters stay readable on narrow screens, where the chart scrolls. */
.chart svg { display: block; width: 100%; min-width: 38rem; max-width: 60rem; height: auto }
.chart:focus-visible, .scroll:focus-visible { outline: .15rem solid var(--accent) }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
/* For those who hear the page: those who see it read the heading above. */
caption { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%) }
th, td { padding: .3rem .75rem; border-bottom: 1px solid var(--line); text-align: right;
  vertical-align: top; white-space: nowrap }
th.words, td.words { text-align: left }
td.words:last-child { white-space: normal; min-width: 12rem }
thead th { border-bottom: 2px solid var(--ink) }
tbody th { font-weight: 600 }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(17rem, 100%), 1fr));
  gap: 1.5rem 1rem }
.cards img { display: block; width: 100%; height: auto; margin-top: .5rem }
.cards dl { display: flex; flex-wrap: wrap; gap: 0 1rem; margin: .25rem 0 0;
  font-variant-numeric: tabular-nums }
.cards dl div { display: flex; gap: .35rem }
.cards dt, .key { color: var(--soft) }
.cards dd { margin: 0 }
.key { max-width: none; display: flex; flex-wrap: wrap; align-items: center; gap: .25rem .6rem }
.key img { width: 12rem; height: .9rem }
.terms { display: grid; grid-template-columns: max-content 1fr; gap: .3rem 1.25rem }
.terms dt { font-weight: 600 }
.terms dd { margin: 0; max-width: 70ch }
)";

constexpr std::string_view kDark = R"(@media screen and (prefers-color-scheme: dark) {
  :root {
    --paper: #15171c; --ink: #e8e6e3; --soft: #b3b1ad; --line: #454a54; --shade: #20242c;
    --accent: #56b4e9;
  }
)";

constexpr std::string_view kPrint = R"(@media print {
  body { max-width: none; padding: 0; font-size: 10pt }
  nav { display: none }
  h2 { break-after: avoid }
  figure, tr, #recommendation { break-inside: avoid }
  .chart, .scroll { overflow: visible }
  .chart svg { min-width: 0 }
  .cards { grid-template-columns: repeat(2, 1fr) }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact }
}
)";

}  // namespace

std::string cost_style() {
    return std::string(kLight) + std::string(kDark) + chart::dark_rules(".chart", "  ") + "}\n" +
           std::string(kPrint);
}

}  // namespace cobble::driver
