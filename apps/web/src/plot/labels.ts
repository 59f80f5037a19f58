// Names at the ends of curves, moved apart so that none covers another.

export interface Placed {
  y: number // wanted, then given: the middle of the first line [px]
  height: number // [px]
}

/** Moves the labels least, between `top` and `bottom`; their order is kept, those at one height keep theirs. */
export function spread<T extends Placed>(labels: T[], top: number, bottom: number): T[] {
  const sorted = labels.map((label, i) => ({ label, i })).sort((a, b) => a.label.y - b.label.y || a.i - b.i)
  const placed = sorted.map(({ label }) => ({ ...label }))
  // Groups that touch share their shift: the group stands in the middle of what its labels want.
  let groups = placed.map((label) => ({ labels: [label], height: label.height, wanted: label.y - 0 }))
  for (let moved = true; moved; ) {
    moved = false
    for (let i = 0; i + 1 < groups.length; ++i) {
      const [a, b] = [groups[i]!, groups[i + 1]!]
      if (startOf(a) + a.height <= startOf(b) + 1e-6) continue
      const labels = [...a.labels, ...b.labels]
      let offset = 0
      let sum = 0
      for (const label of labels) {
        sum += label.y - offset
        offset += label.height
      }
      groups.splice(i, 2, { labels, height: offset, wanted: sum / labels.length })
      moved = true
      break
    }
  }
  function startOf(group: { height: number; wanted: number }): number {
    return Math.max(top, Math.min(bottom - group.height, group.wanted))
  }
  groups = groups.filter((group) => group.labels.length > 0)
  for (const group of groups) {
    let y = startOf(group)
    for (const label of group.labels) {
      label.y = y
      y += label.height
    }
  }
  return placed
}
