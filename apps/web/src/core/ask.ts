// The page's one core: `ask('simulate', [['mass', '2 kg']])`.
import module from 'virtual:core'
import { connect } from './client'
import CoreWorker from './worker?worker&inline'

const bytes = Uint8Array.from(atob(module), (c) => c.charCodeAt(0))

export const ask = connect(new CoreWorker(), bytes)
