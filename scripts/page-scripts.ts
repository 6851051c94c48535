/** Vite's manifest of the client build: by source, which file it became and what it imports. */
export interface Manifest {
  readonly [source: string]: Chunk
}

export interface Chunk {
  readonly file: string
  readonly name?: string
  readonly imports?: readonly string[]
  readonly dynamicImports?: readonly string[]
}

export interface Script {
  readonly file: string
  readonly name: string
  readonly bytes: number
}

/** Is a part that the page may ask for one that counts? `source`: its key in the manifest. */
export type Asks = (source: string, chunk: Chunk) => boolean

// SvelteKit's app entry names every page of the product; a page loads its own, and says so in its HTML.
const isTableOfPages = (name: string | undefined) => name === 'entry/app'

/**
 * What a page loads: the scripts in its HTML and all they import, and of what they may ask for the parts that count.
 * @param sizeOf bytes of a file on the wire
 * @returns largest first
 */
export function scriptsOf(
  html: string,
  manifest: Manifest,
  sizeOf: (file: string) => number,
  asks: Asks = () => false,
): Script[] {
  const sources = new Map(Object.entries(manifest).map(([source, { file }]) => [file, source]))
  const inHtml = [...html.matchAll(/_app\/immutable\/[\w./-]+\.js/g)].map(([file]) => sources.get(file))
  return scriptsFrom(
    inHtml.filter((source) => source !== undefined),
    manifest,
    sizeOf,
    asks,
  )
}

/** The same for what these sources of the manifest import. */
export function scriptsFrom(
  sources: readonly string[],
  manifest: Manifest,
  sizeOf: (file: string) => number,
  asks: Asks = () => false,
): Script[] {
  const waiting = [...sources]
  const seen = new Map<string, Script>()
  for (let source = waiting.pop(); source !== undefined; source = waiting.pop()) {
    const chunk = manifest[source]
    if (chunk === undefined || seen.has(source)) continue
    seen.set(source, { file: chunk.file, name: chunk.name ?? source, bytes: sizeOf(chunk.file) })
    const lazy = isTableOfPages(chunk.name) ? [] : (chunk.dynamicImports ?? [])
    const asked = lazy.filter((one) => manifest[one] !== undefined && asks(one, manifest[one]))
    waiting.push(...(chunk.imports ?? []), ...asked)
  }
  return [...seen.values()].sort((a, b) => b.bytes - a.bytes)
}
