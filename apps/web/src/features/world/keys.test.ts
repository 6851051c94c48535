import { describe, expect, test } from 'vitest'
import { Driver } from './driver.ts'
import { happening } from './happenings.ts'
import { driveKey, movedBy, turnedBy } from './keys.ts'

const pose = { x: 10, y: 20, heading: 0 }

describe('keys in the world', () => {
  test('arrows move a thing by 1 cm, with Shift by 10', () => {
    expect(movedBy({ key: 'ArrowUp' }, pose)).toEqual({ ...pose, y: 21 })
    expect(movedBy({ key: 'ArrowLeft', shiftKey: true }, pose)).toEqual({ ...pose, x: 0 })
    expect(movedBy({ key: 'a' }, pose)).toBeNull()
  })

  test('comma turns left and dot turns right by 5 degrees, the brackets too', () => {
    expect(turnedBy({ key: ',' }, pose)?.heading).toBe(5)
    expect(turnedBy({ key: '.' }, pose)?.heading).toBe(355)
    expect(turnedBy({ key: '[' }, pose)?.heading).toBe(5)
    expect(turnedBy({ key: ']' }, pose)?.heading).toBe(355)
  })

  test('leave shortcuts of the browser alone', () => {
    expect(driveKey({ key: 'ArrowLeft', altKey: true })).toBeNull()
    expect(movedBy({ key: 'ArrowUp', ctrlKey: true }, pose)).toBeNull()
    expect(turnedBy({ key: '.', metaKey: true }, pose)).toBeNull()
  })
})

describe('driving', () => {
  const event = (key: string) => ({ key, preventDefault: () => undefined }) as unknown as KeyboardEvent

  test('a held key is told once, and leaving lets go of all', () => {
    const told: [string, boolean][] = []
    const driver = new Driver((key, down) => told.push([key, down]))
    driver.press(event('ArrowUp'))
    driver.press(event('ArrowUp'))
    driver.press(event('ArrowLeft'))
    driver.letGo(event('ArrowLeft'))
    driver.letGoOfAll()
    driver.letGo(event('ArrowUp'))
    expect(told).toEqual([
      ['up', true],
      ['left', true],
      ['left', false],
      ['up', false],
    ])
  })
})

describe('what is said aloud', () => {
  const robot = {
    id: 'bo',
    pose,
    motors: { B: 50, C: 50 },
    led: null,
    display: [],
    frequency: null,
    speech: null,
    bumps: 0,
    trying: false,
    touching: [],
    rays: {},
    tones: [],
    problem: null,
    trail: [],
    lit: null,
  }

  test('bumping and stopping, nothing else', () => {
    expect(happening(robot, { ...robot, touching: ['block'] })).toBe('bumped')
    expect(happening(robot, { ...robot, motors: { B: 1, C: 0 } })).toBe('stopped')
    expect(happening(robot, { ...robot, motors: { B: 20, C: 90 } })).toBeNull()
    expect(happening({ ...robot, touching: ['block'] }, { ...robot, touching: ['block'] })).toBeNull()
  })
})
