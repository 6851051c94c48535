import { cards } from './cards.ts'
import { convert } from './convert.ts'
import { kMeans } from './kmeans.ts'
import { q } from './learn.ts'
import type { Options } from './options.ts'
import { examples } from './net/examples.ts'
import { net } from './net/learn-net.ts'
import { run } from './run.ts'
import { sweep } from './sweep/sweep.ts'
import { thesis } from './sweep/thesis.ts'
import type { Language } from './words.ts'

/** One command: its options beside `--help` and `--lang`, and what it does with the rest of the call. */
export interface Command {
  readonly options: Options
  /** Gives what is printed on standard output. `language`: the one that the call asks for. @throws {CallError | FileError} */
  execute(args: string[], language?: Language): string | Promise<string>
}

export type Commands = { readonly [name: string]: (() => Command | Promise<Command>) | Commands }

export const commands: Commands = {
  run: () => run,
  cards: () => cards,
  learn: {
    q: () => q,
    net: () => net,
    'q-sweep': () => sweep,
    'q-thesis': () => thesis,
    kmeans: () => kMeans,
  },
  examples: () => examples,
  convert: () => convert,
  // Loaded when it is asked for: it alone needs a browser.
  print: async () => (await import('./print/print.ts')).print,
  // These alone need databases.
  serve: async () => (await import('./serve.ts')).serve,
}

/** The command that a call names, as far as its words lead. `path`: those words. */
export function findCommand(args: readonly string[]) {
  let found: Commands[string] = commands
  const path: string[] = []
  while (typeof found === 'object' && Object.hasOwn(found, args[path.length] ?? '')) {
    const name: string = args[path.length]!
    found = found[name]!
    path.push(name)
  }
  return { found, path, rest: args.slice(path.length) }
}
