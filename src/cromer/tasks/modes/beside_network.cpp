#include "cromer/tasks/modes/beside_network.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "cromer/analysis/complex_modes.h"
#include "cromer/tasks/network/network_file.h"

namespace cromer::core {
namespace {

using Shape = std::vector<std::complex<double>>;

/// Which channel is taken for each mass, and with which sign.
struct Mounting {
  std::vector<std::size_t> channel;
  std::vector<double> sign;

  explicit Mounting(std::size_t channels) : channel(channels), sign(channels, 1.0) {
    std::iota(channel.begin(), channel.end(), std::size_t{0});
  }

  Shape seen_by_masses(const Shape& shape) const {
    Shape turned(shape.size());
    for (std::size_t i = 0; i < shape.size(); ++i) turned[i] = sign[i] * shape[channel[i]];
    return turned;
  }
};

struct Match {
  std::size_t found, of_network;
  double mac;
  double score;  ///< less for frequencies that are apart
};

/// Pairs of modes, the likest first, each mode once.
std::vector<Match> matches(const std::vector<NaturalMode>& found, const std::vector<NaturalMode>& of_network,
                           const Mounting& mounting) {
  constexpr double least_mac = 0.5, most_apart = std::numbers::ln2;  // twice as fast, or half
  std::vector<Match> all;
  for (std::size_t j = 0; j < found.size(); ++j) {
    const Shape shape = mounting.seen_by_masses(found[j].shape);
    for (std::size_t k = 0; k < of_network.size(); ++k) {
      if (!(found[j].frequency.value > 0) || !(of_network[k].frequency.value > 0)) continue;
      const double mac = modal_assurance(shape, of_network[k].shape);
      const double apart = std::abs(std::log(found[j].frequency.value / of_network[k].frequency.value));
      if (mac >= least_mac && apart < most_apart) all.push_back({j, k, mac, mac - apart});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Match& a, const Match& b) { return a.score > b.score; });
  std::vector<Match> chosen;
  for (const Match& each : all)
    if (std::none_of(chosen.begin(), chosen.end(), [&](const Match& other) {
          return other.found == each.found || other.of_network == each.of_network;
        }))
      chosen.push_back(each);
  return chosen;
}

/// Means over the modes of the recording; what has no match counts as 0.
struct Agreement {
  double mac = 0, score = 0;

  Agreement(const std::vector<Match>& chosen, std::size_t modes) {
    for (const Match& each : chosen) {
      mac += each.mac / static_cast<double>(modes);
      score += each.score / static_cast<double>(modes);
    }
  }
};

/// Two channels that look swapped, or one that looks reversed: shapes agree well with the
/// network's only if that is undone.
std::optional<Notice> mounted_wrongly(const ModesResult& found, const std::vector<NaturalMode>& of_network,
                                      const Agreement& as_it_is) {
  constexpr double well = 0.9, clearly = 0.1;
  const std::size_t channels = found.names.size();
  // One shape may look so by chance.
  if (found.modes.size() < 2 || as_it_is.mac >= well) return std::nullopt;
  double best = as_it_is.score + clearly;
  std::optional<Notice> said;
  const auto try_it = [&](const Mounting& mounting, const auto& notice) {
    const Agreement agreement(matches(found.modes, of_network, mounting), found.modes.size());
    if (agreement.mac < well || agreement.mac <= as_it_is.mac || agreement.score <= best) return;
    best = agreement.score;
    said = notice(agreement.mac);
  };
  for (std::size_t a = 0; a < channels; ++a) {
    for (std::size_t b = a + 1; b < channels; ++b) {
      Mounting swapped(channels);
      std::swap(swapped.channel[a], swapped.channel[b]);
      try_it(swapped, [&](double mac) {
        return Notice{
            "channels_look_swapped",
            {{"first", found.names[a]}, {"second", found.names[b]}, {"mac", as_it_is.mac}, {"swapped", mac}}};
      });
    }
    Mounting reversed(channels);
    reversed.sign[a] = -1;
    try_it(reversed, [&](double mac) {
      return Notice{"channel_looks_reversed",
                    {{"column", found.names[a]}, {"mac", as_it_is.mac}, {"reversed", mac}}};
    });
  }
  return said;
}

}  // namespace

Result<void> set_beside(ModesResult& found, const Network& network, bool all) {
  if (auto good = check_a_column_for_each_mass(found.names, network, found.file); !good) return good;
  const auto modes = network_modes(network, given_network);
  if (!modes) return modes.error();
  found.network = network;
  if (!found.ok()) return {};

  const std::vector<Match> chosen = matches(found.modes, modes->modes, Mounting(found.names.size()));
  std::vector<bool> seen(modes->modes.size());
  for (const Match& each : chosen) {
    const NaturalMode& mode = modes->modes[each.of_network];
    found.modes[each.found].of_network =
        ModeOfNetwork{each.of_network + 1, mode.frequency.value, mode.damping_ratio.value, each.mac};
    seen[each.of_network] = true;
  }
  if (const auto wrong = mounted_wrongly(found, modes->modes, Agreement(chosen, found.modes.size()))) {
    found.notices.push_back(*wrong);
    return {};
  }
  for (const NaturalMode& mode : found.modes)
    if (!mode.of_network)
      found.notices.push_back(Notice{"mode_unlike_network", {{"frequency", mode.frequency.value}}});
  if (!all) return {};
  for (std::size_t k = 0; k < modes->modes.size(); ++k)
    if (const double frequency = modes->modes[k].frequency.value;
        !seen[k] && frequency > 0 && frequency < found.recording->rate / 2)
      found.notices.push_back(Notice{"network_mode_not_found", {{"mode", k + 1}, {"frequency", frequency}}});
  return {};
}

}  // namespace cromer::core
