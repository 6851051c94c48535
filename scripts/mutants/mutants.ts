// `npm run mutants`: changes one place at a time in a copy of the tree, and runs the unit tests to see whether they find it.
import { readFileSync, writeFileSync } from 'node:fs'
import { parseArgs } from 'node:util'
import { inHouse } from '../prepare/house.mjs'
import { asScript, Trouble } from '../prepare/run.mjs'
import { Copy } from './copy.ts'
import type { Mutant } from './mutations.ts'
import { Records, recordsFile, testsHash } from './records.ts'
import { reachesGoals, reportOf, type RoomReport, type Tried } from './report.ts'
import { roomsIn, type Room } from './rooms.ts'
import { filesOf, sampleOf, type Equivalent } from './sample.ts'

const house = inHouse('.')
const equivalent = JSON.parse(
  readFileSync(inHouse('scripts/mutants/equivalent.json'), 'utf8'),
) as readonly Equivalent[]

interface Options {
  /** Mutants a room; null: as many as the room says. */
  readonly count: number | null
  readonly seed: number
  /** Only in files whose path matches. */
  readonly only: RegExp
}

/** A room's mutants, and what is known of them. */
class Sample {
  readonly room: Room
  readonly #mutants: readonly Mutant[]
  readonly #among: number
  readonly #records: Records
  readonly #tests: string

  constructor(room: Room, records: Records, { count, seed, only }: Options) {
    const { mutants, among } = sampleOf(house, room, { count: count ?? room.sample, seed, equivalent })
    // Mutants of one file follow each other, since their tests are warm then.
    this.#mutants = mutants
      .filter(({ file }) => only.test(file))
      .toSorted((a, b) => a.file.localeCompare(b.file) || a.line - b.line)
    this.room = room
    this.#among = among
    this.#records = records
    this.#tests = testsHash(house, room)
  }

  /** Tries those that were not tried yet, in the copy. Returns whether the room's tests pass without any fault. */
  async run(copy: Copy): Promise<boolean> {
    try {
      for (const [at, mutant] of this.#mutants.entries()) await this.#try(copy, mutant, at + 1)
      return true
    } catch (error) {
      if (!(error instanceof Trouble)) throw error
      console.error(error.message)
      return false
    }
  }

  async #try(copy: Copy, mutant: Mutant, at: number): Promise<void> {
    if (this.#records.outcomeOf(mutant, this.#tests) !== null) return
    const outcome = await copy.outcomeOf(mutant, this.room)
    this.#records.add(mutant, this.#tests, outcome)
    const { file, line, change } = mutant
    const place = `${this.room.name} ${at}/${this.#mutants.length}`
    console.log(`${place} ${outcome.padEnd(8)} ${file}:${line}  ${change}`)
  }

  get report(): RoomReport {
    const tried = this.#mutants.flatMap((mutant): Tried[] => {
      const outcome = this.#records.lastOutcomeOf(mutant)
      return outcome === null ? [] : [{ mutant, outcome }]
    })
    const files = filesOf(house, this.room)
    return {
      ...{ room: this.room, among: this.#among, drawn: this.#mutants.length, tried },
      equivalent: equivalent.filter(({ file }) => files.includes(file)).length,
    }
  }
}

function chosenOf(rooms: readonly Room[], names: readonly string[]): readonly Room[] {
  const unknown = names.find((name) => !rooms.some((room) => room.name === name))
  if (unknown !== undefined)
    throw new Trouble(`There is no room ${unknown}. Rooms: ${rooms.map(({ name }) => name).join(', ')}.`)
  return names.length === 0 ? rooms : names.map((name) => rooms.find((room) => room.name === name)!)
}

await asScript(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      sample: { type: 'string' },
      seed: { type: 'string', default: '1' },
      out: { type: 'string' },
      only: { type: 'string', default: '' },
      fresh: { type: 'boolean', default: false },
      report: { type: 'boolean', default: false },
    },
  })
  const records = new Records(recordsFile())
  if (values.fresh) records.forget()
  const seed = Number(values.seed)
  const options = {
    ...{ count: values.sample === undefined ? null : Number(values.sample) },
    ...{ seed, only: new RegExp(values.only) },
  }
  const samples = chosenOf(roomsIn(house), positionals).map((room) => new Sample(room, records, options))
  let isSound = true
  if (!values.report)
    await Copy.use(house, async (copy) => {
      for (const sample of samples) isSound = (await sample.run(copy)) && isSound
    })
  const reports = samples.map((sample) => sample.report)
  const report = reportOf(reports, seed)
  if (values.out === undefined) console.log(`\n${report}`)
  else writeFileSync(values.out, report)
  return isSound && reachesGoals(reports) ? 0 : 1
})
