import { expect, test } from 'vitest'
import { nothing } from '@botgarten/blocks'
import type { PortSense, RobotView } from '@botgarten/lab'
import type { Uses } from '@botgarten/programs'
import { cardConfig } from '@botgarten/simulation'
import { drawBadge } from '#drawing/badges.ts'
import { message } from '#words/message.ts'
import { badgesOf, sensesShown } from './badges.ts'

const bo = { led: null, display: [] as string[], frequency: null, speech: null } as unknown as RobotView
const none: Uses = {
  ...{ ports: [], colour: [], light: [], lamp: false, display: false, sound: false, speech: false },
}
const sensing = (ports: readonly PortSense[]) => ({ ports, motors: [], timers: [], keys: [] })
const said = (robot: RobotView, uses: Partial<Uses>, ports: readonly PortSense[] = []) =>
  badgesOf(robot, { ...none, ...uses }, sensing(ports)).map(({ label, value, idle }) => ({
    label,
    value,
    idle,
  }))
const word = (key: string, facts = {}) => message(`world.badge.${key}`, facts)

test('touch, gyro, compass and sound stand beside Bo where the program uses their port, in whole numbers', () => {
  const ports: PortSense[] = [
    { port: '1', kind: 'touch', values: { touch: 1 } },
    { port: '2', kind: 'gyro', values: { angle: -44.6, rate: 3 } },
    { port: '3', kind: 'sound', values: { sound: 0 } },
    { port: '4', kind: 'compass', values: { compass: 90.2 } },
  ]
  expect(said(bo, { ports: ['1', '2', '3', '4'] }, ports)).toEqual([
    { label: word('bumper'), value: [word('pressed')], idle: false },
    { label: word('turned'), value: ['−45°'], idle: false },
    { label: word('hears'), value: ['0'], idle: true },
    { label: word('compass'), value: ['90°'], idle: false },
  ])
  expect(said(bo, { ports: ['3'] }, ports)).toHaveLength(1)
  expect(said(bo, {}, ports)).toEqual([])
})

test('a bumper that nothing presses is pale', () => {
  const free: PortSense = { port: '1', kind: 'touch', values: { touch: 0 } }
  expect(said(bo, { ports: ['1'] }, [free])).toEqual([
    { label: word('bumper'), value: [word('free')], idle: true },
  ])
})

test('what Bo says is cut where it is long; silence is pale', () => {
  expect(said(bo, { speech: true })).toEqual([{ label: word('says'), value: [word('nothing')], idle: true }])
  const [badge] = said({ ...bo, speech: 'a'.repeat(40) }, { speech: true })
  expect(badge).toEqual({
    ...{ label: word('says'), idle: false },
    value: [word('word', { text: `${'a'.repeat(28)}…` })],
  })
})

test('a word stands in quotation marks; that a row shows none stands without them', () => {
  const [badge] = said({ ...bo, display: ['Gras', nothing] }, { display: true })
  expect(badge?.value).toEqual([word('word', { text: 'Gras' }), message('neuron.empty')])
})

test('a program that only looks with its distance sensors has no badge of a sense', () => {
  expect(sensesShown({ ...none, ports: ['2', '3'] }, cardConfig)).toBe(false)
  expect(sensesShown({ ...none, ports: ['1'] }, cardConfig)).toBe(true)
})

test('every badge of what Bo does has a spot of colour or a picture', () => {
  const uses = { ...none, lamp: true, display: true, sound: true, speech: true }
  const badges = badgesOf({ ...bo, led: 'red' }, uses, sensing([]))
  expect(badges.map(({ id }) => id).toSorted()).toEqual(['display', 'lamp', 'speech', 'tone'])
  for (const badge of badges) {
    const pictures = drawBadge(badge, { x: 0, y: 0, width: 90, height: 34 }, 40).flatMap((shape) =>
      shape.kind === 'group' ? [shape.shapes] : [],
    )
    if (typeof badge.icon === 'string')
      expect(pictures, badge.id).toEqual([[expect.anything(), expect.anything()]])
    else expect(badge.icon.colour).toMatch(/^#/)
  }
})
