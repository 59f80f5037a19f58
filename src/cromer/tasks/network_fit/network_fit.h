// Task: from a recording of all masses of a network to the values of its links.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/identify/network/fit_network.h"
#include "cromer/notice.h"
#include "cromer/quantity.h"
#include "cromer/read/channels.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/network/network_file.h"

namespace cromer::core {

struct FittedNetwork {
  std::string file{}, network_file{};
  Channels channels{};  ///< the samples used, one column for each mass
  NetworkFile asked{};  ///< 0 where values are open
  NetworkFit fit{};
  Notice message{};  ///< why it did not succeed; empty if it did
  std::vector<Notice> notices{};

  bool succeeded() const { return fit.status == FitStatus::converged; }
  /// What was found of one link, each by its name in the network's file.
  std::vector<Parameter> found_of(std::size_t link) const;
};

/// Finds the values that the network's file leaves open, from the columns of one kind in the recording: the
/// first is that of the first mass. Of the options, how the file is read, run, from and to are used. An Error
/// names option, or what the file lacks.
Result<FittedNetwork> fit_network(const Recording& recording, const NetworkFile& network,
                                  const std::string& network_file, const FitOptions& options,
                                  const Watch& watch = {});

/// The options of `fit` that go with a network.
bool is_fit_option_of_networks(std::string_view option);

}  // namespace cromer::core
