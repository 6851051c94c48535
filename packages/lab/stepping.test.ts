import type { Block } from '@botgarten/blocks'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { drive, forever, labWith, net, program, turn, worldWith } from './testing/scene.ts'

const number = (id: string, value: number): Block => ({
  id,
  type: 'math_number',
  fields: { NUM: String(value) },
})
const repeat = (id: string, times: number, ...blocks: readonly Block[]): Block => ({
  ...{ id, type: 'controls_repeat_ext', values: { TIMES: number(`${id}T`, times) } },
  statements: { DO: blocks },
})
const show = (id: string): Block => ({
  ...{ id, type: 'robActions_display_text' },
  values: { OUT: number(`${id}O`, 1), COL: number(`${id}C`, 0), ROW: number(`${id}R`, 0) },
})

const lit = (lab: ReturnType<typeof labWith>) => lab.view().robots[0]!.lit
const main = program(
  drive('one', 30, 5),
  repeat('twice', 2, show('a'), turn('left', 30, 45)),
  drive('two', 30, 5),
)

describe('a stop', () => {
  it('pauses before its block is executed, every time it is reached, and going on goes past it', () => {
    const lab = labWith(main)
    lab.setStops(['left'])
    lab.start()
    const reached = []
    for (let k = 0; k < 3; k++) {
      lab.advance(600)
      reached.push([lab.view().phase, lit(lab), lab.view().robots[0]!.display[0]?.trim()])
      lab.resume()
    }
    expect(reached).toEqual([
      ['paused', 'left', '1'],
      ['paused', 'left', '1'],
      ['ended', null, '1'],
    ])
  })

  it('at the first block of all pauses at once; one that is taken away is not reached', () => {
    const lab = labWith(main)
    lab.setStops(['one'])
    lab.start()
    lab.advance(600)
    expect([lit(lab), lab.view().tick]).toEqual(['one', 0])
    lab.setStops([])
    lab.resume()
    lab.advance(3000)
    expect(lab.view().phase).toBe('ended')
  })

  it('stops the program of any robot', () => {
    const world = worldWith(2)
    const robots = [world.robots[0]!, { ...world.robots[1]!, program: 'other' }]
    const programs = { main: program(drive('far', 30, 50)), other: program(drive('near', 30, 1), show('b')) }
    const lab = labWith(programs.main, { ...world, robots }, { programs })
    lab.setStops(['b'])
    lab.start()
    lab.advance(600)
    expect(lab.view().phase).toBe('paused')
    expect(lab.view().robots.map((robot) => robot.lit)).toEqual(['far', 'b'])
  })

  it('changes nothing in the run, and nothing on the way back through time', () => {
    const stops = fc.subarray(['one', 'a', 'left', 'two', 'net', 'loop'])
    const long = program(
      drive('one', 30, 5),
      repeat('loop', 3, show('a'), turn('left', 30, 45)),
      forever(net()),
    )
    const hashAt = (ids: readonly string[]) => {
      const lab = labWith(long)
      lab.setStops(ids)
      lab.start()
      while (lab.view().tick < 400) {
        lab.advance(1)
        lab.resume()
      }
      const hash = lab.hash()
      lab.goTo(123)
      lab.goTo(400)
      expect(lab.hash()).toBe(hash)
      return hash
    }
    const plain = hashAt([])
    fc.assert(
      fc.property(stops, (ids) => {
        expect(hashAt(ids)).toBe(plain)
      }),
      { numRuns: 20, seed: 4 },
    )
  })
})

describe('a step over', () => {
  it('goes to the next block that is not inside, however long that takes', () => {
    const lab = labWith(main)
    const seen = []
    for (let k = 0; k < 5; k++) {
      lab.step('over')
      seen.push(lit(lab))
    }
    expect(seen).toEqual(['one', 'twice', 'two', null, 'one'])
  })

  it('comes out of a row to the block below the one that holds it', () => {
    const lab = labWith(main)
    for (const kind of ['over', 'over', 'block', 'over', 'over', 'over', 'over'] as const) lab.step(kind)
    expect(lit(lab)).toBe('two')
  })

  it('ends at a stop on its way', () => {
    const lab = labWith(main)
    lab.setStops(['left'])
    for (let k = 0; k < 3; k++) lab.step('over')
    expect([lit(lab), lab.view().phase]).toEqual(['left', 'paused'])
  })
})
