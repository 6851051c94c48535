import { existsSync, readFileSync } from 'node:fs'
import { dirname, join } from 'node:path'

interface Manifest {
  readonly name: string
  readonly dependencies?: { readonly [name: string]: string }
  readonly exports?: { readonly [path: string]: unknown }
}

export interface Found {
  readonly folder: string
  readonly manifest: Manifest
}

const manifestIn = (folder: string) =>
  JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as Manifest

/** Looks where Node looks: in the `node_modules` of each folder from here up. */
export function folderOf(name: string, from: string): string {
  const folder = join(from, 'node_modules', name)
  if (existsSync(join(folder, 'package.json'))) return folder
  if (dirname(from) === from) throw new Error(`${name} is not installed`)
  return folderOf(name, dirname(from))
}

/**
 * All packages that some packages stand on, each once, by their `dependencies`.
 * @param root folder of the repository @param starts folders of packages
 */
export function packagesBelow(root: string, starts: readonly string[]): readonly Found[] {
  const found = new Map<string, Found>()
  const take = (folder: string) => {
    if (found.has(folder)) return
    const manifest = manifestIn(folder)
    found.set(folder, { folder, manifest })
    for (const name of Object.keys(manifest.dependencies ?? {})) {
      const own = name.startsWith('@botgarten/') && join(root, 'packages', name.slice('@botgarten/'.length))
      take(own || folderOf(name, folder))
    }
  }
  for (const start of starts) take(start)
  return [...found.values()]
}

/** Is a package one of the repository's own? */
export const isOwn = ({ manifest }: Found): boolean => manifest.name.startsWith('@botgarten/')
