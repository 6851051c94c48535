import { addBlocks, knowMaps } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardDocument } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { createLab, type Lab } from '@botgarten/lab'
import type { Program } from '@botgarten/programs'
import * as fc from 'fast-check'
import { beforeAll, describe, expect, it, test } from 'vitest'
import { isSame, penFor, readLog, recorded, replay, type Ground, type Line } from '../index.ts'

beforeAll(() => {
  addBlocks(expert)
  addBlocks(learning)
  knowMaps(content)
})

const ground: Ground = {
  floorOf: content.floorOf,
  checksOf: (place) => content.card(place)?.card.checks ?? [],
}

const child = { session: '0a1b2c3d', pseudonym: '0101D' }

/** The lab of a card with its solution, or another of its programs, and what is written of it. */
function sitting(place: string, name = 'solution') {
  const { card, world } = content.card(place)!
  const document = cardDocument(world, card, content.program(place, name)!, 0)
  const lab = createLab()
  lab.load(document, content.floorOf(document.world), { seed: 1, checks: card.checks })
  const lines: Line[] = []
  let t = 0
  const pen = penFor(
    child,
    () => (t += 7),
    (line) => lines.push(line),
  )
  const head = { format: 1, version: '0', study: 'test', group: 1, seed: 1, order: ['one'] }
  pen.write({ event: 'session', ...head })
  return { ...recorded(lab, pen, { place, seed: 1 }), lines }
}

/** What comes back from the file of these lines. */
function again(lines: readonly Line[]) {
  const read = readLog(lines.map((line) => JSON.stringify(line)).join('\n'))
  expect(read.faults).toEqual([])
  const played = replay(read.lines, ground)
  expect(played.faults).toEqual([])
  return played.runs
}

const ids = content.cards.map(({ id }) => id)
test.each(ids)('a run of %s that was written down comes to the same hash', (place) => {
  const { lab, lines, end } = sitting(place)
  lab.start()
  for (let frame = 0; frame < 200; frame++) lab.advance(frame % 3, 50)
  lab.view()
  lab.stop()
  end()
  const runs = again(lines)
  expect(runs).toHaveLength(1)
  expect(runs.every(isSame)).toBe(true)
})

/** Something that a hand does; numbers choose among what there is. */
const deeds: readonly ((lab: Lab, number: number) => void)[] = [
  (lab) => lab.start(),
  (lab) => lab.stop(),
  (lab) => lab.pause(),
  (lab) => lab.resume(),
  (lab) => lab.reset(),
  (lab, number) => lab.advance(number % 40),
  (lab, number) => lab.advance(number % 40, 1),
  (lab, number) => lab.step((['tick', 'block', 'over', 'network'] as const)[number % 4]!),
  (lab, number) => lab.press('up', number % 2 === 0),
  (lab, number) => lab.drive(number % 3 === 0 ? null : { left: number % 100, right: -(number % 70) }),
  (lab, number) => lab.place('bo', { x: number % 200, y: 60, heading: number % 360 }),
  (lab, number) => lab.goTo(number % 60),
  (lab) => lab.branch(),
  (lab) => lab.swap(),
  (lab) => lab.view(),
  turnKnob,
  changeBlocks,
]

function turnKnob(lab: Lab, number: number): void {
  const [id, brain] = Object.entries(lab.document().brains)[0]!
  const links = Object.entries(brain.weights).flatMap(([from, row]) =>
    Object.keys(row).map((to) => [from, to]),
  )
  const [from, to] = links[number % links.length]!
  lab.setWeight(id, from!, to!, (number % 21) / 10 - 1)
}

/** The first number in the program becomes another one; a program without is laid out anew. */
function changeBlocks(lab: Lab, number: number): void {
  const programs = lab.document().programs
  const text = JSON.stringify(programs).replace(/"NUM":"-?\d+"/, `"NUM":"${number % 50}"`)
  lab.edit(JSON.parse(text) as { [id: string]: Program }, number % 2 === 0)
}

describe('whatever hands do in whatever order', () => {
  const deed = fc.tuple(fc.nat(deeds.length - 1), fc.nat(1000))
  it.each(['friendship', 'fear'])('runs of %s come to the same hashes', (place) => {
    fc.assert(
      fc.property(fc.array(deed, { minLength: 5, maxLength: 40 }), (done) => {
        const { lab, lines, end } = sitting(place, 'start')
        lab.start()
        for (const [which, number] of done) deeds[which]!(lab, number)
        lab.advance(5)
        end()
        expect(again(lines).filter((run) => !isSame(run))).toEqual([])
      }),
      { seed: 22, numRuns: 20 },
    )
  })
})

test('a lab that writes down drives as one that does not', () => {
  const { lab, lines } = sitting('friendship')
  const { card, world } = content.card('friendship')!
  const plain = createLab()
  const document = cardDocument(world, card, content.program('friendship', 'solution')!, 0)
  plain.load(document, content.floorOf(document.world), { seed: 1, checks: card.checks })
  for (const one of [lab, plain]) {
    one.start()
    one.advance(500)
  }
  expect(lab.hash()).toBe(plain.hash())
  expect(lab.view()).toEqual(plain.view())
  expect(lines.map(({ event }) => event)).toContain('run')
})

test('a replay paints a floor again where building has changed it', () => {
  const { lab, lines, end } = sitting('friendship')
  lab.start()
  const { world } = lab.document()
  for (const floor of [content.floorOf(world), undefined, content.floorOf(world)])
    lab.rebuild(lab.document(), floor)
  end()
  const read = readLog(lines.map((line) => JSON.stringify(line)).join('\n'))
  let painted = 0
  const floorOf: Ground['floorOf'] = (one) => (painted++, ground.floorOf(one))
  expect(replay(read.lines, { ...ground, floorOf }).faults).toEqual([])
  // When the card was opened, and for two of the three changes.
  expect(painted).toBe(1 + 2)
})

test('checks, and the knobs of a pull, stand in the log', () => {
  const { lab, lines, flush } = sitting('friendship')
  lab.start()
  for (let second = 0; second < 20; second++) {
    lab.advance(60)
    lab.view()
  }
  turnKnob(lab, 3)
  flush()
  const events = new Set(lines.map(({ event }) => event))
  expect(events).toEqual(new Set(['session', 'open', 'run', 'time', 'check', 'knob', ...ended(lines)]))
})

const ended = (lines: readonly Line[]) => lines.map(({ event }) => event).filter((event) => event === 'end')
