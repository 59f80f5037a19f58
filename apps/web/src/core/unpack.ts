// Archives with deflated entries (phyphox exports them) are inflated by the browser, so that the core needs no
// inflate of its own. PKWARE, "APPNOTE.TXT - .ZIP File Format Specification", 6.3.

const localMark = 0x04034b50
const centralMark = 0x02014b50
const endMark = 0x06054b50
const stored = 0
const deflated = 8

interface Entry {
  /// The entry in the directory, with name, extra fields and comment.
  record: Uint8Array
  /// The entry's own heading and what it holds.
  local: Uint8Array
  content: Uint8Array
}

/// The file as it is, unless it is a ZIP archive with deflated entries: then one that holds the same entries
/// stored. What is locked, damaged or claims to hold far more than its size stays as it is: the core says so.
export async function unpack(file: Uint8Array): Promise<Uint8Array> {
  try {
    const entries = directoryOf(file)
    if (!entries.some(isDeflated)) return file
    return archiveOf(await Promise.all(entries.map(storedEntry)))
  } catch {
    return file
  }
}

const view = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)

/// Throws where the archive is damaged.
function directoryOf(file: Uint8Array): Entry[] {
  const all = view(file)
  if (file.length < 22 || all.getUint32(0, true) !== localMark) return []
  let end = file.length - 22
  while (all.getUint32(end, true) !== endMark) --end
  const entries: Entry[] = []
  let at = all.getUint32(end + 16, true)
  let packed = 0
  for (let left = all.getUint16(end + 10, true); left > 0; --left) {
    if (all.getUint32(at, true) !== centralMark) throw new RangeError('no directory')
    const size = all.getUint32(at + 20, true)
    const length =
      46 + all.getUint16(at + 28, true) + all.getUint16(at + 30, true) + all.getUint16(at + 32, true)
    const local = all.getUint32(at + 42, true)
    if (all.getUint32(local, true) !== localMark) throw new RangeError('no entry')
    const from = local + 30 + all.getUint16(local + 26, true) + all.getUint16(local + 28, true)
    packed += size
    // Entries that share their bytes could be many times the file.
    if (from + size > file.length || at + length > end || packed > file.length)
      throw new RangeError('too short')
    entries.push({
      record: file.slice(at, at + length),
      local: file.slice(local, from),
      content: file.subarray(from, from + size),
    })
    at += length
  }
  return entries
}

const mostTimes = 50
const allowance = 10_000

/// Deflated, not locked, and of a size that may be inflated.
function isDeflated({ record, content }: Entry): boolean {
  const of = view(record)
  const locked = (of.getUint16(8, true) & 1) !== 0
  return (
    of.getUint16(10, true) === deflated &&
    !locked &&
    of.getUint32(24, true) <= mostTimes * content.length + allowance
  )
}

async function storedEntry(entry: Entry): Promise<Entry> {
  if (!isDeflated(entry)) return entry
  const content = await inflate(entry.content, view(entry.record).getUint32(24, true))
  const record = entry.record.slice()
  const local = entry.local.slice()
  view(record).setUint16(10, stored, true)
  view(record).setUint32(20, content.length, true)
  view(local).setUint16(8, stored, true)
  return { record, local, content }
}

/// Throws where it is not deflated, or is not of that size.
async function inflate(content: Uint8Array, size: number): Promise<Uint8Array> {
  const stream = new Blob([content as Uint8Array<ArrayBuffer>])
    .stream()
    .pipeThrough(new DecompressionStream('deflate-raw'))
  const inflated = new Uint8Array(size)
  const reader = stream.getReader()
  let at = 0
  for (;;) {
    const { done, value } = await reader.read()
    if (done) break
    if (at + value.length > size) {
      await reader.cancel()
      throw new RangeError('more than it claims')
    }
    inflated.set(value, at)
    at += value.length
  }
  if (at !== size) throw new RangeError('less than it claims')
  return inflated
}

function archiveOf(entries: Entry[]): Uint8Array {
  let offset = 0
  for (const { record, local, content } of entries) {
    view(record).setUint32(42, offset, true)
    offset += local.length + content.length
  }
  const end = new Uint8Array(22)
  view(end).setUint32(0, endMark, true)
  view(end).setUint16(8, entries.length, true)
  view(end).setUint16(10, entries.length, true)
  view(end).setUint32(
    12,
    entries.reduce((sum, { record }) => sum + record.length, 0),
    true,
  )
  view(end).setUint32(16, offset, true)
  return joined([
    ...entries.flatMap(({ local, content }) => [local, content]),
    ...entries.map(({ record }) => record),
    end,
  ])
}

function joined(parts: Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0))
  let at = 0
  for (const part of parts) {
    whole.set(part, at)
    at += part.length
  }
  return whole
}
