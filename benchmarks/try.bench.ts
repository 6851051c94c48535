import { worldAt } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { tryOut, type Tried } from '@botgarten/experiments/trying'
import { beginNight } from '@botgarten/lab/trying'
import type { Trial } from '@botgarten/learning/q-senses'
import { tryingIn } from '@botgarten/programs'
import { median, type Table } from './bench.ts'

const seeds = 20
const minutes = 8

const { card, world } = content.card('try-dodge')!
const worlds = card.starts.map((_, start) => worldAt(world, card, start))
const floor = content.floorOf(world)
const { trial } = tryingIn(content.program('try-dodge', 'solution')!.programs['main']!)!

/** Pushes a wall most of the time: what costs the physics most. */
const pushes: Trial = {
  ...trial,
  pay: [
    { for: 'bump', coins: 5 },
    { for: 'ahead', coins: 0.01 },
  ],
}

/** Simulated seconds a second of one core's time. */
function speedOf(of: Trial): number {
  const night = beginNight(worlds[0]!, floor, of)
  night.advance(3600)
  const before = process.cpuUsage()
  night.advance(4 * 3600)
  const { user, system } = process.cpuUsage(before)
  return 240_000_000 / (user + system)
}

function row(name: string, of: Trial) {
  const all: Tried[] = Array.from({ length: seeds }, (_, k) =>
    tryOut(worlds, floor, { ...of, seed: k + 1 }, minutes),
  )
  const firsts = all.map(({ first }) => first ?? 99)
  const bumps = all.map(({ curve }) => curve.reduce((sum, one) => sum + one.bumps, 0))
  const count = (holds: (one: Tried) => boolean) => `${all.filter(holds).length} of ${seeds}`
  return [
    name,
    count(({ first }) => first !== null),
    count(({ last }) => last),
    median(firsts),
    median(bumps),
    Math.round(speedOf(of)),
  ]
}

/** How surely and how fast Bo learns with its own sensors not to bump. */
export default function tries(): Table {
  const bump = (coins: number) => ({ ...trial, pay: [trial.pay[0]!, { for: 'bump' as const, coins }] })
  return {
    title: 'Learning by trying with Bo’s sensors',
    how: `Card try-dodge, ${minutes} simulated minutes, seeds 1 to ${seeds}; passed: after some whole minute the frozen table drives 60 s from each start of the card without a bump and at 400 cm a minute. Speed: simulated seconds a second of a core’s own time, four minutes after the first.`,
    columns: ['pay', 'passed', 'still at minute 8', 'first minute (middle)', 'bumps (middle)', '× real time'],
    rows: [
      row('4 cm ahead 1, bump −5', trial),
      row('bump −10', bump(-10)),
      row('bump −2', bump(-2)),
      row('bump ends the try', { ...trial, bumpEnds: true }),
      ['pushing a wall', '', '', '', '', Math.round(speedOf(pushes))],
    ],
    notes: ['Pushing a wall: three of four moves touch. There the physics library is what takes the time.'],
  }
}
