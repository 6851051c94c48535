import { parts } from '@botgarten/blocks/configuration'
import { cardConfig, FRONT, HALF_WIDTH, REAR, type SensorPlace } from '@botgarten/simulation'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { tilt, withTilt } from './motors.ts'
import {
  handleOf,
  isOnRobot,
  kinds,
  lookingAt,
  movedTo,
  nudged,
  placedByKey,
  spotOf,
  turnedBy,
} from './placing.ts'
import { freePort, movedOver, ports, unknownPorts } from './ports.ts'

const eye: SensorPlace = { kind: 'ultrasonic', x: 10, y: 4, angle: 20 }
const bumper: SensorPlace = { kind: 'touch', x: FRONT, y: 0, angle: 0 }
const anywhere = fc.record({
  x: fc.double({ min: -100, max: 100, noNaN: true }),
  y: fc.double({ min: -100, max: 100, noNaN: true }),
})

describe('a sensor in the picture', () => {
  it('is drawn with the front up: ahead is up, left is left', () => {
    expect(spotOf(eye)).toEqual({ x: -4, y: -10 })
  })

  it('stays on the body, on a grid of half a centimetre, wherever it is let go of', () => {
    fc.assert(
      fc.property(anywhere, fc.constantFrom(...kinds), (spot, kind) => {
        const { x, y } = movedTo({ ...eye, kind }, spot)
        expect(x >= -REAR && x <= FRONT && Math.abs(y) <= HALF_WIDTH).toBe(true)
        const onGrid = (value: number, edge: number) =>
          Number.isInteger(value * 2) || Math.abs(value) === edge
        expect(onGrid(x, REAR) && onGrid(y, HALF_WIDTH)).toBe(true)
      }),
    )
  })

  it('comes to lie where the hand is, to the grid', () => {
    expect(movedTo(eye, { x: 2.2, y: 3.1 })).toEqual({ ...eye, x: -3, y: -2 })
  })

  it('that is a bumper sits in front or behind and faces that way', () => {
    expect(movedTo(bumper, { x: 5, y: 6 })).toEqual({ kind: 'touch', x: -REAR, y: 0, angle: 180 })
    expect(movedTo(bumper, { x: 5, y: -4 })).toEqual(bumper)
    expect(nudged(bumper, 0, 1).x).toBe(-REAR)
    expect(nudged(nudged(bumper, 0, 1), 0, -1)).toEqual(bumper)
  })

  it('that is a bumper changes its end at the middle of the body', () => {
    const middle = (FRONT - REAR) / 2
    expect(movedTo(bumper, { x: 0, y: 0.1 - middle }).x).toBe(-REAR)
    expect(movedTo(bumper, { x: 0, y: -0.1 - middle }).x).toBe(FRONT)
  })

  it('can be of each kind that a robot of Open Roberta has', () => {
    const known = parts.flatMap(({ is }) => ('sensor' in is ? [is.sensor] : []))
    expect([...kinds].sort()).toEqual([...new Set<string>([...known, 'position'])].sort())
  })

  it('goes half a centimetre by an arrow key', () => {
    expect(nudged(eye, 1, 0)).toEqual({ ...eye, y: 3.5 })
    expect(nudged(eye, 0, 1)).toEqual({ ...eye, x: 9.5 })
  })

  it('turns by five degrees, to the left for more', () => {
    expect(turnedBy(eye, 1).angle).toBe(25)
    expect(turnedBy({ ...eye, angle: 180 }, 1).angle).toBe(-175)
  })

  it('looks where its handle is pulled', () => {
    fc.assert(
      fc.property(fc.integer({ min: -35, max: 36 }), (notches) => {
        const turned = { ...eye, angle: notches * 5 }
        expect(lookingAt(eye, handleOf(turned, 5)).angle).toBe(turned.angle)
      }),
    )
  })

  it('may be let go of a little beside the body, not far from it', () => {
    expect(isOnRobot({ x: 9, y: 0 })).toBe(true)
    expect(isOnRobot({ x: 0, y: -12 })).toBe(true)
    expect(isOnRobot({ x: 12, y: 0 })).toBe(false)
  })
})

describe('ports', () => {
  it('have the first free one', () => {
    expect(freePort(cardConfig)).toBe('4')
    expect(freePort({ ...cardConfig, sensors: {} })).toBe('1')
    const full = Object.fromEntries(ports.map((port) => [port, eye]))
    expect(freePort({ ...cardConfig, sensors: full })).toBeNull()
  })

  it('change places when a sensor goes where another sits', () => {
    const { sensors } = movedOver(cardConfig, '1', '3')
    expect([sensors['1']?.kind, sensors['3']?.kind]).toEqual(['ultrasonic', 'colour'])
    expect(movedOver(cardConfig, '1', '4').sensors).toEqual({
      '2': cardConfig.sensors['2'],
      '3': cardConfig.sensors['3'],
      '4': cardConfig.sensors['1'],
    })
    expect(movedOver(cardConfig, '4', '1')).toBe(cardConfig)
  })
})

describe('unequal motors', () => {
  it('are one number, there and back', () => {
    for (let percent = -30; percent <= 30; percent++)
      expect(tilt(withTilt(cardConfig, percent))).toBe(percent)
    expect(withTilt(cardConfig, 20).strength).toEqual({ left: 1, right: 0.8 })
    expect(withTilt(cardConfig, -20).strength).toEqual({ left: 0.8, right: 1 })
    expect(withTilt(withTilt(cardConfig, 20), 0)).toEqual(cardConfig)
  })
})

const plugged = (...types: readonly string[]) => ({
  stacks: [
    {
      ...{ x: 0, y: 0 },
      blocks: [
        {
          ...{ id: 'brick', type: 'robBrick_EV3-Brick' },
          values: Object.fromEntries(types.map((type, k) => [`S${k + 1}`, { id: type, type }])),
        },
      ],
    },
  ],
})

describe('what a file has plugged in', () => {
  it('is not said twice where the picture and the lists of ports show it', () => {
    expect(unknownPorts(plugged(...parts.map(({ type }) => type)))).toEqual([])
    expect(unknownPorts({ stacks: [] })).toEqual([])
  })

  it('and nobody knows is said with its port', () => {
    expect(unknownPorts(plugged('robBrick_touch', 'robBrick_nose'))).toEqual(['2'])
  })
})

describe('a key on a sensor', () => {
  it('moves it, or turns it where it looks somewhere', () => {
    const steps = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'].map((key) => {
      const { x, y } = spotOf(placedByKey({ ...eye, x: 5 }, key)!)
      return [x + 4, y + 5]
    })
    expect(steps).toEqual([
      [-0.5, 0],
      [0.5, 0],
      [0, -0.5],
      [0, 0.5],
    ])
    expect(placedByKey(eye, ',')?.angle).toBe(25)
    expect(placedByKey(eye, '.')?.angle).toBe(15)
  })

  it('does nothing where it means nothing', () => {
    expect(placedByKey(bumper, ',')).toEqual(bumper)
    expect(placedByKey(eye, 'Tab')).toBeNull()
    expect(placedByKey(eye, 'constructor')).toBeNull()
  })
})
