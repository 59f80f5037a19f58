#include <fmt/format.h>

#include "cromer/report/figure.h"
#include "cromer/report/process.h"
#include "cromer/report/tidy_svg.h"

namespace cromer {
namespace {

// Lato where fontconfig has it; asked once. Without an answer the wider DejaVu Sans, fontconfig's own
// stand-in.
Typeface installed_typeface() {
  static const Typeface found = [] {
    const auto match = run_process({"fc-match", "-f", "%{family}", "Lato"}, "");
    return match.ok() && match->exit_status == 0 && match->out.find("Lato") != std::string::npos
               ? Typeface::lato
               : Typeface::dejavu_sans;
  }();
  return found;
}

// The first line of gnuplot's complaint that says something.
std::string complaint(const std::string& text) {
  std::size_t start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string line = text.substr(start, end - start);
    if (line.find_first_not_of(" \t^") != std::string::npos) return line;
    start = end + 1;
  }
  return "it wrote no picture";
}

}  // namespace

Result<std::string> draw(const Figure& figure, FigureFormat format) {
  const Typeface typeface = format == FigureFormat::svg ? Typeface::dejavu_sans : installed_typeface();
  auto output = run_process({"gnuplot", "-d"}, gnuplot_script(figure, format, typeface));
  if (!output) {
    return Error{
        fmt::format("figures are drawn by gnuplot, which could not be run ({}): install it, for instance "
                    "with apt install gnuplot-nox",
                    output.error().message)};
  }
  if (output->exit_status != 0 || output->out.empty()) {
    const bool no_cairo = output->err.find("unknown or ambiguous terminal") != std::string::npos;
    return Error{
        fmt::format("gnuplot could not draw {}: {}{}", figure.id.empty() ? "the figure" : figure.id,
                    complaint(output->err),
                    no_cairo ? "; this gnuplot lacks that format, gnuplot-nox and gnuplot-qt have it" : "")};
  }
  if (format != FigureFormat::svg) return std::move(output->out);
  return tidy_svg(output->out, without_markup(figure.title.empty() ? figure.id : figure.title));
}

std::string gnuplot_version() {
  const auto answer = run_process({"gnuplot", "--version"}, "");
  if (!answer || answer->exit_status != 0) return "";
  return answer->out.substr(0, answer->out.find('\n'));
}

}  // namespace cromer
