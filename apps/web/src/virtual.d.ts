declare module 'virtual:core' {
  const packed: string // the core's module, as pack.ts packs it
  export default packed
}
declare module 'js-lzma' {
  /** Throws a text where the bytes are no .lzma file. */
  export function decompressFile(from: { readByte(): number }, to: { writeByte(byte: number): void }): true
}
