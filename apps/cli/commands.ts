import type { Options } from './options.ts'
import type { Language } from './words.ts'

/** One command: its options beside `--help` and `--lang`, and what it does with the rest of the call. */
export interface Command {
  readonly options: Options
  /** Does it take several languages, `--lang de,en`? */
  readonly inLanguages?: true
  /** Gives what is printed on standard output. `asked`: the languages that the call asks for. @throws {CallError | FileError} */
  execute(args: string[], asked?: readonly Language[]): string | Promise<string>
}

export type Commands = { readonly [name: string]: (() => Command | Promise<Command>) | Commands }

/** Each is loaded when it is asked for: a server has no use for the lab, nor the lab for a browser. */
const withLab =
  <Loaded>(load: () => Promise<Loaded>) =>
  async (): Promise<Loaded> => {
    await import('./lab.ts')
    return load()
  }

export const commands: Commands = {
  run: withLab(async () => (await import('./run.ts')).run),
  cards: withLab(async () => (await import('./cards.ts')).cards),
  learn: {
    q: withLab(async () => (await import('./learn.ts')).q),
    net: withLab(async () => (await import('./net/learn-net.ts')).net),
    try: withLab(async () => (await import('./trying/learn-try.ts')).learnTry),
    'q-sweep': withLab(async () => (await import('./sweep/sweep.ts')).sweep),
    'q-race': withLab(async () => (await import('./sweep/race.ts')).race),
    'q-thesis': withLab(async () => (await import('./sweep/thesis.ts')).thesis),
    kmeans: withLab(async () => (await import('./kmeans.ts')).kMeans),
  },
  map: {
    check: withLab(async () => (await import('./map.ts')).mapCheck),
    drive: withLab(async () => (await import('./map.ts')).mapDrive),
  },
  race: {
    'four-brains': withLab(async () => (await import('./brain-race.ts')).fourBrains),
  },
  record: withLab(async () => (await import('./net/record.ts')).record),
  replay: withLab(async () => (await import('./replay.ts')).replay),
  examples: withLab(async () => (await import('./net/examples.ts')).examples),
  convert: withLab(async () => (await import('./convert.ts')).convert),
  print: withLab(async () => (await import('./print/print.ts')).print),
  serve: async () => (await import('./serve.ts')).serve,
  doctor: async () => (await import('./doctor.ts')).doctor,
  backup: async () => (await import('./backup.ts')).backup,
  phrase: async () => (await import('./backup.ts')).phrase,
  restore: async () => (await import('./backup.ts')).restore,
  teacher: {
    reset: async () => (await import('./teacher.ts')).reset,
  },
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
