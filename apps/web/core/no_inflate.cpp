// The functions of zlib that the readers call. The browser unpacks archives before they come here, so nothing
// is ever inflated.
#include <zlib.h>

extern "C" {

int inflateInit2_(z_streamp, int, const char*, int) { return Z_STREAM_ERROR; }
int inflate(z_streamp, int) { return Z_STREAM_ERROR; }
int inflateEnd(z_streamp) { return Z_OK; }

/// The cyclic redundancy check of ISO 3309, bit by bit, since archives are small.
uLong crc32(uLong crc, const Bytef* bytes, uInt length) {
  if (!bytes) return 0;
  crc = ~crc & 0xffffffff;
  for (uInt i = 0; i < length; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc & 0xffffffff;
}
}
