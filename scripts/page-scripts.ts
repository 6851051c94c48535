/** Vite's manifest of the client build: by source, which file it became and what it imports. */
export interface Manifest {
  readonly [key: string]: {
    readonly file: string
    readonly name?: string
    readonly imports?: readonly string[]
    readonly dynamicImports?: readonly string[]
  }
}

export interface Script {
  readonly file: string
  readonly name: string
  readonly bytes: number
}

// SvelteKit's app entry names every page of the product; a page loads its own, and says so in its HTML.
const isTableOfPages = (name: string | undefined) => name === 'entry/app'
// A part of the page that only a click asks for hangs on a file of this name, and has files of words of its own; pages
// begin with these.
const atOnce = ['app', 'blockly']
const isForLater = (key: string, name: string | undefined) =>
  /\/later\.ts$/.test(key) ||
  smallWords(name) !== undefined ||
  !atOnce.includes(wordsOf(key)?.['file'] ?? 'app')
// Chunks of cards and worlds: the page loads the one that it shows.
const isContent = (name: string | undefined) => name?.startsWith('content-') ?? false

// Files of words: the page loads those of the language that it speaks. Small ones of a language come together.
const wordsOf = (key: string) => /content:words\/(?<language>\w+)\/(?<file>[\w-]+)$/.exec(key)?.groups
const smallWords = (name = '') => /^words-(\w+)$/.exec(name)?.[1]
const languageOf = (key: string, name: string | undefined) => wordsOf(key)?.['language'] ?? smallWords(name)

// Of what comes late a page never asks for another playground; what is seen inside a network belongs to the lab.
const playgroundOf = (key: string) => /features\/(q-learning|sorting)\/later\.ts$/.exec(key)?.[1]

export interface Counted {
  /** Also the parts that only a click asks for. */
  readonly withLater?: boolean
  /** The card or world that the page shows, as its folder is called without the number. */
  readonly content?: string
  /** The playground whose late parts it may ask for; not given: all of them. */
  readonly playground?: string
  /** The language that it speaks; not given: all of them. */
  readonly language?: string
}

/**
 * What a page loads: the scripts in its HTML and all they import, at once or by themselves soon after.
 * @param sizeOf bytes of a file on the wire
 * @returns largest first
 */
export function scriptsOf(
  html: string,
  manifest: Manifest,
  sizeOf: (file: string) => number,
  { withLater = false, content, language, playground }: Counted = {},
): Script[] {
  const keys = new Map(Object.entries(manifest).map(([key, { file }]) => [file, key]))
  const waiting = [...html.matchAll(/_app\/immutable\/[\w./-]+\.js/g)].map(([file]) => keys.get(file))
  const seen = new Map<string, Script>()
  for (let key = waiting.pop(); key !== undefined; key = waiting.pop()) {
    const chunk = manifest[key]
    if (chunk === undefined || seen.has(key)) continue
    seen.set(key, { file: chunk.file, name: chunk.name ?? key, bytes: sizeOf(chunk.file) })
    const lazy = isTableOfPages(chunk.name) ? [] : (chunk.dynamicImports ?? [])
    const comes = (one: string) => {
      const { name } = manifest[one] ?? {}
      if (language && (languageOf(one, name) ?? language) !== language) return false
      if (playground && (playgroundOf(one) ?? playground) !== playground) return false
      return isContent(name) ? name === `content-${content}` : withLater || !isForLater(one, name)
    }
    waiting.push(...(chunk.imports ?? []), ...lazy.filter(comes))
  }
  return [...seen.values()].sort((a, b) => b.bytes - a.bytes)
}
