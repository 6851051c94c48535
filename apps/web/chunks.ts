import type { Plugin } from 'vite'
import { chunkOfWords, isForTeachers } from './words.ts'

// Which scripts come together. Nothing here names a file, a feature or a card: what a page needs follows from its imports.

interface Modules {
  getModuleIds(): IterableIterator<string>
  getModuleInfo(id: string): {
    readonly code: string | null
    readonly importedIds: readonly string[]
    readonly dynamicallyImportedIds: readonly string[]
  } | null
}

const page = /[\\/]src[\\/]routes(.*)[\\/]\+(?:page|layout|error)\.(?:svelte|ts)$/
/** Letters of code that are not worth a request of their own. */
const few = 6_000

/** Pages that bring a module along at once, by their folder; the frame of all pages is the first page's. */
const pagesOf = new Map<string, Set<string>>()
/** Modules that come with a part that is asked for later. */
const isInLazyPart = new Set<string>()
/** Lazy parts of the features that a page's `load` asks for, by the page's module. */
const askedByLoad = new Map<string, readonly string[]>()
/** Modules of the first page's chunk. */
let first: ReadonlySet<string> = new Set()

/** Calls `see` for a module and for all that it imports, directly or through others, until `see` says that it knows one. */
function follow(modules: Modules, start: string, see: (id: string) => boolean): void {
  const waiting = [start]
  for (let id = waiting.pop(); id !== undefined; id = waiting.pop())
    if (see(id)) waiting.push(...(modules.getModuleInfo(id)?.importedIds ?? []))
}

function followAll(modules: Modules): void {
  for (const start of modules.getModuleIds()) {
    const name = page.exec(start)?.[1]
    if (name !== undefined)
      follow(modules, start, (id) => {
        const pages = pagesOf.get(id) ?? new Set()
        pagesOf.set(id, pages)
        return !pages.has(name) && pages.add(name) !== undefined
      })
    for (const lazy of modules.getModuleInfo(start)?.dynamicallyImportedIds ?? [])
      // SvelteKit asks for every page so.
      if (!modules.getModuleInfo(lazy)?.importedIds.some((id) => page.test(id)))
        follow(modules, lazy, (id) => !isInLazyPart.has(id) && isInLazyPart.add(id) !== undefined)
  }
}

const pageWithLoad = /[\\/]src[\\/]routes.*[\\/]\+page\.ts$/
const feature = /[\\/]feature\.ts$/

function followLoads(modules: Modules): void {
  for (const id of modules.getModuleIds()) {
    if (!pageWithLoad.test(id)) continue
    const features = modules.getModuleInfo(id)?.importedIds.filter((one) => feature.test(one)) ?? []
    const parts = features.flatMap((one) => modules.getModuleInfo(one)?.dynamicallyImportedIds ?? [])
    if (parts.length > 0) askedByLoad.set(id, parts)
  }
}

const nameOf = (id: string) =>
  `${isInLazyPart.has(id) ? 'parts' : 'pages'}${[...pagesOf.get(id)!].sort().join('').replace(/\W+/g, '-')}`

/** What the first page imports, and the little that only some other pages share, as far as it needs nothing large. */
function modulesOfFirst(modules: Modules): Set<string> {
  const lengths = new Map<string, number>()
  const lengthOf = (id: string) => (chunkOfWords(id) ? 0 : (modules.getModuleInfo(id)?.code?.length ?? 0))
  for (const id of pagesOf.keys()) lengths.set(nameOf(id), (lengths.get(nameOf(id)) ?? 0) + lengthOf(id))
  const isShared = (id: string) => pagesOf.get(id)!.size > 1 || isInLazyPart.has(id)
  const own = (id: string) => pagesOf.get(id)!.has('')
  const found = new Set(
    [...pagesOf.keys()].filter((id) => own(id) || (isShared(id) && lengths.get(nameOf(id))! < few)),
  )
  const imports = (id: string) => modules.getModuleInfo(id)?.importedIds ?? []
  for (let before = 0; before !== found.size;) {
    before = found.size
    for (const id of found)
      if (!own(id) && imports(id).some((one) => pagesOf.has(one) && !found.has(one))) found.delete(id)
  }
  return found
}

/** Learns which pages need what, before chunks are made. */
export const pagesOfModules: Plugin = {
  name: 'pages-of-modules',
  buildEnd(error) {
    if (error || this.environment.name !== 'client') return
    followAll(this)
    followLoads(this)
    first = modulesOfFirst(this)
  },
}

interface Built {
  readonly type: string
  readonly fileName: string
  code: string
  /** Its modules, by their ids. */
  readonly modules?: { readonly [id: string]: unknown }
  imports?: string[]
  dynamicImports?: string[]
  readonly viteMetadata?: { readonly importedCss: ReadonlySet<string> }
}

/**
 * Scripts of which a page that waits for a part needs most before it is of use: those that only such pages have, and those of
 * all pages. Others are shared for the sake of a library that is needed later, as the physics is.
 */
let heavy: readonly string[] = []

const virtual = 'virtual:files-of-teachers'
/** Files that only pages of teachers load, at once or later. */
let ofTeachers: readonly string[] = []

/** Gives the list to the service worker, which is built after the pages. */
export const filesOfTeachers: Plugin = {
  name: 'files-of-teachers',
  resolveId: (id) => (id === virtual ? `\0${virtual}` : null),
  load: (id) => (id === `\0${virtual}` ? `export const ofTeachers = ${JSON.stringify(ofTeachers)}` : null),
}

/** The folder of the page that a node is made of; null for the frame of all pages. */
const routeOf = ({ modules = {} }: Built) =>
  Object.keys(modules).flatMap((id) => page.exec(id)?.[1] ?? [])[0] ?? null

const isOfTeachers = (node: Built) => /^[\\/]teacher(?:[\\/]|$)/.test(routeOf(node) ?? '')

/** Scripts and styles that pages load, at once or later. */
function filesOf(pages: readonly Built[], bundle: { readonly [file: string]: Built }): ReadonlySet<string> {
  const files = new Set<string>()
  const add = (file: string) => {
    if (files.has(file)) return
    files.add(file)
    const { imports = [], dynamicImports = [], viteMetadata } = bundle[file] ?? {}
    for (const style of viteMetadata?.importedCss ?? []) files.add(style)
    for (const other of [...imports, ...dynamicImports]) add(other)
  }
  for (const { fileName } of pages) add(fileName)
  return files
}

/** Messages for teachers: every page has their address, since one table names all files of messages. */
const isWordsForTeachers = ({ modules = {} }: Built) =>
  Object.keys(modules).length > 0 && Object.keys(modules).every(isForTeachers)

/** Files that pages of teachers load and no other page. */
function filesOfTeachersIn(
  nodes: readonly Built[],
  bundle: { readonly [file: string]: Built },
): readonly string[] {
  const others = filesOf(
    nodes.filter((node) => !isOfTeachers(node)),
    bundle,
  )
  return [...filesOf(nodes.filter(isOfTeachers), bundle)].filter((file) => {
    const chunk = bundle[file]
    return !others.has(file) || (chunk !== undefined && isWordsForTeachers(chunk))
  })
}

/** The chunk of a page or of its frame. */
const isNode = ({ type, fileName }: Built) => type === 'chunk' && /[\\/]nodes[\\/]/.test(fileName)

/**
 * SvelteKit has a page fetch what it imports before anything runs, but leaves out what it has met before behind a part that
 * is asked for later. So pages name all that they import, and only they name what may be asked for later.
 */
export const allOfPagesAtOnce: Plugin = {
  name: 'all-of-pages-at-once',
  generateBundle(_options, bundle) {
    const built = bundle as unknown as { readonly [file: string]: Built }
    const nodes = Object.values(built).filter(isNode)
    const shared = new Set<Built>()
    const pagesWith = new Map<string, readonly { readonly waits: boolean }[]>()
    for (const node of nodes) {
      const all = new Map<string, Built>()
      const add = (file: string) => {
        const chunk = built[file]
        if (!chunk || all.has(file)) return
        all.set(file, chunk)
        shared.add(chunk)
        chunk.imports?.forEach(add)
      }
      node.imports?.forEach(add)
      // Asked for in any case before the screen stands: so it need not wait until the page's scripts run.
      const asked = Object.keys(node.modules ?? {}).flatMap((id) => askedByLoad.get(id) ?? [])
      Object.values(built)
        .filter(({ modules = {} }) => asked.some((id) => id in modules))
        .forEach(({ fileName }) => add(fileName))
      node.imports = [...all.keys()]
      const about = { waits: asked.length > 0 }
      for (const file of [node.fileName, ...node.imports])
        pagesWith.set(file, [...(pagesWith.get(file) ?? []), about])
      const later = [node, ...all.values()].flatMap(({ dynamicImports = [] }) => dynamicImports)
      node.dynamicImports = [...new Set(later)]
    }
    for (const chunk of shared) if (!isNode(chunk)) chunk.dynamicImports = []
    heavy = [...pagesWith]
      .filter(([, pages]) => pages.length === nodes.length || pages.every(({ waits }) => waits))
      .map(([file]) => file)
    ofTeachers = filesOfTeachersIn(nodes, built)
  },
}

/**
 * Has browsers compile heavy scripts while they travel, instead of function by function when the page calls them:
 * https://v8.dev/blog/explicit-compile-hints. The comment counts in the first line alone, before what Vite writes there.
 */
export const compiledAtOnce: Plugin = {
  name: 'compiled-at-once',
  generateBundle: {
    order: 'post',
    handler(_options, bundle) {
      const built = bundle as unknown as { readonly [file: string]: Built }
      for (const file of heavy) {
        const chunk = built[file]
        if (chunk?.type === 'chunk') chunk.code = `//# allFunctionsCalledOnLoad\n${chunk.code}`
      }
    },
  },
}

/**
 * What the first page shares with others is a chunk, and what the same other pages share is one: who has been on one of them
 * has it. What lazy parts need besides stands apart, so that they do not bring a page along. Null for what no page imports.
 */
function chunkOfPages(id: string): string | null {
  if (first.has(id)) return 'first'
  return pagesOf.has(id) ? nameOf(id) : null
}

export const chunks = [
  // SvelteKit's first script imports it and must not pull anything else in before the page is set up.
  { name: 'preload', test: /preload-helper|runtime[\\/]client[\\/]payload\.js/, priority: 4 },
  { name: chunkOfWords, debugName: 'words', priority: 3 },
  {
    name: chunkOfPages,
    debugName: 'pages',
    priority: 2,
    minShareCount: 2,
    includeDependenciesRecursively: false,
  },
  // What lazy parts share and no page needs.
  { name: 'parts', priority: 1, minShareCount: 2, entriesAware: true, entriesAwareMergeThreshold: 1_500 },
]
