import { activations, forward, layOut, type Brain } from '@botgarten/learning/neural-network/brain'
import { COLOURS, createSimulation } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'

const brainOf = (file: string) => content.program('either-or', file)!.brains['net'] as Brain

type Reading = readonly [red: number, blue: number]

/** What the card's two neurons get on a colour of its floor, 0 to 100 as the blocks say. */
function readingsOn(wanted: string): Reading {
  const world = content.world('either-or')!
  const simulation = createSimulation(world, content.floorOf(world), 1)
  for (let x = 10; x < world.size.width - 10; x += 2) {
    simulation.place('bo', { x, y: 100, heading: 0 })
    if (simulation.read(0, '1', 'colour') !== wanted) continue
    const part = (mode: 'red' | 'blue') => (Number(simulation.read(0, '1', mode)) * 100) / 255
    return [part('red'), part('blue')]
  }
  throw new Error(`${wanted} is not on the floor.`)
}

const red = readingsOn(COLOURS.red)
const blue = readingsOn(COLOURS.blue)
const white = readingsOn(COLOURS.white)
const black = readingsOn(COLOURS.black)

/** Does the lamp do on all four colours what the card asks for? */
const solves = (shines: (reading: Reading) => boolean) =>
  shines(red) && shines(blue) && !shines(white) && !shines(black)

/** Where the way from a to b crosses the way from c to d, as shares of both (Cramer's rule). */
function crossing(a: Reading, b: Reading, c: Reading, d: Reading): readonly [number, number] {
  const [u, v, w] = [b, c, d].map((p, i) =>
    i === 2 ? [c[0] - p[0], c[1] - p[1]] : [p[0] - a[0], p[1] - a[1]],
  )
  const by = u![0]! * w![1]! - u![1]! * w![0]!
  return [(v![0]! * w![1]! - v![1]! * w![0]!) / by, (u![0]! * v![1]! - u![1]! * v![0]!) / by]
}

describe('either, or: the card that no single layer can solve', () => {
  it('no line parts the colours: between red and blue lies a mix that lies between white and black, too', () => {
    const shares = crossing(red, blue, white, black)
    const mix = (a: Reading, b: Reading, share: number) => a.map((part, i) => part + share * (b[i]! - part))
    const [one, other] = [mix(red, blue, shares[0]), mix(white, black, shares[1])]
    one.forEach((part, i) => expect(part).toBeCloseTo(other[i]!, 9))
    // A weighted sum is above its bound on the mix if it is so at red and blue, and not if it is not at white and black.
    for (const share of shares) {
      expect(share).toBeGreaterThan(0)
      expect(share).toBeLessThan(1)
    }
  })

  it.each(activations)('no weights from −3 to 3 and no bias do it with one layer: %s', (activation) => {
    const weights = Array.from({ length: 61 }, (_, step) => -3 + step / 10)
    const biases = Array.from({ length: 61 }, (_, step) => -300 + step * 10)
    const neuron = (id: string, more = {}) => ({ id, activation: 'identity' as const, bias: 0, ...more })
    let nets = 0
    for (const fromRed of weights)
      for (const fromBlue of weights)
        for (const bias of biases) {
          const net = layOut({
            kind: 'network',
            layers: [[neuron('red'), neuron('blue')], [neuron('lamp', { activation, bias })]],
            weights: { red: { lamp: fromRed }, blue: { lamp: fromBlue } },
            sets: {},
          })
          nets += 1
          if (solves((reading) => forward(net, reading)[0]! > 0)) expect.fail(JSON.stringify(net))
        }
    expect(nets).toBe(61 ** 3)
  })

  it('the solution does it with two hidden neurons, its typical wrong nets do not', () => {
    const does = (file: string) => {
      const net = layOut(brainOf(file))
      return solves((reading) => forward(net, reading)[0]! > 0)
    }
    expect(brainOf('solution').layers.map((layer) => layer.length)).toEqual([2, 2, 1])
    expect(does('solution')).toBe(true)
    expect(['all-zero', 'all-full', 'mirrored', 'one-layer'].map((name) => does(`wrong/${name}`))).toEqual([
      false,
      false,
      false,
      false,
    ])
  })

  it('with green as a third sensor one layer is enough', () => {
    // As the card says under "And then?": red and blue in, green out.
    const green = { [COLOURS.red]: 0, [COLOURS.blue]: (0x57 * 100) / 255, white: 100, black: 0 }
    const lamp = ([r, b]: Reading, g: number) => 0.3 * r + 0.6 * b - g > 0
    expect(lamp(red, green[COLOURS.red]) && lamp(blue, green[COLOURS.blue])).toBe(true)
    expect(lamp(white, green.white) || lamp(black, green.black)).toBe(false)
  })
})
