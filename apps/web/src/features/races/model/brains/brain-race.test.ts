import 'fake-indexeddb/auto'
import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { finish, race } from '@botgarten/experiments/brain-race'
import { laneKinds } from '@botgarten/experiments/brain-race/table'
import { afterEach, beforeAll, beforeEach, expect, test, vi } from 'vitest'
import { screen } from '#lab/testing/session.ts'
import { workersHere } from '#lab/testing/worker.ts'
import { open, save } from '#storage/projects.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { friendship } from '#storage/testing/sample.ts'
import { BrainRace } from './brain-race.svelte.ts'
import { openCourse, type OpenCourse } from './ground.ts'

let course: OpenCourse
let workers: ReturnType<typeof workersHere>
const races: BrainRace[] = []

beforeAll(() => {
  addBlocks(learning)
  addBlocks(expert)
})
beforeEach(async () => {
  await freshDevice()
  const garden = (await openCourse('garden'))!
  const { ground } = garden
  // One second from each start is enough to see who drives.
  course = { ...garden, ground: { ...ground, course: { ...ground.course, seconds: 1 } } }
  workers = workersHere(() => import('./worker.ts'))
  screen()
  vi.stubGlobal('matchMedia', () => ({ matches: false }))
})
afterEach(() => {
  for (const one of races.splice(0)) one.close()
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

function raceOn(open = course): BrainRace {
  const one = new BrainRace(open)
  races.push(one)
  return one
}

test('the brains of the course drive as in one go, and the first start is shown from its beginning', async () => {
  const one = raceOn()
  expect([one.isOver, one.summaries]).toEqual([false, []])
  await one.race()
  const lanes = laneKinds.map((kind) => ({ kind, racer: course.given[kind] }))
  expect(one.results).toEqual(structuredClone(finish(race(course.ground, lanes, 1))))
  expect([one.isOver, one.drove, one.problem, one.share]).toEqual([true, 4, null, null])
  expect(one.summaries).toHaveLength(4)
  expect([one.start, one.second, one.playback.count]).toEqual([0, 0, 11])
  one.show(2)
  expect(one.start).toBe(2)
  expect(workers.map(({ isOver }) => isOver)).toEqual([true])
})

test('a project of this device drives in its lane, and knows afterwards what came of it', async () => {
  await save('mine', friendship, 0)
  const { own, mine } = (await openCourse('garden', 'mine'))!
  const one = raceOn({ ...course, own, mine })
  expect(one.chosen).toEqual({ hand: 'mine', examples: '', trying: '', ifThen: '' })
  await one.race()
  expect((await open('mine'))!.project.raced).toEqual({ course: 'garden', brains: one.drove })
  await one.answer('trust', 'hand')
  await one.answer('explain', 'ifThen')
  expect(one.answers).toEqual({ trust: 'hand', explain: 'ifThen' })
  expect((await open('mine'))!.project.raced).toMatchObject({ trust: 'hand', explain: 'ifThen' })
  await one.race()
  expect([one.answers, (await open('mine'))!.project.raced]).toEqual([
    {},
    { course: 'garden', brains: one.drove },
  ])
})

test('a project that was deleted meanwhile gets the message that it is not saved', async () => {
  const one = raceOn({ ...course, mine: { id: 'gone', kind: null, card: 'free' } })
  await one.race()
  expect(one.problem).toBe('notSaved')
})

test('a race that fails shows a message and the last result, and can be run again', async () => {
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  vi.stubGlobal('Worker', class { onerror = (_: { message: string }) => {}; terminate() {}; postMessage() { this.onerror({ message: 'No memory.' }) } }) // prettier-ignore
  const one = raceOn()
  await one.race()
  expect([one.problem, one.share, one.isOver]).toEqual(['failed', null, false])
  workersHere(() => import('./worker.ts'))
  await one.race()
  expect([one.problem, one.isOver]).toEqual([null, true])
})
