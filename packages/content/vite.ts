// The catalogue on a page: modules `content:…` that this plugin writes from the files. A page imports lists; what it opens
// comes with an import of its own, so that one card is one request and no list of cards stands in the build.
import { join } from 'node:path'
import { laneKinds } from '@botgarten/experiments/brain-race/table'
import type { Plugin, Rolldown, ViteDevServer } from 'vite'
import { contentIn, type ContentFiles } from './files.ts'
import { nodesOf } from './items/walk.ts'
import { topics } from './schema/formTypes.ts'
import { packedPixels } from './pixels.ts'

const prefix = 'content:'
const root = join(import.meta.dirname, '../../content')

// A string is read faster than an object of code.
const data = (value: unknown) => `JSON.parse(${JSON.stringify(JSON.stringify(value))})`

/** Imports of the addresses of files, and the table of them: `{ "friendship": a0, … }`. */
function addresses(name: string, files: readonly (readonly [key: string, path: string])[], query: string) {
  const imports = files.map(([, path], at) => `import ${name}${at} from ${JSON.stringify(path + query)}`)
  const rows = files.map(([key], at) => `${JSON.stringify(key)}: ${name}${at}`)
  return { imports: imports.join('\n'), table: `{ ${rows.join(', ')} }` }
}

/** `id => import(…)` of what has a module of its own; null for what is not there. */
const loaded = (folder: string, ids: readonly string[]) => {
  const rows = ids.map((id) => {
    const name = JSON.stringify(`${prefix}${folder}/${id}`)
    return `${JSON.stringify(id)}: () => import(${name})`
  })
  return `{ ${rows.join(', ')} }`
}

type Parts = { readonly [part: string]: (content: ContentFiles, of: string) => string }

/** What stands in `content:<part>` and in `content:<part>/<of>`. */
const modules: Parts = {
  cards(content) {
    const ids = content.cards.map(({ id }) => id)
    const drawn = ids.flatMap((id) => {
      const picture = content.pictureOfCard(id)
      return picture === null ? [] : [[id, picture] as const]
    })
    const pictures = addresses('picture', drawn, '?url')
    return `${pictures.imports}
      const pictures = ${pictures.table}
      const loaders = ${loaded('card', ids)}
      const own = (table, id) => (Object.hasOwn(table, id) ? table[id] : null)
      export default {
        cards: ${data(content.cards)},
        pictureOfCard: (id) => own(pictures, id),
        card: async (id) => (await own(loaders, id)?.())?.default ?? null,
        goals: async () => (await import('${prefix}goals')).default,
        freeLab: async () => (await import('${prefix}free-lab')).default,
      }`
  },

  goals: (content) => `export default ${data(content.goals())}`,

  card: (content, id) => `export default ${data(content.card(id))}`,

  'free-lab': (content) => `export default ${data(content.freeLab())}`,

  worlds(content) {
    const painted = content.worlds.flatMap((id) => {
      const { floor } = content.world(id)!
      return 'asset' in floor ? [[floor.asset, content.path(floor.asset.replace(prefix, ''))] as const] : []
    })
    const floors = addresses('floor', painted, '?url')
    const pixels = addresses('pixels', painted, '?pixels')
    return `${floors.imports}
      ${pixels.imports}
      const addressIn = (table) => ({ floor }) => table['asset' in floor ? floor.asset : ''] ?? null
      export default {
        worlds: ${data(content.worlds)},
        world: async (id) => (await import('${prefix}every-world')).default[id] ?? null,
        floorAddress: addressIn(${floors.table}),
        pixelsAddress: addressIn(${pixels.table}),
      }`
  },

  'every-world': (content) =>
    `export default ${data(Object.fromEntries(content.worlds.map((id) => [id, content.world(id)])))}`,

  maps(content) {
    const files = content.maps.map((id) => [id, content.path('maps', id, 'map.svg')] as const)
    const drawings = addresses('map', files, '?url&no-inline')
    return `${drawings.imports}
      const drawings = ${drawings.table}
      export default {
        maps: ${data(content.maps)},
        stations: ${data(content.stations)},
        ends: ${data(content.ends)},
        drawn: ${data(content.drawn)},
        map: async (id) => (Object.hasOwn(drawings, id) ? (await fetch(drawings[id])).text() : null),
      }`
  },

  zoo(content) {
    const files = content.cages.map(({ cage }) => [cage.id, content.mapOfCage(cage.id)] as const)
    const drawings = addresses('map', files, '?url&no-inline')
    return `${drawings.imports}
      const drawings = ${drawings.table}
      export default {
        cages: ${data(content.cages)},
        addressOf: (id) => drawings[id],
        map: async (id) => (await fetch(drawings[id])).text(),
      }`
  },

  senses(content) {
    const files = content.senseCages.map(
      ({ cage }) => [cage.id, content.pictureOfSenseCage(cage.id)] as const,
    )
    const pictures = addresses('animal', files, '?url&no-inline')
    return `${pictures.imports}
      const pictures = ${pictures.table}
      export default { senseCages: ${data(content.senseCages)}, pictureOf: (id) => pictures[id] }`
  },

  courses(content) {
    const racersOf = (id: string) =>
      Object.fromEntries(laneKinds.map((kind) => [kind, content.racer(id, kind)]))
    return `export default ${data(content.courses.map((course) => ({ course, racers: racersOf(course.id) })))}`
  },

  sets(content) {
    const files = content.sets.flatMap(({ id, things }) =>
      things.map((thing) => [`${id}/${thing.id}`, content.pictureOf(id, thing.id)] as const),
    )
    const pictures = addresses('thing', files, '?url')
    return `${pictures.imports}
      const pictures = ${pictures.table}
      export default { sets: ${data(content.sets)}, pictureOf: (set, thing) => pictures[set + '/' + thing] }`
  },

  questionnaires(content) {
    const drawn = topics.map((topic) => [topic, content.pictureOfTopic(topic)] as const)
    const pictures = addresses('picture', drawn, '?url')
    return `${pictures.imports}
      export default { forms: ${data(content.forms)}, asked: ${data(askedIn(content))}, pictures: ${pictures.table} }`
  },

  // They come with the first item that shows one: the library shows none.
  'item-pictures'(content) {
    const files = content.items.flatMap(({ id }) => {
      const folder = content.itemFolder(id)
      return content.picturesOf(id).map((file) => [`${folder}/${file}`, content.path(folder, file)] as const)
    })
    const pictures = addresses('picture', files, '?url')
    return `${pictures.imports}
      export default ${pictures.table}`
  },

  items(content) {
    return `const texts = ${loaded('texts', content.languages)}
      export default {
        items: ${data(content.items)},
        questions: ${data(content.questions)},
        packs: ${data(content.packs)},
        itemTexts: async (language) => (await texts[language]()).default,
        alignment: async () => (await import('${prefix}alignment')).default,
        answers: async () => (await import('${prefix}answers')).default,
        references: async () => (await import('${prefix}references')).default,
        pictureAt: async (file) => (await import('${prefix}item-pictures')).default['materials/' + file] ?? file,
      }`
  },

  texts: (content, language) => `export default ${data(content.itemTexts(language))}`,
  alignment: (content) => `export default ${data(content.alignment())}`,
  answers: (content) => `export default ${data(content.answers())}`,
  references: (content) => `export default ${data(content.references())}`,

  programs: () => `export default {
    program: async (card, file) => (await import('${prefix}shown-programs')).default[card + '/' + file] ?? null,
    newBlocks: async () => (await import('${prefix}new-blocks')).default,
  }`,

  'shown-programs': (content) => `export default ${data(shownPrograms(content))}`,
  'new-blocks': (content) => `export default ${data(content.newBlocks())}`,
}

/** Every question about Bo with its words, but not why: a form tells no answers. */
function askedIn({ questions, languages, itemTexts }: ContentFiles) {
  const texts = languages.map((language) => [language, itemTexts(language).questions] as const)
  return questions.map((question) => ({
    question,
    text: Object.fromEntries(
      texts.map(([language, all]) => {
        const { question: asked, choices } = all[question.id]!
        return [language, { question: asked, choices }]
      }),
    ),
  }))
}

/** Programs of cards that an item or a question shows, by `card/file`. Start programs come with their cards. */
function shownPrograms(content: ContentFiles) {
  const named = new Set<string>()
  const { items } = content.itemTexts(content.languages[0]!)
  for (const text of Object.values(items))
    for (const node of nodesOf(text!)) {
      if (node.type !== 'embed') continue
      if ('file' in node.embed) named.add(`${node.embed.card}/${node.embed.file}`)
      if (node.embed.kind === 'way') named.add(`${node.embed.card}/solution`)
    }
  for (const { run } of content.questions) if ('file' in run) named.add(`${run.card}/${run.file}`)
  return Object.fromEntries(
    [...named]
      .filter((name) => !name.endsWith('/start'))
      .map((name) => [name, content.program(name.split('/')[0]!, name.slice(name.indexOf('/') + 1))]),
  )
}

/** `content:card/friendship`: the part `card`, of `friendship`. */
const ours = new RegExp(`${prefix}(${Object.keys(modules).join('|')})(?:/([\\w-]+))?$`)

/** What was read last; a change of any file is a catalogue of its own. */
let latest: ContentFiles | null = null
const forget = () => void (latest = null)

function moduleFor(context: Rolldown.PluginContext, id: string) {
  const content = (latest ??= contentIn(root))
  const [, part = '', of = ''] = ours.exec(id) ?? []
  for (const file of content.filesBelow()) context.addWatchFile(file)
  return { code: modules[part]!(content, of), map: null, moduleType: 'js' as const }
}

/** While somebody writes a card, every page that shows content/ is read again. */
function refresh({ watcher, environments }: ViteDevServer) {
  watcher.add(root)
  watcher.on('all', (_, file) => {
    if (!file.startsWith(root)) return
    forget()
    if (file.startsWith(join(root, 'words'))) return
    for (const { moduleGraph, hot } of Object.values(environments)) {
      for (const [id, module] of moduleGraph.idToModuleMap)
        if (id.startsWith(`\0${prefix}`)) moduleGraph.invalidateModule(module)
      hot.send({ type: 'full-reload' })
    }
  })
}

/** Where pixels lie without a build: the page's policy lets nothing be fetched from an address that is its own content. */
const whileDeveloping = '/pixels'

/** `<world>/floor.png?pixels`: the address of the picture's pixels as sensors read them. No page needs a reader of PNG for them. */
async function pixelsModule(context: Rolldown.PluginContext, id: string) {
  const file = id.split('?')[0]!
  const world = /([^\\/]+)[\\/]floor\.png$/.exec(file)![1]!
  if (context.environment.mode !== 'build') return `export default '${whileDeveloping}/${world}'`
  const source = await packedPixels(file)
  const name = context.emitFile({ type: 'asset', name: `${world}.pixels`, source })
  return `export default import.meta.ROLLUP_FILE_URL_${name}`
}

/** The one plugin that serves content/ to a page. */
export const contentPlugin: Plugin = {
  name: 'botgarten-content',
  enforce: 'pre',
  buildStart: forget,
  watchChange: forget,
  configureServer(server) {
    refresh(server)
    server.middlewares.use(whileDeveloping, (request, response) => {
      const world = /[\w-]+$/.exec(request.url ?? '')?.[0] ?? ''
      packedPixels(join(root, 'worlds', world, 'floor.png')).then(
        (pixels) => response.end(pixels),
        () => response.writeHead(404).end(),
      )
    })
  },
  resolveId: {
    filter: { id: ours },
    handler: (id) => `\0${id.replace('\0', '')}`,
  },
  load: {
    filter: { id: [ours, /floor\.png\?pixels$/] },
    handler(id) {
      return ours.test(id) ? moduleFor(this, id) : pixelsModule(this, id)
    },
  },
}
