import adapter from '@sveltejs/adapter-node'
import { sveltekit } from '@sveltejs/kit/vite'
import { defineConfig } from 'vite'
import { promised } from '@botgarten/browsers/promised'
import { contentPlugin } from '@botgarten/content/vite'
import { allOfPagesAtOnce, chunks, compiledAtOnce, filesOfTeachers, pagesOfModules } from './chunks.ts'
import { examples } from './examples.ts'
import { notices } from './notices.ts'
import { webSpace } from './web-space.ts'
import { words } from './words.ts'

/** Where files for a web space go, without a server; not given: the build for our own server. */
const folder = process.env['BOTGARTEN_WEB_SPACE']

/** Bytes of a picture that comes alone in any case. */
const large = 50_000

export default defineConfig({
  define: { __WEB_SPACE__: JSON.stringify(folder !== undefined) },
  plugins: [
    contentPlugin,
    ...examples,
    words,
    notices,
    pagesOfModules,
    allOfPagesAtOnce,
    compiledAtOnce,
    filesOfTeachers,
    sveltekit({
      adapter: folder ? webSpace(folder) : adapter({ precompress: true }),
      // The sizes of the one build are not those of the other.
      outDir: folder ? '.svelte-kit/web-space' : '.svelte-kit',
      // Small styles, of parts that come late above all, would each be a request.
      inlineStyleThreshold: 9216,
      // It comes after the page: app/offline.
      serviceWorker: { register: false },
      csp: {
        mode: 'hash',
        directives: {
          'default-src': ['self'],
          'script-src': ['self'],
          'style-src': ['self', 'unsafe-inline'],
          'img-src': ['self', 'data:', 'blob:'],
          'connect-src': ['self'],
          'object-src': ['none'],
          'base-uri': ['none'],
          'frame-ancestors': ['self'],
        },
      },
    }),
  ],
  build: {
    target: Object.entries(promised).map(([browser, version]) => `${browser}${version}`),
    // A picture in a script would be loaded by who never sees it. Things are many, small, and never come alone.
    assetsInlineLimit: (file, { length }) =>
      file.endsWith('.svg') ? /content[\\/](things|materials)[\\/]/.test(file) && length < large : undefined,
  },
  environments: {
    client: {
      build: {
        rolldownOptions: {
          preserveEntrySignatures: 'allow-extension',
          output: { codeSplitting: { groups: chunks } },
        },
      },
    },
  },
  server: { fs: { allow: ['../..'] } },
})
