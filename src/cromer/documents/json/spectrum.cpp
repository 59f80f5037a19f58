#include "cromer/documents/described/spectrum.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/documents.h"

namespace cromer::core {

std::string to_json(const SpectrumResult& result, bool with_fourier, const Voice& voice) {
  return to_text(json_of(SpectrumDocument{result, with_fourier}, voice), with_fourier);
}

}  // namespace cromer::core
