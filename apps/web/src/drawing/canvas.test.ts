import { beforeAll, expect, test, vi } from 'vitest'
import { paint, type Canvas } from './canvas.ts'
import type { Command } from './commands.ts'

beforeAll(() => {
  vi.stubGlobal(
    'Path2D',
    class {
      constructor(readonly d: string) {}
    },
  )
})

const families = { title: 'Baloo', read: 'Nunito' }

/** What a canvas was told, in order: calls with what they were given, and what was set. */
function painted(commands: readonly Command[]): readonly string[] {
  const told: string[] = []
  const state: { [name: string]: unknown } = { globalAlpha: 1 }
  const said = (value: unknown) => (typeof value === 'string' ? value : JSON.stringify(value))
  const canvas = new Proxy(state, {
    get: (_, name: string) =>
      name in state
        ? state[name]
        : (...given: unknown[]) => void told.push([name, ...given.map(said)].join(' ')),
    set: (_, name: string, value) => {
      if (state[name] !== value) told.push(`${name} = ${said(value)}`)
      state[name] = value
      return true
    },
  })
  paint(canvas as unknown as Canvas, commands, families)
  return told.slice(told.indexOf('lineJoin = round') + 1, -1)
}

test('a shape is filled, then outlined', () => {
  expect(painted([{ kind: 'circle', x: 1, y: 2, r: 3, fill: '#fff', stroke: '#000', lineWidth: 2 }])).toEqual(
    [
      'beginPath',
      `ellipse 1 2 3 3 0 0 ${2 * Math.PI}`,
      'fillStyle = #fff',
      'fill',
      'strokeStyle = #000',
      'lineWidth = 2',
      'setLineDash []',
      'stroke',
    ],
  )
})

test('a group is moved, turned, scaled, and what comes after it stands where it stood', () => {
  const dot: Command = { kind: 'circle', x: 0, y: 0, r: 1 }
  expect(painted([{ kind: 'group', x: 5, y: 6, turn: 90, scale: 2, shapes: [dot] }, dot])).toEqual([
    'save',
    'translate 5 6',
    `rotate ${Math.PI / 2}`,
    'scale 2 2',
    'beginPath',
    `ellipse 0 0 1 1 0 0 ${2 * Math.PI}`,
    'restore',
    'beginPath',
    `ellipse 0 0 1 1 0 0 ${2 * Math.PI}`,
  ])
})

test('a path is read once, however often it is painted', () => {
  const path: Command = { kind: 'path', d: 'M0 0h1', fill: 'red' }
  expect(painted([path, path])).toEqual(['fillStyle = red', 'fill {"d":"M0 0h1"}', 'fill {"d":"M0 0h1"}'])
})

test('letters stand on their line in the lab’s fonts', () => {
  expect(
    painted([
      { kind: 'text', text: '12', x: 3, y: 4, size: 16, font: 'title', align: 'middle', fill: '#333' },
    ]),
  ).toEqual(['font = 700 16px Baloo', 'textAlign = center', 'fillStyle = #333', 'fillText 12 3 4'])
})

test('corners are never rounder than half a side, lines close, opacities multiply', () => {
  expect(
    painted([
      { kind: 'rect', x: 0, y: 0, width: 4, height: 10, round: 9, opacity: 0.5 },
      {
        kind: 'line',
        points: [
          { x: 0, y: 0 },
          { x: 1, y: 0 },
        ],
        closed: true,
      },
    ]),
  ).toEqual([
    'globalAlpha = 0.5',
    'beginPath',
    'roundRect 0 0 4 10 2',
    'globalAlpha = 1',
    'beginPath',
    'moveTo 0 0',
    'lineTo 1 0',
    'closePath',
  ])
})

test('a pale group is painted elsewhere first, so that what lies under its shapes is not seen through them', () => {
  const shapes: Command[] = [
    { kind: 'circle', x: 0, y: 0, r: 1 },
    { kind: 'circle', x: 1, y: 0, r: 1 },
  ]
  const order: string[] = []
  const recorder = (name: string) =>
    new Proxy({}, {
      get: (own, key: string) =>
        key in own
          ? own[key]
          : () => (order.push(`${name} ${key}`), key === 'getTransform' ? 'here' : undefined),
      set: (own, key: string, value) => (
        key === 'globalAlpha' && order.push(`${name} globalAlpha ${value}`),
        (own[key] = value),
        true
      ),
    })
  const [canvas, over] = [recorder('page'), recorder('layer')]
  canvas.globalAlpha = over.globalAlpha = 1
  over.canvas = {}
  paint(
    canvas as unknown as Canvas,
    [{ kind: 'group', opacity: 0.5, shapes }],
    families,
    () => over as unknown as CanvasRenderingContext2D,
  )
  expect(order.filter((told) => told.endsWith('ellipse'))).toEqual(['layer ellipse', 'layer ellipse'])
  expect(order.slice(-4)).toEqual(['page globalAlpha 0.5', 'page drawImage', 'page restore', 'page restore'])
  expect(order).not.toContain('layer globalAlpha 0.5')
})

test('a single pale shape needs no layer', () => {
  const shapes: Command[] = [{ kind: 'circle', x: 0, y: 0, r: 1, fill: '#000' }]
  const layer = vi.fn()
  const canvas = new Proxy({ globalAlpha: 1 }, {
    get: (own, key: string) => (key in own ? own[key] : () => undefined),
  })
  paint(canvas as unknown as Canvas, [{ kind: 'group', opacity: 0.5, shapes }], families, layer)
  expect(layer).not.toHaveBeenCalled()
})
