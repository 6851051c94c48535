import 'fake-indexeddb/auto'
import { content } from '@botgarten/content/files'
import { shortestPath } from '@botgarten/learning/q-learning'
import { beforeEach, expect, test } from 'vitest'
import { save } from '#storage/projects.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { friendship } from '#storage/testing/sample.ts'
import { trackOn } from './testing/track.ts'
import { openTrack, tracks } from './track.ts'

beforeEach(freshDevice)

test.each(tracks())('on the map %s there is a way from the start to the goal', (id) => {
  const { world, task } = trackOn(id)
  expect(task.start).not.toBe(task.goal)
  expect(shortestPath(world)).toBeGreaterThan(1)
})

test('a map is raced on from where its card begins: closed roads are closed', () => {
  const { task } = trackOn('railway')
  expect(task).toMatchObject({ start: 3, goal: 1 })
  expect(task.closed).toEqual([[3, 2], [2, 3]]) // prettier-ignore
  expect(trackOn('cliff').task.closed).toBeUndefined()
})

test('all maps of the content can be raced on', () => {
  expect(tracks()).toEqual(content.maps)
})

test('a map or a project that is not there, and a project that learns nothing, open no track', async () => {
  await save('mine', friendship, 0)
  const opened = await Promise.all([
    openTrack({ project: null, map: 'nowhere' }),
    openTrack({ project: 'nobody', map: null }),
    openTrack({ project: 'mine', map: null }),
  ])
  expect(opened).toEqual([null, null, null])
})
