// A worker for pages opened from disk, where browsers start none: a hidden frame whose script believes to be one. The
// theme's search runs in it. After iframe-worker by Martin Donath (MIT), which the theme would fetch from elsewhere.
if (location.protocol === 'file:') {
  window.Worker = class extends EventTarget {
    constructor(url) {
      super()
      this.frame = document.createElement('iframe')
      this.frame.hidden = true
      document.body.append(this.frame)
      const inside = this.frame.contentWindow
      inside.document.open()
      inside.document.write(`<script>
        postMessage = (message) => parent.postMessage(message, '*')
        importScripts = (...urls) => urls.reduce((before, url) => before.then(() => new Promise((resolve) => {
          const script = Object.assign(document.createElement('script'), { src: url, onload: resolve })
          document.body.append(script)
        })), Promise.resolve())
      <\/script><body><script src="${url}"><\/script>`)
      inside.document.close()
      this.loaded = new Promise((resolve) => { inside.onload = resolve })
      window.addEventListener('message', (event) => {
        if (event.source !== inside) return
        this.dispatchEvent(new MessageEvent('message', { data: event.data }))
        this.onmessage?.(event)
      })
    }
    postMessage(data) {
      this.loaded.then(() => this.frame.contentWindow.dispatchEvent(new MessageEvent('message', { data: structuredClone(data) })))
    }
    terminate() {
      this.frame.remove()
    }
  }
}
