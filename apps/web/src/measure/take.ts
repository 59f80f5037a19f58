// What was dropped, pasted or chosen: one file is read, and what cannot be is said where a bad file is.
import { words } from '../words/words.svelte'
import { longest, nothing, openFile, session } from './session.svelte'

/// Opens the first of `files`. False where it could not be read, or there is none.
export async function takeFiles(files: ArrayLike<globalThis.File> | null | undefined): Promise<boolean> {
  const file = files?.[0]
  if (!file) return false
  const w = words().measure.drop
  const refuse = (name: string, message: string, code = ''): false => {
    session.refused = { file: null, name, why: { ...nothing, message, code } }
    return false
  }
  if (file.size > longest) return refuse(file.name, w.tooLarge(`${Math.round(file.size / 1e6)}\u00a0MB`))
  let bytes: Uint8Array
  try {
    bytes = new Uint8Array(await file.arrayBuffer())
  } catch {
    return refuse(file.name, w.noFile)
  }
  if (!(await openFile({ name: file.name, bytes, origin: 'file' }))) return false
  if (files.length > 1) refuse(Array.from(files, (each) => each.name).slice(1).join(', '), w.oneOnly(file.name), 'one_at_a_time')
  return true
}
