// How the records are made: a base condition, and one departure at a time from it.
#pragma once

namespace cromer::core::bench {

/// What the intervals and the scatter must be there (issue "Identify", calibration).
enum class Demand {
  white,    ///< coverage 93 to 97 %, scatter at most 1.05 of the bound
  rounded,  ///< noise at least 0.3 of the rounding step: coverage 93 to 97 %
  honest,   ///< coverage at least 93 %
};

struct Condition {
  const char* name;
  Demand demand = Demand::white;
  double cycles = 20;
  double amplitude_to_noise = 50;
  double correlation = 0;  ///< of the noise from sample to sample
  double resolution = 0;   // [m]
  double outliers = 0;     ///< share of samples that are off by up to the amplitude
  double jitter = 0;       ///< of the times, which the record tells: uniform, share of a step either way
  bool gaps = false;       ///< three gaps of a cycle or so, and one sample in ten missing
  bool half = false;       ///< half of the record missing, in three blocks
  double late = 0;    // [s] standard deviation of how late samples are taken, which the record does not tell
  double clock = 0;   // [s] the times are rounded to multiples of it
  double growth = 0;  ///< noise that grows with the motion: its standard deviation over the displacement
};

inline constexpr Condition conditions[] = {
    {"base"},
    {"2 cycles", Demand::white, 2},
    {"5 cycles", Demand::white, 5},
    {"60 cycles", Demand::white, 60},
    {"200 cycles", Demand::white, 200},
    {"amplitude 5 × noise", Demand::white, 20, 5},
    {"amplitude 500 × noise", Demand::white, 20, 500},
    {"jitter", Demand::white, 20, 50, 0, 0, 0, 0.4},
    {"gaps", Demand::white, 20, 50, 0, 0, 0, 0, true},
    {"1 mm steps, noise 1 mm", Demand::rounded, 20, 50, 0, 1e-3},
    {"1 mm steps, noise 0.3 mm", Demand::rounded, 20, 166, 0, 1e-3},
    {"1 mm steps, noise 0.1 mm", Demand::honest, 20, 500, 0, 1e-3},
    {"correlated noise, 0.5", Demand::honest, 20, 50, 0.5},
    {"correlated noise, 0.9", Demand::honest, 20, 50, 0.9},
    {"5 % outliers", Demand::honest, 20, 50, 0, 0, 0.05},
    {.name = "correlated noise, 0.97", .demand = Demand::honest, .correlation = 0.97},
    {.name = "half missing", .half = true},
    {.name = "half missing, noise 0.9", .demand = Demand::honest, .correlation = 0.9, .half = true},
    {.name = "times off by 3 ms", .demand = Demand::honest, .amplitude_to_noise = 500, .late = 3e-3},
    // Of even times: what the rounding leaves repeats at other frequencies than the motion's, and intervals
    // are then too wide. Of uneven ones it is noise.
    {.name = "times rounded to 10 ms", .demand = Demand::honest, .amplitude_to_noise = 500, .clock = 0.01},
    {.name = "rounded uneven times",
     .demand = Demand::honest,
     .amplitude_to_noise = 500,
     .jitter = 0.2,
     .clock = 0.01},
    {.name = "noise grows with motion", .demand = Demand::honest, .amplitude_to_noise = 500, .growth = 0.05},
};

}  // namespace cromer::core::bench
