// node pack.mjs FOLDER MODULE PACKED: packs a WebAssembly module by pack.wasm of the folder. What it writes holds
// first the program that unpacks it: its length (4 bytes, the lowest first), unpack.wasm gzipped, the length of
// the module, and the module.
import { readFileSync, writeFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'

const [folder, module, to] = process.argv.slice(2)
const plain = readFileSync(module)
const imports = { wasi_snapshot_preview1: { proc_exit() {} } }
const compiled = new WebAssembly.Module(readFileSync(`${folder}/pack.wasm`))
const packer = new WebAssembly.Instance(compiled, imports).exports
packer._initialize()
if (plain.length > packer.most()) throw new RangeError(`${module}: ${plain.length} bytes, of ${packer.most()} that can be packed`)
new Uint8Array(packer.memory.buffer, packer.plain(), plain.length).set(plain)
const length = packer.pack(plain.length)
const packed = new Uint8Array(packer.memory.buffer, packer.packed(), length)

const number = (value) => Buffer.from(Uint32Array.of(value).buffer)
const unpacker = gzipSync(readFileSync(`${folder}/unpack.wasm`), { level: 9 })
writeFileSync(to, Buffer.concat([number(unpacker.length), unpacker, number(plain.length), packed]))
