// The modes of a network of masses, and what methods really simulate of them; the modes in a recording.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cromer/export.h>
#include <cromer/methods.h>
#include <cromer/notice.h>
#include <cromer/quantity.h>
#include <cromer/read.h>
#include <cromer/result.h>

namespace cromer {

namespace core {
struct ModesResult;
}

struct ModesOptions {
  std::vector<Method> method{};     ///< what these make of each mode; none
  std::optional<double> step{};     // [s] > 0, of these methods
  std::optional<double> beta{};     // of newmark, 0 to 1; 1/4
  std::optional<double> gamma{};    // of newmark, 0 to 1; 1/2
  std::optional<double> rho_inf{};  // of generalized-alpha, 0 to 1; 0.8
  // Of a recording:
  std::optional<int> modes{};              ///< so many at most; all that are found
  std::optional<double> from_frequency{};  // [rad/s] only modes between
  std::optional<double> to_frequency{};    // [rad/s]
  std::optional<Method> of_method{};       ///< that simulated it, with `step`: its share is taken out
  ReadOptions read{};
};

/// What a method makes of a mode, from the eigenvalues of its own step.
struct ModeByMethod {
  std::string method;
  double step = 0;                        // [s]
  std::optional<double> frequency{};      // [Hz] |eigenvalue|/2 pi; empty where nothing oscillates
  std::optional<double> damping_ratio{};  ///< likewise; negative where the mode grows
  bool stable = true;                     ///< the mode stays bounded
};

struct Mode {
  Estimate frequency{};                       // [Hz] |eigenvalue|/2 pi; NaN where it falls away from rest
  Estimate damping_ratio{};                   ///< NaN without a frequency
  std::vector<std::complex<double>> shape{};  ///< of each name; the largest is 1
  std::vector<std::complex<double>> shape_error{};  ///< standard errors of its parts; of recordings
  std::optional<double> participation{};            ///< effective modal mass over the whole; of networks
  std::vector<ModeByMethod> methods{};
};

struct Modes {
  std::vector<std::string> names{};  ///< of the masses, or of the channels
  std::vector<Mode> modes{};         ///< by rising frequency
  std::vector<Notice> notices{};     ///< what else there is to know
  Notice message{};                  ///< why no modes were found in a recording; empty if some were
  std::shared_ptr<const core::ModesResult> detail{};
};

/// The modes of small motions about rest of the network in a file that ends in .toml (docs/networks.md), of
/// at most 500 masses; else those in a recording of several channels, with 95 % intervals. An Error names the
/// argument, or what is wrong in which line of the file.
CROMER_API Result<Modes> modes(const std::string& file, const ModesOptions& options = {});

}  // namespace cromer
