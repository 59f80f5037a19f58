// The core writes long lists of numbers not as text but beside the document, which says {"block": [first,
// count]} in their place: here they come back together.

/// The document with every block in it as a Float64Array of its own.
export function withBlocks(value: unknown, numbers: Float64Array): unknown {
  if (Array.isArray(value)) {
    for (let i = 0; i < value.length; ++i) value[i] = withBlocks(value[i], numbers)
    return value
  }
  if (typeof value !== 'object' || value === null) return value
  const object = value as Record<string, unknown>
  const block = object.block
  if (Array.isArray(block)) return numbers.slice(block[0], block[0] + block[1])
  for (const name in object) object[name] = withBlocks(object[name], numbers)
  return object
}

/// The buffers of a document's arrays: what can be handed to another thread without a copy.
export function buffersOf(value: unknown, found: ArrayBuffer[] = []): ArrayBuffer[] {
  if (value instanceof Float64Array) found.push(value.buffer as ArrayBuffer)
  else if (typeof value === 'object' && value !== null)
    for (const each of Object.values(value)) buffersOf(each, found)
  return found
}
