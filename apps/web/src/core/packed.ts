// The core comes packed, with the program that unpacks it before it (pack/pack.mjs): a third smaller than gzip.

interface Unpacker {
  memory: WebAssembly.Memory
  _initialize(): void
  plain(): number
  packed(): number
  most(): number
  unpack(length: number): void
}

/// What pack.mjs has packed. Throws where it is damaged.
export async function unpacked(bytes: Uint8Array): Promise<Uint8Array> {
  const numberAt = (at: number) => new DataView(bytes.buffer, bytes.byteOffset + at).getUint32(0, true)
  const program = 4 + numberAt(0)
  const length = numberAt(program)
  const packed = bytes.subarray(program + 4)
  const module = await WebAssembly.compile((await unzip(bytes.subarray(4, program))) as Uint8Array<ArrayBuffer>)
  const unpacker = start<Unpacker>(module)
  const most = unpacker.most()
  if (length > most || packed.length > most) throw new RangeError('the packed core is damaged')
  new Uint8Array(unpacker.memory.buffer, unpacker.packed(), packed.length).set(packed)
  unpacker.unpack(length)
  return new Uint8Array(unpacker.memory.buffer, unpacker.plain(), length)
}

/// What is gzipped.
export async function unzip(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as Uint8Array<ArrayBuffer>])
    .stream()
    .pipeThrough(new DecompressionStream('gzip'))
  return new Uint8Array(await new Response(stream).arrayBuffer())
}

/// A module asks a system for little (arguments, an output for its last words), and gets none of it.
export function start<Exports extends { _initialize(): void }>(module: WebAssembly.Module): Exports {
  const imports: Record<string, Record<string, () => number>> = {}
  for (const each of WebAssembly.Module.imports(module)) (imports[each.module] ??= {})[each.name] = () => 0
  const instance = new WebAssembly.Instance(module, imports).exports as unknown as Exports
  instance._initialize()
  return instance
}
