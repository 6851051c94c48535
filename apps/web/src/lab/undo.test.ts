import { emptyBrain, withWeight } from '@botgarten/learning/neural-network/brain'
import { expect, test } from 'vitest'
import type { Change } from './change.ts'
import { UndoStack } from './undo.svelte.ts'

interface Done {
  readonly change: Change
  readonly back: Change
}

/** A stack that listens to a session which only writes down what is asked of it. */
function stack() {
  const asked: string[] = []
  const world = { tick: 0, hasFuture: false }
  const undo = new UndoStack({
    apply: (change) => asked.push(inWords(change)) > 0,
    hasFuture: () => world.hasFuture,
    now: () => world.tick,
    settle: () => undefined,
  })
  const at = (tick: number, { change, back }: Done, joined = false) => {
    world.tick = tick
    undo.hear({ kind: 'changed', change, back, joined })
  }
  const branch = (tick: number) => {
    world.hasFuture = true
    undo.hear({ kind: 'branched', tick })
  }
  return { undo, asked, world, at, branch }
}

function inWords(change: Change): string {
  if (change.kind === 'place') return `place ${change.id} ${change.after.x}`
  if (change.kind === 'brain') return `brain ${change.id} ${change.after.weights['a']?.['b'] ?? 0}`
  return change.kind
}

const place = (id: string, x: number): Change => ({ kind: 'place', id, after: { x, y: 0, heading: 0 } })
const moved = (id: string): Done => ({ change: place(id, 2), back: place(id, 1) })
const turned = (weight: number): Done => ({
  change: { kind: 'brain', id: 'net', after: withWeight(emptyBrain, 'a', 'b', weight) },
  back: { kind: 'brain', id: 'net', after: emptyBrain },
})
const edited: Done = {
  change: { kind: 'blocks', program: 'main', direction: 'redo' },
  back: { kind: 'blocks', program: 'main', direction: 'undo' },
}

test('steps go back and come again in order', () => {
  const { undo, asked, at } = stack()
  at(0, moved('box'))
  at(0, turned(0.5))
  for (let step = 0; step < 2; step++) undo.undo()
  for (let step = 0; step < 2; step++) undo.redo()
  expect(asked).toEqual(['brain net 0', 'place box 1', 'place box 2', 'brain net 0.5'])
})

test('rule 9: after going on from the past the other future is the one thing that comes again', () => {
  const { undo, asked, at, branch } = stack()
  at(100, moved('box'))
  at(300, turned(0.5))
  branch(200)
  expect([undo.canUndo, undo.canRedo]).toEqual([true, true])
  undo.redo()
  undo.undo()
  undo.undo()
  expect(asked).toEqual(['future', 'future', 'place box 1'])
})

test('rule 9: what was done at the very tick that is gone back to belongs to the other future', () => {
  const { undo, asked, at, branch } = stack()
  at(199, moved('box'))
  at(200, turned(0.5))
  branch(200)
  undo.undo()
  undo.undo()
  expect(asked).toEqual(['place box 1'])
})

test('rule 9: what is done in the new future does not lose the other one', () => {
  const { undo, asked, at, branch } = stack()
  branch(200)
  at(250, turned(0.5))
  undo.redo()
  undo.undo()
  undo.undo()
  undo.redo()
  expect(asked).toEqual(['future', 'future', 'brain net 0', 'brain net 0.5'])
})

test('what was done in the other future can be taken back there', () => {
  const { undo, asked, at, branch } = stack()
  at(300, turned(0.5))
  branch(200)
  undo.redo()
  undo.undo()
  expect(undo.canUndo).toBe(false)
  expect(asked).toEqual(['future', 'future'])
})

test('rule 9: a run that begins, or a block that is edited, ends the other future', () => {
  const { undo, world, at, branch } = stack()
  branch(200)
  world.hasFuture = false
  expect(undo.canRedo).toBe(false)
  branch(200)
  at(250, edited)
  expect(undo.canRedo).toBe(false)
})

test('a step that is joined goes back and comes again with the one before it', () => {
  const { undo, asked, at } = stack()
  at(0, moved('box'))
  at(0, edited)
  at(0, turned(0.5), true)
  undo.undo()
  expect(asked).toEqual(['brain net 0', 'blocks'])
  undo.redo()
  expect(asked).toEqual(['brain net 0', 'blocks', 'blocks', 'brain net 0.5'])
  expect(undo.count).toBe(3)
})

test('what is no step of a hand is not taken back', () => {
  const { undo, at, asked } = stack()
  undo.hear({ kind: 'changed', change: moved('box').change, back: null, joined: false })
  expect(undo.canUndo).toBe(false)
  at(0, turned(0.5))
  undo.hear({ kind: 'begun' })
  undo.undo()
  expect(asked).toEqual(['brain net 0'])
})

test.each(['config', 'scene'] as const)('rule 9: another %s ends the other future, too', (kind) => {
  const { undo, at, branch } = stack()
  branch(200)
  expect(undo.canRedo).toBe(true)
  const change = { kind, id: 'bo', after: {} } as unknown as Change
  at(250, { change, back: change })
  expect(undo.canRedo).toBe(false)
})
