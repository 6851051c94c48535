import { posix } from 'node:path'
import { plainPath } from './plain.ts'

/**
 * Files that stand in for the link from `node_modules/@botgarten/NAME` to `packages/NAME`: zips hold no links that
 * Windows follows.
 * @param exported the package's `exports`
 */
export function shimsOf(name: string, exported: { readonly [path: string]: unknown }): Map<string, string> {
  const folder = `node_modules/@botgarten/${name}`
  const files = new Map<string, string>()
  const exports: Record<string, string> = {}
  for (const [path, target] of Object.entries(exported)) {
    // Types alone, for the compiler.
    if (typeof target !== 'string') continue
    const file = `${path === '.' ? 'index' : path.slice(2).replaceAll('/', '-')}.js`
    exports[path] = `./${file}`
    const source = posix.relative(folder, posix.join('packages', name, plainPath(target)))
    files.set(`${folder}/${file}`, `export * from '${source}'\n`)
  }
  files.set(
    `${folder}/package.json`,
    `${JSON.stringify({ name: `@botgarten/${name}`, type: 'module', exports })}\n`,
  )
  return files
}
