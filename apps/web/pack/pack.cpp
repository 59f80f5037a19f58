// Packs a WebAssembly module, when the page is built.
#include "door.h"
#include "predictor.h"
#include "range.h"

namespace cromer::pack {
namespace {

/// How many bytes it is packed.
std::size_t pack(const std::uint8_t* bytes, std::size_t count, std::uint8_t* packed) {
  static Predictor predictor(bytes);
  Range range;
  std::uint8_t* to = packed;
  const auto write = [&] {
    *to++ = static_cast<std::uint8_t>(range.first >> 24);
    range.widen();
  };
  for (std::size_t i = 0; i < count; ++i) {
    predictor.byte([&](int p, int bit) {
      const bool one = bytes[i] >> bit & 1;
      range.narrow(range.split(p), one);
      while (range.known()) write();
      return one;
    });
    predictor.take(bytes[i]);
  }
  for (int i = 0; i < 4; ++i) write();
  return static_cast<std::size_t>(to - packed);
}

}  // namespace
}  // namespace cromer::pack

/// `count`: of the plain bytes.
extern "C" __attribute__((export_name("pack"))) std::size_t pack(std::size_t count) {
  return cromer::pack::pack(plain_bytes, count, packed_bytes);
}
