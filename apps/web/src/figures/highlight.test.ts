import { networks } from '@botgarten/programs'
import { beforeEach, describe, expect, test } from 'vitest'
import { friendship } from '#storage/testing/sample.ts'
import { Highlight, partOf } from './highlight.svelte.ts'

const [net] = networks(friendship.programs['main']!)
const neurons = [...net!.inputs, ...net!.outputs]
const neuron = (id: string) => neurons.find((one) => one.id === id)!
let highlight = new Highlight(
  () => [],
  () => '',
)
beforeEach(() => {
  highlight = new Highlight(
    () => neurons,
    () => 'bo',
  )
})
const lit = () => neurons.filter(({ id }) => highlight.lightsNeuron(id)).map(({ id }) => id)

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
    highlight.pointAt(place, 'eyeLeft')
    expect(highlight.now).toEqual({ place, neurons: ['eyeLeft'], part: 'sensor 2' })
    expect(lit()).toEqual(['eyeLeft'])
    expect(highlight.lightsPart('bo', 'sensor 2')).toBe(true)
    expect(highlight.lightsPart('bo', 'sensor 3')).toBe(false)
    highlight.pointAt(place, null)
    expect([highlight.now, lit()]).toEqual([null, []])
  })

  test('what was touched last stays lit, and comes back when nothing else is pointed at', () => {
    highlight.touch('node', 'wheelLeft')
    expect(highlight.touched).toMatchObject({ place: 'node', part: 'motor C' })
    highlight.pointAt('block', 'eyeRight')
    expect(lit()).toEqual(['eyeRight'])
    highlight.pointAt('block', null)
    expect(lit()).toEqual(['wheelLeft'])
    highlight.touch('node', null)
    expect(lit()).toEqual([])
  })

  test('when a part of Bo is pointed at or touched, with all that is plugged in there', () => {
    highlight.pointAtPart('sensor 3')
    expect(highlight.now).toEqual({ place: 'part', neurons: ['eyeRight'], part: 'sensor 3' })
    highlight.pointAtPart(null)
    highlight.touchPart('motor B')
    expect([lit(), highlight.touched?.place]).toEqual([['wheelRight'], 'part'])
    highlight.touchPart(null)
    expect(highlight.now).toBeNull()
  })

  test('but nothing where no neuron is, and nothing on another robot', () => {
    highlight.pointAtPart('motor A')
    expect(highlight.now).toBeNull()
    highlight.pointAt('block', 'gone')
    expect(highlight.now).toBeNull()
    highlight.touch('block', 'eyeLeft')
    expect(highlight.lightsPart('bo2', 'sensor 2')).toBe(false)
  })
})
