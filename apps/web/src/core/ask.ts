// The page's one core: `ask('simulate', [['mass', '2 kg']])`. A page that lets go of long questions opens its own.
import module from 'virtual:core'
import { connect, type Ask } from './client'
import CoreWorker from './worker?worker&inline'

const bytes = Uint8Array.from(atob(module), (c) => c.charCodeAt(0))

/// A core in a worker of its own. `close` ends it in the middle of a question, which is then never answered.
export function openCore(): { ask: Ask; close: () => void } {
  const worker = new CoreWorker()
  return { ask: connect(worker, bytes.slice()), close: () => worker.terminate() }
}

export const ask = openCore().ask
