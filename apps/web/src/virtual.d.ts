declare module 'virtual:core' {
  const base64: string // the core's module, gzipped
  export default base64
}
declare module 'js-lzma' {
  /** Throws a text where the bytes are no .lzma file. */
  export function decompressFile(from: { readByte(): number }, to: { writeByte(byte: number): void }): true
}
