import { beforeAll, describe, expect, it, vi } from 'vitest'

import { frameOf } from '../../src/plot/curve'
import type { Pen } from '../../src/plot/pen'
import { resonanceWords } from '../../src/simulate/resonance_words'

interface Word { text: string; left: number; right: number; y: number }

/// A pen that keeps the words and where they stand; a letter is 7 px wide.
function keeping(): { pen: Pen; words: Word[] } {
  const words: Word[] = []
  const width = (text: string) => 7 * text.length
  const nothing = () => {}
  const pen = {
    line: nothing, fill: nothing, box: nothing, dot: nothing, width, within: (...all: unknown[]) => (all.at(-1) as () => void)(),
    text: (x: number, y: number, text: string, { align = 'left' }: { align?: string }) =>
      void words.push({ text, y, left: align === 'right' ? x - width(text) : x, right: align === 'right' ? x : x + width(text) }),
  }
  return { pen: pen as unknown as Pen, words }
}

const peak = (meaning: string, name: string, height: number) => {
  const x = Float64Array.from({ length: 200 }, (_, i) => 1 + i / 50)
  return { meaning, name, x, y: x.map((w) => height / Math.hypot(1, 12 * (w - 3))) }
}

describe('the words on the resonance curve', () => {
  beforeAll(() => {
    vi.stubGlobal('document', { documentElement: { dataset: {} } })
    vi.stubGlobal('getComputedStyle', () => ({ getPropertyValue: () => '#000000' }))
  })

  it.each([240, 270, 330, 420])('cover none another in a frame of %i px', (wide) => {
    const { pen, words } = keeping()
    const frame = frameOf(40, 40 + wide, 28, 240, [1, 5], [0, 2])
    const curves = [peak('exact', 'exakt', 1.667), peak('euler-cromer', 'Euler-Cromer', 1.667), peak('implicit-euler', 'Euler implizit', 0.789)]
    const unsettled = [{ meaning: 'forward-euler', name: 'Euler vorwärts', why: ['schwingt nie ein:', 'wächst ohne Ende'] }]
    resonanceWords({ atDrive: () => '1.667\u00a0m', unsettled, at: 3, text: 'Antrieb 3,000 rad/s', drawn: true, listed: false })(pen, frame, curves)
    expect(words).toHaveLength(7)
    const over = words.flatMap((a, i) =>
      words.slice(i + 1).filter((b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 0 && Math.abs(a.y - b.y) < 12).map((b) => `${a.text} / ${b.text}`),
    )
    expect(over).toEqual([])
  })
})
