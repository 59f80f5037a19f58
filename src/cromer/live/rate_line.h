// What rate samples without times were sent at, from when they arrived. Pure.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace cromer::core {

/// Sample i was sent at `begin + i * period`, but for what the way takes at least.
struct RateLine {
  double begin;   // [s]
  double period;  // [s] > 0
  double at(double i) const { return begin + i * period; }
};

/// An arrival is the time of sending and a delay that is never negative, so the times of a steady sender are
/// a line below all arrivals: of all such lines the one with the least sum of delays, which is an edge of
/// their lower convex hull (S. B. Moon, P. Skelly & D. Towsley, Proc. IEEE INFOCOM 1999, 227; L. Zhang, Z.
/// Liu & C. H. Xia, Proc. IEEE INFOCOM 2002, 160). At least two arrivals [s], which never fall.
RateLine line_below(std::span<const double> arrivals);

/// [s] How far delays change from one sample to the next: the mean size of the second differences, each
/// counted as a tenth of a second at most. A rate that changes smoothly hardly has any. 0 for less than
/// three.
double roughness(std::span<const double> arrivals);

/// [s] What all but the worst tenth of the arrivals' pieces of 0.4 s or four samples are late by at least.
double lateness(std::span<const double> arrivals, const RateLine& line);

/// Whether delays explain all departures from the line: every now and then, in a third of the tenths of a
/// second at least, all in all and lately, a sample has to arrive as good as at its time, up to 0.3 ms or
/// what delays vary by.
bool is_touched(std::span<const double> arrivals, const RateLine& line);

/// The line of the last arrivals, of as many of them as keep one steady rate: 16, 8, 4 or 2 s and 48 samples
/// at least, or all where there are less; `least` [s] is needed. Its `begin` is that of the first arrival.
/// Nothing where they are not steady, or more than 20 000 a second: a file that is piped in.
std::optional<RateLine> steady_rate(std::span<const double> arrivals, double least);

constexpr double longest_memory = 16;        // [s] that steady_rate looks back at most
constexpr std::size_t least_samples = 48;    ///< that show a rate
constexpr std::size_t most_samples = 20000;  ///< that steady_rate looks back at most

}  // namespace cromer::core
