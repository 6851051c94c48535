import { createHash } from 'node:crypto'
import { appendFileSync, existsSync, globSync, mkdirSync, readFileSync, rmSync } from 'node:fs'
import { homedir } from 'node:os'
import { dirname, join } from 'node:path'
import type { Mutant } from './mutations.ts'
import type { Outcome } from './report.ts'
import type { Room } from './rooms.ts'

/** The file with results of earlier runs, outside of the repository: a line of JSON for each. */
export const recordsFile = (): string =>
  join(process.env['BOTGARTEN_RECORDS'] ?? join(homedir(), '.cache', 'botgarten'), 'mutants.jsonl')

interface Record {
  /** Hash of the file with the fault. */
  readonly key: string
  /** Hash of the room's tests. */
  readonly tests: string
  readonly outcome: Outcome
}

const hashOf = (parts: readonly string[]): string => {
  const hash = createHash('sha256')
  for (const part of parts) hash.update(`${part.length}:`).update(part)
  return hash.digest('hex').slice(0, 24)
}

const keyOf = ({ file, text }: Mutant): string => hashOf([file, text])

/** Hash of a room's tests: changed tests may kill other mutants. */
export function testsHash(house: string, { tests, walking }: Pick<Room, 'tests' | 'walking'>): string {
  const files = tests.flatMap((folder) => globSync(`${folder}/**/*.test.ts`, { cwd: house }))
  return hashOf([...files, ...walking].sort().map((file) => readFileSync(join(house, file), 'utf8')))
}

/** Outcomes of mutants in earlier runs. */
export class Records {
  readonly #file: string
  readonly #known = new Map<string, Record>()

  /** @param file is made with the first record; lines that cannot be read are passed over */
  constructor(file: string) {
    this.#file = file
    const lines = existsSync(file) ? readFileSync(file, 'utf8').split('\n') : []
    for (const line of lines) {
      const read = parsed(line)
      if (read) this.#known.set(read.key, read)
    }
  }

  /** Null if it has to be tried: never tried, or survived tests that have changed since. */
  outcomeOf(mutant: Mutant, tests: string): Outcome | null {
    const known = this.#known.get(keyOf(mutant))
    if (!known) return null
    const isFound = known.outcome === 'killed' || known.outcome === 'timeout'
    return isFound || known.tests === tests ? known.outcome : null
  }

  /** The outcome of its last try, also with older tests; null if it was never tried. */
  lastOutcomeOf(mutant: Mutant): Outcome | null {
    return this.#known.get(keyOf(mutant))?.outcome ?? null
  }

  add(mutant: Mutant, tests: string, outcome: Outcome): void {
    const one: Record = { key: keyOf(mutant), tests, outcome }
    this.#known.set(one.key, one)
    mkdirSync(dirname(this.#file), { recursive: true })
    appendFileSync(this.#file, `${JSON.stringify(one)}\n`)
  }

  forget(): void {
    this.#known.clear()
    rmSync(this.#file, { force: true })
  }
}

/** A line that was cut off when a run was stopped is none. */
function parsed(line: string): Record | null {
  try {
    const read = JSON.parse(line) as Partial<Record> | null
    const isWhole = typeof read?.key === 'string' && typeof read.tests === 'string' && 'outcome' in read
    return isWhole ? (read as Record) : null
  } catch {
    return null
  }
}
