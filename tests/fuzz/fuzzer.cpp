// libFuzzer's entry to one of the targets.
#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return cromer::core::fuzz::CROMER_FUZZ_TARGET(data, size);
}
