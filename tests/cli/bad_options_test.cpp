// Wrong options: exit status 2, nothing on standard output, a message that names the option and the cure, no
// file left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

struct BadOption {
  const char* name;
  std::vector<std::string> arguments;
  std::vector<std::string> said;
};

class BadOptions : public ::testing::TestWithParam<BadOption> {};

TEST_P(BadOptions, AreRefusedWithTheCure) {
  const Folder folder;
  auto arguments = GetParam().arguments;
  const bool writes = !arguments.empty() && arguments.front() == "simulate" &&
                      std::find(arguments.begin(), arguments.end(), "-o") == arguments.end();
  if (writes) arguments.insert(arguments.end(), {"-o", "run.csv", "--json"});
  const Finished end = folder.run(arguments);
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.out, IsEmpty());
  EXPECT_THAT(end.err, StartsWith("cromer: "));
  for (const auto& text : GetParam().said) EXPECT_THAT(end.err, HasSubstr(text));
  EXPECT_THAT(folder.names(), IsEmpty());
}

const BadOption bad_options[] = {
    {"no_command", {}, {"a command is needed", "simulate"}},
    {"unknown_command", {"simulat"}, {"\"simulat\"", "did you mean simulate?"}},
    {"unknown_option", {"simulate", "--mas", "1"}, {"--mas", "did you mean --mass?"}},
    {"unknown_option_with_value", {"simulate", "--stifness=9"}, {"did you mean --stiffness?"}},
    {"no_value", {"simulate", "--mass"}, {"--mass needs a value"}},
    {"value_of_a_flag", {"methods", "--json=3"}, {"--json takes no value"}},
    {"twice", {"simulate", "--mass", "1", "--mass", "2"}, {"--mass is given 2 times"}},
    {"stray_file", {"simulate", "lab.csv"}, {"takes no file", "lab.csv"}},
    {"no_file", {"fit"}, {"needs a file"}},
    {"unquoted",
     {"fit", "lab.csv", "--mass", "217.6", "g"},
     {"--mass 217.6 g", "quotes", "--mass \"217.6 g\""}},
    {"unquoted_before_the_file",
     {"fit", "--mass", "217.6", "±", "0.3", "g", "lab.csv", "--segments", "3"},
     {"--mass 217.6 ± 0.3 g", "--mass \"217.6 ± 0.3 g\""}},
    {"unquoted_behind_an_equals_sign",
     {"compare", "lab.csv", "--segment=30", "s"},
     {"--segment 30 s", "--segment \"30 s\""}},
    {"unquoted_without_a_file", {"simulate", "--until", "50", "s"}, {"--until 50 s", "--until \"50 s\""}},
    {"unquoted_author",
     {"report", "lab.csv", "--author", "Anna", "B.", "Student", "-o", "out"},
     {"--author Anna B. Student", "--author \"Anna B. Student\""}},
    {"mass_without_its_option",
     {"fit", "lab.csv", "217.6 ± 0.3 g"},
     {"no such file", "did you mean --mass \"217.6 ± 0.3 g\"?"}},
    {"output_with_one_dash", {"report", "lab.csv", "-out", "lab"}, {"unknown option -out", "--output"}},
    {"output_behind_an_equals_sign", {"fit", "lab.csv", "-out=lab.csv"}, {"unknown option -out", "--output"}},
    {"of_the_report",
     {"fit", "lab.csv", "--author", "A"},
     {"--author is an option of cromer report, not of cromer fit"}},
    {"of_the_fit",
     {"modes", "lab.csv", "--mass", "1"},
     {"--mass is an option of cromer fit, not of cromer modes"}},
    {"one_dash", {"fit", "lab.csv", "-mass", "217.6 g"}, {"unknown option -mass", "did you mean --mass?"}},
    {"no_such_file_among_several",
     {"report", CROMER_SOURCE_DIR "/data/recording2.csv", "lab.csv", "-o", "out"},
     {"lab.csv: cannot be read"}},
    {"grams_or_kilograms",
     {"fit", "lab.csv", "--mass", "217.6"},
     {"--mass 217.6", "would be kg", "--mass \"217.6 g\"", "--mass \"217.6 kg\""}},
    {"grams_or_kilograms_with_their_error",
     {"compare", "lab.csv", "--mass", "217.6 ± 0.3"},
     {"--mass \"217.6 ± 0.3 g\"", "--mass \"217.6 ± 0.3 kg\""}},
    {"centimetres_or_metres", {"fit", "lab.csv", "--disc-diameter", "12"}, {"\"12 cm\"", "\"12 m\""}},
    {"wrong_unit", {"simulate", "--mass", "217.6 N"}, {"--mass", "217.6 N", "force", "mass"}},
    {"unknown_unit", {"simulate", "--mass", "3 stone"}, {"--mass", "stone"}},
    {"word", {"simulate", "--step", "small"}, {"--step", "small"}},
    {"not_a_number", {"simulate", "--step", "nan"}, {"--step"}},
    {"infinite", {"simulate", "--until", "1e999"}, {"--until"}},
    {"mass_zero", {"simulate", "--mass", "0"}, {"--mass", "must be positive"}},
    {"mass_negative", {"simulate", "--mass", "-1"}, {"--mass", "must be positive", "-1"}},
    {"friction_negative", {"simulate", "--friction", "-0.1"}, {"--friction", "must not be negative"}},
    {"step_negative", {"simulate", "--step", "-0.01"}, {"--step", "must be positive", "-0.01"}},
    {"tolerance", {"simulate", "--tolerance", "1e-16"}, {"--tolerance", "1e-15 and 1e-2"}},
    {"every_zero", {"simulate", "--every", "0"}, {"--every", "must be positive"}},
    {"every_part", {"simulate", "--every", "2.5"}, {"--every", "whole number"}},
    {"memory", {"simulate", "--step", "1e-9", "--until", "1e6"}, {"1e+15 states", "24 PB", "--every"}},
    {"endless", {"simulate", "--step", "1e-300", "--until", "1e6"}, {"--step", "too many"}},
    {"unknown_method", {"simulate", "--method", "rk5"}, {"--method", "\"rk5\"", "did you mean rk4?"}},
    {"exact_drag", {"simulate", "--method", "exact", "--drag", "1"}, {"exact", "drag"}},
    {"exact_cubic", {"simulate", "--method", "exact", "--cubic", "1"}, {"exact", "cubic"}},
    {"exact_friction",
     {"simulate", "--method", "exact", "--friction", "1", "--drive-amplitude", "1", "--drive-frequency", "2"},
     {"exact", "friction"}},
    {"static_below_kinetic",
     {"simulate", "--friction", "2", "--static-friction", "1"},
     {"--static-friction", "2 N"}},
    {"unknown_event", {"simulate", "--event", "speed=1"}, {"--event", "speed", "turning-point"}},
    {"compensated_adaptive",
     {"simulate", "--method", "dormand-prince", "--compensated"},
     {"--compensated", "dormand-prince", "chooses its own steps", "euler-cromer"}},
    {"compensated_exact",
     {"simulate", "--method", "exact", "--compensated"},
     {"--compensated", "closed form"}},
    {"compensated_friction",
     {"simulate", "--friction", "0.2", "--compensated"},
     {"--compensated", "--friction", "0.2 N"}},
    {"compensated_event",
     {"simulate", "--event", "position=0", "--compensated"},
     {"--compensated", "--event", "position=0"}},
    {"two_springs",
     {"simulate", "--stiffness", "1", "--natural-frequency", "1"},
     {"--stiffness", "--natural-frequency"}},
    {"two_dampings",
     {"simulate", "--damping", "1", "--quality-factor", "1"},
     {"--damping", "--quality-factor"}},
    {"ratio_of_nothing",
     {"simulate", "--stiffness", "0", "--damping-ratio", "0.1"},
     {"--damping-ratio", "positive stiffness"}},
    {"no_period", {"simulate", "--stiffness", "0"}, {"--step", "--until"}},
    {"drive_without_frequency", {"simulate", "--drive-amplitude", "1"}, {"--drive-frequency"}},
    {"hdf5", {"inspect", "lab.csv", "-o", "run.h5"}, {"run.h5", "HDF5", ".csv or .json"}},
    {"hdf5_fit", {"fit", "lab.csv", "-o", "run.h5"}, {"run.h5", "HDF5", ".csv or .json"}},
    {"hdf5_compare", {"compare", "lab.csv", "-o", "run.h5"}, {"run.h5", "HDF5", ".csv or .json"}},
    {"ending", {"simulate", "-o", "run.dat"}, {"run.dat", ".csv"}},
    {"no_folder", {"simulate", "-o", "missing/run.csv"}, {"missing"}},
    {"plot_ending", {"simulate", "--plot", "run.gif"}, {"--plot", ".svg"}},
    {"temperature", {"fit", "lab.csv", "--temperature", "20"}, {"--temperature", "20 °C"}},
    {"air_without_disc", {"fit", "lab.csv", "--temperature", "20 °C"}, {"--temperature", "--disc-diameter"}},
    {"exponent_below_one",
     {"fit", "lab.csv", "--hysteresis-exponent", "0.5"},
     {"--hysteresis-exponent", "at least 1"}},
    {"compare_without_a_spring", {"compare", "lab.csv", "--no-spring"}, {"--no-spring"}},
    {"seed_without_trials", {"fit", "lab.csv", "--seed", "7"}, {"--seed", "--monte-carlo"}},
    {"goal_of_a_driven_motion",
     {"fit", "lab.csv", "--drive-frequency", "1 Hz", "--goal", "decay_rate 1 %"},
     {"--goal", "driven", "--from"}},
    {"segments_of_a_driven_motion",
     {"fit", "lab.csv", "--force-column", "F", "--segments", "3"},
     {"--segments", "driven", "--from"}},
    {"textbook_of_a_driven_motion",
     {"fit", "lab.csv", "--drive-frequency", "auto", "--textbook"},
     {"--textbook", "driven"}},
    {"force_under_compare",
     {"compare", "lab.csv", "--force-column", "F"},
     {"--force-column", "option of cromer fit, not of cromer compare"}},
    {"step_under_fit",
     {"fit", "lab.csv", "--step", "0.1"},
     {"--step", "option of cromer simulate, not of cromer fit"}},
    {"uncertain_step", {"simulate", "--step", "0.01 ± 0.001 s"}, {"--step", "uncertainty"}},
};

INSTANTIATE_TEST_SUITE_P(Options, BadOptions, ::testing::ValuesIn(bad_options),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BadOptions, AnOutputThatIsAFolderIsRefusedBeforeTheRun) {
  const Folder folder;
  const Finished end = folder.run({"simulate", "-o", "/", "--json"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.out, IsEmpty());
}

TEST(BadOptions, AnUnwritableFolderKeepsItsOldFile) {
  const Folder folder;
  folder.write("old.csv", "old\n");
  const Finished end = folder.run({"simulate", "-o", "old.csv", "--plot", "missing/run.svg"});
  EXPECT_EQ(end.status, 2);
  EXPECT_EQ(folder.read("old.csv"), "old\n");
  EXPECT_THAT(folder.names(), ::testing::ElementsAre("old.csv"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
