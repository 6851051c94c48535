import { emptyBrain, withWeight } from '@botgarten/learning/neural-network'
import { expect, test } from 'vitest'
import { UndoStack, type Step } from './undo.svelte.ts'

/** A stack over hands that only write down what they are asked for. */
function stack() {
  const asked: string[] = []
  const world = { tick: 0, hasFuture: false }
  const undo = new UndoStack({
    blocks: (direction, program) => asked.push(`blocks ${direction} ${program}`) > 0,
    robots: () => asked.push('robots'),
    place: (id, { x }) => asked.push(`place ${id} ${x}`),
    brain: (id, { weights }) => asked.push(`brain ${id} ${weights['a']?.['b'] ?? 0}`),
    config: (id) => asked.push(`config ${id}`),
    scene: () => asked.push('scene'),
    future: () => asked.push('future'),
    hasFuture: () => world.hasFuture,
    now: () => world.tick,
  })
  const at = (tick: number, step: Step) => {
    world.tick = tick
    undo.note(step)
  }
  const branch = (tick: number) => {
    world.hasFuture = true
    undo.branch(tick)
  }
  return { undo, asked, world, at, branch }
}

const pose = (x: number) => ({ x, y: 0, heading: 0 })
const moved = (id: string): Step => ({ kind: 'place', id, before: pose(1), after: pose(2) })
const turned = (weight: number): Step => ({
  ...{ kind: 'brain', id: 'net', before: emptyBrain },
  after: withWeight(emptyBrain, 'a', 'b', weight),
})

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
  at(250, { kind: 'blocks', program: 'main' })
  expect(undo.canRedo).toBe(false)
})
