import { parseProject, writeProject } from '@botgarten/programs'
import { afterEach, beforeEach, describe, expect, it } from 'vitest'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { Robots } from './robots.svelte.ts'

beforeEach(freshDevice)
afterEach(closeSessions)

function four() {
  const { session } = sessionOf()
  const robots = new Robots(session)
  for (const kind of ['shared', 'own', 'shared'] as const) robots.add(kind)
  return { session, robots }
}

describe('several robots', () => {
  it('are four at most: no fifth is added', () => {
    const { robots } = four()
    expect([robots.ids.length, robots.full]).toEqual([4, true])
    robots.add('own')
    expect(robots.ids).toEqual(['bo', 'bo2', 'bo3', 'bo4'])
  })

  it('are in the file with their programs and weights, and open again from it', () => {
    const { session } = four()
    const { world } = parseProject(writeProject(session.project))
    expect(world.robots.map(({ program, brain }) => [program, brain])).toEqual([
      ['main', ''],
      ['main', 'bo2'],
      ['bo3', ''],
      ['bo3', 'bo4'],
    ])
    const again = new Robots(sessionOf(parseProject(writeProject(session.project))).session)
    expect(again.ids).toEqual(['bo', 'bo2', 'bo3', 'bo4'])
  })

  it('can be removed, but not the first', () => {
    const { robots } = four()
    robots.choose('bo3')
    robots.remove()
    expect([robots.ids, robots.full]).toEqual([['bo', 'bo2', 'bo4'], false])
    robots.choose('bo')
    robots.remove()
    expect(robots.ids).toEqual(['bo', 'bo2', 'bo4'])
  })
})
