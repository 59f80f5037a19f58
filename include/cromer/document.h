// Results as text: the same JSON documents that the program writes.
#pragma once

#include <string>
#include <vector>

#include <cromer/compare.h>
#include <cromer/export.h>
#include <cromer/fit.h>
#include <cromer/methods.h>
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
/// With the kept states, or without them.
CROMER_API std::string json(const Simulation& simulation, bool with_states = true,
                            Language language = Language::english);

}  // namespace cromer
