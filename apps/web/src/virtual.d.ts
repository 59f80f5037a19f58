declare module 'virtual:core' {
  const base64: string // the core's module, gzipped
  export default base64
}
