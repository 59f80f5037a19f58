// The core's code, sorted for packing: operations in one stream, the locals they name in another, and so on. Like
// beside like packs a tenth smaller. Sorting (when the page is built) and putting back (when it is opened) are one
// walk over the code: there from the module into the streams, here from the streams into a module.
//
// WebAssembly Core Specification 2.0, 5.4 and 5.5.

enum Stream { others, declarations, operations, blocks, branches, calls, locals, globals, offsets, integers, longs, reals, vectors }
const streamCount = 13
const heading = 4 * streamCount // their lengths
const codeSection = 10

class Tape {
  at = 0
  constructor(readonly bytes: Uint8Array) {}
}

/** Moves a module from tapes to tapes, one for each stream. `sized` moves what has its size written before it. */
function moveModule(from: Tape[], to: Tape[], sized: (move: () => void) => void): void {
  const byte = (stream: Stream): number => {
    const source = from[stream]!
    const target = to[stream]!
    if (source.at >= source.bytes.length) throw new RangeError('the code ends early')
    return (target.bytes[target.at++] = source.bytes[source.at++]!)
  }
  const bytes = (stream: Stream, count: number) => {
    for (; count > 0; --count) byte(stream)
  }
  const number = (stream: Stream): number => {
    const source = from[stream]!
    const target = to[stream]!
    for (let value = 0, shift = 0; ; shift += 7) {
      const next = (target.bytes[target.at++] = source.bytes[source.at++]!)
      value |= (next & 0x7f) << shift
      if (!(next >= 0x80)) return value
    }
  }
  const numbers = (stream: Stream, count: number) => {
    for (; count > 0; --count) number(stream)
  }
  const place = () => {
    number(Stream.operations) // its alignment, which the operation all but says
    number(Stream.offsets)
  }

  const memoryOperation = () => {
    const code = number(Stream.operations)
    if (code >= 8) bytes(Stream.globals, code === 8 || code === 10 ? 2 : 1)
  }
  const vectorOperation = () => {
    const code = number(Stream.operations)
    if (code === 12 || code === 13) bytes(Stream.vectors, 16)
    else if (code >= 21 && code <= 34) byte(Stream.vectors)
    else if (code <= 11 || (code >= 84 && code <= 93)) {
      place()
      if (code >= 84 && code <= 91) byte(Stream.vectors)
    }
  }

  const moveFunction = () => {
    numbers(Stream.declarations, 2 * number(Stream.declarations))
    for (let depth = 1; depth > 0;) {
      const code = byte(Stream.operations)
      if (code >= 0x20 && code <= 0x22) number(Stream.locals)
      else if (code >= 0x28 && code <= 0x3e) place()
      else if (code === 0x41) number(Stream.integers)
      else if (code === 0x10) number(Stream.calls)
      else if (code === 0x0b) --depth
      else if (code >= 0x02 && code <= 0x04) {
        ++depth
        number(Stream.blocks)
      } else if (code === 0x0c || code === 0x0d) number(Stream.branches)
      else if (code === 0x0e) numbers(Stream.branches, number(Stream.branches) + 1)
      else if (code === 0x11) numbers(Stream.calls, 2)
      else if (code === 0x23 || code === 0x24 || code === 0x3f || code === 0x40) number(Stream.globals)
      else if (code === 0x42) number(Stream.longs)
      else if (code === 0x43) bytes(Stream.reals, 4)
      else if (code === 0x44) bytes(Stream.reals, 8)
      else if (code === 0xfc) memoryOperation()
      else if (code === 0xfd) vectorOperation()
    }
  }

  bytes(Stream.others, 8)
  while (byte(Stream.others) !== codeSection) bytes(Stream.others, number(Stream.others))
  sized(() => {
    for (let left = number(Stream.declarations); left > 0; --left) sized(moveFunction)
  })
  const others = from[Stream.others]!
  bytes(Stream.others, others.bytes.length - others.at)
}

/** A module's streams, after their lengths. */
export function sortedCode(module: Uint8Array): Uint8Array {
  const from = new Tape(module)
  const streams = Array.from({ length: streamCount }, () => new Tape(new Uint8Array(module.length)))
  moveModule(Array(streamCount).fill(from), streams, (move) => {
    while (module[from.at++]! >= 0x80);
    move()
  })
  const sorted = new Uint8Array(heading + module.length)
  const lengths = new DataView(sorted.buffer)
  let size = heading
  streams.forEach(({ at, bytes }, i) => {
    lengths.setUint32(4 * i, at, true)
    sorted.set(bytes.subarray(0, at), size)
    size += at
  })
  return sorted.subarray(0, size)
}

/** The module that sortedCode took apart. Throws a RangeError where the bytes end early. */
export function moduleOf(sorted: Uint8Array): Uint8Array<ArrayBuffer> {
  const lengths = new DataView(sorted.buffer, sorted.byteOffset)
  let at = heading
  const streams = Array.from({ length: streamCount }, (_, i) => new Tape(sorted.subarray(at, (at += lengths.getUint32(4 * i, true)))))
  const module = new Tape(new Uint8Array(2 * sorted.length))
  moveModule(streams, Array(streamCount).fill(module), (move) => {
    const begin = module.at
    move()
    const size = leb(module.at - begin)
    module.bytes.copyWithin(begin + size.length, begin, module.at)
    module.bytes.set(size, begin)
    module.at += size.length
  })
  return module.bytes.subarray(0, module.at) as Uint8Array<ArrayBuffer>
}

function leb(value: number): number[] {
  return value < 0x80 ? [value] : [(value & 0x7f) | 0x80, ...leb(value >>> 7)]
}
