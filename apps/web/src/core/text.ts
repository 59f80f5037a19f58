// Bytes as text of which gzip makes hardly more than the bytes were: 94 characters, 34 of which stand for six bits and
// 60 for seven, as long as gzip's own codes for them get. (Base64 has so few characters that gzip takes three of them
// for a repetition now and then, and loses by it.)

const characters = 94
const short = 128 - characters // of six bits

/// From '=' to '~' and on from ' ': only '<', which could end a script, is never reached.
const characterOf = (index: number) => String.fromCharCode(32 + ((index + 29) % 95))
const indexOf = (code: number) => (code + 34) % 95

export function textOf(bytes: Uint8Array): string {
  let text = ''
  let [held, bits, at] = [0, 0, 0]
  const next = (count: number) => {
    if (bits < count) [held, bits] = [(held << 8) | (bytes[at++] ?? 0), bits + 8]
    return (held >> (bits -= count)) & ((1 << count) - 1)
  }
  while (8 * at - bits < 8 * bytes.length) {
    const six = next(6)
    text += characterOf(six < short ? six : 2 * six + next(1) - short)
  }
  return text
}

export function bytesOf(text: string): Uint8Array {
  const bytes = new Uint8Array((7 * text.length) >> 3)
  let [held, bits, at] = [0, 0, 0]
  for (let i = 0; i < text.length; ++i) {
    const index = indexOf(text.charCodeAt(i))
    const isShort = index < short
    held = (held << (isShort ? 6 : 7)) | (isShort ? index : index + short)
    bits += isShort ? 6 : 7
    if (bits >= 8) bytes[at++] = held >> (bits -= 8)
  }
  return bytes.subarray(0, at)
}
