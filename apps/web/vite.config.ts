import { paraglideVitePlugin } from '@inlang/paraglide-js'
import adapter from '@sveltejs/adapter-node'
import { sveltekit } from '@sveltejs/kit/vite'
import { defineConfig, type Plugin } from 'vite'
import { readCardText } from '../../packages/materials/cardText.ts'

/** Cards' words become syntax trees at build: no Markdown parser is sent to the page. */
const cardTexts: Plugin = {
  name: 'card-texts',
  transform: {
    filter: { id: /\.md$/ },
    handler: (markdown) => ({ code: `export default ${JSON.stringify(readCardText(markdown))}`, map: null }),
  },
}

export default defineConfig({
  plugins: [
    cardTexts,
    sveltekit({
      adapter: adapter({ precompress: true }),
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
    paraglideVitePlugin({ project: './project.inlang' }),
  ],
  build: { target: 'es2022' },
  server: { fs: { allow: ['../..'] } },
})
