// The hand-ins that a teacher has opened, and the answer key of a class.
import { askAside as ask } from '../core/ask'
import { keyFor, mark, readHandIn, whoIs, type Marked } from './hand_in'
import type { Key } from './key'

class Marking {
  rows: Marked[] = $state.raw([])
  /// Names of files that are no hand-ins.
  refused: string[] = $state.raw([])
  /// How many are still to be marked, and how many keys to be made.
  toMark = $state(0)
  toKey = $state(0)
  left = $derived(this.toMark + this.toKey)
  keys: { student: string; key: Key }[] = $state.raw([])
  open = $derived(this.rows.length + this.refused.length + this.left + this.keys.length > 0)
}
export const marking = new Marking()

let [markTurn, keyTurn] = [0, 0]

/// Marks them one after another, the oldest file first: what a student handed in later takes the earlier one's place.
export async function markFiles(files: ArrayLike<globalThis.File>): Promise<void> {
  const mine = ++markTurn
  const inTime = Array.from(files).sort((a, b) => a.lastModified - b.lastModified)
  const texts = await Promise.all(inTime.map((file) => file.text().catch(() => '')))
  if (mine !== markTurn) return
  const read = texts.map((text, i) => ({ name: inTime[i]!.name, handIn: readHandIn(text) }))
  marking.refused = read.filter(({ handIn }) => !handIn).map(({ name }) => name)
  const handIns = read.flatMap(({ handIn }) => (handIn ? [handIn] : []))
  marking.toMark = handIns.length
  for (const handIn of handIns) {
    const marked = await mark(handIn, ask)
    if (mine !== markTurn) return
    const others = marking.rows.filter((row) => whoIs(row.handIn) !== whoIs(handIn))
    marking.rows = [...others, marked].sort((a, b) => a.handIn.student.localeCompare(b.handIn.student, undefined, { numeric: true }))
    marking.toMark -= 1
  }
}

/// The key of students 1 to `count` of a class.
export async function makeKeys(course: string, count: number): Promise<void> {
  const mine = ++keyTurn
  marking.keys = []
  marking.toKey = count
  for (let number = 1; number <= count; ++number) {
    const key = await keyFor(course, String(number), ask)
    if (mine !== keyTurn) return
    if (key) marking.keys = [...marking.keys, { student: String(number), key }]
    marking.toKey -= 1
  }
}

export function closeMarking(): void {
  ++markTurn
  ++keyTurn
  Object.assign(marking, { rows: [], refused: [], toMark: 0, toKey: 0, keys: [] })
}
