import { existsSync, globSync, readdirSync, readFileSync } from 'node:fs'
import { basename, dirname, join } from 'node:path'

/** A folder as content/ is built: of folders that are called like what lies in them, most with a number before. */
export interface Folder {
  /** Absolute path of what lies below. */
  readonly path: (...below: string[]) => string
  readonly has: (...below: string[]) => boolean
  readonly text: (...below: string[]) => string
  readonly json: (...below: string[]) => unknown
  /** Paths below of the folders that hold such a file, in their order. */
  readonly foldersWith: (pattern: string) => readonly string[]
  /** Languages with words. */
  readonly languages: () => readonly string[]
  /** The text beside in each language that has one. */
  readonly translated: <Text>(
    folder: string,
    read: (markdown: string) => Text,
  ) => { readonly [language: string]: Text }
}

/** `cards/network/05-friendship` is called `friendship`: the number says the order. */
export const idOf = (folder: string): string => basename(folder).replace(/^\d+-/, '')

export const numberOf = (folder: string): number => Number(/^\d+/.exec(basename(folder))?.[0])

/** What is called like its folder. @throws Error where it is not: one of the two is a slip */
export function named<Named extends { readonly id: string }>(folder: string, one: Named): Named {
  if (one.id === idOf(folder)) return one
  throw new Error(`content/${folder} says that it is called "${one.id}": give both one name.`)
}

/** Makes it when it is first asked for. */
export function once<Value>(make: () => Value): () => Value {
  let made: { readonly value: Value } | undefined
  return () => (made ??= { value: make() }).value
}

/** Makes each when it is first asked for by its name. */
export function each<Value>(make: (name: string) => Value): (name: string) => Value {
  const made = new Map<string, Value>()
  return (name) => {
    if (!made.has(name)) made.set(name, make(name))
    return made.get(name)!
  }
}

export function folderAt(root: string): Folder {
  const path = (...below: string[]) => join(root, ...below)
  const has = (...below: string[]) => existsSync(path(...below))
  const text = (...below: string[]) => readFileSync(path(...below), 'utf8')
  const languages = once(() =>
    readdirSync(path('words'))
      .map((name) => basename(name, '.json'))
      .filter((name) => /^[a-z]{2}(-[A-Za-z]+)?$/.test(name))
      .sort(),
  )
  return {
    ...{ path, has, text, languages },
    json: (...below) => JSON.parse(text(...below)) as unknown,
    foldersWith: (pattern) => globSync(pattern, { cwd: root }).sort().map(dirname),
    translated: (folder, read) =>
      Object.fromEntries(
        languages()
          .filter((language) => has(folder, `${language}.md`))
          .map((language) => [language, read(text(folder, `${language}.md`))]),
      ),
  }
}
