// The hand-ins that a teacher has opened, and the answer key of a class.
import { askAside as ask } from '../core/ask'
import { keyFor, mark, readHandIn, type Marked } from './hand_in'
import type { Key } from './key'

class Marking {
  rows: Marked[] = $state.raw([])
  /// Names of files that are no hand-ins.
  refused: string[] = $state.raw([])
  /// How many are still to be marked.
  left = $state(0)
  keys: { student: string; key: Key }[] = $state.raw([])
  open = $derived(this.rows.length + this.refused.length + this.left + this.keys.length > 0)
}
export const marking = new Marking()

let turn = 0

/// Marks them one after another; the later of one student takes the earlier one's place.
export async function markFiles(files: ArrayLike<globalThis.File>): Promise<void> {
  const mine = ++turn
  const texts = await Promise.all(Array.from(files, async (file) => ({ name: file.name, text: await file.text().catch(() => '') })))
  const read = texts.map(({ name, text }) => ({ name, handIn: readHandIn(text) }))
  marking.refused = read.filter(({ handIn }) => !handIn).map(({ name }) => name)
  const handIns = read.flatMap(({ handIn }) => (handIn ? [handIn] : []))
  marking.left = handIns.length
  for (const handIn of handIns) {
    const marked = await mark(handIn, ask)
    if (mine !== turn) return
    const others = marking.rows.filter((row) => row.handIn.course !== handIn.course || row.handIn.student !== handIn.student)
    marking.rows = [...others, marked].sort((a, b) => a.handIn.student.localeCompare(b.handIn.student, undefined, { numeric: true }))
    marking.left -= 1
  }
}

/// The key of students 1 to `count` of a class.
export async function makeKeys(course: string, count: number): Promise<void> {
  const mine = ++turn
  marking.keys = []
  marking.left = count
  for (let number = 1; number <= count; ++number) {
    const key = await keyFor(course, String(number), ask)
    if (mine !== turn) return
    if (key) marking.keys = [...marking.keys, { student: String(number), key }]
    marking.left -= 1
  }
}

export function closeMarking(): void {
  ++turn
  Object.assign(marking, { rows: [], refused: [], left: 0, keys: [] })
}
