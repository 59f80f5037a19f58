// Recordings to try the page with: simulated by the core, with a sensor's noise.
import { ask } from '../core/ask'
import type { Options } from '../core/types'
import { page } from '../state/page.svelte'
import { openFile, session } from './session.svelte'
import { measureDefaults, type MeasureState } from './state'

export type ExampleName = 'disc' | 'plain' | 'rubbing'

const sensor: Options = [
  ['method', 'rk4'],
  ['step', '1 ms'],
  ['every', '10'],
  ['sensor-noise', '0.3 mm'],
  ['sensor-resolution', '0.1 mm'],
  ['sensor-offset', '0.2 m'],
  ['seed', '24']
]

const recipes: Record<ExampleName, { file: string; law: Options; settings: Partial<MeasureState> }> = {
  disc: {
    file: 'disc_12cm.csv',
    law: [
      ['mass', '217.6 g'],
      ['stiffness', '17.04 N/m'],
      ['damping', '0.000789 kg/s'],
      ['drag', '0.02043 kg/m'],
      ['position', '3.6 cm'],
      ['until', '120 s']
    ],
    settings: { mass: '217.6 ± 0.3 g', disc: '12 cm' }
  },
  plain: {
    file: 'plain_damping.csv',
    law: [
      ['mass', '200.8 g'],
      ['stiffness', '16.6 N/m'],
      ['damping', '0.02 kg/s'],
      ['position', '3 cm'],
      ['until', '40 s']
    ],
    settings: { mass: '200.8 ± 0.3 g', disc: '' }
  },
  rubbing: {
    file: 'dry_friction.csv',
    law: [
      ['mass', '250 g'],
      ['stiffness', '20 N/m'],
      ['friction', '0.02 N'],
      ['position', '5 cm'],
      ['until', '12 s']
    ],
    settings: { mass: '250 ± 0.3 g', disc: '' }
  }
}

/// Makes a recording by the core and opens it.
export async function openSynthetic(name: string, options: Options, settings: Partial<MeasureState>): Promise<boolean> {
  const made = await ask('synthetic', options)
  if (!made) return false
  if (made.status === 2) {
    session.refused = { file: null, name, why: made.document }
    return false
  }
  const file = { name, bytes: new TextEncoder().encode(made.document.text), origin: 'simulated' as const }
  return openFile(file, { ...settings, air: page.measure.air || measureDefaults.air })
}

export const openExample = (name: ExampleName): Promise<boolean> =>
  openSynthetic(recipes[name].file, [...recipes[name].law, ...sensor], recipes[name].settings)
