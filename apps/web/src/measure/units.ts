// Units that suit the size: 0.000785 kg/s is read as 0.785 g/s, 0.0003 m as 0.3 mm.

/// What a value in the unit `from` is multiplied with to be in the unit `unit`.
export interface Scale {
  factor: number
  unit: string
}

const smaller: Record<string, [Scale, Scale]> = {
  'kg/s': [{ factor: 1, unit: 'kg/s' }, { factor: 1000, unit: 'g/s' }],
  'kg/m': [{ factor: 1, unit: 'kg/m' }, { factor: 1000, unit: 'g/m' }],
  kg: [{ factor: 1, unit: 'kg' }, { factor: 1000, unit: 'g' }],
  N: [{ factor: 1, unit: 'N' }, { factor: 1000, unit: 'mN' }],
  J: [{ factor: 1, unit: 'J' }, { factor: 1000, unit: 'mJ' }]
}

/// For values of the size of `size` in the SI unit `unit`; "1" is no unit.
export function scaleFor(size: number, unit: string): Scale {
  if (unit === '1') return { factor: 1, unit: '' }
  const size_ = Math.abs(size)
  if (unit === 'm' || unit === 'm/s') {
    if (size_ < 0.01) return { factor: 1000, unit: `m${unit}` }
    return size_ < 1 ? { factor: 100, unit: `c${unit}` } : { factor: 1, unit }
  }
  const pair = smaller[unit]
  return pair ? pair[size_ < 0.1 ? 1 : 0] : { factor: 1, unit }
}
