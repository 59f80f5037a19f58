// All that figures of small inputs hold, as it is written down in the tree.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "cromer/documents/words/words.h"
#include "cromer/figures/figures.h"
#include "cromer/tasks/network/network_file.h"
#include "tests/support/written_down.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using test::as_written;

void write(std::string& text, const Axis& axis) {
  text += fmt::format("  axis {}, {} to {} by {}{}\n", axis.name, as_written(axis.low), as_written(axis.high),
                      as_written(axis.step), axis.logarithmic ? ", logarithmic" : "");
}

void write(std::string& text, const Curve& curve) {
  text += fmt::format("  {} \"{}\" \"{}\" \"{}\" {}{}{}{}{}\n", curve.role, curve.name, curve.remark,
                      curve.remark_outside, static_cast<int>(curve.mark), curve.dashed ? " dashed" : "",
                      curve.with_dots ? " dots" : "", curve.road ? " road" : "",
                      curve.sets_axes ? "" : " beside");
  for (const auto& place : {curve.label_x, curve.label_y, curve.text_x, curve.text_y})
    if (place) text += "    at " + as_written(*place) + '\n';
  text += "    x " + as_written(curve.x) + "\n    y " + as_written(curve.y) + '\n';
}

std::string as_written(const Figure& figure) {
  std::string text =
      fmt::format("{}\n{}\n{}\n{}\nsize {}, {} in a row{}\n", figure.id, figure.title, figure.caption,
                  figure.note, static_cast<int>(figure.size), figure.columns, figure.shared_x ? ", x" : "");
  for (const Panel& panel : figure.panels) {
    text += fmt::format("panel {}: span {}{}{}{}{}\n", panel.title, panel.span,
                        panel.phase_portrait ? " portrait" : "", panel.names_inside ? " inside" : "",
                        panel.names_listed ? " listed" : "", panel.bare ? " bare" : "");
    write(text, panel.x);
    write(text, panel.y);
    for (const Curve& each : panel.curves) write(text, each);
    for (const Note& each : panel.notes)
      text += fmt::format("  note {} at {} {}, {} {}{}{}{}\n", each.text, as_written(each.x),
                          as_written(each.y), as_written(each.text_x), as_written(each.text_y),
                          each.circle ? " circle" : "", each.leader ? "" : " alone", each.dot ? " dot" : "");
    for (const Marker& each : panel.markers)
      text += fmt::format("  {} {} at {}\n", each.role, each.text, as_written(each.x));
    if (panel.map) {
      text += fmt::format("  map {}{}\n    x {}\n    y {}\n    z {}\n    reach {}\n", panel.map->name,
                          panel.map->decades ? ", decades" : "", as_written(panel.map->x),
                          as_written(panel.map->y), as_written(panel.map->z), as_written(panel.map->reach));
    }
  }
  for (const Curve& each : figure.key) write(text, each);
  return text + '\n';
}

void expect_figures_as_written_down(const std::string& text, const std::string& name) {
  test::expect_as_written_down(text, CROMER_SOURCE_DIR "/tests/figures/written_down/" + name + ".txt");
}

/// Options as they are typed: "mass 0.2, method rk4, method exact".
std::vector<TypedOption> typed(const std::string& line) {
  std::vector<TypedOption> options;
  for (std::size_t from = 0; from < line.size();) {
    const std::size_t end = std::min(line.find(", ", from), line.size()), blank = line.find(' ', from);
    options.push_back({line.substr(from, blank - from), line.substr(blank + 1, end - blank - 1)});
    from = end + 2;
  }
  return options;
}

TEST(FiguresWrittenDown, OfSweeps) {
  std::string text;
  const auto add = [&](const std::map<std::string_view, std::string>& values,
                       const std::vector<std::string>& measure, const std::string& direction = "") {
    SweepOptions options;
    options.values = values;
    options.measure = measure;
    if (!direction.empty()) options.direction = direction;
    const auto result = sweep(options);
    ASSERT_TRUE(result.ok());
    const auto figure = sweep_figure(*result);
    ASSERT_TRUE(figure);
    text += as_written(*figure);
  };
  add({{"damping-ratio", "0.02,0.1"}, {"drive-amplitude", "1"}, {"drive-frequency", "0.5:2:9"}},
      {"amplitude", "phase"});
  add({{"damping-ratio", "0.01:1:7:log"}, {"drive-amplitude", "1"}, {"drive-frequency", "0.5:2:4"}},
      {"amplitude", "phase"});
  add({{"damping", "0.1"}, {"drive-amplitude", "1"}, {"drive-frequency", "0.1:10:3:log"}}, {"amplitude"});
  add({{"damping", "0.1"}, {"drive-amplitude", "1"}, {"drive-frequency", "1,10"}}, {"peak", "rms"});
  add({{"stiffness", "9"}, {"position", "3,2,1"}, {"until", "5"}}, {"final"});
  add({{"cubic", "0.05"}, {"damping", "0.1"}, {"drive-amplitude", "0.3"}, {"drive-frequency", "0.8:1.4:4"}},
      {"amplitude"}, "both");
  add({{"cubic", "0.01:0.1:6"},
       {"damping", "0.2"},
       {"drive-amplitude", "0.3"},
       {"drive-frequency", "0.8:1.4:3"}},
      {"amplitude"}, "both");
  add({{"cubic", "0.01,0.05"},
       {"damping", "0.2"},
       {"drive-amplitude", "0.3"},
       {"drive-frequency", "0.8:1.4:3"}},
      {"amplitude"}, "both");
  add({{"position", "-1:1:6"}, {"velocity", "-2:2:3"}, {"until", "3"}}, {"peak"});
  add({{"position", "0.5:1:6"}, {"stiffness", "1:9:3"}, {"until", "3"}}, {"peak", "energy"});
  add({{"velocity", "1:2:3"}, {"stiffness", "1:9:6"}, {"until", "3"}}, {"peak"});
  add({{"velocity", "0.5:1:6"}, {"stiffness", "1:9:3"}, {"until", "3"}}, {"final"});
  for (const char* line :
       {"stiffness 0.001:36:2, position 1:2:2, method forward-euler, step 0.5, until 900, measure final",
        "mass 1:4:2, damping 0.1, drive unbalance, unbalance-mass 0.1, eccentricity 0.01, drive-frequency "
        "0.5:2:4, "
        "measure peak, measure mean, measure rms, measure energy",
        "damping 0.1, drive base, base-displacement 0.01, drive-frequency 0.5:2:4, measure transmissibility",
        "damping 0.1:0.6:6, drive-amplitude 1, drive-frequency 0.5:2:3, measure phase, measure energy"}) {
    SweepOptions options;
    ASSERT_TRUE(assign(typed(line), options_of(options), "sweep")) << line;
    const auto result = sweep(options);
    ASSERT_TRUE(result.ok()) << in_words(result.error());
    const auto figure = sweep_figure(*result);
    ASSERT_TRUE(figure);
    text += line + ('\n' + as_written(*figure));
  }
  expect_figures_as_written_down(text, "sweeps");
}

TEST(FiguresWrittenDown, OfSpectra) {
  std::string bytes = "t (s),east (m/s^2),north (m/s^2)\n", pulse = "t (s),a (m/s^2)\n";
  for (int i = 0; i <= 400; ++i) {
    bytes += fmt::format("{:.2f},{:.5f},{:.5f}\n", 0.01 * i, std::sin(0.06 * i) * std::exp(-0.005 * i),
                         0.7 * std::sin(0.1 * i + 1) * std::exp(-0.01 * i));
    pulse += fmt::format("{:.4f},{:.5f}\n", 1e-4 * i,
                         i <= 110 ? 500 * std::sin(std::numbers::pi * i / 110.0) : 0.0);
  }
  std::string text;
  const auto add = [&](const std::string& file, const std::vector<std::string>& columns, bool shock) {
    SpectrumOptions options;
    options.column = columns;
    options.damping_ratio = {"2 %", "5 %"};
    options.shock = shock;
    if (!shock)
      options.periods = "0.1:2:5:log";
    else
      options.frequencies = "5:500:5:log Hz";
    const SpectrumFile read{"motion.csv", file};
    const auto result = response_spectrum({&read, 1}, options);
    ASSERT_TRUE(result.ok());
    text += as_written(spectrum_figure(*result)) + as_written(tripartite_figure(*result));
  };
  add(bytes, {"east"}, false);
  add(bytes, {"east", "north"}, false);
  add(pulse, {}, true);
  expect_figures_as_written_down(text, "spectra");
}

/// So many motions that ring ever faster, of one component or two, with options as they are typed.
std::vector<MotionSpectra> ringing(int count, int components, const std::string& line) {
  SpectrumOptions options;
  EXPECT_TRUE(assign(typed(line), options_of(options), "spectrum")) << line;
  std::vector<MotionSpectra> motions;
  for (int m = 0; m < count; ++m) {
    std::vector<SpectrumFile> files;
    for (int c = 0; c < components; ++c) {
      std::string bytes = "t (s),a (m/s^2)\n";
      for (int i = 0; i < 60; ++i)
        bytes += fmt::format("{:.2f},{:.5f}\n", 0.02 * i, (1 + 0.1 * m) * std::sin((0.2 + 0.01 * m) * i + c));
      files.push_back({fmt::format("folder/motion{}{}.csv", m, c == 0 ? "e" : "n"), bytes});
    }
    std::vector<std::string> names;
    for (const SpectrumFile& file : files) names.push_back(file.name);
    motions.push_back({names, response_spectrum(files, options)});
  }
  return motions;
}

TEST(FiguresWrittenDown, OfManyMotions) {
  std::string text;
  const auto add = [&](const std::vector<MotionSpectra>& motions) {
    const SpectrumResult& any = *motions[0].result;
    text += as_written(spectra_figure(motions, false));
    if (!any.options.shock || any.options.shock_response == "pseudo-velocity")
      text += as_written(spectra_figure(motions, true));
  };
  add(ringing(3, 1, "periods 0.1:2:4:log, damping-ratio 2 %, damping-ratio 5 %"));
  add(ringing(2, 2, "periods 0.1:0.5:3, in-g true, baseline constant"));
  add(ringing(2, 1, "frequencies 1:20:4:log Hz, shock true"));
  add(ringing(2, 1, "frequencies 1:20:4:log Hz, shock true, shock-response relative-displacement"));
  add(ringing(2, 1, "frequencies 1:20:4:log Hz, shock true, shock-response pseudo-velocity"));
  add(ringing(10, 1, "periods 0.1:2:4:log"));
  add(ringing(11, 1, "periods 0.1:2:4:log"));
  add(ringing(101, 1, "periods 0.2:1:3"));
  std::vector<MotionSpectra> one_fails = ringing(3, 1, "periods 0.1:2:4:log");
  one_fails[1].result = Error{"interrupted"};
  add(one_fails);
  expect_figures_as_written_down(text, "many_motions");
}

/// Masses hung on in turn: 10 N/m, with a scatter of some millimetres.
TEST(FiguresWrittenDown, OfASpringAtRest) {
  std::vector<Hold> holds;
  const double off[] = {0.002, -0.001, -0.003, 0.001, 0.001};
  for (int i = 0; i < 5; ++i) {
    Hold hold;
    hold.file = "hold.csv";
    hold.run = i + 1;
    hold.samples = 50;
    hold.position = 0.2 + 0.1 * i + off[i];
    hold.scatter = 0.001 * (i + 1);
    hold.standard_error = 0.0005 * (i + 1);
    hold.mass = {0.1 * i, 0.0002};
    holds.push_back(hold);
  }
  const auto found = static_stiffness(holds, {10, 0});
  ASSERT_TRUE(found);
  expect_figures_as_written_down(as_written(static_figure(*found)), "spring");
}

/// A chain of carts, each on a spring and every other one with friction in its link, some of them told apart.
std::string chain(int masses) {
  std::string toml;
  for (int i = 1; i <= masses; ++i)
    toml += fmt::format("[[mass]]\nname = \"m{}\"\nmass = \"{} kg\"\n{}", i, i,
                        i == 1 ? "position = \"1 cm\"\n" : "");
  for (int i = 1; i <= masses; ++i)
    toml += fmt::format("[[link]]\n{}to = \"m{}\"\nstiffness = \"{} N/m\"\n{}",
                        i == 1 ? "" : fmt::format("from = \"m{}\"\n", i - 1), i, 30 + i,
                        i % 2 == 0 ? "damping = \"0.1 kg/s\"\n" : "");
  return toml;
}

TEST(FiguresWrittenDown, OfChainsOfCarts) {
  std::string text;
  for (const int masses : {1, 2, 5, 8, 9}) {
    const auto network = read_network(chain(masses), "/a/folder/carts.toml");
    ASSERT_TRUE(network) << in_words(network.error());
    SimulateOptions options;
    options.method = {"exact"};
    options.until = 2;
    const auto run = run_network(*network, "/a/folder/carts.toml", options);
    ASSERT_TRUE(run) << in_words(run.error());
    const auto modes = network_modes(*network, "/a/folder/carts.toml", {});
    ASSERT_TRUE(modes) << in_words(modes.error());
    text += as_written(network_figure({&*run, 1})) + as_written(modes_figure(*modes));
  }
  expect_figures_as_written_down(text, "chains");
}

/// The modes of three floors in the wind, and as they would be where two of them are near each other.
TEST(FiguresWrittenDown, OfModesInARecording) {
  const std::string file = CROMER_SOURCE_DIR "/data/networks/floors_in_wind.csv";
  const auto recording = read_recording(bytes_of(file), "floors_in_wind.csv", {});
  ASSERT_TRUE(recording);
  auto modes = recording_modes(*recording);
  ASSERT_TRUE(modes);
  std::string text = as_written(modes_figure(*modes));
  std::vector<MeasuredMode>& found = modes->recording->found.modes;
  ASSERT_GE(found.size(), 3u);
  found[1].frequency.value = found[0].frequency.value + 0.5;
  text += as_written(modes_figure(*modes));
  expect_figures_as_written_down(text, "modes");
}

TEST(FiguresWrittenDown, OfRuns) {
  std::string text;
  const std::vector<MotionPanel> all = *parse_panels("position,velocity,phase,energy");
  for (const char* line :
       {"stiffness 36, damping 0.3, method exact, method euler-cromer, step 0.02, until 4",
        "stiffness 36, damping 14, method exact, step 0.05, until 2",
        "stiffness 36, method forward-euler, method rk4, step 0.05, until 6",
        "stiffness 36, method forward-euler, step 0.1, until 10",
        "stiffness 36, method verlet, step 0.4, until 10",
        "stiffness 36, damping 0.2, method implicit-euler, method exact, method rk4, step 0.1, until 6",
        "stiffness 36, friction 1, position 0.2, method exact, step 0.02, until 3",
        "stiffness 36, quadratic 20, position 0.5, method rk4, step 0.02, until 4",
        "stiffness 0, velocity 2, method rk4, step 0.1, until 2",
        "stiffness -1, position 0.001, method rk4, step 0.1, until 12",
        "stiffness 0, pendulum 9.81, position 2.5, method verlet, step 0.02, until 5",
        "stiffness 4e6, position 0.002, method rk4, step 1e-5, until 0.005",
        "damping -0.2, van-der-pol 0.2, position 0.1, method rk4, step 0.1, until 40",
        "stiffness 36, drive-amplitude 1, drive-frequency 6, method rk4, step 0.05, until 20",
        "stiffness 36, damping 0.5, drive-amplitude 1, drive-frequency 5, drive-frequency 7, method exact, "
        "step 0.05, until 12",
        "stiffness 36, damping 0.5, drive-amplitude 1, drive-frequency 5, drive-frequency 7, method exact, "
        "method heun, step 0.05, until 12",
        "stiffness 36, damping 1, drive half-sine, drive-amplitude 2, drive-duration 0.4, method exact, "
        "step 0.02, until 3",
        "stiffness 36, damping 1, drive step, drive-amplitude 2, method rk4, step 0.02, until 8",
        "stiffness 36, method rk4, step 0.05, event turning-point:stop, until 3",
        "stiffness 36, quintic -5000, position 0.4, method rk4, step 0.05, until 5"}) {
    SimulateOptions options;
    ASSERT_TRUE(assign(typed(line), options_of(options), "simulate")) << line;
    const auto result = simulate(options);
    ASSERT_TRUE(result.ok()) << in_words(result.error());
    text += line + ('\n' + as_written(simulate_figure(*result, all)));
  }
  expect_figures_as_written_down(text, "runs");
}

/// A column of so many samples a second about 0.3, with noise of 0.1 %, but for those that are lost.
std::string measured(const std::string& heading, double rate, double until, double from,
                     const std::function<double(double)>& motion,
                     const std::function<bool(double)>& lost = nullptr) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 1e-4);
  std::string bytes = "Time (s)," + heading + "\n";
  for (int i = 0; i < rate * until; ++i) {
    const double t = i / rate, rest = noise(random);
    if (!lost || !lost(t)) bytes += fmt::format("{:.10g},{:.8f}\n", from + t, 0.3 + motion(t) + rest);
  }
  return bytes;
}

struct RecordedMotion {
  std::string name, bytes, options{};
};

std::vector<RecordedMotion> recorded_motions() {
  const auto swing = [](double rate, double w) {
    return [=](double t) { return 0.08 * std::exp(-rate * t) * std::cos(w * t); };
  };
  const auto gap = [](double t) { return t > 2.1 && t < 3.3; };
  const auto driven = [](double t) {
    return 0.05 * std::cos(5 * t) + 0.03 * std::exp(-0.3 * t) * std::cos(6 * t);
  };
  const auto spiked = [=](double t) { return swing(0.1, 6)(t) + (t == 4.0 ? 0.3 : t == 5.0 ? -0.06 : 0); };
  return {{"a few swings", measured("Position (m)", 50, 8, 0, swing(0.1, 6)), "law viscous"},
          {"many swings", measured("Position (m)", 50, 40, 0, swing(0.05, 9)), "law viscous"},
          {"a gap", measured("Position (mm)", 50, 8, 0, swing(0.1, 6), gap), "law viscous"},
          {"samples set aside", measured("Position (m)", 50, 8, 0, spiked), "law viscous"},
          {"few samples", measured("Position (cm)", 4, 12, 0, swing(0.1, 6)), "law viscous"},
          {"an angle", measured("Angle (deg)", 50, 8, 0, swing(0.1, 6)), "law viscous"},
          {"a velocity", measured("Velocity (m/s)", 50, 8, 0, swing(0.2, 6)), "law viscous"},
          {"an acceleration", measured("Acceleration (m/s^2)", 50, 8, 0, swing(0.2, 6)), "law viscous"},
          {"a voltage", measured("Voltage (V)", 50, 8, 0, swing(0.2, 6)), "law viscous"},
          {"far from time zero", measured("Position (m)", 50, 8, 1e6, swing(0.1, 6)), "law viscous"},
          {"within milliseconds", measured("Position (m)", 2e5, 0.004, 0, swing(60, 1e4)), "law viscous"},
          {"segments and a mass", measured("Position (m)", 50, 20, 0, swing(0.1, 6)),
           "law viscous, segments 5, mass 0.2"},
          {"friction",
           measured("Position (m)", 50, 8, 0,
                    [](double t) {
                      const double half = std::numbers::pi / 6, k = std::floor(t / half);
                      const double left = std::max(0.0, 0.08 - 0.01 * k);
                      return t < 8 * half
                                 ? (left - 0.005) * std::cos(6 * t) + (std::fmod(k, 2) == 0 ? 0.005 : -0.005)
                                 : 0;
                    }),
           "law friction"},
          {"driven", measured("Position (m)", 50, 20, 0, driven), "drive-frequency 5"},
          {"nothing", measured("Position (m)", 50, 8, 0, [](double) { return 0.0; }), ""}};
}

TEST(FiguresWrittenDown, OfFits) {
  std::string text;
  for (const RecordedMotion& each : recorded_motions()) {
    FitOptions options;
    ASSERT_TRUE(assign(typed(each.options), options_of(options), "fit")) << each.name;
    const auto fits = fit(each.bytes, "lab.csv", options);
    ASSERT_TRUE(fits) << in_words(fits.error());
    text += each.name + '\n' + as_written(fit_figure(*fits));
  }
  expect_figures_as_written_down(text, "fits");
}

TEST(FiguresWrittenDown, OfComparisons) {
  std::string text;
  const std::vector<MotionPanel> all = *parse_panels("position,velocity,phase,energy");
  for (const RecordedMotion& each : recorded_motions()) {
    if (each.bytes.find("Position") == std::string::npos && each.bytes.find("Angle") == std::string::npos)
      continue;
    if (each.options.find("law") == std::string::npos) continue;
    for (const char* methods :
         {"method euler-cromer, step 0.08", "method forward-euler, method rk4, step 0.02"}) {
      if (each.name == "within milliseconds") continue;
      CompareOptions options;
      ASSERT_TRUE(assign(typed(each.options), options_of(options), "compare")) << each.name;
      ASSERT_TRUE(assign(typed(methods), options_of(options), "compare"));
      const auto compared = compare(each.bytes, "lab.csv", options);
      ASSERT_TRUE(compared) << in_words(compared.error());
      text += fmt::format("{}, {}\n{}", each.name, methods, as_written(compare_figure(*compared, all)));
    }
  }
  expect_figures_as_written_down(text, "comparisons");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
