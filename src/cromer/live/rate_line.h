// The rate at which samples without times were sent, from their arrivals. Pure.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace cromer::core {

/// Sample i was sent at `begin + i * period`; the shortest delay on the way is not known and counts as none.
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

/// [s] How much delays change from one sample to the next: the mean size of the second differences, each
/// counted as a tenth of a second at most. A rate that changes smoothly hardly has any. 0 for less than
/// three.
double roughness(std::span<const double> arrivals);

/// [s] How late the arrivals are: the 0.9 quantile of the least delays in pieces of 0.2 s, or of two samples
/// where that is longer.
double lateness(std::span<const double> arrivals, const RateLine& line);

/// Whether delays alone explain all departures from the line. Then samples arrive on time again and again, up
/// to 0.3 ms or 0.7 of the roughness: in more than 0.4 of all tenths of a second, in as many of their last
/// quarter, and in three quarters of all stretches of 0.8 s.
bool is_touched(std::span<const double> arrivals, const RateLine& line);

/// The line of the last arrivals that keep one steady rate: of the last 16, 8, 4 or 2 s with at least 48
/// samples, or of all if there are fewer, but of `least` [s] at least. Its `begin` is that of the first
/// arrival. Nothing if the rate is not steady, or above 20 000 a second: a file that is piped in.
std::optional<RateLine> steady_rate(std::span<const double> arrivals, double least);

constexpr double longest_memory = 16;        // [s] that steady_rate looks back at most
constexpr std::size_t least_samples = 48;    ///< that show a rate
constexpr std::size_t most_samples = 20000;  ///< that steady_rate looks back at most

}  // namespace cromer::core
