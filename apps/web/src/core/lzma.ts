// Decompresses an .lzma file: a fifth smaller than gzip, and browsers have no decompressor of its kind.
//
// I. Pavlov, "LZMA specification (draft)", 2015, https://www.7-zip.org/sdk.html: a range coder whose
// probabilities learn, each in its context; matches with earlier bytes, the last four distances at hand.

const bitsOfModel = 11
const learning = 5
const half = 1 << (bitsOfModel - 1)

/// So many probabilities, all even.
const even = (count: number) => new Uint16Array(count).fill(half)

/// The bits of a range coder.
class Bits {
  private range = 0xffffffff
  private code = 0

  constructor(
    private readonly bytes: Uint8Array,
    private at: number,
  ) {
    for (let i = 0; i < 5; ++i) this.code = ((this.code << 8) | this.bytes[this.at++]!) >>> 0
  }

  private normalise() {
    if (this.range >= 0x1000000) return
    if (this.at >= this.bytes.length) throw new RangeError('the compressed data end early')
    this.range = (this.range << 8) >>> 0
    this.code = ((this.code << 8) | this.bytes[this.at++]!) >>> 0
  }

  bit(model: Uint16Array, index: number): number {
    const probability = model[index]!
    const bound = (this.range >>> bitsOfModel) * probability
    let bit = 0
    if (this.code < bound) {
      this.range = bound
      model[index] = probability + (((1 << bitsOfModel) - probability) >>> learning)
    } else {
      this.range -= bound
      this.code -= bound
      model[index] = probability - (probability >>> learning)
      bit = 1
    }
    this.normalise()
    return bit
  }

  /// Bits without a model.
  plain(count: number): number {
    let value = 0
    for (; count > 0; --count) {
      this.range >>>= 1
      const bit = this.code >= this.range ? 1 : 0
      if (bit) this.code -= this.range
      value = value * 2 + bit
      this.normalise()
    }
    return value
  }

  /// `count` bits, the highest first, each in the context of those before it.
  tree(model: Uint16Array, count: number, from = 0): number {
    let node = 1
    for (let i = 0; i < count; ++i) node = (node << 1) | this.bit(model, from + node)
    return node - (1 << count)
  }

  /// The same, the lowest first.
  treeFromBelow(model: Uint16Array, count: number, from = 0): number {
    let node = 1
    let value = 0
    for (let i = 0; i < count; ++i) {
      const bit = this.bit(model, from + node)
      node = (node << 1) | bit
      value |= bit << i
    }
    return value
  }
}

/// Lengths of matches, 2 and more.
class Lengths {
  private readonly choice = even(2)
  private readonly low = even(16 << 3)
  private readonly middle = even(16 << 3)
  private readonly high = even(256)

  read(bits: Bits, place: number): number {
    if (!bits.bit(this.choice, 0)) return 2 + bits.tree(this.low, 3, place << 3)
    if (!bits.bit(this.choice, 1)) return 10 + bits.tree(this.middle, 3, place << 3)
    return 18 + bits.tree(this.high, 8)
  }
}

const states = 12
const lengthContexts = 4
const modelledSlots = 14
const endOfData = 0xffffffff

/// The bytes of an .lzma file whose heading says how many they are (13 bytes, then the stream). Throws a
/// RangeError where they are damaged.
export function unlzma(file: Uint8Array): Uint8Array {
  const size = sizeOf(file)
  const properties = file[0]!
  const contextBits = properties % 9
  const lowBits = Math.floor(properties / 9) % 5
  const placeMask = (1 << Math.floor(properties / 45)) - 1
  const lowMask = (1 << lowBits) - 1

  const bits = new Bits(file, 13)
  const literals = even(0x300 << (contextBits + lowBits))
  const isMatch = even(states << 4)
  const isRepeat = even(states)
  const isOlder = [even(states), even(states), even(states)] as const
  const isLong = even(states << 4)
  const slots = even(lengthContexts << 6)
  const near = even(1 + 128 - modelledSlots)
  const aligned = even(16)
  const matchLengths = new Lengths()
  const repeatLengths = new Lengths()

  const out = new Uint8Array(size)
  const distance = [0, 0, 0, 0] as [number, number, number, number] // less 1
  let at = 0
  let state = 0

  const literal = () => {
    const before = at > 0 ? out[at - 1]! : 0
    const from = 0x300 * (((at & lowMask) << contextBits) + (before >> (8 - contextBits)))
    let symbol = 1
    if (state >= 7) {
      let matched = out[at - distance[0] - 1]!
      while (symbol < 0x100) {
        const expected = (matched >> 7) & 1
        matched <<= 1
        const bit = bits.bit(literals, from + ((1 + expected) << 8) + symbol)
        symbol = (symbol << 1) | bit
        if (bit !== expected) break
      }
    }
    while (symbol < 0x100) symbol = (symbol << 1) | bits.bit(literals, from + symbol)
    out[at++] = symbol & 0xff
    state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6
  }

  const farDistance = (length: number): number => {
    const slot = bits.tree(slots, 6, Math.min(length - 2, lengthContexts - 1) << 6)
    if (slot < 4) return slot
    const count = (slot >> 1) - 1
    const base = (2 | (slot & 1)) * 2 ** count
    if (slot < modelledSlots) return base + bits.treeFromBelow(near, count, base - slot)
    return base + bits.plain(count - 4) * 16 + bits.treeFromBelow(aligned, 4)
  }

  /// The last distance but `age` becomes the last.
  const reuse = (age: number) => {
    const [again] = distance.splice(age, 1)
    distance.unshift(again!)
  }

  while (at < size) {
    const place = at & placeMask
    if (!bits.bit(isMatch, (state << 4) + place)) {
      literal()
      continue
    }
    let length: number
    if (!bits.bit(isRepeat, state)) {
      distance.pop()
      length = matchLengths.read(bits, place)
      distance.unshift(farDistance(length))
      if (distance[0] === endOfData) break
      state = state < 7 ? 7 : 10
    } else {
      if (!bits.bit(isOlder[0], state)) {
        if (!bits.bit(isLong, (state << 4) + place)) {
          if (distance[0] >= at) throw new RangeError('the compressed data are damaged')
          out[at] = out[at - distance[0] - 1]!
          ++at
          state = state < 7 ? 9 : 11
          continue
        }
      } else {
        reuse(!bits.bit(isOlder[1], state) ? 1 : !bits.bit(isOlder[2], state) ? 2 : 3)
      }
      length = repeatLengths.read(bits, place)
      state = state < 7 ? 8 : 11
    }
    if (distance[0] >= at || at + length > size) throw new RangeError('the compressed data are damaged')
    for (const end = at + length; at < end; ++at) out[at] = out[at - distance[0] - 1]!
  }
  return out
}

function sizeOf(file: Uint8Array): number {
  const heading = new DataView(file.buffer, file.byteOffset, file.byteLength)
  const size = file.length < 18 ? 0 : heading.getUint32(5, true)
  if (file.length < 18 || heading.getUint32(9, true) !== 0)
    throw new RangeError('the compressed data do not say how many they are')
  return size
}
