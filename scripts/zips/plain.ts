import { stripTypeScriptTypes } from 'node:module'
import type { Entry } from './archive.ts'

/** Where a module of ours lies in a zip. */
export const plainPath = (path: string): string => path.replace(/\.ts$/, '.js')

/**
 * A module without its types, as it runs, and with the others that it names where they lie in a zip. Node could strip them
 * itself, but each thread would load 24 MB to do so, and a small computer would wait for it at every start.
 */
export const plain = (source: string): string =>
  stripTypeScriptTypes(source).replaceAll(/(?<=[\w-])\.ts(?=['"`])/g, '.js')

/** A file of ours as a zip holds it. */
export const asShipped = (entry: Entry): Entry =>
  entry.path.endsWith('.ts')
    ? {
        ...entry,
        path: plainPath(entry.path),
        read: () => Buffer.from(plain(Buffer.from(entry.read()).toString())),
      }
    : entry
