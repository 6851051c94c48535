import { content } from '@botgarten/content/files'
import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { createLab } from '@botgarten/lab'
import { ProjectError, type Program } from '@botgarten/programs'
import { paintFloor } from '@botgarten/simulation'
import { givenFiles, mutated, opened } from '../packages/programs/testing/mutations.ts'
import { percentile, type Table } from './bench.ts'

addBlocks(expert)

const copies = 10_000
const ticks = 60

const world = content.world('blank')!
const floor = paintFloor({ ...world, floor: { colour: '#FFFFFF' } })

/** An opened program drives a second, whatever it has become. */
function drive(program: Program): void {
  const robots = world.robots.slice(0, 1).map((robot) => ({ ...robot, program: 'main' }))
  const lab = createLab()
  const document = { programs: { main: program }, brains: {}, world: { ...world, robots } }
  lab.load(document, floor, { seed: 1, checks: [] })
  lab.start()
  lab.advance(ticks)
}

function seconds(act: () => void): number {
  const before = process.threadCpuUsage()
  act()
  const { user, system } = process.threadCpuUsage(before)
  return (user + system) / 1e6
}

/** Mutated copies of the given programs: opened and driven, or refused. */
export default function openRobertaFuzz(): Table {
  const files = givenFiles()
  const counts = new Map<string, number>()
  const times: number[] = []
  const crashes: string[] = []
  const slow: string[] = []
  for (let number = 1; number <= copies; number++) {
    const { what, text } = mutated(files, number)
    try {
      let outcome: Program | ProjectError | undefined
      times.push(seconds(() => (outcome = opened(text))))
      if (times.at(-1)! >= 1) slow.push(what)
      const name = outcome instanceof ProjectError ? `refused: ${outcome.reason}` : 'opened'
      counts.set(name, (counts.get(name) ?? 0) + 1)
      if (outcome && !(outcome instanceof ProjectError)) drive(outcome)
    } catch (error) {
      crashes.push(`${what}: ${String(error)}`)
    }
  }
  if (crashes.length > 0) process.exitCode = 1
  return {
    title: `${copies} mutated copies of Open Roberta’s files`,
    how: `Cut, doubled, swapped, joined with other files, with hostile entities and characters, nested deeply, made large: one to three changes a copy, drawn from its number. What opens is written, read again (equal), looked through for what to mend, and driven for ${ticks} ticks. Processor time of opening, writing and opening again.`,
    columns: ['what', 'figure', 'goal'],
    rows: [
      ...[...counts].sort(([a], [b]) => (a < b ? -1 : 1)).map(([name, count]) => [name, count, '']),
      ['crashes', crashes.length, 0],
      ['slower than a second', slow.length, 0],
      ['slowest, s', Math.max(...times).toFixed(3), '< 1'],
      ['99 of 100 within, ms', (percentile(times, 0.99) * 1000).toFixed(1), ''],
    ],
    notes: [...crashes, ...slow].slice(0, 20),
  }
}
