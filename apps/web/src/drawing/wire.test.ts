import fc from 'fast-check'
import { expect, test } from 'vitest'
import type { Command, Group } from './commands.ts'
import type { Frame, Layer } from './surface.ts'
import { Receiver, Sender } from './wire.ts'

const dot = (x: number): Command => ({ kind: 'circle', x, y: 0, r: 1, fill: '#123456' })
const box = { x: -5, y: -5, width: 10, height: 10 }
const still = (...shapes: readonly Command[]): Group => ({ kind: 'group', still: box, shapes })
const frame = (shapes: readonly Command[], under: readonly Layer[] = []): Frame => ({
  shapes,
  under,
  size: { width: 100, height: 50 },
  at: { x: 0, y: 0 },
  ratio: 2,
  families: { title: 'Baloo', read: 'Nunito' },
})

/** Both ends with what a browser does to messages between them; what looks as before does not travel. */
function line() {
  const [sender, receiver] = [new Sender(), new Receiver()]
  let last: Frame | null = null
  return (one: Frame) => {
    const sent = sender.send(one)
    if (sent) last = receiver.receive(structuredClone(sent))
    return last!
  }
}

const shape: fc.Arbitrary<Command> = fc.letrec<{ shape: Command }>((tie) => ({
  shape: fc.oneof(
    { maxDepth: 3 },
    fc.integer({ max: 9 }).map(dot),
    fc
      .record({ shapes: fc.array(tie('shape'), { maxLength: 3 }), x: fc.integer(), isStill: fc.boolean() })
      .map(({ isStill, ...rest }) => ({
        kind: 'group' as const,
        ...(isStill ? { still: box } : {}),
        ...rest,
      })),
  ),
})).shape

test('what arrives is what was sent, frame after frame, whatever comes again', () => {
  const frames = fc
    .array(shape, { minLength: 1, maxLength: 6 })
    .chain((known) => fc.array(fc.array(fc.constantFrom(...known), { maxLength: 5 }), { maxLength: 6 }))
  fc.assert(
    fc.property(frames, (all) => {
      const travels = line()
      for (const shapes of all) expect(travels(frame(shapes)).shapes).toEqual(shapes)
    }),
  )
})

test('shapes of a picture travel once and are the same object then', () => {
  const [sender, receiver] = [new Sender(), new Receiver()]
  const look = still(dot(1), dot(2))
  const at = (x: number) => frame([{ kind: 'group', x, shapes: [look] }])
  const [first, second] = [sender.send(at(1))!, sender.send(at(2))!]
  expect([first, second].map(({ newStills }) => newStills.length)).toEqual([1, 0])
  const shapesOf = ({ shapes }: Frame) => ((shapes[0] as Group).shapes[0] as Group).shapes
  expect(shapesOf(receiver.receive(first))).toBe(shapesOf(receiver.receive(second)))
})

test('of what grows only the new part travels, and the old part stays the same objects', () => {
  const [sender, receiver] = [new Sender(), new Receiver()]
  const [a, b, c] = [dot(1), dot(2), dot(3)]
  const trail = (...shapes: readonly Command[]): Group => ({ ...still(...shapes), grows: true })
  const sent = [trail(a, b), trail(a, b, c), trail(b, c)].map((one) => sender.send(frame([], [one]))!)
  const lengths = sent.map(
    ({ newStills }) => (JSON.parse(newStills[0]!.shapes as string) as unknown[]).length,
  )
  expect(lengths).toEqual([2, 1, 2])
  const [before, after, other] = sent.map((one) => (receiver.receive(one).under[0] as Group).shapes)
  expect(after).toEqual([a, b, c])
  expect(after![0]).toBe(before![0])
  expect(other).toEqual([b, c])
})

test('pictures that are not shown any more are dropped, large ones soon, and come again when they are', () => {
  const [sender, receiver] = [new Sender(), new Receiver()]
  const [small, large] = [still(dot(-1)), { ...still(dot(-2)), still: { ...box, width: 1000, height: 500 } }]
  const sends = (...shapes: readonly Command[]) => {
    const sent = sender.send(frame(shapes))!
    expect(receiver.receive(structuredClone(sent)).shapes).toEqual(shapes)
    return sent
  }
  sends(small, large)
  const dropped = Array.from({ length: 400 }, (_, x) => sends(dot(x)).dropped.length)
  expect(dropped.flatMap((count, frame) => (count > 0 ? [frame] : []))).toEqual([3, 300])
  expect(sends(small, large).newStills).toHaveLength(2)
})

test('a picture travels once for as long as it is shown, and is let go then', () => {
  const closed: string[] = []
  class Bitmap {
    constructor(readonly name: string) {}
    close() {
      closed.push(this.name)
    }
  }
  Object.assign(globalThis, { ImageBitmap: Bitmap })
  const [sender, receiver] = [new Sender(), new Receiver()]
  const picture = (name: string) => ({ source: new Bitmap(name) as unknown as ImageBitmap, ...box })
  const [floor, other] = [picture('floor'), picture('other')]
  const sent = [[floor], [floor], [other], [floor]].map((under, x) => sender.send(frame([dot(x)], under))!)
  expect(sent.map(({ newSources }) => newSources.length)).toEqual([1, 0, 1, 1])
  const sources = sent.map((one) =>
    receiver.receive(one).under.map((layer) => (layer as typeof floor).source),
  )
  expect(sources).toEqual([[floor.source], [floor.source], [other.source], [floor.source]])
  expect(closed).toEqual(['floor', 'other'])
  Reflect.deleteProperty(globalThis, 'ImageBitmap')
})

test('what looks as before does not travel', () => {
  const sender = new Sender()
  expect(sender.send(frame([dot(1)]))).not.toBeNull()
  expect(sender.send(frame([dot(1)]))).toBeNull()
  expect(sender.send(frame([dot(2)]))).not.toBeNull()
})

test('rows of numbers with gaps arrive as they are', () => {
  const points = new Float32Array([1, 2, NaN, NaN, 3.5, 4])
  const field = still({ kind: 'lines', points, stroke: '#000' })
  expect(line()(frame([], [field])).under).toEqual([field])
})
