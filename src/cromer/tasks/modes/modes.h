// Task: the modes of a network, and what methods really simulate of them.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cromer/model/network.h"
#include "cromer/notice.h"
#include "cromer/quantity.h"
#include "cromer/result.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

/// What `cromer modes` takes.
struct ModesOptions {
  std::vector<std::string> method{};      ///< names; none by default
  std::optional<double> step{};           // [s] > 0, with a method
  std::optional<double> beta{}, gamma{};  // of newmark, 0 to 1; 1/4 and 1/2 by default
  std::optional<double> rho_inf{};        // of generalized-alpha, 0 to 1; 0.8 by default
};

std::vector<Option> options_of(ModesOptions& options);

/// What a method makes of a mode.
struct ModeByMethod {
  std::string method;
  double step = 0;  // [s]
  MethodEffect effect{};
  Notice words{};  ///< the same in words

  /// |eigenvalue|/2 pi [Hz], and the damping ratio; empty where nothing oscillates.
  std::optional<double> frequency() const;
  std::optional<double> damping_ratio() const;
};

struct NaturalMode {
  Estimate frequency{};                       // [Hz] |eigenvalue|/2 pi; not a number where nothing pulls back
  Estimate damping_ratio{};                   ///< not a number where the frequency is 0 or none
  std::vector<std::complex<double>> shape{};  ///< its largest component 1
  std::optional<double> participation{};      ///< effective modal mass over the whole; of networks
  std::vector<ModeByMethod> methods{};
};

struct ModesResult {
  std::string file;
  std::vector<std::string> names{};  ///< of masses, or of channels: the components of shapes
  std::vector<NaturalMode> modes{};  ///< by rising frequency
  std::vector<Notice> notices{};
};

/// The modes of small motions about rest. An Error names option, value and constraint, or says that there are
/// too many masses.
Result<ModesResult> network_modes(const Network& network, const std::string& file,
                                  const ModesOptions& options = {});

/// The most masses whose modes are sought.
inline constexpr std::size_t most_masses_for_modes = 500;

}  // namespace cromer::core
