// Unpacks a WebAssembly module, in the page.
#include "door.h"
#include "predictor.h"
#include "range.h"

namespace cromer::pack {
namespace {

void unpack(const std::uint8_t* packed, std::uint8_t* bytes, std::size_t count) {
  static Predictor predictor(bytes);
  Range range;
  std::uint32_t read = 0;
  for (int i = 0; i < 4; ++i) read = read << 8 | *packed++;
  for (std::size_t i = 0; i < count; ++i) {
    bytes[i] = predictor.byte([&](int p, int) {
      const std::uint32_t split = range.split(p);
      const bool one = read <= split;
      range.narrow(split, one);
      while (range.known()) {
        range.widen();
        read = read << 8 | *packed++;
      }
      return one;
    });
    predictor.take(bytes[i]);
  }
}

}  // namespace
}  // namespace cromer::pack

/// `count`: of the bytes to come.
extern "C" __attribute__((export_name("unpack"))) void unpack(std::size_t count) {
  cromer::pack::unpack(packed_bytes, plain_bytes, count);
}
