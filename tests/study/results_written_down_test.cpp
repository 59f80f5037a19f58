// All results of small studies by their names, as they are written down in the tree.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "cromer/documents/words/words.h"
#include "cromer/study/results.h"
#include "cromer/study/run_study.h"
#include "tests/support/written_down.h"

namespace cromer::core {
namespace CROMER_FILE {

std::string as_written(const Results& results) {
  std::string text;
  for (const auto& [name, fact] : results.facts()) {
    if (const auto* number = std::get_if<Number>(&fact)) {
      text += name + " = " + test::as_written(number->quantity.value);
      if (number->quantity.uncertainty != 0) text += " +- " + test::as_written(number->quantity.uncertainty);
      text += number->unit.empty() ? "\n" : " " + number->unit + "\n";
    } else {
      text += name + " = \"" + std::get<std::string>(fact) + "\"\n";
    }
  }
  for (const auto& [name, column] : results.columns())
    text +=
        fmt::format("{}: {} \"{}\" {}\n", name, test::as_written(column.values), column.name, column.unit);
  return text;
}

/// The study beside the files of the transcripts and its results, in the tree.
void expect_results_as_written_down(const std::string& toml, const std::string& name) {
  const std::string tree = CROMER_SOURCE_DIR;
  const auto study = read_study(toml, tree + "/tests/cli/transcripts/files/study.toml");
  ASSERT_TRUE(study) << in_words(study.error());
  const auto run = run_study(*study);
  ASSERT_TRUE(run) << in_words(run.error());
  EXPECT_TRUE(run->failure.empty()) << in_words(run->failure);
  test::expect_as_written_down(as_written(run->results), tree + "/tests/study/results/" + name + ".txt");
}

TEST(ResultsWrittenDown, OfFitsAndComparisons) {
  expect_results_as_written_down(R"(
[[task]]
fit = "swing"
file = "swing.csv"
mass = "217.6 ± 0.3 g"
disc_diameter = "12 cm"
temperature = "25 °C"
segments = 3
textbook = true

[[task]]
fit = "drag"
file = "drag.csv"
law = "viscous+drag"
mass = "0.2 kg"
spring_mass = "20 g"
disc_diameter = "5 cm"

[[task]]
fit = "pendulum"
file = "pendulum.csv"

[[task]]
fit = "driven"
file = "driven.csv"
drive_frequency = "5 rad/s"
mass = "0.2 kg"

[[task]]
fit = "shaken"
file = "shaken.csv"
force_column = "F"

[[task]]
fit = "friction"
file = "mass1.csv"
law = "viscous+friction"

[[task]]
fit = "none"
file = "noise.csv"
may_fail = true

[[task]]
compare = "beside"
file = "swing.csv"
method = ["euler-cromer", "rk4"]
step = "0.02 s"
mass = "217.6 g"

[[task]]
compare = "far"
file = "drag.csv"
law = "viscous+drag"
method = "forward-euler"
step = "0.04 s"
)",
                                 "fits");
}

TEST(ResultsWrittenDown, OfRuns) {
  expect_results_as_written_down(R"(
[[task]]
simulate = "free"
stiffness = "36 N/m"
damping = "0.2 kg/s"
position = "5 cm"
method = ["exact", "forward-euler", "verlet"]
step = "0.02 s"
until = "4 s"
quiet = true

[[task]]
simulate = "slow"
stiffness = "1 N/m"
damping = "3 kg/s"
method = "implicit-euler"
step = "0.05 s"
until = "3 s"

[[task]]
simulate = "driven"
mass = "2 kg"
stiffness = "36 N/m"
damping = "1 kg/s"
drive_amplitude = "2 N"
drive_frequency = ["3 rad/s", "5 rad/s"]
method = ["exact", "euler-cromer"]
step = "0.02 s"
until = "12 s"

[[task]]
simulate = "shaken"
stiffness = "36 N/m"
damping = "1 kg/s"
drive = "base"
base_displacement = "1 cm"
drive_frequency = "5 rad/s"
method = "newmark"
step = "0.02 s"
until = "10 s"

[[task]]
simulate = "bent"
stiffness = "36 N/m"
cubic = "20 N/m^3"
drag = "0.1 kg/m"
friction = "0.3 N"
method = "rk4"
step = "0.02 s"
until = "3 s"

[[task]]
simulate = "pushed"
stiffness = "36 N/m"
damping = "1 kg/s"
drive = "half-sine"
drive_amplitude = "2 N"
drive_duration = "0.4 s"
method = "verlet"
step = "0.02 s"
until = "3 s"

[[task]]
simulate = "pendulums"
network = "../../../../data/networks/pendulums.toml"
method = ["rk4", "implicit-euler"]
step = "0.05 s"
until = "5 s"
quiet = true

[[task]]
modes = "modes"
file = "../../../../data/networks/frame.toml"
method = "newmark"
step = "0.01 s"
quiet = true

[[task]]
modes = "in_wind"
file = "../../../../data/networks/floors_in_wind.csv"
network = "../../../../data/networks/frame.toml"
quiet = true

[[task]]
difference = "apart"
of = "free.2"
minus = "free.1"
)",
                                 "runs");
}

TEST(ResultsWrittenDown, OfCurves) {
  expect_results_as_written_down(R"(
[[task]]
resonance = "force"
natural_frequency = "6 rad/s"
damping_ratios = [0.05, 0.6]
drive_amplitude = "1 N"
method = "exact"
frequency_from = "0.5 rad/s"
frequency_to = "12 rad/s"
points = 24

[[task]]
resonance = "base"
natural_frequency = "6 rad/s"
damping_ratio = 0.1
drive = "base"
base_displacement = "1 mm"
method = ["exact", "implicit-euler", "heun"]
step = "0.05 s"
frequency_from = "3 rad/s"
frequency_to = "9 rad/s"
points = 7

[[task]]
resonance = "unbalance"
mass = "50 kg"
natural_frequency = "3 Hz"
damping_ratio = 0.2
drive = "unbalance"
unbalance_mass = "0.5 kg"
eccentricity = "20 cm"
method = "exact"
frequency_from = "1 Hz"
frequency_to = "9 Hz"
points = 9

[[task]]
local_error = "error"
natural_frequency = "6 rad/s"
damping_ratio = 0.02
method = ["forward-euler", "euler-cromer", "verlet", "heun"]

[[task]]
method_map = "map"
natural_frequency = "2 rad/s"
damping_ratio = 0.02
method = ["forward-euler", "euler-cromer", "newmark", "rk4", "exact"]
from = 0.05
to = 3
points = 9

[[task]]
work_precision = "linear"
natural_frequency = "1 rad/s"
damping_ratio = 0.02
method = ["forward-euler", "verlet", "rk4", "dormand-prince"]
until = "20 s"
halvings = 5

[[task]]
work_precision = "bent"
stiffness = "1 N/m"
cubic = "1 N/m^3"
damping = "0.1 kg/s"
drive_amplitude = "0.5 N"
drive_frequency = "1.2 rad/s"
position = 1
method = ["euler-cromer", "heun"]
until = "10 s"
halvings = 5

[[task]]
spectrum = "quake"
file = "../../../../data/ground/shaking.csv"
column = ["east", "north"]
periods = "0.1:2:5"
damping_ratio = [0.02, 0.05]

[[task]]
spectrum = "yielding"
file = "../../../../data/ground/shaking.csv"
column = "east"
periods = "0.2,1"
ductility = [2, 4]
quiet = true

[[task]]
spectrum = "lossy"
file = "../../../../data/ground/shaking.csv"
column = "east"
periods = "0.2,1"
loss_factor = 0.1

[[task]]
spectrum = "shock"
file = "../../../../data/ground/drop.csv"
shock = true
frequencies = "5:500:5:log Hz"

[[task]]
sweep = "grid"
damping_ratio = [0.02, 0.05]
drive_amplitude = "1 N"
drive_frequency = "0.5:1.5:5"
measure = ["amplitude", "phase", "peak"]

[[task]]
sweep = "ends"
position = "0.5,1,1.5"
cubic = 1
until = "5 s"

[[task]]
sweep = "both"
cubic = 0.05
damping = 0.1
drive_amplitude = 0.3
drive_frequency = "0.8:1.4:4"
direction = "both"
)",
                                 "curves");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
