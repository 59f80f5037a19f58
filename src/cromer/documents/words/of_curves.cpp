#include "cromer/documents/words/catalogue.h"

namespace cromer::core {
namespace {

using enum Use;

constexpr Entry entries[] = {
    {"from_not_positive", error, "{--from}: it must be positive", "{--from}: das muss größer als 0 sein"},
    {"to_not_above_from", error, "{--to}: it must be above {--from}",
     "{--to}: das muss über {--from} liegen"},
    {"too_few_points", error, "{--points}: at least 2", "{--points}: mindestens 2"},
    {"method_map_not_linear", error,
     "{option:option}: only a linear law has one frequency and one decay rate",
     "{option:option}: nur ein lineares Gesetz hat eine einzige Frequenz und eine einzige Abklingrate"},
    {"law_does_not_oscillate", error, "{--damping}: this law does not oscillate",
     "{--damping}: dieses Gesetz schwingt nicht"},
    {"frequency_from_not_positive", error, "{--frequency-from}: it must be positive",
     "{--frequency-from}: das muss größer als 0 sein"},
    {"frequency_to_not_above_from", error, "{--frequency-to}: it must be above {--frequency-from}",
     "{--frequency-to}: das muss über {--frequency-from} liegen"},
    {"resonance_without_force", error, "{--drive-amplitude}: a resonance curve needs a force",
     "{--drive-amplitude}: eine Resonanzkurve braucht eine Kraft"},
    {"resonance_of_other_drive", error,
     "{option:option}: a resonance curve needs a harmonic force, an unbalance or a shaking base",
     "{option:option}: eine Resonanzkurve gibt es zu einer harmonischen Kraft, einer Unwucht oder einem "
     "schwingenden Fußpunkt"},
    {"resonance_not_linear", error, "{option:option}: this resonance curve is for the linear law only",
     "{option:option}: diese Resonanzkurve ist die des linearen Gesetzes"},
    {"resonance_without_damping", error,
     "{--damping}: without damping no transient dies down, and there is no steady amplitude",
     "{--damping}: ohne Dämpfung klingt kein Einschwingen ab, und es gibt keine stationäre Amplitude"},
    {"resonance_without_spring", error, "{--stiffness}: without a spring there is no resonance",
     "{--stiffness}: ohne Feder gibt es keine Resonanz"},
    {"damping_ratios_and_damping", error,
     "{--damping-ratios}: the damping is set by {--damping}, {--damping-ratio} or {--quality-factor} "
     "already; give one of them",
     "{--damping-ratios}: die Dämpfung ist durch {--damping}, {--damping-ratio} oder {--quality-factor} "
     "schon festgelegt; bitte nur eines davon angeben"},
    {"local_error_under_drive", error,
     "{--drive}: the error of a step is measured on a smooth motion, free or under a harmonic drive",
     "{--drive}: der Fehler eines Schritts wird an einer glatten Bewegung gemessen, frei oder unter einem "
     "harmonischen Antrieb"},
    {"local_error_without_closed_form", error,
     "{option:option}: the error of a step is measured against the closed form, and this law has none",
     "{option:option}: der Fehler eines Schritts wird an der geschlossenen Lösung gemessen, die dieses "
     "Gesetz nicht hat"},
    {"local_error_without_period", error,
     "{--stiffness}: the steps are parts of a natural period, and this law has none",
     "{--stiffness}: die Schritte sind Teile einer Eigenperiode, die dieses Gesetz nicht hat"},
    {"longest_not_positive", error, "{--longest}: it must be positive",
     "{--longest}: das muss größer als 0 sein"},
    {"halvings_out_of_range", error, "{--halvings}: 1 to 30", "{--halvings}: 1 bis 30"},
    {"reference_run_failed", error, "the reference run failed: {what}",
     "der Vergleichslauf misslang: {what}"},
};

}  // namespace

const std::span<const Entry> words_of_curves = entries;

}  // namespace cromer::core
