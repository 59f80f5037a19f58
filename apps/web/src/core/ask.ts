// The page's cores: `ask('simulate', [['mass', '2 kg']])`.
import module from 'virtual:core'
import { connect, type Ask } from './client'
import CoreWorker from './worker?worker&inline'

const bytes = Uint8Array.from(atob(module), (c) => c.charCodeAt(0))

/// A core in a worker of its own. `close` ends it in the middle of a question, which is then never answered.
export function openCore(): { ask: Ask; close: () => void } {
  const worker = new CoreWorker()
  return { ask: connect(worker, bytes), close: () => worker.terminate() }
}

export const ask: Ask = openCore().ask

let aside: Ask | undefined
/** A second worker for what takes longer, so that moving a slider never waits for it. */
export const askAside: Ask = (...question) => (aside ??= openCore().ask)(...question)
