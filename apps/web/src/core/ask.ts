// The page's cores: `ask('motion', [['mass', '2 kg']])`.
import packed from 'virtual:core'
import { connect, type Ask } from './client'
import type { Start, Started } from './worker'
import CoreWorker from './worker?worker&inline'

const give = (worker: Worker, start: Start) => worker.postMessage(start)

const first = new CoreWorker()
/// The core's module, compiled once, by the first worker. null where a browser does not let it be handed on.
export const compiled = new Promise<WebAssembly.Module | null>((resolve) => {
  first.addEventListener('message', ({ data }: MessageEvent<Started | object>) => {
    if ('module' in data) resolve(data.module)
  })
  for (const fault of ['messageerror', 'error']) first.addEventListener(fault, () => resolve(null))
})
give(first, { packed })

export const ask: Ask = connect(first)

/// A core in a worker of its own. `close` ends it in the middle of a question, which is then never answered.
export function openCore(): { ask: Ask; close: () => void } {
  const worker = new CoreWorker()
  void compiled.then((module) => give(worker, module ? { module } : { packed }))
  return { ask: connect(worker), close: () => worker.terminate() }
}

let aside: Ask | undefined
/** A second worker for what takes longer, so that moving a slider never waits for it. */
export const askAside: Ask = (...question) => (aside ??= openCore().ask)(...question)
