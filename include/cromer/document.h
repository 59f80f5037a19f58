// Results as documents: the same JSON, CSV and figures that the program writes.
#pragma once

#include <string>

#include <cromer/compare.h>
#include <cromer/export.h>
#include <cromer/fit.h>
#include <cromer/methods.h>
#include <cromer/network.h>
#include <cromer/notice.h>
#include <cromer/simulate.h>
#include <cromer/spectrum.h>
#include <cromer/sweep.h>

namespace cromer {

/// Indented JSON (a frequency response: on one line) with a newline at its end; numbers as the shortest text
/// that reads back the same, NaN and infinity as null; sentences in `language`, naming arguments as their
/// fields are called. "" for a result that no call has filled.
CROMER_API std::string json(const LawFit& fit, Language language = Language::english);
CROMER_API std::string json(const Comparison& comparison, Language language = Language::english);
CROMER_API std::string json(const ResponseSpectrum& spectrum, Language language = Language::english);
CROMER_API std::string json(const FrequencyResponse& response, Language language = Language::english);
CROMER_API std::string json(const Modes& modes, Language language = Language::english);
CROMER_API std::string json(const NetworkFit& fit, Language language = Language::english);
/// With the kept states, or without them.
CROMER_API std::string json(const Simulation& simulation, bool with_states = true,
                            Language language = Language::english);
CROMER_API std::string json(const NetworkSimulation& simulation, bool with_states = true,
                            Language language = Language::english);

/// A table with a header row; every number reads back as the same double. A fit: one row, with its numbers,
/// their standard errors and 95 % intervals. A comparison: the measured and simulated motions. A simulation:
/// its states. Modes: a row for each. A fitted network: a row for each value found. "" of a result that no
/// call has filled, and of a spectrum that was interrupted.
CROMER_API std::string csv(const LawFit& fit);
CROMER_API std::string csv(const Comparison& comparison);
CROMER_API std::string csv(const ResponseSpectrum& spectrum);
CROMER_API std::string csv(const FrequencyResponse& response);
CROMER_API std::string csv(const Modes& modes);
CROMER_API std::string csv(const Simulation& simulation);
CROMER_API std::string csv(const NetworkSimulation& simulation);
CROMER_API std::string csv(const NetworkFit& fit);

/// The program's figure of the result as an SVG document. "" of a result that no call has filled, and of one
/// that was interrupted before there was anything to draw.
CROMER_API std::string svg(const LawFit& fit);
CROMER_API std::string svg(const Comparison& comparison);
CROMER_API std::string svg(const ResponseSpectrum& spectrum);
CROMER_API std::string svg(const FrequencyResponse& response);
CROMER_API std::string svg(const Modes& modes);
CROMER_API std::string svg(const Simulation& simulation);
CROMER_API std::string svg(const NetworkSimulation& simulation);
CROMER_API std::string svg(const NetworkFit& fit);

}  // namespace cromer
