// Builds the page as one file, build/page/cromer-lab.html: script, style and core inlined, no request made.
import { existsSync, readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig, type Plugin } from 'vite'

/** The compiled core: what CROMER_WASM names, else the one of the build directory. */
function coreFile(): string {
  const files = [process.env.CROMER_WASM, '../../build/page/core.wasm']
  const found = files.find((file) => file && existsSync(file))
  if (!found) throw new Error('no core.wasm: build apps/web/core, or name it in CROMER_WASM')
  return found
}

/** Packed beside it by apps/web/core/build, a fifth smaller than gzip; else gzipped here. */
function packedCore(): Buffer {
  const file = coreFile()
  return existsSync(`${file}.lzma`) ? readFileSync(`${file}.lzma`) : gzipSync(readFileSync(file), { level: 9 })
}

/** `import core from 'virtual:core'`: the core, packed, in base64. */
function core(): Plugin {
  return {
    name: 'cromer-core',
    resolveId: (id) => (id === 'virtual:core' ? '\0core' : undefined),
    load: (id) =>
      id === '\0core'
        ? `export default "${packedCore().toString('base64')}"`
        : undefined,
  }
}

/** Puts script and style into the html, which becomes cromer-lab.html. */
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
          text = text.replace('</body>', () => `<script type="module">${code}</script></body>`)
          delete bundle[file]
        } else if (file.endsWith('.css')) {
          text = text.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${part.source}</style>`)
          delete bundle[file]
        }
      }
      html.source = text
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
