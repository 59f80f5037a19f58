// Of a class and a student one number, the same on every computer: integers only, no clock, no chance.

/// What a class link says and what students type, brought to one form: no blanks at the ends, one between
/// words, no difference of case or of how an umlaut is composed.
export const oneForm = (text: string): string => text.normalize('NFC').trim().replace(/\s+/g, ' ').toLocaleLowerCase('en')

/// FNV-1a over the UTF-8 bytes, then the finalizer of MurmurHash3: 32 bits that all depend on every bit.
export function hashOf(text: string): number {
  let hash = 0x811c9dc5
  for (const byte of new TextEncoder().encode(text)) hash = Math.imul(hash ^ byte, 0x01000193)
  hash = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b)
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35)
  return (hash ^ (hash >>> 16)) >>> 0
}

/// The seed of one student's recording. A separator keeps class "A1", student "2" from class "A", student "12".
export const seedOf = (course: string, student: string): number => hashOf(`${oneForm(course)}\n${oneForm(student)}`)

/// Numbers from 0 up to, not including 1, that follow from a seed (splitmix32).
export function numbersOf(seed: number): () => number {
  let state = seed >>> 0
  return () => {
    state = (state + 0x9e3779b9) >>> 0
    let z = Math.imul(state ^ (state >>> 16), 0x21f0aaad)
    z = Math.imul(z ^ (z >>> 15), 0x735a2d97)
    return ((z ^ (z >>> 15)) >>> 0) / 2 ** 32
  }
}

/// A class of four characters that are not mixed up when read aloud: for a new link.
export function newCourse(random: () => number = Math.random): string {
  const letters = '23456789ABCDEFHJKMNPRTUVWXYZ'
  return Array.from({ length: 4 }, () => letters[Math.floor(random() * letters.length)]).join('')
}

/// How a recording is named: "7F3A-19".
export const nameOf = (course: string, student: string): string =>
  `${course.trim().toUpperCase()}-${student.trim().replace(/\s+/g, ' ')}`
