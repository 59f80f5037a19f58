// The simplest law that a record asks for.
#pragma once

#include <optional>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct LawChoice {
  LawFit chosen;
  /// The fits of all laws tried; of a given law, that alone.
  ///
  /// Of a free motion: all sums of viscous, drag and friction, each with a linear spring, with cubic and with
  /// odd-quadratic, for angles also as a pendulum. Of a driven motion: the viscous law, and it with cubic,
  /// with quadratic, with both and with odd-quadratic (only where there is a spring), each of these also with
  /// drag and with friction. Then, of either:
  /// - the best law with van-der-pol in the place of drag, and with quintic in that of cubic, each also
  ///   beside viscous damping alone; with quadratic, where that leaves less than a zero that wanders would;
  ///   hysteresis where its exponent is given;
  /// - as long as something is left, for two rounds or three, the best law with one more term, with quadratic
  ///   and cubic together, or with odd-quadratic and quintic; hysteresis beside the viscous law; the same of
  ///   a law that leaves much less but has terms that are not sure;
  /// - under a harmonic drive, beside drag or friction, hysteresis with the viscous law (not on the page);
  /// - a law with van-der-pol with drag, friction, cubic or odd-quadratic as well.
  ///
  /// The viscous law comes first, and it alone if it was refused. Only the chosen law and the one of lowest
  /// BIC beside it are fitted to the last digit, the others well enough to be compared. Where the reading of
  /// a recorded force is not given, the fits under the other readings come last.
  std::vector<LawFit> candidates;
  /// Names the laws that fit as well and give other numbers, by the samples that the laws were compared on;
  /// empty where there are none. It is among the notices of `chosen` too.
  Notice rivals{};
};

/// What is given beforehand; all else is chosen.
struct GivenLaw {
  std::optional<Law> law{};
  std::optional<BetweenSamples> between{};  ///< how a recorded force is read
};

/// Fits the candidates and takes the one that criterion.h chooses; of a recorded force also the reading of
/// lowest BIC, with the spread between readings that stay open in its errors. options.law and the drive's
/// reading are ignored. Of a record of more than 200,000 samples the candidates see a part, and the chosen
/// law is then fitted to all. An interruption is iteration_limit with a message; the candidates are then
/// those that were done.
LawChoice choose_law(const Record& record, const LawFitOptions& options, const Watch& watch = {},
                     const GivenLaw& given = {});

}  // namespace cromer::core
