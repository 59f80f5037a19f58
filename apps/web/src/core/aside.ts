// A second worker for what takes longer, so that moving a slider never waits for it. Started when first asked.
import module from 'virtual:core'
import { connect, type Ask } from './client'
import CoreWorker from './worker?worker&inline'

let aside: Ask | undefined

export const askAside: Ask = (...question) =>
  (aside ??= connect(new CoreWorker(), Uint8Array.from(atob(module), (c) => c.charCodeAt(0))))(...question)
