import { addBlocks, knowMaps, nothing } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { createLab, type Check, type Document, type View } from '@botgarten/lab'
import { drivenRun } from '@botgarten/lab/testing/driven'
import { withLearnedWay } from '@botgarten/maps'
import { isLong } from '@botgarten/numbers/testing'
import { dialects, pythonFrom, type Dialect } from '@botgarten/programs/python'
import { runPython } from '@botgarten/programs/python/testing'
import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { cardDocument } from '../index.ts'

addBlocks(expert)
addBlocks(learning)
knowMaps(content)

const cards = content.cards.map(({ id }) => id)
const startsOf = (id: string) => content.card(id)!.card.starts.map((_, start) => start)
const all = cards.flatMap((id) => startsOf(id).map((start) => [id, start] as const))
/** Every card from its first start; every start in `npm run test:long`. */
const runs = isLong ? all : all.filter(([, start]) => start === 0)

/** What a robot did in a run. */
interface Drive {
  /** A pose a tick. */
  readonly poses: View['robots'][number]['pose'][]
  /** What stands on the display, a tick. */
  readonly words: string[]
  /** Lamps and tones in order, each when it changed. */
  readonly lamps: unknown[]
  readonly tones: unknown[]
  checks: readonly (readonly [string, boolean])[]
}

const newDrive = (): Drive => ({ poses: [], lamps: [], words: [], tones: [], checks: [] })

function note(drive: Drive, view: View): void {
  const { pose, led, display, frequency } = view.robots[0]!
  drive.poses.push(pose)
  drive.words.push(display.join('|').replaceAll(nothing, '-'))
  for (const [list, value] of [
    [drive.lamps, led],
    [drive.tones, frequency === null ? null : Math.round(frequency)],
  ] as const)
    if (JSON.stringify(list.at(-1)) !== JSON.stringify(value)) list.push(value)
}

interface Task {
  readonly document: Document
  readonly floor: ReturnType<typeof content.floorOf>
  readonly checks: readonly Check[]
  readonly ticks: number
}

function taskOf(id: string, start: number): Task {
  const { card, world } = content.card(id)!
  const plain = cardDocument(world, card, content.program(id, 'solution')!, start)
  const document = withLearnedWay(plain, (map) => content.mapFile(map))
  const seconds = Math.max(60, ...card.checks.map((one) => one.seconds))
  return {
    ...{ document, floor: content.floorOf(document.world), checks: card.checks },
    ticks: seconds * TICKS_PER_SECOND,
  }
}

/** The blocks' run. */
function byBlocks({ document, floor, checks, ticks }: Task): Drive {
  const drive = newDrive()
  const lab = createLab()
  lab.load(document, floor, { seed: 1, checks })
  lab.start()
  for (let tick = 0; tick < ticks; tick++) {
    lab.advance(1)
    note(drive, lab.view())
  }
  drive.checks = lab.view().checks.map(({ id, passed }) => [id, passed])
  return drive
}

/** The run of the file in MicroPython, on the same simulation. */
async function byPython({ document, floor, checks, ticks }: Task, dialect: Dialect): Promise<Drive> {
  const drive = newDrive()
  const run = drivenRun(document, floor, checks, 1)
  const [{ program, config }] = [document.world.robots[0]!]
  const { programs, brains, tables } = document
  const { text } = pythonFrom(
    { name: 'card', program: programs[program]!, config, brains, ...(tables && { tables }), dialect },
    (key) => key,
  )
  let left = ticks
  const tick = () => {
    run.advance()
    note(drive, run.view())
    if (--left === 0) throw new Error('time is up')
  }
  const { error } = await runPython(text, run.robot, { tick, random: () => 0 }, config)
  expect(error ?? '').toMatch(/^$|time is up/)
  run.robot.stop()
  while (left > 0) {
    run.advance()
    note(drive, run.view())
    left--
  }
  drive.checks = run.results().map(({ id, passed }) => [id, passed])
  return drive
}

const turnBetween = (a: number, b: number) => Math.abs(((a - b + 540) % 360) - 180)

type Pose = View['robots'][number]['pose']

/** Python's loops may have waited so many ticks more or less (python.md, "Time"). */
const late = 10

const far = (a: Pose, b: Pose) => ({
  cm: Math.hypot(a.x - b.x, a.y - b.y),
  degrees: turnBetween(a.heading, b.heading),
})

/** Are the two ways the same within 2 cm and 3°? Gives the seconds at which they are not. */
function astray(ours: Drive, theirs: Drive): readonly number[] {
  const isNear = (pose: Pose, tick: number) =>
    theirs.poses.slice(Math.max(0, tick - late), tick + late + 1).some((other) => {
      const { cm, degrees } = far(pose, other)
      return cm < 2 && degrees < 3
    })
  return ours.poses.flatMap((pose, tick) =>
    tick % TICKS_PER_SECOND === 0 && !isNear(pose, tick) ? [tick / TICKS_PER_SECOND] : [],
  )
}

/** On ev3dev a network's tone lasts a tenth of a second and is then begun again. */
const sounding = ({ tones }: Drive) =>
  tones.filter((tone) => tone !== null).filter((tone, k, heard) => tone !== heard[k - 1])

/** Words that stood for a tenth of a second: over the edge of a colour they flicker. */
const read = ({ words }: Drive) =>
  words
    .filter((word, tick) => words.slice(tick, tick + 6).every((later) => later === word))
    .filter((word, k, all) => word !== all[k - 1])

/** The hub of SPIKE Prime shows one word for all of a network's outputs. */
const asOnHub = (word: string) => word.split('|').find((row) => /[^-]/.test(row)) ?? word.slice(0, 1)

const readFrom = (drive: Drive, dialect: Dialect) =>
  read(dialect === 'spike' ? { ...drive, words: drive.words.map(asOnHub) } : drive)

/** These checks look into the blocks' program, for its network and for the table that it drives by. */
const insideBlocks = ['tried', 'eyesDecide', 'netDecides', 'cheats']
const seen = ({ checks }: Drive) => checks.filter(([id]) => !insideBlocks.includes(id))

/** The blocks drive once for all dialects. */
const driven = new Map<string, { readonly task: Task; readonly ours: Drive }>()
function drivenBy(id: string, start: number) {
  const key = `${id} ${start}`
  if (!driven.has(key)) {
    const task = taskOf(id, start)
    driven.set(key, { task, ours: byBlocks(task) })
  }
  return driven.get(key)!
}

describe.each(dialects)('a card’s solution as Python for %s', (dialect) => {
  it.each(runs)('%s from start %i drives, lights, shows and sounds as its blocks do', async (id, start) => {
    const { task, ours } = drivenBy(id, start)
    const theirs = await byPython(task, dialect)
    expect(astray(ours, theirs)).toEqual([])
    expect(seen(theirs)).toEqual(seen(ours))
    expect(theirs.lamps).toEqual(ours.lamps)
    expect(read(theirs)).toEqual(readFrom(ours, dialect))
    expect(sounding(theirs)).toEqual(sounding(ours))
  })
})
