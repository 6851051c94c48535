import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Plugin } from 'vite'

const listed = () => readFileSync(join(import.meta.dirname, 'static/licences/libraries.txt'), 'utf8')

/** The package that a module belongs to: `…/node_modules/@sveltejs/kit/src/x.js` to `@sveltejs/kit`. */
const packageOf = (module: string) =>
  /.*[\\/]node_modules[\\/]((?:@[^\\/]+[\\/])?[^\\/]+)/.exec(module)?.[1]!.replace('\\', '/')

/** Packages in the last column of the table of libraries; `micromark*` stands for all that begin so. */
const patternsIn = (libraries: string) =>
  libraries
    .split('\n\n')[1]!
    .split('\n')
    .flatMap((line) => line.split(/\s{2,}/)[3]?.split(', ') ?? [])

/** What is served and has no notice, and notices of what is not served. */
export function unlike(modules: readonly string[], libraries: string) {
  const packages = [...new Set(modules.flatMap((module) => packageOf(module) ?? []))].sort()
  const patterns = patternsIn(libraries)
  const fits = (name: string, pattern: string) =>
    pattern.endsWith('*') ? name.startsWith(pattern.slice(0, -1)) : name === pattern
  return {
    unlisted: packages.filter((name) => !patterns.some((pattern) => fits(name, pattern))),
    unused: patterns.filter((pattern) => !packages.some((name) => fits(name, pattern))),
  }
}

/** Ends a build that serves a library without its notice: what is bundled is known only here. */
export const notices: Plugin = {
  name: 'notices',
  applyToEnvironment: ({ name }) => name === 'client',
  generateBundle(_, bundle) {
    const served = Object.values(bundle).flatMap((chunk) =>
      chunk.type === 'chunk'
        ? Object.entries(chunk.modules).flatMap(([id, { renderedLength }]) =>
            renderedLength > 0 ? [id] : [],
          )
        : [],
    )
    const { unlisted, unused } = unlike(served, listed())
    if (unlisted.length + unused.length > 0)
      this.error(
        `static/licences/libraries.txt is not what is served. Missing: ${unlisted.join(', ') || 'none'}. Not served: ${unused.join(', ') || 'none'}.`,
      )
  },
}
