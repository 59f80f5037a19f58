// Axes whose words hold a symbol: ["time ", "t", …] is "time t" with an italic t.
import type { Axis } from '../plot/curve'

export const axis = (parts: readonly string[], unit: string): Axis => ({
  name: `${parts[0]}*${parts[1]}*`,
  plain: parts[0]!.trim(),
  unit
})
