import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'
import { paint } from './canvas.ts'
import type { Canvas } from './shapes.ts'
import type { Command } from './commands.ts'

beforeAll(() => {
  vi.stubGlobal(
    'Path2D',
    class {
      constructor(readonly d: string) {}
    },
  )
})

const unmoved = { a: 1, b: 0, c: 0, d: 1, e: 0, f: 0 }
const families = { title: 'Baloo', read: 'Nunito' }

/** What a canvas was calls, in order: calls with what they were given, and what was set. */
function painted(commands: readonly Command[]): readonly string[] {
  const calls: string[] = []
  const state: { [name: string]: unknown } = { globalAlpha: 1 }
  const said = (value: unknown) => (typeof value === 'string' ? value : JSON.stringify(value))
  const canvas = new Proxy(state, {
    get: (_, name: string) =>
      name in state
        ? state[name]
        : (...given: unknown[]) => {
            calls.push([name, ...given.map(said)].join(' '))
            return name === 'getTransform' ? unmoved : undefined
          },
    set: (_, name: string, value) => {
      if (state[name] !== value) calls.push(`${name} = ${said(value)}`)
      state[name] = value
      return true
    },
  })
  paint(canvas as unknown as Canvas, commands, families)
  return calls.slice(calls.indexOf('lineJoin = round') + 1)
}

test('a shape is filled, then outlined', () => {
  expect(painted([{ kind: 'circle', x: 1, y: 2, r: 3, fill: '#fff', stroke: '#000', lineWidth: 2 }])).toEqual(
    [
      'beginPath',
      `ellipse 1 2 3 3 0 0 ${2 * Math.PI}`,
      'fillStyle = #fff',
      'fill',
      'strokeStyle = #000',
      'lineCap = round',
      'lineWidth = 2',
      'setLineDash []',
      'stroke',
    ],
  )
})

test('a group is moved, turned, scaled, and what comes after it stands where it stood', () => {
  const dot: Command = { kind: 'circle', x: 0, y: 0, r: 1 }
  const calls = painted([{ kind: 'group', x: 5, y: 6, turn: 90, scale: [2, 3], shapes: [dot] }, dot])
  const [moved, ...rest] = calls
  const [a, b, c, d, e, f] = moved!.split(' ').slice(1).map(Number) as [number, ...number[]]
  const at = (x: number, y: number) => [a * x + c! * y + e!, b! * x + d! * y + f!].map(Math.round)
  // Scaled first, then turned from the right to below, then moved.
  expect([at(0, 0), at(1, 0), at(0, 1)]).toEqual([
    [5, 6],
    [5, 8],
    [2, 6],
  ])
  expect(rest).toEqual([
    'beginPath',
    `ellipse 0 0 1 1 0 0 ${2 * Math.PI}`,
    'setTransform 1 0 0 1 0 0',
    'beginPath',
    `ellipse 0 0 1 1 0 0 ${2 * Math.PI}`,
  ])
})

test('a group in a group is where both take it', () => {
  const inner: Command = { kind: 'group', x: 10, turn: 30, shapes: [] }
  const calls = painted([{ kind: 'group', scale: 2, turn: 60, shapes: [inner] }])
  const [a, b, , , e, f] = calls[1]!.split(' ').slice(1).map(Number) as [number, ...number[]]
  expect([a, b]).toEqual([expect.closeTo(0), expect.closeTo(2)])
  expect([e, f]).toEqual([expect.closeTo(10), expect.closeTo(10 * Math.sqrt(3))])
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

test('many lines at once are one stroke', () => {
  const points = new Float32Array([0, 0, 1, 2, NaN, NaN, 3, 4, 5, 6])
  const calls = painted([{ kind: 'lines', points, stroke: '#111' }])
  expect(calls.filter((one) => /To|stroke$/.test(one))).toEqual([
    'moveTo 0 0',
    'lineTo 1 2',
    'moveTo 3 4',
    'lineTo 5 6',
    'stroke',
  ])
})

test('a pale group is painted elsewhere first, so that what lies under its shapes is not seen through them', () => {
  const shapes: Command[] = [
    { kind: 'circle', x: 0, y: 0, r: 1 },
    { kind: 'circle', x: 1, y: 0, r: 1 },
  ]
  const order: string[] = []
  const recorder = (name: string) => {
    const state: { [key: string]: unknown } = { globalAlpha: 1, canvas: {} }
    return new Proxy(state, {
      get: (own, key: string) => (key in own ? own[key] : () => (order.push(`${name} ${key}`), unmoved)),
      set(own, key: string, value) {
        if (key === 'globalAlpha') order.push(`${name} globalAlpha ${value}`)
        own[key] = value
        return true
      },
    })
  }
  const [canvas, over] = [recorder('page'), recorder('layer')]
  paint(
    canvas as unknown as Canvas,
    [{ kind: 'group', opacity: 0.5, shapes }],
    families,
    () => over as unknown as CanvasRenderingContext2D,
  )
  expect(order.filter((call) => call.endsWith('ellipse'))).toEqual(['layer ellipse', 'layer ellipse'])
  expect(order.slice(-3)).toEqual(['page globalAlpha 0.5', 'page drawImage', 'page setTransform'])
  expect(order).not.toContain('layer globalAlpha 0.5')
})

test('a single pale shape needs no layer', () => {
  const shapes: Command[] = [{ kind: 'circle', x: 0, y: 0, r: 1, fill: '#000' }]
  const layer = vi.fn()
  const state: { [key: string]: unknown } = { globalAlpha: 1 }
  const canvas = new Proxy(state, {
    get: (own, key: string) => (key in own ? own[key] : () => unmoved),
  })
  paint(canvas as unknown as Canvas, [{ kind: 'group', opacity: 0.5, shapes }], families, layer)
  expect(layer).not.toHaveBeenCalled()
})

describe('with canvases of its own', () => {
  interface Made {
    width: number
    height: number
    fills: number
  }
  const made: Made[] = []
  beforeEach(() => {
    made.length = 0
    vi.stubGlobal(
      'DOMMatrix',
      class {
        rotate = () => this
        scale = () => this
      },
    )
    vi.stubGlobal('document', {
      createElement() {
        const one = { width: 0, height: 0, fills: 0 }
        made.push(one)
        const own: { [key: string]: unknown } = { fill: () => (one.fills += 1) }
        const context = new Proxy(own, { get: (own, key: string) => own[key] ?? (() => unmoved) })
        return Object.assign(one, { getContext: () => context })
      },
    })
  })

  /** The calls of a canvas that is three times as fine, by the names of its methods and what is set. */
  function screen() {
    const shown: unknown[] = []
    const state: { [key: string]: unknown } = {
      getTransform: () => ({ a: 0, b: 3, c: -3, d: 0, e: 0, f: 0 }),
      drawImage: (...given: unknown[]) => shown.push(given.slice(1)),
      createPattern: () => ({ setTransform: () => null }),
    }
    const canvas = new Proxy(state, { get: (own, key: string) => own[key] ?? (() => null) })
    return { shown, state, canvas: canvas as unknown as Canvas }
  }

  const still = (turns: boolean): Command => ({
    kind: 'group',
    still: { x: -5, y: -5, width: 10, height: 10 },
    turns,
    shapes: [{ kind: 'circle', x: 0, y: 0, r: 4, fill: '#000' }],
  })
  const at = (x: number, shape: Command): Command => ({ kind: 'group', x, shapes: [shape] })

  test('what stays the same is painted once, and shown again wherever it moves', () => {
    const { shown, canvas } = screen()
    const shape = still(false)
    paint(canvas, [at(1, shape), at(2, shape)], families, vi.fn())
    expect(shown).toEqual([
      [-5, -5, 10, 10],
      [-5, -5, 10, 10],
    ])
    expect(made).toMatchObject([{ width: 30, height: 30, fills: 1 }])
  })

  test('what stays the same is painted again once other letters have come', () => {
    const { canvas } = screen()
    const shape = still(false)
    paint(canvas, [shape], families, vi.fn())
    paint(canvas, [shape], { ...families }, vi.fn())
    expect(made).toHaveLength(2)
  })

  test('of what grows only the new part is painted, over a picture of the rest', () => {
    const { canvas } = screen()
    const [a, b, c] = [1, 2, 3].map((r): Command => ({ kind: 'circle', x: 0, y: 0, r, fill: '#000' }))
    const bounds = { x: -5, y: -5, width: 10, height: 10 }
    const trail = (...shapes: Command[]): Command => ({ kind: 'group', still: bounds, grows: true, shapes })
    for (const one of [trail(a!, b!), trail(a!, b!, c!), trail(b!)]) paint(canvas, [one], families, vi.fn())
    expect(made.map(({ fills }) => fills)).toEqual([2, 1, 1])
  })

  test('what turns is painted finer', () => {
    const { shown, canvas } = screen()
    paint(canvas, [at(1, still(true))], families, vi.fn())
    expect(made).toMatchObject([{ width: 45, height: 45, fills: 1 }])
    expect(shown).toEqual([[-5, -5, 10, 10]])
  })

  test('stripes are a pattern that is made once', () => {
    const { canvas, state } = screen()
    const line: Command = {
      kind: 'line',
      points: [],
      stroke: '#111',
      stripes: { on: '#fff', colour: '#123456', every: 7, width: 4 },
      flat: true,
    }
    paint(canvas, [line, line], families)
    expect(made).toMatchObject([{ width: 28, height: 28 }])
    expect(state.strokeStyle).toHaveProperty('setTransform')
    expect(state.lineCap).toBe('butt')
  })
})
