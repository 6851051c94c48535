import { createSimulation, paintFloor } from '@botgarten/simulation'
import { expect, test } from 'vitest'
import { worldWith } from '../testing/scene.ts'
import { newTrack, note } from './tracks.ts'

test('a trail holds ten points a second; after ten minutes only its first minute goes', () => {
  const world = worldWith()
  const { state } = createSimulation(world, paintFloor(world), 1)
  const track = newTrack()
  const until = (second: number, from: number) => {
    for (let tick = from * 60 + 1; tick <= second * 60; tick++) note([track], tick, state, [false])
    return [track.trail[0]!.t, track.trail.at(-1)!.t, track.trail.length]
  }
  expect(until(600, 0)).toEqual([0.1, 600, 6000])
  // One point more than ten minutes: those of the first 60 s have gone.
  expect(until(601, 600)).toEqual([60.1, 601, 6010 - 600])
})
