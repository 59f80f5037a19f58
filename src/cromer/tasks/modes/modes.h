// Task: the modes of a network or of a recording, and what methods make of them.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cromer/identify/modal/modal_analysis.h"
#include "cromer/model/network.h"
#include "cromer/notice.h"
#include "cromer/quantity.h"
#include "cromer/read/recording.h"
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
  // Of a recording:
  std::optional<int> run{};                                ///< from 1; the only one
  std::optional<double> from{}, to{};                      // [s] the times used; all by default
  std::optional<int> modes{};                              ///< at most this many; all by default
  std::optional<double> from_frequency{}, to_frequency{};  // [rad/s] only modes between
  std::string of_method{};                                 ///< that simulated it, with `step`; "" none
  std::optional<Network> network{};                        ///< its masses are the channels, in this order
  ReadOptions read{};
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

/// The mode of a network that one of a recording is.
struct ModeOfNetwork {
  std::size_t mode = 0;  ///< from 1, by rising frequency
  double frequency = 0;  // [Hz]
  double damping_ratio = 0;
  double mac = 0;  ///< modal assurance criterion of the two shapes, 0.5 to 1
};

struct NaturalMode {
  Estimate frequency{};                       // [Hz] |eigenvalue|/2 pi; NaN where it falls away from rest
  Estimate damping_ratio{};                   ///< NaN where the frequency is 0 or NaN
  std::vector<std::complex<double>> shape{};  ///< its largest component 1
  std::optional<double> participation{};      ///< effective modal mass over the whole; of networks
  std::vector<std::complex<double>> shape_error{};  ///< standard errors of its parts; of recordings
  std::optional<ModeOfNetwork> of_network{};        ///< of recordings set beside a network
  std::vector<ModeByMethod> methods{};
};

/// What the modes of a recording were found in.
struct ModalSource {
  int run = 1;                 ///< of the file, from 1
  std::string quantity, unit;  ///< of the channels: "acceleration", "m/s²"
  std::size_t samples = 0;
  double rate = 0;      // [1/s]
  double duration = 0;  // [s]
  std::size_t gaps = 0;
  ModalAnalysis found;
  Notice words{};  ///< what kind of motion it is, and how its modes were found; empty where there are none
};

struct ModesResult {
  std::string file;
  std::vector<std::string> names{};  ///< of masses, or of channels: the components of shapes
  std::vector<NaturalMode> modes{};  ///< by rising frequency
  std::vector<Notice> notices{};
  std::optional<ModalSource> recording{};  ///< empty of a network
  std::optional<Network> network{};        ///< that has these modes, or beside which they are set
  Notice message{};                        ///< why no modes were found; empty if some were

  bool ok() const { return message.empty(); }
};

/// How two modes beat and how strongly they are coupled; as uncertain as their frequencies, which count as
/// independent.
struct Beat {
  Estimate frequency;  // [Hz] their difference
  Estimate period;     // [s]
  Estimate coupling;   ///< the difference of their squared frequencies over the sum
};

/// Of a result with two modes that swing, the difference of whose frequencies has a 95 % interval above 0;
/// else empty.
std::optional<Beat> beat_of(const ModesResult& result);

/// The modes of small motions about rest. An Error names option, value and constraint, or says that there are
/// too many masses.
Result<ModesResult> network_modes(const Network& network, const std::string& file,
                                  const ModesOptions& options = {});

/// The modes in a recording as it is, with the options that are of any recording: without `of_method` and
/// `network`. An Error says what is wrong with the columns.
Result<ModesResult> found_modes(const Recording& recording, const ModesOptions& options = {});

/// The modes in a recording: all columns of one kind are its channels, those that a fit would take. With
/// `of_method` they are those of the law that was simulated, without the method's share, and `methods` has
/// what the recording itself shows. With `network` they are set beside those of this network. An Error says
/// what is wrong with the options or the columns.
Result<ModesResult> recording_modes(const Recording& recording, const ModesOptions& options = {});

/// The most masses whose modes are sought.
inline constexpr std::size_t most_masses_for_modes = 500;

}  // namespace cromer::core
