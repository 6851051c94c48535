import { networks } from '@botgarten/programs'
import { beforeEach, describe, expect, test } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { Glow, partOf } from './glow.svelte.ts'

const [net] = networks(friendship.programs['main']!)
const neurons = [...net!.inputs, ...net!.outputs]
const neuron = (id: string) => neurons.find((one) => one.id === id)!
let glow = new Glow(
  () => [],
  () => '',
)
beforeEach(() => {
  glow = new Glow(
    () => neurons,
    () => 'bo',
  )
})
const lit = () => neurons.filter(({ id }) => glow.lightsNeuron(id)).map(({ id }) => id)

test('a neuron stands for the part that it is plugged into', () => {
  expect(['eyeLeft', 'eyeRight', 'wheelLeft', 'wheelRight'].map((id) => partOf(neuron(id)))).toEqual([
    'sensor 2',
    'sensor 3',
    'motor C',
    'motor B',
  ])
  expect(partOf({ ...neuron('wheelLeft'), type: 'ai_nn_output_node_led' })).toBe('lamp')
  expect(partOf({ ...neuron('eyeLeft'), fields: {} })).toBeNull()
})

describe('block, node and part light up together', () => {
  test.each(['block', 'node'] as const)('when a %s is pointed at, and no longer when it is left', (place) => {
    expect(lit()).toEqual([])
    glow.pointAt(place, 'eyeLeft')
    expect(glow.now).toEqual({ place, neurons: ['eyeLeft'], part: 'sensor 2' })
    expect(lit()).toEqual(['eyeLeft'])
    expect(glow.lightsPart('bo', 'sensor 2')).toBe(true)
    expect(glow.lightsPart('bo', 'sensor 3')).toBe(false)
    glow.pointAt(place, null)
    expect([glow.now, lit()]).toEqual([null, []])
  })

  test('what was touched last stays lit, and comes back when nothing else is pointed at', () => {
    glow.touch('node', 'wheelLeft')
    expect(glow.touched).toMatchObject({ place: 'node', part: 'motor C' })
    glow.pointAt('block', 'eyeRight')
    expect(lit()).toEqual(['eyeRight'])
    glow.pointAt('block', null)
    expect(lit()).toEqual(['wheelLeft'])
    glow.touch('node', null)
    expect(lit()).toEqual([])
  })

  test('when a part of Bo is pointed at or touched, with all that is plugged in there', () => {
    glow.pointAtPart('sensor 3')
    expect(glow.now).toEqual({ place: 'part', neurons: ['eyeRight'], part: 'sensor 3' })
    glow.pointAtPart(null)
    glow.touchPart('motor B')
    expect([lit(), glow.touched?.place]).toEqual([['wheelRight'], 'part'])
    glow.touchPart(null)
    expect(glow.now).toBeNull()
  })

  test('but nothing where no neuron is, and nothing on another robot', () => {
    glow.pointAtPart('motor A')
    expect(glow.now).toBeNull()
    glow.pointAt('block', 'gone')
    expect(glow.now).toBeNull()
    glow.touch('block', 'eyeLeft')
    expect(glow.lightsPart('bo2', 'sensor 2')).toBe(false)
  })
})
