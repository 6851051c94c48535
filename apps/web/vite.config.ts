import adapter from '@sveltejs/adapter-node'
import { sveltekit } from '@sveltejs/kit/vite'
import { defineConfig, type Plugin } from 'vite'
import { contentPlugin } from '@botgarten/content/vite'
import { examples } from './examples.ts'
import { notices } from './notices.ts'
import { webSpace } from './web-space.ts'
import { chunkOfWords, words } from './words.ts'

/**
 * The physics library's lists of what it could load from a file and of what can touch what hold all joints, edges and chains;
 * we load no such file, use no joint, and all our shapes are circles and polygons. With the lists shorter and the classes
 * marked as free of effects, 15 kB fewer travel.
 */
const lessPhysics: Plugin = {
  name: 'less-physics',
  transform: {
    filter: { id: /[\\/]planck\.mjs$/ },
    handler: (code) => ({
      code: code
        .replace(/, _a\[(\w+Joint|ChainShape|EdgeShape)\.TYPE\] = \1/g, '')
        .replace(/^Contact\.addType\((Edge|Chain)Shape\.TYPE, .*\n/gm, '')
        .replace(/^var worldSerializer = [^;]*;\n(Serializer\.\w+ = .*\n)*/m, '')
        .replaceAll('new EdgeShape()', '/* @__PURE__ */ new EdgeShape()')
        .replaceAll('/** @class */', '/* @__PURE__ */'),
      map: null,
    }),
  },
}

/** The reader of XML also reads streams, and the entities of HTML; we give it whole texts, of XML and nothing else. */
const lessXml: Plugin = {
  name: 'less-xml',
  transform: {
    filter: { id: /[\\/]sax[\\/]lib[\\/]sax\.js$/ },
    handler: (code) => ({
      code: code
        .replace(/ {2}function createStream[^]*(?= {2}\/\/ this really needs to be replaced)/, '')
        .replace(/ {2}sax\.(SAXStream|createStream) = .*\n/g, '')
        .replace(/ {2}var Stream\n[^]*?if \(!Stream\) .*\n/, '')
        .replace(/(sax\.ENTITIES = )Object\.assign\([^]*?\}\)/, '$1{}'),
      map: null,
    }),
  },
}

// Few requests: what one card needs comes together, what all pages share, and what the lab's parts share.
/** `content:card/friendship` becomes `content-friendship`: what a page opens of content/ comes by itself. */
const openedOf = (id: string) => {
  const name = /content:(?:card\/([\w-]+)|(every-world|free-lab))$/.exec(id)?.slice(1).find(Boolean)
  return name === undefined ? null : `content-${name}`
}
const chunks = [
  // SvelteKit's first script imports it and must not pull anything else in before the page is set up.
  { name: 'preload', test: /preload-helper|runtime[\\/]client[\\/]payload\.js/, priority: 3 },
  // What SvelteKit's pages share of it: the state of the page, the names of addresses.
  {
    name: 'navigation',
    test: /@sveltejs[\\/]kit[\\/]src[\\/](runtime[\\/](app|client|env|shared)|exports[\\/](index|internal))/,
    minShareCount: 2,
    priority: 2,
  },
  { name: openedOf, priority: 2 },
  { name: chunkOfWords, priority: 2 },
  {
    name: 'common',
    test: /content:(cards|worlds)$|(src[\\/](content|app[\\/]offline|parts(?![\\/]page[\\/])|words)|node_modules[\\/]svelte)[\\/]|storage[\\/](bin|channel|copy-name|database|endings|handout|projects|refusal|settings)\.ts/,
    minShareCount: 2,
    priority: 1,
  },
  // A group takes along what its files import: these are needed without it.
  { name: 'limits', test: /packages[\\/]programs[\\/]project[\\/](error|limits)\.ts/, priority: 3 },
  // What reads projects and files that come from elsewhere: a first visit has none.
  {
    name: 'reading',
    test: /node_modules[\\/]valibot[\\/]|packages[\\/]programs[\\/]project[\\/](project|schema\S*)\.ts/,
    minShareCount: 2,
    priority: 2,
  },
  // The home page reads project files without bringing the simulation along.
  {
    name: 'programs',
    test: /packages[\\/](blocks[\\/](?!configuration|q-learning|sorting|network[\\/]ai_nn_hidden|learning|expert|later|toolbox-expert|parts[\\/](learning|sorting|expression))|learning[\\/]neural-network[\\/](?!curves|keep)|numbers[\\/](?!exp-ln|arc|doubled|sin-cos-parts)|programs|simulation[\\/](floor[\\/]colours|\w+\.ts))/,
    minShareCount: 2,
    priority: 1,
  },
  { name: 'drawing', test: /src[\\/](drawing|figures[\\/]world|features[\\/]world)[\\/]/, minShareCount: 2 },
  {
    name: 'engine',
    test: /[\\/](packages[\\/](?!blocks|learning|numbers|maps|content[\\/](things|items|questions|schema)|simulation[\\/](floor[\\/]png|body[\\/]plugged))|node_modules[\\/]planck[\\/]|src[\\/](?!routes|service-worker|storage|lab[\\/]floor|app[\\/]lab-screen|figures[\\/](blocks|card|map|things|network[\\/]deep)|parts[\\/](ErrorScreen|page[\\/])|features[\\/](about|home|materials|projects|q-learning|share|sorting|tour|network[\\/]deep|editor[\\/](learning|expert|layers|pictures))))/,
    minShareCount: 2,
  },
]

/** Where files for a web space go, without a server; not given: the build for our own server. */
const folder = process.env['BOTGARTEN_WEB_SPACE']

export default defineConfig({
  define: { __WEB_SPACE__: JSON.stringify(folder !== undefined) },
  plugins: [
    contentPlugin,
    ...examples,
    words,
    lessPhysics,
    lessXml,
    notices,
    sveltekit({
      adapter: folder ? webSpace(folder) : adapter({ precompress: true }),
      // The sizes of the one build are not those of the other.
      outDir: folder ? '.svelte-kit/web-space' : '.svelte-kit',
      // Small styles, of parts that come late above all, would each be a request.
      inlineStyleThreshold: 8192,
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
    target: 'es2022',
    // A picture in a script would be loaded by who never sees it. Things are many, small, and never come alone.
    assetsInlineLimit: (file) =>
      file.endsWith('.svg') ? /content[\\/](things|materials)[\\/]/.test(file) : undefined,
  },
  environments: {
    client: { build: { rolldownOptions: { output: { codeSplitting: { groups: chunks } } } } },
  },
  server: { fs: { allow: ['../..'] } },
})
