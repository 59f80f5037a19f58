// Builds the page as one file, build/page/cromer-lab.html: script, style and core inlined, no request made.
import { createHash } from 'node:crypto'
import { existsSync, readFileSync } from 'node:fs'
import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig, type Plugin } from 'vite'
import { packed } from './src/core/pack'

/** The compiled core: what CROMER_WASM names, else the one of the build directory. */
function coreFile(): string {
  const files = [process.env.CROMER_WASM, '../../build/page/core.wasm']
  const found = files.find((file) => file && existsSync(file))
  if (!found) throw new Error('no core.wasm: build apps/web/core, or name it in CROMER_WASM')
  return found
}

/** `import core from 'virtual:core'`: the core, packed. The built page has it in an element of its own, at the end:
 * amid the script it would keep gzip from finding what repeats before and after it. */
function core(): Plugin {
  let built = true
  return {
    name: 'cromer-core',
    configResolved: ({ command }) => {
      built = command === 'build'
    },
    resolveId: (id) => (id === 'virtual:core' ? '\0core' : undefined),
    load: (id) => {
      if (id !== '\0core') return
      return `export default ${built ? "document.getElementById('core').textContent" : JSON.stringify(packed(readFileSync(coreFile())))}`
    },
  }
}

/** What the page may do, wherever it is opened: run its own script, style and workers, and ask its own origin. */
function policyOf(html: string): string {
  const own = (tag: string) =>
    [...html.matchAll(new RegExp(`<${tag}( type="module")?>([\\s\\S]*?)</${tag}>`, 'g'))]
      .map(([, , text]) => `'sha256-${createHash('sha256').update(text!).digest('base64')}'`)
      .join(' ')
  return [
    "default-src 'none'", `script-src ${own('script')} 'wasm-unsafe-eval'`, `style-src ${own('style')}`, 'worker-src blob:',
    'img-src data:', "connect-src 'self'", "base-uri 'none'", "form-action 'none'",
  ].join('; ')
}

/** Puts script and style into the html, which becomes cromer-lab.html; its policy stands before them. */
function oneFile(): Plugin {
  return {
    name: 'cromer-one-file',
    enforce: 'post',
    generateBundle(_, bundle) {
      const html = bundle['index.html']
      if (html?.type !== 'asset') return
      let text = String(html.source)
      for (const [file, part] of Object.entries(bundle)) {
        if (part.type === 'chunk') {
          const code = part.code.replaceAll('</script', '<\\/script')
          text = text.replace(/<script type="module"[^>]*><\/script>/, () => '')
          const core = `<script type="text/plain" id="core">${packed(readFileSync(coreFile()))}</script>`
          text = text.replace('</body>', () => `<script type="module">${code}</script>${core}</body>`)
          delete bundle[file]
        } else if (file.endsWith('.css')) {
          text = text.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${part.source}</style>`)
          delete bundle[file]
        }
      }
      const policy = `<meta http-equiv="Content-Security-Policy" content="${policyOf(text)}" />`
      html.source = text.replace('<meta charset="utf-8" />', (charset) => `${charset}\n    ${policy}`)
      html.fileName = 'cromer-lab.html'
    },
  }
}

export default defineConfig({
  plugins: [svelte(), core(), oneFile()],
  worker: { format: 'iife', plugins: () => [core()] },
  build: {
    target: 'es2022',
    outDir: '../../build/page',
    emptyOutDir: false,
    assetsInlineLimit: 100_000_000,
    cssCodeSplit: false,
    modulePreload: false,
    reportCompressedSize: false,
  },
})
