// The embedded recordings: the commands that made them make them again, and fit answers as promised.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"
#include "tests/support/bytes_of.h"

namespace cromer::core::test {
namespace CROMER_FILE {

const std::string data = CROMER_SOURCE_DIR "/data/";

/// Everything behind the lines that say where it came from.
std::string samples(const std::string& csv) { return csv.substr(csv.find("Time (s)")); }

TEST(SampleData, IsMadeAgainToTheByte) {
  Folder folder;
  const Finished end = folder.run({"simulate",
                                   "--mass",
                                   "217.6 g",
                                   "--stiffness",
                                   "17.04 N/m",
                                   "--damping",
                                   "0.000789 kg/s",
                                   "--drag",
                                   "0.02043 kg/m",
                                   "--position",
                                   "0.036 m",
                                   "--until",
                                   "120 s",
                                   "--method",
                                   "rk4",
                                   "--step",
                                   "1 ms",
                                   "--every",
                                   "10",
                                   "--sensor-noise",
                                   "0.3 mm",
                                   "--sensor-resolution",
                                   "0.1 mm",
                                   "--sensor-offset",
                                   "0.2 m",
                                   "--seed",
                                   "24",
                                   "--quiet",
                                   "-o",
                                   "recording2.csv"});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_TRUE(samples(folder.read("recording2.csv")) == samples(bytes_of(data + "recording2.csv")));
}

TEST(SampleData, AnswersTheLabsQuestions) {
  const Finished end =
      Folder().run({"fit", data + "recording2.csv", "--mass", "217.6 ± 0.3 g", "--disc-diameter", "12 cm",
                    "--segment", "30 s", "--segments", "3", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto fit = end.json();
  EXPECT_EQ(fit.value("status", ""), "converged");
  EXPECT_EQ(fit.value("law", ""), "viscous+drag");
  const auto& parameters = fit.at("parameters");
  const auto truth = [&](const char* name, double value) {
    const double found = parameters.at(name).at("value"), error = parameters.at(name).at("standard_error");
    EXPECT_NEAR(found, value, 3.5 * error) << name;
    EXPECT_LT(parameters.at(name).at("confidence_95").at(0), found) << name;
    EXPECT_GT(parameters.at(name).at("confidence_95").at(1), found) << name;
  };
  truth("stiffness", 17.04);
  truth("damping", 0.000789);
  truth("drag_constant", 0.02043);
  truth("equilibrium", 0.2);
  truth("position", 0.036);
  // The mass's 0.3 g in 217.6 g, carried through.
  EXPECT_NEAR(parameters.at("stiffness").at("standard_error").get<double>() / 17.04, 0.3 / 217.6, 1e-5);
  EXPECT_NEAR(fit.at("decay_rate_mean").get<double>(), 0.00984, 0.00004);
  EXPECT_NEAR(fit.at("reynolds").at("max").get<double>(), 2525, 10);
  EXPECT_EQ(fit.at("decay_segments").size(), 3u);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
