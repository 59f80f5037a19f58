// Every change of the state goes through `change`; what a slider does in one go is one change.
import { page, replace, type PageDocument } from './page.svelte'

const oneGo = 800 // [ms] changes of one name closer together than this are one
const most = 200 // changes kept

interface Step {
  name: string
  before: PageDocument
}
const copyOfPage = (): PageDocument => structuredClone($state.snapshot(page) as PageDocument)

const past: Step[] = $state([])
const undone: PageDocument[] = $state([])
let last = { name: '', at: -Infinity }

/** Changes the state. `name` tells changes apart: those of one slider share it. */
export function change(name: string, mutate: (state: PageDocument) => void, now = performance.now()): void {
  const goesOn = name === last.name && now - last.at < oneGo && past.length > 0
  const before = goesOn ? null : copyOfPage()
  mutate(page)
  last = { name, at: now }
  if (!before) return
  past.push({ name, before })
  if (past.length > most) past.shift()
  undone.length = 0
}

/** Changes what undo must not take back: the state and all that are kept. */
export function settle(mutate: (state: PageDocument) => void): void {
  mutate(page)
  for (const step of past) mutate(step.before)
  for (const each of undone) mutate(each)
  last = { name: '', at: -Infinity }
}

export const canUndo = (): boolean => past.length > 0

export function undo(): void {
  const step = past.pop()
  if (!step) return
  undone.push(copyOfPage())
  last = { name: '', at: -Infinity }
  replace(step.before)
}

export function redo(): void {
  const next = undone.pop()
  if (!next) return
  past.push({ name: 'redo', before: copyOfPage() })
  replace(next)
}

/** Forgets everything: after a link was opened. */
export function forget(): void {
  past.length = 0
  undone.length = 0
}
