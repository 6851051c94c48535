import { readFileSync, writeFileSync } from 'node:fs'
import { isLong } from '@botgarten/numbers/testing'
import fc from 'fast-check'
import { flushSync } from 'svelte'
import { afterAll, beforeAll, expect, test, vi } from 'vitest'
import { allCards } from '#content/cards.ts'
import { assetsFromDisk } from '#lab/testing/assets.ts'
import { screen } from '#lab/testing/session.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { language } from '#words/language.svelte.ts'
import { fetchWords } from '#words/message.ts'
import { openCard, reopened, type Lab } from './child.svelte.ts'
import { edits, onMapKinds, type Pick } from './edits.ts'
import { Log } from './log.ts'

// Taking the drawing of a map apart needs the document of a page; no picture is drawn here.
vi.mock('#figures/map/picture.ts', () => ({ takeApart: () => ({}) }))

const kinds = Object.keys(edits)

/** Sequences: a sample in `npm test`, 10,000 in `npm run test:long`; `BOTGARTEN_EDITS=<number>` runs another number. */
const sequences = Number(process.env['BOTGARTEN_EDITS'] ?? (isLong ? 10_000 : 60))
/** `BOTGARTEN_EDITS_COUNT=1` counts the sequences that fail instead of ending with the first. */
const counts = process.env['BOTGARTEN_EDITS_COUNT'] === '1'
const seed = Number(process.env['BOTGARTEN_SEED'] ?? (isLong ? Date.now() % 1e9 : 1))
const log = new Log()

let draw: ReturnType<typeof screen>
beforeAll(async () => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'setInterval', 'clearInterval'] })
  vi.stubGlobal('document', Object.assign(new EventTarget(), { hidden: false, documentElement: {} }))
  vi.stubGlobal('window', globalThis)
  vi.stubGlobal('addEventListener', () => {})
  vi.stubGlobal('removeEventListener', () => {})
  await freshDevice()
  assetsFromDisk()
  // Floors of the content have no address here: they are white.
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  draw = screen()
  await language.speak('en')
  await fetchWords('missed', 'q-learning')
})
afterAll(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
  if (!isLong && !counts) return
  const before = readFileSync(log.file, 'utf8')
  const report = log.report(
    { sequences, seed },
    allCards.map(({ id }) => id),
  )
  // The part about the browser is written by `npm run edits:browser`.
  const below = before.indexOf('\n## ')
  writeFileSync(log.file, report + (below < 0 ? '' : before.slice(below)))
})

function drawNow(milliseconds: number): void {
  draw(milliseconds)
  vi.advanceTimersByTime(milliseconds)
  flushSync()
}

/** Draws a frame, and lets everything that follows it come. */
async function frame(milliseconds = 50): Promise<void> {
  drawNow(milliseconds)
  for (let turns = 0; turns < 2; turns += 1) await new Promise((done) => setImmediate(done))
  flushSync()
}

function picker(seed: number): Pick {
  let state = seed >>> 0
  const below = (count: number) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return Math.floor((state / 2 ** 32) * count)
  }
  return { below, of: (items) => items[below(items.length)] }
}

/** Until Bo drives by its program; a way that has to be learned is learned in turbo. */
async function drives(lab: Lab): Promise<void> {
  if (lab.learning) lab.learning.player.speed = Infinity
  lab.ui.start()
  const isOn = () => lab.session.lab.facts.phase === 'running' || lab.learning?.state === 'playing'
  for (let frames = 0; frames < 6 || (frames < 40 && isOn() && !lab.moves); frames += 1) await frame()
}

function readNotes(lab: Lab): void {
  if (lab.fault !== null) throw lab.fault
  for (const note of lab.notes())
    if (/undefined|NaN|\[object|missed\.|\{\w+\}/.test(note)) throw new Error(`A note reads "${note}".`)
}

interface Step {
  readonly kind: number
  readonly seed: number
  readonly wait: number
}

/** One edit and the frame after it. A run ends when its task changes. */
async function edit(lab: Lab, kind: string, { seed, wait }: Step): Promise<void> {
  const [moves, key, isRunning] = [
    lab.moves,
    lab.learning?.task.key,
    lab.session.lab.facts.phase === 'running',
  ]
  const measure = log.measure()
  const done = await edits[kind]!(lab, picker(seed))
  flushSync()
  readNotes(lab)
  const { phase } = lab.session.lab.facts
  if (isRunning && onMapKinds.includes(kind) && key !== lab.learning?.task.key && phase === 'running')
    throw new Error(`Bo drives on after ${kind}, though something else is to be learned.`)
  if (phase === 'running' && ['field', 'deleteBlock', 'unplug'].includes(kind) && lab.stuck)
    throw new Error('A program runs that has to be fixed first.')
  drawNow(50)
  readNotes(lab)
  if (done) log.note(kind, moves, measure())
  for (let frames = 0; frames <= wait; frames += 1) {
    await frame()
    readNotes(lab)
  }
}

async function again(lab: Lab): Promise<Lab> {
  // Undo and redo happen two frames after the press.
  for (let frames = 0; frames < 4; frames += 1) await frame()
  const { lab: next, lost } = await reopened(lab)
  if (lost !== null) throw new Error(`A reload has lost ${lost}.`)
  await frame()
  readNotes(next)
  return next
}

async function run(card: string, steps: readonly Step[], id: string): Promise<void> {
  let lab = await openCard(card, id)
  try {
    await drives(lab)
    if (lab.session.lab.facts.phase === 'running') log.started(card)
    for (const step of steps) {
      if (!lab.moves && step.wait > 0) await drives(lab)
      const of = lab.learning?.outline && step.kind % 4 > 0 ? onMapKinds : kinds
      if (step.kind % 40 === 0) lab = await again(lab)
      else await edit(lab, of[(step.kind >> 2) % of.length]!, step)
    }
    lab = await again(lab)
  } finally {
    lab.close()
  }
}

const step = fc.record({ kind: fc.nat(), seed: fc.nat(), wait: fc.nat(3) })
const card = fc.constantFrom(...allCards.map(({ id }) => id))

test('random edits while a card runs end in no exception, lose nothing and stop what depends on them', async () => {
  let number = 0
  const property = fc.asyncProperty(
    card,
    fc.array(step, { minLength: 6, maxLength: 14 }),
    async (id, steps) => {
      try {
        await run(id, steps, `edits-${number++}`)
      } catch (cause) {
        if (!counts) throw cause
        log.failed(cause)
      }
    },
  )
  const errors = vi.spyOn(console, 'error')
  await fc.assert(property, { numRuns: sequences, seed })
  expect(errors.mock.calls).toEqual([])
  if (isLong) for (const kind of kinds) expect([kind, log.whileMoving(kind) >= 300]).toEqual([kind, true])
}, 7_200_000)
