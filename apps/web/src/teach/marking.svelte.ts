// The teacher's side: the class that is being made, the hand-ins that were opened, and the answer key.
import { askAside as ask } from '../core/ask'
import { page } from '../state/page.svelte'
import { commonOptions, keyFor, mark, readHandIn, whoIs, type HandIn, type Marked } from './hand_in'
import { optionsOf, stateOf, type ClassOptions } from './options'
import type { Key } from './questions'
import { oneForm, seedOf } from './seed'

class Marking {
  /// A class is being made.
  making = $state(false)
  rows: Marked[] = $state.raw([])
  /// Names of files that are no hand-ins.
  refused: string[] = $state.raw([])
  /// How many are still to be marked, and how many keys to be made.
  toMark = $state(0)
  toKey = $state(0)
  left = $derived(this.toMark + this.toKey)
  keys: { student: string; key: Key }[] = $state.raw([])
  /// What the keys are of.
  keyOptions: ClassOptions | null = $state.raw(null)
  open = $derived(this.rows.length + this.refused.length + this.left + this.keys.length > 0)
}
export const marking = new Marking()

let [markTurn, keyTurn] = [0, 0]
/// By who handed them in; more may be opened while these are being marked.
const handIns = new Map<string, HandIn>()

/// Marks them one after another, the oldest file first: what a student handed in later takes the earlier one's place.
export async function markFiles(files: ArrayLike<globalThis.File>): Promise<void> {
  const mine = ++markTurn
  const inTime = Array.from(files).sort((a, b) => a.lastModified - b.lastModified)
  const texts = await Promise.all(inTime.map((file) => file.text().catch(() => '')))
  const read = texts.map((text, i) => ({ name: inTime[i]!.name, handIn: readHandIn(text) }))
  for (const { handIn } of read) if (handIn) handIns.set(whoIs(handIn), handIn)
  if (mine !== markTurn) return
  marking.refused = read.filter(({ handIn }) => !handIn).map(({ name }) => name)
  const all = [...handIns.values()].sort((a, b) => a.student.localeCompare(b.student, undefined, { numeric: true }))
  const done: Marked[] = []
  marking.toMark = all.length
  for (const handIn of all) {
    done.push(await mark(handIn, ask, optionsFor(handIn.course, all)))
    if (mine !== markTurn) return
    marking.rows = [...done]
    marking.toMark = all.length - done.length
  }
}

/// Of the class whose link is open here; else what most of its hand-ins say.
function optionsFor(course: string, all: HandIn[]) {
  if (oneForm(course) === oneForm(page.teach.course)) return stateOf(optionsOf(page.teach))
  return commonOptions(all.filter((handIn) => oneForm(handIn.course) === oneForm(course)))
}

/// The key of students 1 to `count` of a class.
export async function makeKeys(course: string, count: number, options: ClassOptions): Promise<void> {
  const mine = ++keyTurn
  Object.assign(marking, { keys: [], keyOptions: options, toKey: count })
  for (let number = 1; number <= count; ++number) {
    const student = String(number)
    const key = await keyFor(seedOf(course, student), options, ask)
    if (mine !== keyTurn) return
    if (key) marking.keys = [...marking.keys, { student, key }]
    marking.toKey -= 1
  }
}

export function closeMarking(): void {
  ++markTurn
  ++keyTurn
  handIns.clear()
  Object.assign(marking, { rows: [], refused: [], toMark: 0, toKey: 0, keys: [], keyOptions: null })
}
