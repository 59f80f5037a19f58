// The results of a task as named results of the study: "id.stiffness", "id.2.peak", column "id.2.x".
#pragma once

#include <string>

#include "cromer/study/results.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/curves/local_error.h"
#include "cromer/tasks/curves/method_map.h"
#include "cromer/tasks/curves/resonance.h"
#include "cromer/tasks/curves/work_precision.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// "id.N" for run N: the entries of its description, those of its parameters without "parameters.";
/// newton_per_step, peak, peak_velocity; effect (a sentence); energy_* of a free motion; steady.* and exact.*
/// of a driven one. Columns t, x, v, energy, phase (of a swing).
void collect(const std::string& id, const SimulateResult& result, Results& results);

/// "id.N" for the run by method N: the entries of its description, label. "id.N.NAME" for each mass (what is
/// no letter, digit or hyphen in its name becomes _): peak, peak_t, x_end, v_end, and of its own energy, with
/// that of its links to the ground, energy_peak, energy_peak_t. Columns t, energy of the run; t, x, v, energy
/// of each mass; t, energy of each link, "id.N.links.N", which has energy_peak, energy_peak_t.
void collect(const std::string& id, const std::vector<NetworkRun>& runs, Results& results);

/// "id": the entries of its description. "id.links.N.NAME" for each value found of link N, with .low and
/// .high; "id.NAME" for each mass (its name as above): position, velocity, equilibrium, likewise, rms,
/// r_squared. Columns t, and measured, fitted, residual of each mass.
void collect(const std::string& id, const FittedNetwork& fitted, Results& results);

/// "id": modes; of two modes beat_frequency, beat_period, and coupling, the difference of their squared
/// frequencies over the sum. "id.N" for mode N: frequency, period, damping_ratio, participation; for each
/// component of its shape NAME and NAME.phase; beside a network of_network.mode, .frequency,
/// .frequency_error, .damping_ratio, .mac; "id.N.methods.N": label, frequency, frequency_error,
/// damping_ratio. Columns mode, frequency, damping_ratio.
void collect(const std::string& id, const ModesResult& found, Results& results);

/// "id": the entries of a fit's description; mass, spring_mass, disc_diameter, damping_mean, reynolds_last,
/// air_temperature, air_density, air_viscosity (with reynolds), other_stiffness (with .rms), common_decay
/// (with .amplitude) (beside rival laws), first_rate, last_rate, stretches, first_stretch, last_stretch,
/// lowest_stretch and highest_stretch (with .amplitude, .frequency); simulate.OPTION (the law as options of
/// simulate). Columns t, since_start, measured; left_out_t, left_out; of a law
/// displacement, fitted_displacement, residual, mean, in all of which samples that are set aside are NaN;
/// window_t, reynolds; of the stretches amplitude, rate, law_rate, stretch_frequency, and bar_amplitude,
/// bar_rate, bar_frequency (error bars); between them by the law law_amplitude, law_curve (the rate),
/// law_frequency.
void collect(const std::string& id, const FittedRecording& fitted, Results& results);

/// "id": stiffness with .low and .high, gravity. "id.N" for hold N: label, mass, position, residual. Columns
/// mass, position, residual, bar_mass, bar_residual (error bars), line_mass, line.
void collect(const std::string& id, const StaticStiffness& found, Results& results);

/// "id": the same as for its fit, and explanation (a sentence). "id.N" for curve N: the entries of its
/// description; amplitude_error_end, excess_max, excess_max_t. Columns t, x, top_t, top, bottom_t, bottom.
void collect(const std::string& id, const CompareResult& compared, Results& results);

/// "id": points. "id.N" for curve N: label, damping_ratio, peak, peak_frequency, peak_transmissibility,
/// peak_transmissibility_ratio (the frequency ratio there), last_transmissibility, peak_transmitted,
/// last_transmitted. Columns frequency, frequency_ratio, amplitude, phase, amplification, transmissibility,
/// transmitted, transmitted_phase.
void collect(const std::string& id, const ResonanceResult& resonance, Results& results);

/// "id.N" for method N: label, x_slope, v_slope, x_over_predicted, v_over_predicted. Columns h, x_error,
/// v_error.
void collect(const std::string& id, const LocalErrorResult& errors, Results& results);

/// "id": natural_frequency, decay_rate. "id.N" for method N: label, order, stable_up_to (w h, or "any"), and
/// at w h = 0.1 at_a_tenth.decay_rate, .frequency_error, .energy_factor. Columns wh, decay_rate,
/// frequency_error, decay_error.
void collect(const std::string& id, const MethodMapResult& map, Results& results);

/// "id.N" for method N: label, slope, evaluations_for_a_millionth (NaN if that error is not reached). Columns
/// evaluations, error.
void collect(const std::string& id, const WorkPrecisionResult& work, Results& results);

/// "id": peak_acceleration, arias_intensity, duration_5_95, all of the first component. "id.N" for damping
/// ratio N: damping_ratio (or loss_factor), ductility, peak, peak_period. Columns period, frequency, and SD,
/// PSV, PSA. Of two components these are RotD50; SD_1, SD_2, SD_geometric_mean, SD_RotD100 and so on stand
/// beside them. Of a shock: primary, residual, maximax, positive, negative.
void collect(const std::string& id, const SpectrumResult& spectrum, Results& results);

/// "id": points, not_settled, not_finite, method, way, steps. "id.N" for curve N over the innermost option:
/// label, the value of each other option, and for each measure MEASURE.smallest, .smallest_at, .largest and
/// .largest_at. Its columns are the innermost option and the measures, named as in the CSV file. "id.point.N"
/// for row N, if there are at most 1000: label, options and measures.
void collect(const std::string& id, const SweepResult& sweep, Results& results);

}  // namespace cromer::core
