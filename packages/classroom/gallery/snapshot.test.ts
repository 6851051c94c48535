import { expect, test } from 'vitest'
import { projectText } from '../testing/projects.ts'
import { snapshotOf } from './snapshot.ts'

/** A project whose world has this many letters as JSON, most of them those of its one obstacle. */
function withWorld(letters: number) {
  const project = JSON.parse(projectText('wide')) as { world: { obstacles: object[] } }
  const empty = { ...project.world, obstacles: [{ id: '' }] }
  const id = 'a'.repeat(letters - JSON.stringify(empty).length)
  return snapshotOf({ document: JSON.stringify({ ...project, world: { ...empty, obstacles: [{ id }] } }) })
}

test('a world of 40,000 letters is drawn with its obstacles, and a longer one as its floor with the robots', () => {
  const whole = withWorld(40_000).world
  expect(whole).toHaveLength(40_000)
  const floor = JSON.parse(withWorld(40_001).world) as object
  expect(floor).toMatchObject({ obstacles: [], robots: [{ id: 'bo' }] })
})

test('a chain has the last twenty projects that it was made from, each once', () => {
  const made = (ids: readonly string[]) => {
    const project = JSON.parse(projectText('made')) as object
    return snapshotOf({ document: JSON.stringify({ ...project, madeFrom: ids.map((id) => ({ id })) }) }).chain
  }
  const ids = Array.from({ length: 21 }, (_, at) => `project-${at}`)
  expect(made(ids)).toEqual(ids.slice(1))
  expect(made(['a', 'b', 'a'])).toEqual(['a', 'b'])
})
