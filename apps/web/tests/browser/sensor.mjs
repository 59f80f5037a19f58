// A sensor that sends a swing by TCP, `time value` a hundred times a second.
import { createServer } from 'node:net'

/** A swing of 1.5 Hz with a decay rate of 0.1 1/s; `from`: as `cromer serve --from` takes it. */
export async function swingingSensor() {
  const frequency = 1.5 // [Hz]
  const sockets = new Set()
  const sensor = createServer((socket) => {
    sockets.add(socket)
    const begin = performance.now()
    let n = 0
    const timer = setInterval(() => {
      for (; n / 100 <= (performance.now() - begin) / 1000; ++n) {
        const t = n / 100
        const noise = 0.002 * Math.sin(1e4 * Math.sin(1e4 * n))
        socket.write(`${t.toFixed(3)} ${(Math.exp(-0.1 * t) * Math.cos(2 * Math.PI * frequency * t) + noise).toFixed(6)}\n`)
      }
    }, 10)
    socket.on('error', () => {})
    socket.on('close', () => {
      clearInterval(timer)
      sockets.delete(socket)
    })
  })
  await new Promise((resolve) => sensor.listen(0, '127.0.0.1', resolve))
  return { sensor, sockets, from: `tcp:127.0.0.1:${sensor.address().port}`, frequency }
}
