import 'fake-indexeddb/auto'
import { content } from '@botgarten/content/files'
import { cardProject } from '@botgarten/content'
import { finish, race } from '@botgarten/experiments/brain-race'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { laneKinds } from '@botgarten/experiments/brain-race/table'
import type { Project } from '@botgarten/programs'
import { beforeAll, expect, test } from 'vitest'
import { add, open } from '#storage/projects.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { allCourses, kindOf, openCourse, saveRaced } from './ground.ts'

addBlocks(learning)
beforeAll(freshDevice)

function projectOf(id: string, file = 'solution', more: Partial<Project> = {}): Project {
  const { card, world } = content.card(id)!
  return { ...cardProject(world, card, content.program(id, file)!, id), ...more }
}

test('a project is for the lane of the way in which its brain came about', () => {
  expect(kindOf(projectOf('friendship'))).toBe('hand')
  expect(kindOf(projectOf('show-it'))).toBe('examples')
  expect(kindOf(projectOf('try-dodge'))).toBe('trying')
  expect(kindOf(projectOf('four-brains'))).toBe('ifThen')
  expect(kindOf(projectOf('friendship', 'solution', { programs: {} }))).toBeNull()
})

test('a child comes with a project: it is known by its lane, and brings along what went into it', async () => {
  const effort = { knobs: 0, starts: 9, bumps: 4, hand: 660, computer: 0 }
  await add([{ id: 'mine', project: projectOf('four-brains', 'start', { effort }), changed: 1 }])
  const course = (await openCourse('garden', 'mine'))!
  expect(course.mine).toEqual({ id: 'mine', kind: 'ifThen', card: 'four-brains' })
  expect(course.own.ifThen.map(({ id, racer }) => [id, racer.effort])).toEqual([['mine', effort]])
  expect(course.own.hand).toEqual([])
  for (const kind of laneKinds) expect(course.given[kind]).not.toBeNull()
})

test('what came of a race is saved with the project; where that is gone it is said', async () => {
  const raced = { course: 'garden', brains: 4, trust: 'hand', explain: 'ifThen' } as const
  expect(await saveRaced('mine', raced)).toBe(true)
  expect((await open('mine'))?.project.raced).toEqual(raced)
  expect(await saveRaced('gone', raced)).toBe(false)
})

test('a course that is not there opens nothing, a project that is not there is none', async () => {
  expect(await openCourse('__proto__')).toBeNull()
  expect((await openCourse('garden', 'gone'))?.mine).toBeNull()
})

test.each(allCourses)('on $id a lane without a brain is not ready, and the others drive', async ({ id }) => {
  const { ground } = (await openCourse(id))!
  const short = { ...ground, course: { ...ground.course, seconds: 1 } }
  const racer = content.program('friendship', 'solution')!
  const lanes = [
    { kind: 'hand', racer },
    { kind: 'trying', racer: null },
  ] as const
  const [hand, trying] = finish(race(short, lanes, 1))
  expect([hand!.problem, hand!.runs?.length]).toEqual([null, 5])
  expect([trying!.problem, trying!.runs]).toEqual(['missing', null])
})
