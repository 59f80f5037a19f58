// An .lzma file: a fifth smaller than gzip, and browsers have no decompressor of its kind.
import { decompressFile } from 'js-lzma'

/// The bytes that xz --format=lzma packed. Throws where they are damaged.
export function unlzma(file: Uint8Array): Uint8Array {
  let plain = new Uint8Array(4 * file.length)
  let [at, size] = [0, 0]
  const readByte = () => {
    if (at === file.length) throw new RangeError('the compressed data end early')
    return file[at++]!
  }
  const writeByte = (byte: number) => {
    if (size === plain.length) {
      const longer = new Uint8Array(2 * size)
      longer.set(plain)
      plain = longer
    }
    plain[size++] = byte
  }
  decompressFile({ readByte }, { writeByte })
  return plain.subarray(0, size)
}
