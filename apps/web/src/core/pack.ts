// Packs the core when the page is built (vite.config.ts).
import { execFileSync } from 'node:child_process'
import { textOf } from './text'
import { moduleOf, sortedCode } from './streams'

/** A module as the page carries it. */
export function packed(module: Uint8Array): string {
  const sorted = sortedCode(module)
  if (Buffer.compare(moduleOf(sorted), module) !== 0) throw new Error('the code has an operation that streams.ts does not know')
  const options = ['--format=lzma', '--lzma1=preset=9e,lc=1,lp=0,pb=0', '--stdout']
  return textOf(execFileSync('xz', options, { input: sorted, maxBuffer: 1 << 28 }))
}
