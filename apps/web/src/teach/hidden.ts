// Whether a class has the law of its recordings hidden: its students work by hand, and nothing here fits them.
import { page } from '../state/page.svelte'
import { hashOf, nameOf } from './seed'

/// "7F3A-19.csv"; of the practice recording where there is no name.
export const recordingName = (name: string): string => `${name || 'practice'}.csv`.replace(/[^\w.-]+/g, '_')

const seen = new Set<number>()

/// It is known again when it was saved and is opened from a disk under another name.
export function isHidden(file: { name: string; bytes: Uint8Array } | null): boolean {
  const { course, hide } = page.teach
  if (!file || !hide || course.trim() === '') return false
  const content = hashOf(new TextDecoder().decode(file.bytes))
  if (file.name.startsWith(recordingName(nameOf(course, '')).replace(/\.csv$/, ''))) seen.add(content)
  return seen.has(content)
}
