// The same damped swing as each logger would write it, and what the page is to say of it.

const count = 1200
const rate = 50
const t = Array.from({ length: count }, (_, i) => i / rate)
/** [m] 3 cm that die down at 0.05 1/s, at 1.5 Hz, with a noise that is the same in every run. */
const x = t.map((at, i) => {
  const noise = ((Math.imul(i + 1, 2654435761) >>> 0) / 2 ** 32 - 0.5) * 4e-4
  return 0.2 + 0.03 * Math.exp(-0.05 * at) * Math.cos(2 * Math.PI * 1.5 * at) + noise
})
const rows = (line) => t.map((at, i) => line(at, x[i], i)).join('')
const comma = (value) => String(value).replace('.', ',')
const f = (value) => value.toFixed(5)

/** An archive of its entries, stored, or packed by `deflate`. */
export function zip(entries, deflate) {
  const crc = (bytes) => {
    let sum = ~0
    for (const byte of bytes) {
      sum ^= byte
      for (let k = 0; k < 8; ++k) sum = (sum >>> 1) ^ (0xedb88320 & -(sum & 1))
    }
    return ~sum >>> 0
  }
  const local = []
  const central = []
  let offset = 0
  for (const [name, text] of entries) {
    const [label, plain] = [Buffer.from(name), Buffer.from(text)]
    const data = deflate ? deflate(plain) : plain
    const fields = Buffer.alloc(26)
    fields.writeUInt16LE(20, 0)
    fields.writeUInt16LE(deflate ? 8 : 0, 4)
    fields.writeUInt32LE(crc(plain), 10)
    fields.writeUInt32LE(data.length, 14)
    fields.writeUInt32LE(plain.length, 18)
    fields.writeUInt16LE(label.length, 22)
    const part = Buffer.concat([Buffer.from('PK\x03\x04'), fields, label, data])
    const tail = Buffer.alloc(14)
    tail.writeUInt32LE(offset, 10)
    central.push(Buffer.concat([Buffer.from('PK\x01\x02'), Buffer.from([20, 0]), fields, tail, label]))
    local.push(part)
    offset += part.length
  }
  const directory = Buffer.concat(central)
  const end = Buffer.alloc(18)
  end.writeUInt16LE(entries.length, 4)
  end.writeUInt16LE(entries.length, 6)
  end.writeUInt32LE(directory.length, 8)
  end.writeUInt32LE(offset, 12)
  return Buffer.concat([...local, directory, Buffer.from('PK\x05\x06'), end])
}

function universal() {
  const pad = (value, width) => String(value).padStart(width)
  const real = (value) => value.toExponential(5).replace(/e([+-])(\d)$/, 'E$10$2').toUpperCase().padStart(13)
  const axis = (kind, label, unit) => `${pad(kind, 10)}${pad(0, 5)}${pad(0, 5)}${pad(0, 5)} ${label.padEnd(20)} ${unit.padEnd(20)}\n`
  const head =
    'a swing\nNONE\n02-JUN-20 10:00:00\nNONE\nNONE\n' +
    `${pad(1, 5)}${pad(0, 10)}${pad(0, 5)}${pad(0, 10)} ${'NONE'.padEnd(10)}${pad(3, 10)}${pad(3, 4)} ${'NONE'.padEnd(10)}${pad(0, 10)}${pad(0, 4)}\n` +
    `${pad(2, 10)}${pad(count, 10)}${pad(1, 10)}${real(0)}${real(1 / rate)}${real(0)}\n` +
    axis(17, 'Time', 's') + axis(8, 'NONE', 'm') + axis(0, 'NONE', 'NONE') + axis(0, 'NONE', 'NONE')
  let values = ''
  x.forEach((value, i) => (values += real(value) + (i % 6 === 5 || i + 1 === count ? '\n' : '')))
  return `    -1\n    58\n${head}${values}    -1\n`
}

export const recordings = [
  ['Logger Pro', 'logger.csv', `Latest: Time (s),Latest: Position (m)\n${rows((a, b) => `${f(a)},${f(b)}\n`)}`],
  ['Graphical Analysis', 'graphical.csv', `Data Set 1:Time(s),Data Set 1:Position(m)\n${rows((a, b) => `${f(a)},${f(b)}\n`)}`],
  ['Vernier Format 2', 'format2.txt',
    `Vernier Format 2\r\nlab.cmbl 3/4/2020 12:00:00\r\nRun 1\r\nTime\tPosition\r\nt\tx\r\ns\tm\r\n\r\n${rows((a, b) => `${f(a)}\t${f(b)}\r\n`)}\r\n`],
  ['PASCO Capstone', 'capstone.csv',
    `\ufeff"Time (s) Run #1";"Position (m) Run #1"\r\n${rows((a, b) => `${comma(f(a))};${comma(f(b))}\r\n`)}`],
  ['DataStudio', 'datastudio.txt',
    `Position, ChA, Run #1\r\nTime ( s )\tPosition ( m )\r\n${rows((a, b) => `${f(a)}\t${f(b)}\r\n`)}`],
  ['phyphox', 'phyphox.csv', `"Time (s)","Gyroscope x (rad/s)"\n${rows((a, b) => `${a.toExponential(9)},${(b - 0.2).toExponential(9)}\n`)}`],
  ['phyphox', 'phyphox.zip', zip([['Raw Data.csv', `"Time (s)","Gyroscope x (rad/s)"\n${rows((a, b) => `${a.toExponential(9)},${(b - 0.2).toExponential(9)}\n`)}`], ['meta/device.csv', 'property,value\nversion,1\n']])],
  ['Tracker', 'tracker.txt', `mass_A\t\t\t\nt\tx\ty\t\n${rows((a, b) => `${f(a)}\t${f(b)}\t${f(b / 2)}\t\n`)}`],
  ['LabVIEW', 'swing.lvm',
    'LabVIEW Measurement\t\r\nWriter_Version\t2\r\nSeparator\tTab\r\nDecimal_Separator\t.\r\nMulti_Headings\tYes\r\nX_Columns\tOne\r\n' +
      `***End_of_Header***\t\r\n\t\r\nChannels\t1\t\r\nSamples\t${count}\t\r\nY_Unit_Label\tmm\t\r\nX_Dimension\tTime\t\r\nX0\t0\t\r\nDelta_X\t0.02\t\r\n` +
      `***End_of_Header***\t\t\r\nX_Value\tPosition\tComment\r\n${rows((a, b) => `${f(a)}\t${f(1000 * b)}\t\r\n`)}`],
  ['PEER', 'swing.dt2',
    `PEER DATABASE\nA swing\nDISPLACEMENT TIME SERIES IN UNITS OF CM\nNPTS=  ${count}, DT=   .0200 SEC,\n${rows((_, b, i) => ` ${(100 * (b - 0.2)).toExponential(6)}${i % 5 === 4 ? '\n' : ''}`)}`],
  ['UFF', 'swing.uff', universal()],
  ['plain', 'plain.csv', `Time (s),Position (m)\n${rows((a, b) => `${f(a)},${f(b)}\n`)}`],
  ['plain', 'latin.csv', `Zeit (s);Weg (cm)\r\n${rows((a, b) => `${comma(f(a))};${comma(f(100 * b))}\r\n`)}`],
]

/** With a spike of 8 cm at 6 s and a gap of 0.7 s at 12 s. */
export const flawed = `Time (s),Position (m)\n${rows((a, b, i) => (i > 600 && i < 635 ? '' : `${f(a)},${f(i === 300 ? b + 0.08 : b)}\n`))}`

/** The swing in other units: `times` of a second, `values` of a metre, about 0. */
export const swingIn = (heading, times, values) => `${heading}\n${rows((a, b) => `${(times * a).toPrecision(12)},${(values * (b - 0.2)).toPrecision(12)}\n`)}`

/** 200 s of it at 1 kHz, more samples than a call has arguments. */
export const longSwing = () => {
  const lines = ['Time (s),Position (m)']
  for (let i = 0; i < 200_000; ++i) {
    const noise = ((Math.imul(i + 1, 2654435761) >>> 0) / 2 ** 32 - 0.5) * 4e-4
    lines.push(`${i / 1000},${f(0.03 * Math.exp(-0.01 * (i / 1000)) * Math.cos((2 * Math.PI * 1.5 * i) / 1000) + noise)}`)
  }
  return `${lines.join('\n')}\n`
}

/** Two runs side by side without times. */
export const twoRuns = `"Position (mm) Run #1";"Position (mm) Run #2"\r\n${rows((_, b, i) => `${comma(f(1000 * b))};${i < 900 ? comma(f(1000 * (0.4 - b))) : ''}\r\n`)}`
