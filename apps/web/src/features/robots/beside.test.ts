import type { Beside } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import type { Weights } from '@botgarten/learning/neural-network'
import { beforeEach, expect, test } from 'vitest'
import { save } from '#storage/projects.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { friendship } from '#storage/testing/sample.ts'
import { weightsFor } from './beside.ts'

beforeEach(freshDevice)

const beside: Beside = content.card('fear')!.card.beside!
const set: Weights = { eyeLeft: { wheelLeft: 0, wheelRight: 0.8 } }
const zero: Weights = { eyeLeft: { wheelLeft: 0, wheelRight: 0 } }

/** A pupil's saved project for the card Friendship: the same network twice, with weights of its own each. */
function saved(net: Weights, other?: Weights): Promise<unknown> {
  const brain = { ...friendship.brains['net']!, weights: net }
  const brains = { net: brain, ...(other && { other: { ...brain, weights: other } }) }
  return save('friendship', { ...friendship, brains }, 0)
}

test('the robot next to the own one drives with the weights that were found for its card', async () => {
  await saved(set)
  expect(await weightsFor(beside)).toEqual({ net: set })
})

test('of two networks it is enough that one has weights: both are taken as they are', async () => {
  await saved(zero, set)
  const both = { ...beside, weights: { net: {}, other: {} } }
  expect(await weightsFor(both)).toEqual({ net: zero, other: set })
})

test('where nothing was found, or every weight is 0, it drives with the solution', async () => {
  expect(await weightsFor(beside)).toBe(beside.weights)
  await saved(zero)
  expect(await weightsFor(beside)).toBe(beside.weights)
})

test('a network that was not there yet has no weights', async () => {
  await saved(set)
  const both = { ...beside, weights: { net: {}, other: {} } }
  expect(await weightsFor(both)).toEqual({ net: set, other: {} })
})
