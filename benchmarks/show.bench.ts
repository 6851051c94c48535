import type { Brain } from '@botgarten/learning/neural-network'
import { afterLesson, beginLesson, type Examples } from '@botgarten/learning/neural-network/examples'
import { practiseFor, starter, type Settings } from '@botgarten/learning/neural-network/train'
import type { Table } from './bench.ts'
import {
  byEyes,
  coachesFriendship,
  drivesFriendship,
  emptyBrain,
  fromAbove,
  network,
  passes,
  remembersFriendship,
} from './show/children.ts'

const children = 6
const mirror = { inputs: [1, 0], outputs: [1, 0] }
const driven: Settings = { ...starter, momentum: 0.9, batch: 16, rounds: 100 }

/** The brain after practice from zero, each example with its mirror image. */
function practised(examples: Examples, settings: Settings, seed: number): Brain {
  const brain = { ...emptyBrain(), examples }
  const exercise = {
    ...{ id: network, layers: brain.layers, weights: brain.weights, examples, seed },
    ...{ keepBack: 0, from: 'zero' as const, mirror },
  }
  const lesson = beginLesson(exercise, settings)
  practiseFor(lesson.practice, lesson.curve, Infinity)
  return { ...afterLesson(brain, lesson), examples }
}

/** One drive, practised; then three times: taken over where it errs, practised again. */
function coached(child: number, settings: Settings): Brain {
  let brain = practised(drivesFriendship(child, fromAbove, 'pad'), settings, child)
  for (let round = 0; round < 3; round++)
    brain = practised(coachesFriendship(child, brain, round), settings, child)
  return brain
}

type Way = (child: number, settings: Settings) => Brain

const shows =
  (show: (child: number) => Examples): Way =>
  (child, settings) =>
    practised(show(child), settings, child)

const ways: readonly (readonly [name: string, way: Way, settings: Settings])[] = [
  ['drive, seen from above, pad', shows((child) => drivesFriendship(child, fromAbove, 'pad')), driven],
  ['drive with Bo’s eyes, pad', shows((child) => drivesFriendship(child, byEyes, 'pad')), driven],
  ['drive with Bo’s eyes, keys', shows((child) => drivesFriendship(child, byEyes, 'keys')), driven],
  ['drive from above, then take over 3 times', coached, driven],
  ...[6, 10, 15].map(
    (count) => [`remember ${count}`, shows((child) => remembersFriendship(child, count)), starter] as const,
  ),
]

function judged(way: Way, settings: Settings): readonly string[] {
  const brains = Array.from({ length: children }, (_, child) => way(child + 1, settings))
  const passed = brains.map(passes)
  const starts = passed.flat()
  const rows = brains.reduce((sum, { examples }) => sum + (examples?.rows.length ?? 0), 0) / children
  return [
    String(Math.round(rows)),
    `${starts.filter(Boolean).length} of ${starts.length}`,
    `${passed.filter((all) => all.every(Boolean)).length} of ${children}`,
  ]
}

/** How well Bo makes friends with the square, by how it was shown. */
export default function show(): Table {
  const lines = ways.flatMap(([name, way, settings]) =>
    (['off', 'on'] as const).map((bias) => [name, bias, ...judged(way, { ...settings, bias })]),
  )
  return {
    title: 'Ways to show Friendship',
    how: `${children} simulated children, whose hand is late by 0.25 s and trembles; a net of two eyes and two wheels, from zero, mirror images too; remembered rows by the starter’s preset, driven ones 100 rounds at 0.1 with momentum 0.9 and batches of 16.`,
    columns: ['way', 'push of its own', 'examples', 'starts passed', 'all three starts'],
    rows: lines,
    notes: ['They are no children: the table shows what the design allows, not what a class will do.'],
  }
}
