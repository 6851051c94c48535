import { paraglideVitePlugin } from '@inlang/paraglide-js'
import adapter from '@sveltejs/adapter-node'
import { sveltekit } from '@sveltejs/kit/vite'
import { defineConfig, type Plugin } from 'vite'
import { readCardText } from '../../packages/materials/cardText.ts'
import { webSpace } from './web-space.ts'

/** Cards' words become syntax trees at build: no Markdown parser is sent to the page. */
const cardTexts: Plugin = {
  name: 'card-texts',
  transform: {
    filter: { id: /\.md$/ },
    handler: (markdown) => ({ code: `export default ${JSON.stringify(readCardText(markdown))}`, map: null }),
  },
}

/**
 * The physics library's list of what it could load from a file holds all its joints; we load no such file and use no joint.
 * With the list shorter and its classes marked as free of effects, 10 kB fewer travel.
 */
const noJoints: Plugin = {
  name: 'no-joints',
  transform: {
    filter: { id: /[\\/]planck\.mjs$/ },
    handler: (code) => ({
      code: code
        .replace(/, _a\[\w+Joint\.TYPE\] = \w+Joint/g, '')
        .replaceAll('/** @class */', '/* @__PURE__ */'),
      map: null,
    }),
  },
}

// Few requests: what one card needs comes together, what all pages share, and what the lab's parts share.
const cardOf = (id: string) => {
  const file =
    /content[\\/](?:cards[\\/][\w-]+[\\/]\d+-|worlds[\\/])(\w+)[\\/](?:\w+\.md|start\.json|world\.json)$/
  const name = file.exec(id)?.[1]
  return name === undefined ? null : `content-${name}`
}
const chunks = [
  // SvelteKit's first script imports it and must not pull anything else in before the page is set up.
  { name: 'preload', test: /preload-helper|runtime[\\/]client[\\/]payload\.js/, priority: 3 },
  { name: cardOf, priority: 2 },
  // A chunk takes along what its modules import: what all words import comes first.
  { name: 'words', test: /generated[\\/]runtime\.js/, priority: 3 },
  // Words that the lab alone needs: nobody else says a message whose key is data.
  {
    name: 'lab-words',
    test: /generated[\\/]messages[\\/](?!(home|parts|comfort|worldname|check|projects|share|about|offline)_)\w+\.js/,
    priority: 2,
  },
  // Words that only the pages about projects need.
  {
    name: 'shelf',
    test: /generated[\\/]messages[\\/](projects|share|about|offline)_/,
    minShareCount: 2,
    priority: 2,
  },
  {
    name: 'common',
    test: /(src[\\/]lib[\\/](content|offline|parts|words)|node_modules[\\/]svelte)[\\/]|storage[\\/](bin|channel|database|handout|projects|settings)\.ts|state[\\/]comfort/,
    minShareCount: 2,
    priority: 1,
  },
  // The home page reads project files without bringing the simulation along.
  {
    name: 'programs',
    test: /packages[\\/](blocks|learning|numbers|programs|simulation[\\/](floor[\\/]colours|\w+\.ts))|node_modules[\\/]valibot[\\/]/,
    minShareCount: 2,
    priority: 1,
  },
  { name: 'drawing', test: /src[\\/]lib[\\/](drawing|world)[\\/]/, minShareCount: 2 },
  {
    name: 'engine',
    test: /[\\/](packages|node_modules[\\/](planck|fflate)|src[\\/]lib[\\/](?!storage|share))[\\/]/,
    minShareCount: 2,
  },
]

/** Where files for a web space go, without a server; not given: the build for our own server. */
const folder = process.env['BOTGARTEN_WEB_SPACE']

export default defineConfig({
  define: { __WEB_SPACE__: JSON.stringify(folder !== undefined) },
  plugins: [
    cardTexts,
    noJoints,
    sveltekit({
      adapter: folder ? webSpace(folder) : adapter({ precompress: true }),
      // The sizes of the one build are not those of the other.
      outDir: folder ? '.svelte-kit/web-space' : '.svelte-kit',
      // Small styles, of parts that come late above all, would each be a request.
      inlineStyleThreshold: 8192,
      // It comes after the page: lib/offline.
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
    paraglideVitePlugin({ project: './project.inlang' }),
  ],
  build: { target: 'es2022' },
  environments: {
    client: { build: { rolldownOptions: { output: { codeSplitting: { groups: chunks } } } } },
  },
  server: { fs: { allow: ['../..'] } },
})
