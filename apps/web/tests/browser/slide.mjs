// How long a move of a slider takes, by a mouse that drags it, from the event to the canvas painted; and its parts.
export const parts = ['waits for its frame', 'to the question', 'core', 'answer travels', 'to drawn', 'to painted', 'all plots']

/** Before the page's own scripts: when a core was asked, and how long it computed, here or in a worker. */
export function watch() {
  window.asked = { at: 0, took: 0, until: 0 }
  const note = (at, took) => Object.assign(window.asked, { at, took, until: performance.now() })
  const instantiate = WebAssembly.instantiate
  WebAssembly.instantiate = async (...all) => {
    const { exports } = await instantiate.apply(WebAssembly, all)
    const page_answer = (...request) => {
      const begin = performance.now()
      const status = exports.page_answer(...request)
      note(begin, performance.now() - begin)
      return status
    }
    return { exports: { ...exports, page_answer } }
  }
  const post = Worker.prototype.postMessage
  Worker.prototype.postMessage = function (message, ...others) {
    const begin = performance.now()
    if (message.task === 'motion') this.addEventListener('message', ({ data }) => note(begin, data.took), { once: true })
    return post.call(this, message, ...others)
  }
}

/** Each move's parts [ms], the last of them from the event on; `moves` of them `pause` ms apart, in a page opened with `watch`. */
export async function slide(page, moves, pause) {
  const slider = page.locator('[type=range][data-option=damping]')
  const { x, y, width, height } = await slider.boundingBox()
  const at = (i) => x + width * (0.3 + 0.4 * Math.abs(((i / moves + 0.5) % 2) - 1))
  await page.evaluate(() => {
    const [plot, ...others] = document.querySelectorAll('[data-drawn]')
    let move = null
    window.moves = []
    addEventListener('pointermove', (event) => (window.came = event.timeStamp), true)
    addEventListener('input', () => (move ??= { came: window.came, began: performance.now(), name: plot.ariaLabel, asked: null }), true)
    /** Once this frame was laid out, painted and handed on. */
    const painted = (then) => {
      const channel = new MessageChannel()
      channel.port1.onmessage = () => then(performance.now())
      channel.port2.postMessage(0)
    }
    const drawn = () => {
      if (!move || move.drawn || plot.ariaLabel === move.name) return
      move.drawn = performance.now()
      move.asked = { ...window.asked }
      painted((now) => (move.painted = move.all = now))
    }
    const rest = () => move?.drawn && painted((now) => move && (move.all = now))
    new MutationObserver(drawn).observe(plot, { attributeFilter: ['data-drawn'] })
    for (const other of others) new MutationObserver(rest).observe(other, { attributeFilter: ['data-drawn'] })
    window.endMove = () => {
      if (move?.painted) {
        const { came, began, drawn, painted, all, asked } = move
        const { at, took, until } = asked
        window.moves.push([began - came, at - began, took, until - at - took, drawn - until, painted - drawn, all - began])
      }
      move = null
    }
  })
  await page.mouse.move(at(0), y + height / 2)
  await page.mouse.down()
  for (let i = 1; i <= moves; ++i) {
    await page.mouse.move(at(i), y + height / 2)
    await page.waitForTimeout(pause)
    await page.evaluate(() => window.endMove())
  }
  await page.mouse.up()
  return page.evaluate(() => window.moves)
}
