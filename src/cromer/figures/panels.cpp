#include "cromer/figures/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "cromer/base/nearest.h"

namespace cromer::core {
namespace {

constexpr std::array<std::string_view, 4> names{"position", "velocity", "energy", "phase"};

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string_view>& words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list.append(i == 0 ? "" : i + 1 == words.size() ? " and " : ", ").append(words[i]);
  return list;
}

}  // namespace

Result<std::vector<MotionPanel>> parse_panels(std::string_view text) {
  std::vector<MotionPanel> panels;
  if (text.empty()) return std::vector{MotionPanel::position};
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    std::string_view name = text.substr(from, comma - from);
    from = comma + 1;
    while (name.starts_with(' ')) name.remove_prefix(1);
    while (name.ends_with(' ')) name.remove_suffix(1);
    const auto found = std::find(names.begin(), names.end(), name);
    const std::vector<std::string> all(names.begin(), names.end());
    if (found == names.end()) {
      if (const std::string near = nearest(name, names); !near.empty())
        return Error{"no_panel_but", {{"panel", name}, {"near", near}, {"panels", all}}};
      return Error{"no_panel", {{"panel", name}, {"panels", all}}};
    }
    const auto panel = static_cast<MotionPanel>(found - names.begin());
    if (std::find(panels.begin(), panels.end(), panel) != panels.end())
      return Error{"panel_twice", {{"panel", name}}};
    panels.push_back(panel);
  }
  return panels;
}

std::string panels_in_words(std::span<const MotionPanel> panels) {
  std::vector<std::string_view> of_time;
  for (const MotionPanel panel : panels)
    if (panel != MotionPanel::phase) of_time.push_back(names[static_cast<std::size_t>(panel)]);
  std::string words = of_time.empty() ? "" : listed(of_time) + " against time";
  if (of_time.size() < panels.size()) words += words.empty() ? "phase portrait" : " and the phase portrait";
  words.front() = static_cast<char>(words.front() - 'a' + 'A');
  return words;
}

EnergyUnit energy_unit(double largest) {
  constexpr EnergyUnit units[] = {{"J", 1}, {"mJ", 1e-3}};
  for (const EnergyUnit& unit : units)
    if (largest >= unit.joules) return unit;
  return {"µJ", 1e-6};
}

TimeUnit time_unit(double duration) {
  if (!(duration > 0 && duration < 0.5)) return {"s", 1};
  return duration >= 5e-4 ? TimeUnit{"ms", 1e-3} : TimeUnit{"µs", 1e-6};
}

std::string short_name(std::string_view file) {
  constexpr std::size_t longest = 34, end = 14;
  const auto slash = file.find_last_of('/');
  std::string name(slash == std::string_view::npos ? file : file.substr(slash + 1));
  if (name.size() <= longest) return name;
  // Do not cut a UTF-8 character.
  const auto inside = [&](std::size_t i) { return (static_cast<unsigned char>(name[i]) & 0xC0) == 0x80; };
  std::size_t front = longest - end - 1, back = name.size() - end;
  while (front > 0 && inside(front)) --front;
  while (back < name.size() && inside(back)) ++back;
  return name.substr(0, front) + "…" + name.substr(back);
}

std::string samples_in_words(std::size_t samples) {
  return fmt::format("{} sample{}", samples, samples == 1 ? "" : "s");
}

std::size_t end_of_line(const std::vector<double>& t, const std::vector<double>& values, double height,
                        double period) {
  const auto leaves =
      std::find_if(values.begin(), values.end(), [&](double value) { return std::abs(value) > height; });
  if (leaves == values.end()) return values.size();
  const double last = t[static_cast<std::size_t>(leaves - values.begin())] + 2 * period;
  return static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), last) - t.begin());
}

void move_names_to_key(Figure& figure) {
  for (Panel& panel : figure.panels)
    for (Curve& curve : panel.curves) {
      const bool known = std::any_of(figure.key.begin(), figure.key.end(),
                                     [&](const Curve& each) { return each.role == curve.role; });
      if (!curve.name.empty() && !known) {
        Curve& look = figure.key.emplace_back(curve);
        look.x.clear(), look.y.clear();
      }
      curve.name = curve.remark = "";
    }
}

PortraitPart portrait_part(double begin, double end, double period) {
  constexpr double first = 5, last = 3, most = 20;  // periods
  if (!(period > 0) || end - begin <= most * period)
    return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            "Phase portrait"};
  return {begin + first * period, end - last * period,
          fmt::format("Phase portrait of the first {:g} and the last {:g} periods", first, last)};
}

void set_portrait_size(Figure& figure) {
  if (figure.panels.size() != 1 || !figure.panels.front().phase_portrait) return;
  figure.size = FigureSize::phase;
  figure.panels.front().names_listed = false;
}

}  // namespace cromer::core
