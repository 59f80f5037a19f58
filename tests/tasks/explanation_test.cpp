// Sentences on a comparison and on a run, of handmade numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {
namespace CROMER_FILE {

/// One rate leaves 0.02 m, the law 0.01 m, alone and by a method.
CompareResult compared() {
  CompareResult both;
  both.recording.series.quantity = "position";
  both.curves.resize(3);
  for (ComparedCurve& curve : both.curves) curve.amplitude_ratio_end = 0.9;
  both.curves[0].law = law_of("viscous");
  both.curves[0].rms = both.curves[0].law_rms = 0.02;
  both.curves[1].law = both.curves[2].law = law_of("viscous+drag");
  both.curves[1].rms = both.curves[1].law_rms = both.curves[2].rms = both.curves[2].law_rms = 0.01;
  both.curves[2].method = "rk4";
  both.curves[2].step = 0.01;
  both.recording.decay_by_amplitude = {{0, 1, 0.5, {}, {}, 0.4, 0}, {1, 2, 0.25, {}, {}, 0.2, 0}};
  return both;
}

TEST(Explanation, SaysHowTheRateChangesWithTheSwing) {
  CompareResult both = compared();
  const std::string left =
      "with one rate for all damping 2.00\u00a0cm (rms) are left, with viscous+drag 1.00\u00a0cm; by one rate "
      "the amplitude at the end is ";
  const std::string end = ". Quote the law instead.";
  EXPECT_EQ(in_words(explanation(both)),
            "One decay rate is not enough. By the law it falls from 0.400 to 0.200\u00a01/s as the swing "
            "dies down from "
            "50.0\u00a0cm to 25.0\u00a0cm; " +
                left + "10\u00a0% too small" + end);
  both.curves[0].amplitude_ratio_end = 1.1;
  std::swap(both.recording.decay_by_amplitude[0], both.recording.decay_by_amplitude[1]);
  EXPECT_EQ(in_words(explanation(both)),
            "One decay rate is not enough. By the law it rises from 0.200 to 0.400\u00a01/s as the swing "
            "grows from "
            "25.0\u00a0cm to 50.0\u00a0cm; " +
                left + "10\u00a0% too large" + end);
  both.curves[0].amplitude_ratio_end = 1.0004;
  EXPECT_THAT(in_words(explanation(both)), testing::HasSubstr(left + "right to 0.05\u00a0%"));
  both.curves[0].amplitude_ratio_end = 0.999;
  EXPECT_THAT(in_words(explanation(both)), testing::HasSubstr(left + "0.10\u00a0% too small"));
}

// The amplitude is one of the displacement, also where a velocity was recorded.
TEST(Explanation, OfAVelocityTheAmplitudeIsALength) {
  CompareResult both = compared();
  both.recording.series.quantity = "velocity";
  EXPECT_THAT(
      in_words(explanation(both)),
      testing::HasSubstr("as the swing dies down from 50.0\u00a0cm to 25.0\u00a0cm; with one rate for all "
                         "damping 0.0200\u00a0m/s (rms)"));
}

TEST(Explanation, PartsWithOtherRatesSpeakWhereNoLawDescribesTheWhole) {
  CompareResult both = compared();
  both.doubts = {Notice{"no_law_describes", {{"times", 7.0}}}};
  const auto rates = [&](double first, double last, double error) {
    both.recording.decay_by_amplitude = {{0, 1, 0.5, make_estimate(first, error, 2), {}, 0.4, 0},
                                         {1, 2, 0.25, make_estimate(last, error, 2), {}, 0.2, 0}};
    return in_words(explanation(both));
  };
  const std::string parts =
      ". One decay rate is not enough, whatever the law: parts of the recording, each fitted by itself, "
      "have ";
  EXPECT_THAT(rates(0.4, 0.2, 0.03),
              testing::HasSubstr(
                  parts + "0.40\u00a0±\u00a00.03\u00a01/s at an amplitude of 50.0\u00a0cm and "
                          "0.20\u00a0±\u00a00.03\u00a01/s at "
                          "25.0\u00a0cm; with one rate for all damping 2.00\u00a0cm (rms) are left, with "
                          "viscous+drag 1.00\u00a0cm."));
  EXPECT_THAT(rates(0.2, 0.4, 0.03), testing::HasSubstr(parts));
  EXPECT_THAT(rates(0.4, 0.2, 0.05), testing::HasSubstr("No verdict on the damping"));
  // Two swings that beat have parts with other rates, too.
  both.recording.modes.resize(2);
  EXPECT_THAT(rates(0.4, 0.2, 0.03), testing::HasSubstr("No verdict on the damping"));
  both.recording.modes.clear();
  both.doubts.push_back(Notice{"modes_beside_the_law"});
  EXPECT_THAT(rates(0.4, 0.2, 0.03), testing::HasSubstr("No verdict on the damping"));
}

// Of a pendulum the rate of the amplitude changes under viscous damping alone: few stretches do not show it.
TEST(Explanation, OfOneRateNothingIsSaidBesideTwo) {
  CompareResult both = compared();
  both.others_tried = true;
  both.curves[0].law = both.curves[1].law = law_of("viscous+pendulum");
  both.curves[0].amplitude_ratio_end = 1.0001;
  both.recording.decay_by_amplitude.clear();
  EXPECT_THAT(in_words(explanation(both)), testing::StartsWith("One decay rate is enough: "));
  both.recording.headline = {{"decay_rate_start", make_estimate(0.677, 0.004, 2), "1/s"},
                             {"decay_rate_end", make_estimate(0.4271, 0.0011, 2), "1/s"}};
  EXPECT_THAT(in_words(explanation(both)), testing::StartsWith("Viscous damping alone is enough: "));
  EXPECT_THAT(in_words(explanation(both)),
              testing::HasSubstr("The amplitude's own rate goes from 0.677 to 0.427\u00a01/s"));
}

TEST(Explanation, NeedsTheLawBesideTheOneRate) {
  CompareResult both = compared();
  const std::string whole = in_words(explanation(both));
  both.curves.resize(2);
  EXPECT_EQ(in_words(explanation(both)), whole);
  both.curves.resize(1);
  EXPECT_TRUE(explanation(both).empty());
}

TEST(Explanation, SaysWhereOneRateIsEnough) {
  CompareResult both = compared();
  both.curves[1].law = law_of("viscous");
  both.curves[0].amplitude_ratio_end = 0.97;
  EXPECT_EQ(in_words(explanation(both)),
            "One decay rate is enough: with one rate for all damping 2.00\u00a0cm (rms) are left, and the "
            "amplitude at the end is "
            "3.0\u00a0% too small.");
  both.curves[0].measured_at_rest = both.curves[0].at_rest = true;
  EXPECT_THAT(in_words(explanation(both)),
              testing::EndsWith(", and the swing has died down where the measured one has."));
}

TEST(Explanation, StretchesThatScatterAreToldBesideOneRate) {
  CompareResult both = compared();
  both.others_tried = true;
  both.curves[1].law = law_of("viscous");
  both.curves[0].amplitude_ratio_end = 1.001;
  const auto stretch = [](double rate, double error) {
    AmplitudeRate each;
    each.rate = make_estimate(rate, error, 2);
    each.law_rate = 0.05;
    return each;
  };
  both.recording.decay_by_amplitude = {stretch(-0.13, 0.02), stretch(0.15, 0.02), stretch(-0.06, 0.02)};
  EXPECT_EQ(
      in_words(explanation(both)),
      "No law that was tried tells more than one decay rate: with one rate for all damping 2.00\u00a0cm "
      "(rms) are left. But "
      "the rates of single stretches, −0.13 to 0.15\u00a01/s, scatter by more than the noise explains, "
      "and their errors are widened by that: something else takes part.");
  both.recording.decay_by_amplitude = {stretch(0.06, 0.02), stretch(0.04, 0.02), stretch(0.07, 0.02)};
  EXPECT_THAT(in_words(explanation(both)), testing::StartsWith("One decay rate is enough"));
}

TEST(Explanation, OneRateIsNotEnoughWhereItsEndIsFarOff) {
  CompareResult both = compared();
  both.curves[1].law = law_of("viscous");
  EXPECT_EQ(in_words(explanation(both)),
            "No law that was tried tells more than one decay rate: with one rate for all damping "
            "2.00\u00a0cm (rms) are left, but "
            "the amplitude at the end is 10\u00a0% too small.");
  both.curves[1].law = both.curves[0].law = law_of("viscous+cubic");
  EXPECT_EQ(
      in_words(explanation(both)),
      "No law that was tried tells more than viscous damping alone: with one rate for all damping "
      "2.00\u00a0cm (rms) are "
      "left, but the amplitude at the end is 10\u00a0% too small. The amplitude's own rate goes from 0.400 "
      "to 0.200\u00a01/s, as the restoring force is not proportional to the displacement.");
  both.curves[0].measured_at_rest = true;
  EXPECT_THAT(in_words(explanation(both)),
              testing::HasSubstr(", but it still swings where the measured motion has died down."));
}

TEST(Explanation, AnAmplitudeWithinTheNoiseIsRight) {
  CompareResult both = compared();
  both.curves[1].law = law_of("viscous");
  both.curves[0].amplitude_ratio_end = 0.81;
  both.curves[0].amplitude_ratio_error = 0.1;
  EXPECT_THAT(
      in_words(explanation(both)),
      testing::EndsWith("the amplitude at the end is right within what the noise lets see, 20\u00a0%."));
  both.curves[0].amplitude_ratio_error = 0.09;
  EXPECT_THAT(in_words(explanation(both)),
              testing::EndsWith("the amplitude at the end is 19\u00a0% too small."));
}

TEST(Explanation, AConstantRateLeavesTheFrequency) {
  CompareResult both = compared();
  std::string numbers =
      "with one rate for all damping 2.00\u00a0cm (rms) are left, with viscous+drag 1.00\u00a0cm.";
  both.recording.decay_by_amplitude[1].law_rate = 0.393;
  // A spring that is not bent has one frequency.
  EXPECT_EQ(in_words(explanation(both)), "One decay rate is not enough: " + numbers);
  both.curves[1].law = law_of("viscous+cubic");
  numbers = "with one rate for all damping 2.00\u00a0cm (rms) are left, with viscous+cubic 1.00\u00a0cm.";
  EXPECT_EQ(in_words(explanation(both)), "One decay rate describes the amplitude, but not the motion: " +
                                             numbers + " The frequency changes as the swing dies down.");
  both.recording.decay_by_amplitude[1].law_rate = 0.391;
  EXPECT_THAT(in_words(explanation(both)),
              testing::StartsWith("One decay rate is not enough. By the law it falls from"));
  both.recording.decay_by_amplitude.clear();
  EXPECT_EQ(in_words(explanation(both)), "One decay rate is not enough: " + numbers);
}

TEST(Explanation, ADoubtIsNoVerdict) {
  CompareResult both = compared();
  both.doubts = {Notice{"the sensor is coarse"}, Notice{"another"}};
  EXPECT_EQ(in_words(explanation(both)),
            "The sensor is coarse. No verdict on the damping: with one rate for all damping 2.00\u00a0cm "
            "(rms) are left, with "
            "viscous+drag 1.00\u00a0cm.");
  both.doubts = {Notice{"äon"}};
  both.curves[1].law = law_of("viscous");
  EXPECT_EQ(in_words(explanation(both)),
            "äon. No verdict on the damping: with one rate for all damping 2.00\u00a0cm (rms) are left.");
}

TEST(Explanation, AMethodThatRunsAwayIsNoWordOnTheLaw) {
  CompareResult both = compared();
  both.recording.decay_by_amplitude.clear();
  const std::string verdict = in_words(explanation(both));
  both.curves[2].diverged = true;
  both.curves[2].complete = false;
  const std::string gone =
      " Simulated by rk4 in steps of 0.0100\u00a0s the motion runs away: that step is too long for the "
      "method. "
      "Take a smaller --step or another --method.";
  EXPECT_EQ(in_words(explanation(both)), verdict + gone);
  both.curves.push_back(both.curves[2]);
  both.curves[3].method = "heun";
  both.curves[3].diverged = false;
  both.curves[3].method_phase = 0.5;
  both.curves[3].rms = 0.03;
  EXPECT_EQ(
      in_words(explanation(both)),
      verdict + gone +
          " Simulated by heun in steps of 0.0100\u00a0s the same law leaves 3.00\u00a0cm: the method adds "
          "a phase of 0.50\u00a0rad by the end.");
  both.curves.resize(1);
  EXPECT_EQ(in_words(explanation(both)), "");
}

TEST(Explanation, SaysWhatTheMethodAddsToTheLaw) {
  CompareResult both = compared();
  both.recording.decay_by_amplitude.clear();
  const std::string before = in_words(explanation(both));
  const auto added = [&](double phase, double ratio, double rms = 0.01) {
    both.curves[2].method_phase = phase;
    both.curves[2].method_amplitude_ratio = ratio;
    both.curves[2].rms = rms;
    return in_words(explanation(both)).substr(before.size());
  };
  const std::string leaves = " Simulated by rk4 in steps of 0.0100\u00a0s the same law leaves ";
  EXPECT_EQ(added(0.0099, 1.0049, 0.0102), "");
  EXPECT_EQ(added(0, 1, 0.01021), leaves + "1.02\u00a0cm; the rest is the method's.");
  EXPECT_EQ(added(0.0101, 1), leaves + "1.00\u00a0cm: the method adds a phase of 0.010\u00a0rad by the end.");
  EXPECT_EQ(added(-0.5, 0.99), leaves +
                                   "1.00\u00a0cm: the method adds a phase of −0.50\u00a0rad and makes the "
                                   "amplitude 1.0\u00a0% smaller by the end.");
  EXPECT_EQ(added(0, 1.0055),
            leaves + "1.00\u00a0cm: the method makes the amplitude 0.55\u00a0% larger by the end.");
  EXPECT_EQ(added(0.0009, 1.0055), added(0, 1.0055));
  EXPECT_THAT(added(0.0011, 1.0055), testing::HasSubstr("adds a phase of 0.0011\u00a0rad"));
  EXPECT_EQ(added(0.0101, 1.0009), added(0.0101, 1));
  EXPECT_THAT(added(0.0101, 1.0011), testing::HasSubstr("makes the amplitude 0.11\u00a0% larger"));
}

/// A run of a law that drags, of which nothing is known.
SimulatedRun run_of(const char* method) {
  SimulatedRun run;
  run.method = method;
  run.label = method;
  run.oscillator.drag = 1;
  return run;
}

TEST(RunInWords, SaysHowItSwung) {
  SimulatedRun run = run_of("rk4");
  EXPECT_EQ(in_words(run_notice(run)), "");
  const auto swung = [&](double first, double last) {
    run.measured =
        MeasuredOscillator{.angular_frequency = 3, .first_amplitude = first, .last_amplitude = last};
    return in_words(run_notice(run));
  };
  EXPECT_EQ(swung(1, 0.5),
            "rk4 swung at 3 rad/s on average, from 1 m between its first two turning points down to 0.5 m");
  EXPECT_EQ(swung(0.5, 1),
            "rk4 swung at 3 rad/s on average, from 0.5 m between its first two turning points up to 1 m");
  EXPECT_EQ(swung(1, 1.0009), "rk4 swung at 3 rad/s on average, 1.001 m to each side");
  EXPECT_EQ(
      swung(1, 0.9989),
      "rk4 swung at 3 rad/s on average, from 1 m between its first two turning points down to 0.9989 m");
  EXPECT_EQ(swung(1, 1.0011),
            "rk4 swung at 3 rad/s on average, from 1 m between its first two turning points up to 1.001 m");
}

TEST(RunInWords, SaysWhoGaveAndTookTheEnergy) {
  const auto energy = [](EnergyBalance balance, double drag, double damping = 0, const char* method = "rk4") {
    SimulatedRun run = run_of(method);
    balance.taken.of<Drag>() = drag;
    balance.taken.of<Viscous>() = damping;
    run.energy_balance = balance;
    return in_words(run_notice(run));
  };
  EXPECT_EQ(energy({.start = 8, .end = 2}, 6),
            "rk4 had 8 J, of which drag took 75 %, the method itself nothing");
  EXPECT_EQ(energy({.start = 8, .end = 2}, 4, 1),
            "rk4 had 8 J, of which damping took 12.5 %, drag 50 %, the method itself 12.5 %");
  EXPECT_EQ(energy({.start = 8, .end = 5}, 1),
            "rk4 had 8 J, of which drag took 12.5 %, the method itself 25 %");
  EXPECT_EQ(energy({.start = 8, .end = 9}, 1),
            "rk4 had 8 J, of which drag took 12.5 %, the method itself added 25 %");
  EXPECT_EQ(energy({.start = 2, .end = 4, .drive = 6}, 4),
            "rk4 had 8 J with what the drive gave, of which drag took 50 %, the method itself nothing");
  EXPECT_EQ(
      energy({.start = 2, .end = 4, .drive = 4}, 4, -2),
      "rk4 had 8 J with what the drive and the damping gave, of which drag took 50 %, the method itself "
      "nothing");
  EXPECT_EQ(energy({.start = 0, .end = 0}, 1), "");
  EXPECT_EQ(energy({.start = 1, .end = 3, .drive = 2}, 0), "");
}

TEST(RunInWords, TellsWhatLastsFromWhatComesAndGoes) {
  const auto words = [](const char* method, double until) {
    SimulateOptions options;
    options.mass = 0.2176;
    options.natural_frequency = 8.849;
    options.law.drag = 0.02;
    options.position = 0.05;
    options.method = {method};
    options.step = 0.01;
    options.until = until;
    const auto result = simulate(options);
    return result ? in_words(run_notice(result->runs.front())) : in_words(result.error());
  };
  // Its energy swings by w h/2 = 4.4 % of what is left.
  for (const double until : {29.7, 29.9, 30.1, 30.3})
    EXPECT_THAT(words("euler-cromer", until),
                testing::ContainsRegex("the method itself nothing, beside [34][.0-9]* % that come and go$"))
        << until;
  EXPECT_THAT(words("forward-euler", 30), testing::Not(testing::HasSubstr("come and go")));
  // Of what grows without end all is told, not the mean of its last half period.
  SimulateOptions options;
  options.mass = 1;
  options.stiffness = 32;
  options.law.cubic = 2000;
  options.damping = 0.08;
  options.position = 0.12;
  options.method = {"forward-euler"};
  options.step = 0.0043;
  options.until = 8.6;
  const auto result = simulate(options);
  ASSERT_TRUE(result);
  const SimulatedRun& run = result->runs.front();
  ASSERT_TRUE(run.energy_balance);
  EXPECT_EQ(method_energy_of(run)->lasting, run.energy_balance->method());
  EXPECT_THAT(words("rk4", 30), testing::Not(testing::HasSubstr("come and go")));
}

TEST(RunInWords, SaysWhetherALawThatKeepsItsEnergyDid) {
  const auto kept = [](double end, const char* method) {
    SimulatedRun run = run_of(method);
    run.oscillator.drag = 0;
    run.oscillator.cubic = 1;
    run.energy_balance = EnergyBalance{.start = 2, .end = end};
    return in_words(run_notice(run));
  };
  EXPECT_EQ(kept(2, "rk4"), "rk4 kept its 2 J");
  EXPECT_EQ(kept(2.0000019, "rk4"), "rk4 kept its 2 J");
  EXPECT_EQ(kept(2.0000021, "rk4"), "rk4 had 2 J, to which the method itself added 0.00011 %");
  EXPECT_EQ(kept(1.5, "rk4"), "rk4 had 2 J, of which the method itself took 25 %");
  EXPECT_EQ(kept(2.5, "rk4"), "rk4 had 2 J, to which the method itself added 25 %");
  EXPECT_EQ(kept(1.5, "verlet"), "verlet had 2 J and at the end 25 % less, which comes and goes");
  EXPECT_EQ(kept(2.5, "verlet"), "verlet had 2 J and at the end 25 % more, which comes and goes");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
