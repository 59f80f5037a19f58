// The style sheet of a report.
#include <set>
#include <string_view>

#include "cromer/report/page.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

// Typography, size and line height in px: 34/41 title, 17.5/28 summary, 16/25 text, 20/27 headings, 14/21
// captions; a grid of 4 px; column 860 px.
constexpr std::string_view layout = R"css(
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%;text-size-adjust:100%}
body{margin:0;background:var(--ground);color:var(--ink);font:16px/25px "Segoe UI",-apple-system,Roboto,"Noto Sans",Lato,system-ui,sans-serif;
font-variant-numeric:tabular-nums lining-nums;overflow-wrap:break-word}
main,header,footer{max-width:908px;margin:0 auto;padding:0 24px}
header{padding-top:48px}
h1{font-size:34px;line-height:41px;font-weight:700;letter-spacing:-.01em;margin:0 0 12px;text-wrap:balance}
h2{font-size:20px;line-height:27px;font-weight:700;margin:40px 0 8px;break-after:avoid}
h2 .number{display:inline-block;min-width:14px;margin-right:8px}
p{margin:0 0 12px}
.byline{color:var(--text-2);font-size:14.5px;line-height:21px;margin:0 0 24px}
.summary p{font-size:17.5px;line-height:28px}
code{font-family:ui-monospace,Menlo,Consolas,"DejaVu Sans Mono",monospace;font-size:.86em;display:inline-block}
sub,sup{font-size:.72em;line-height:0}
.both{display:inline-block;vertical-align:-.36em;line-height:1}
.both sup,.both sub{display:block;font-size:.66em;line-height:1.06;vertical-align:baseline}
.key{display:flex;flex-wrap:wrap;border-top:1px solid var(--ink);border-bottom:1px solid var(--line);margin:20px 0 28px;overflow:hidden}
.key>div{flex:1 1 176px;padding:12px 16px 14px 18px;margin-left:-1px;border-left:1px solid var(--line)}
.key>div:first-child:nth-last-child(5),.key>div:first-child:nth-last-child(5)~div{flex-basis:30%}
.key>div:first-child:nth-last-child(5)~div:nth-child(4){padding-left:0}
.key>div:first-child{padding-left:0}
.key dt,.key .remark{font-size:13px;line-height:19px;color:var(--text-2)}
.key dd{margin:0}
.key .value{font-size:21px;line-height:28px;font-weight:700;white-space:nowrap}
.table{margin:28px 0}
.table .scroll{overflow-x:auto}
.caption,figcaption{font-size:14px;line-height:21px;color:var(--ink);margin:0 0 8px}
table{width:100%;border-collapse:collapse;font-size:15px;line-height:22px;border-top:1px solid var(--ink);border-bottom:1px solid var(--ink)}
th,td{padding:4px 0 4px 26px;text-align:right;vertical-align:middle;border-top:1px solid var(--line);white-space:nowrap}
thead th{border-bottom:1px solid var(--ink);border-top:0;font-size:14px;font-weight:600;vertical-align:bottom}
tbody tr:first-child>*{border-top:0}
th:first-child,td:first-child{padding-left:0}
th.words,td.words{text-align:left}
tbody th{font-weight:400}
td[rowspan]{vertical-align:top}
td.words{font-size:13.5px;color:var(--text-2);white-space:normal;min-width:120px}
td.words:first-child,th.words:first-child{white-space:normal;min-width:150px}
.answer{font-weight:700}
figure{margin:28px 0;break-inside:avoid}
figure svg{display:block;width:100%;height:auto;font-family:inherit}
figcaption{margin:4px 0 0}
.pair{display:grid;grid-template-columns:1fr 1fr;gap:24px 20px;margin:28px 0}
.pair figure{margin:0}
.pair figure.sole{grid-column:1/-1;max-width:420px}
pre{background:var(--sunk);border:1px solid var(--line);border-radius:6px;padding:12px 16px;margin:0 0 16px;overflow-x:auto;font-size:13.5px;line-height:20px}
pre code{font-size:inherit;display:inline}
.skip{position:absolute;left:-9999px}
.skip:focus{left:24px;top:8px;background:var(--ground);color:var(--ink);padding:4px 8px;outline:2px solid var(--focus);outline-offset:2px}
:focus-visible{outline:2px solid var(--focus);outline-offset:2px}
footer{margin-top:48px;padding-bottom:40px;color:var(--text-3);font-size:13px;line-height:19px}
footer>div{border-top:1px solid var(--line);padding-top:12px}
@media (max-width:640px){
main,header,footer{padding-left:16px;padding-right:16px}
header{padding-top:28px}
h1{font-size:27px;line-height:33px}
.summary p{font-size:16.5px;line-height:26px}
.key{display:grid;grid-template-columns:1fr 1fr}
.key>div,.key>div:first-child{padding:10px 8px 10px 0;margin-left:0;border-left:0}
.key .value{font-size:17px;white-space:normal}
.pair{grid-template-columns:1fr;gap:24px}
figure.wide svg{min-width:200%}
figure.wide{overflow-x:auto}
figure.wide::before{content:"scroll sideways \2192";display:block;position:sticky;left:0;width:max-content;color:var(--text-3);font-size:12px}
.table .scroll{background:linear-gradient(90deg,var(--ground) 40%,transparent) 0 0/40px 100% no-repeat local,linear-gradient(270deg,var(--ground) 40%,transparent) 100% 0/40px 100% no-repeat local,linear-gradient(90deg,var(--line),transparent) 0 0/14px 100% no-repeat scroll,linear-gradient(270deg,var(--line),transparent) 100% 0/14px 100% no-repeat scroll}
th,td{padding-left:16px}
td.words:first-child,th.words:first-child{min-width:110px}
td.words{min-width:170px}
}
@media print{
@page{margin:18mm 16mm}
body{font-size:10.5pt;line-height:15pt}
main,header,footer{max-width:none;padding-left:0;padding-right:0}
header{padding-top:0}
h1{font-size:20pt;line-height:25pt}
.summary p{font-size:11.5pt;line-height:17pt}
.skip{display:none}
.table,pre,.key{break-inside:avoid}
pre{white-space:pre-wrap}
table{font-size:9.5pt;line-height:14pt}
}
)css";

void add_surface(std::string& css, const SurfaceColours& s, std::string_view sunk, std::string_view line,
                 std::string_view focus) {
  const auto add = [&](std::string_view name, std::string_view value) {
    css.append("--").append(name).append(":").append(value).append(";");
  };
  css += ":root{";
  add("ground", s.ground), add("ink", s.ink), add("text-2", s.text_2), add("text-3", s.text_3);
  add("sunk", sunk), add("line", line), add("focus", focus);
  css += "}\n";
}

// Figures are drawn for a light ground; in the dark each colour of theirs is exchanged for its partner.
void add_dark_figures(std::string& css) {
  std::set<std::string_view> done;
  const auto exchange = [&](std::string_view light, std::string_view dark) {
    if (!done.insert(light).second) return;
    for (const std::string_view property : {"stroke", "fill"}) {
      css.append("svg [")
          .append(property)
          .append("=\"")
          .append(light)
          .append("\"]{")
          .append(property)
          .append(":")
          .append(dark)
          .append("}\n");
    }
  };
  const SurfaceColours &l = light_surface, &d = dark_surface;
  exchange(l.ground, d.ground), exchange(l.ink, d.ink), exchange(l.text_2, d.text_2),
      exchange(l.text_3, d.text_3);
  exchange(l.axis, d.axis), exchange(l.grid, d.grid), exchange(l.zero_line, d.zero_line);
  for (const RoleStyle& role : palette())
    exchange(role.line, role.line_dark), exchange(role.word, role.word_dark);
}

}  // namespace

std::string page_style() {
  std::string css = ":root{color-scheme:light dark}\n";
  add_surface(css, light_surface, "#EEF0F3", "#DFE3E8", "#2457D6");
  css += layout;
  css += "@media screen and (prefers-color-scheme:dark){\n";
  add_surface(css, dark_surface, "#10151B", "#2A323D", "#8FB4FF");
  add_dark_figures(css);
  css += "}\n";
  return css;
}

}  // namespace cromer::core
