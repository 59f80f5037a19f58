// Twenty recordings to fit: the two of data/, synthetic ones of every law, and one of them in the dialects of
// several loggers.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'

const synthetic = [
  ['viscous', '--stiffness=16.6 --mass=0.2 --damping=0.01 --position=0.03', []],
  ['drag', '--stiffness=17 --mass=0.22 --drag=0.2 --position=0.04', []],
  [
    'viscous_drag',
    '--stiffness=17 --mass=0.22 --damping=0.004 --drag=0.1 --position=0.04',
    ['mass=220 ± 0.5 g'],
  ],
  ['friction', '--stiffness=20 --mass=0.3 --friction=0.008 --position=0.05', []],
  ['viscous_friction', '--stiffness=20 --mass=0.3 --damping=0.01 --friction=0.004 --position=0.06', []],
  ['cubic', '--stiffness=20 --mass=0.3 --damping=0.01 --cubic=1500 --position=0.05', ['law=viscous+cubic']],
  ['slow', '--stiffness=1 --mass=1 --damping=0.03 --position=0.1', ['law=viscous']],
  ['fast', '--stiffness=900 --mass=0.5 --damping=0.2 --position=0.01', ['law=viscous+drag']],
  [
    'driven',
    '--stiffness=20 --mass=0.3 --damping=0.2 --drive-amplitude=0.2 --drive-frequency=6',
    ['drive-frequency=6'],
  ],
  ['noisy', '--stiffness=16.6 --mass=0.2 --damping=0.02 --position=0.02', []],
  ['overdamped', '--stiffness=2 --mass=0.2 --damping=3 --position=0.05', []],
]

const noise = { noisy: '4 mm' }

/// `{name, file, bytes, options}` each; `cromer` is the program, `data` the folder of the samples, `folder` one
/// for what is made.
export function recordings(cromer, data, folder) {
  const made = synthetic.map(([name, law, options], i) => {
    const path = join(folder, `${name}.csv`)
    const sensor = [
      `--sensor-noise=${noise[name] ?? '0.2 mm'}`,
      '--sensor-resolution=0.1 mm',
      `--seed=${i + 1}`,
    ]
    execFileSync(cromer, [
      'simulate',
      ...law.split(' '),
      '--method=rk4',
      '--step=2 ms',
      '--every=10',
      '--until=24 s',
      '--sensor-offset=0.2 m',
      ...sensor,
      '--quiet',
      '-o',
      path,
    ])
    return { name, path, options: options.map((option) => option.split('=')) }
  })
  const samples = ['recording1', 'recording2'].map((name) => ({
    name,
    path: join(data, `${name}.csv`),
    options: [],
  }))
  const recordings = [...samples, ...made].map((each) => ({ ...each, bytes: readFileSync(each.path) }))

  const rows = recordings
    .find((each) => each.name === 'viscous_drag')
    .bytes.toString()
    .trim()
    .split('\n')
    .filter((line) => line[0] !== '#')
    .slice(1)
    .map((line) => line.split(','))
  const add = (name, text, options = []) => recordings.push({ name, bytes: Buffer.from(text), options })
  const table = (heading, separator, change = (cell) => cell) =>
    [heading, ...rows.map((row) => row.map(change).join(separator))].join('\n') + '\n'
  add(
    'semicolons',
    table('Zeit (s);Position (m)', ';', (cell) => cell.replace('.', ',')),
  )
  add(
    'tabs',
    table('"Time (s)"\t"Position (cm)"', '\t', (cell) => cell),
  )
  add('phyphox', table('"Time (s)","Acceleration x (m/s^2)"', ','))
  add('windows', '\ufeff' + table('t/s,x/m', ',').replaceAll('\n', '\r\n'))
  recordings.push({
    name: 'utf16',
    bytes: Buffer.from('\ufeff' + table('Time (s)\tPosition (m)', '\t'), 'utf16le'),
    options: [],
  })
  add('bare', table('', ' ').trimStart(), [
    ['from', '2 s'],
    ['to', '15 s'],
  ])
  add('word', table('Time (s),Position (m)', ',').replace(rows[40][1], 'abc'))
  return recordings
}
