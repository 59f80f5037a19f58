// An .lzma file: a fifth smaller than gzip, and browsers have no decompressor of its kind.
import { decompressFile } from 'js-lzma'

/// The bytes that xz --format=lzma packed. Throws where they are damaged.
export function unlzma(file: Uint8Array): Uint8Array {
  const plain: number[] = []
  let at = 0
  const readByte = () => {
    if (at === file.length) throw new RangeError('the compressed data end early')
    return file[at++]!
  }
  decompressFile({ readByte }, { writeByte: (byte) => plain.push(byte) })
  return Uint8Array.from(plain)
}
