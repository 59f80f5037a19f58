// The core writes long lists of numbers not as text but beside the document, which says {"block": [first,
// count]} in their place: here they come back together.

/// The document with every block in it as its part of `numbers`.
export function withBlocks(value: unknown, numbers: Float64Array): unknown {
  if (Array.isArray(value)) {
    for (let i = 0; i < value.length; ++i) value[i] = withBlocks(value[i], numbers)
    return value
  }
  if (typeof value !== 'object' || value === null) return value
  const object = value as Record<string, unknown>
  const block = object.block
  if (Array.isArray(block)) return numbers.subarray(block[0], block[0] + block[1])
  for (const name in object) object[name] = withBlocks(object[name], numbers)
  return object
}
