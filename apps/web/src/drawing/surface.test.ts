import { beforeEach, expect, test, vi } from 'vitest'
import type { Command, Group } from './commands.ts'
import type { PictureContext } from './picture.ts'
import { Surface, type Frame } from './surface.ts'

const families = { title: 'Baloo', read: 'Nunito' }
const frame = (more: Partial<Frame> = {}): Frame => ({
  shapes: [{ kind: 'circle', x: 5, y: 5, r: 2, fill: '#000' }],
  under: [],
  size: { width: 100, height: 50 },
  at: { x: 0, y: 0 },
  ratio: 2,
  families,
  ...more,
})

/** A canvas that records its calls. */
function canvas() {
  const calls: string[] = []
  const restored: (() => void)[] = []
  const element = {
    width: 300,
    height: 150,
    addEventListener: (name: string, act: () => void) => name === 'contextrestored' && restored.push(act),
  }
  const state: { [name: string]: unknown } = { canvas: element }
  const context = new Proxy(state, {
    get: (own, name: string) =>
      name in own
        ? own[name]
        : (...given: unknown[]) => {
            calls.push([name, ...given.filter((one) => typeof one === 'number')].join(' '))
            return { a: 1, b: 0, c: 0, d: 1, e: 0, f: 0 }
          },
  })
  return { calls, element, restored, context: context as unknown as PictureContext }
}

let one: ReturnType<typeof canvas>
let surface: Surface
beforeEach(() => {
  one = canvas()
  surface = new Surface(one.context, () => canvas().context)
  vi.useFakeTimers()
})

test('a canvas has the pixels of its screen, at twice and three times the density too', () => {
  for (const ratio of [1, 2, 3]) {
    surface.show(frame({ ratio }))
    expect(one.element).toMatchObject({ width: 100 * ratio, height: 50 * ratio })
    expect(one.calls).toContain(`setTransform ${ratio} 0 0 ${ratio} 0 0`)
  }
})

test('it is emptied, then painted from the lowest up', () => {
  const source = {} as ImageBitmap
  const under: Group = { kind: 'group', shapes: [{ kind: 'rect', x: 0, y: 0, width: 1, height: 1 }] }
  surface.show(frame({ under: [{ source, x: 1, y: 2, width: 3, height: 4 }, under] }))
  const order = one.calls.filter((call) => /clearRect|drawImage|roundRect|ellipse/.test(call))
  expect(order.map((call) => call.split(' ')[0])).toEqual(['clearRect', 'drawImage', 'roundRect', 'ellipse'])
})

test('a picture that has not changed is not painted again, and one that has only where it lies', () => {
  const shapes: readonly Command[] = [{ kind: 'circle', x: 0, y: 0, r: 1 }]
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => canvas().context }) })
  const at = (x: number): Command => ({
    kind: 'group',
    x,
    shapes: [{ kind: 'group', still: { x: -2, y: -2, width: 4, height: 4 }, shapes }],
  })
  surface.show(frame({ shapes: [at(10)] }))
  one.calls.length = 0
  surface.show(frame({ shapes: [at(10)] }))
  expect(one.calls).toEqual([])
  surface.show(frame({ shapes: [at(20)] }))
  expect(one.calls.filter((call) => call.startsWith('rect'))).toEqual([
    'rect 15 -5 10 10',
    'rect 35 -5 10 10',
  ])
  vi.unstubAllGlobals()
})

test('other letters, another size and what a browser has dropped are painted completely', () => {
  surface.show(frame())
  const painted = () => one.calls.splice(0).filter((call) => call.startsWith('clearRect')).length
  painted()
  surface.show(frame({ families: { ...families } }))
  surface.show(frame({ size: { width: 80, height: 50 } }))
  expect(painted()).toBe(2)
  one.restored.forEach((act) => act())
  expect(painted()).toBe(1)
})

test('a canvas that takes too long again and again goes on at half the density', () => {
  let now = 0
  vi.spyOn(performance, 'now').mockImplementation(() => (now += 13))
  for (let i = 0; i < 40; i += 1) surface.show(frame())
  expect(one.element).toMatchObject({ width: 100, height: 50 })
  vi.restoreAllMocks()
})
