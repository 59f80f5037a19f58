// The page's cores: `ask('simulate', [['mass', '2 kg']])`.
import module from 'virtual:core'
import { connect, type Ask } from './client'
import CoreWorker from './worker?worker&inline'

const bytes = Uint8Array.from(atob(module), (c) => c.charCodeAt(0))

export const ask: Ask = connect(new CoreWorker(), bytes)

let aside: Ask | undefined
/** A second worker for what takes longer, so that moving a slider never waits for it. */
export const askAside: Ask = (...question) => (aside ??= connect(new CoreWorker(), bytes))(...question)
