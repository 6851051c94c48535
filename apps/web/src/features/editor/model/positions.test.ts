import type * as Blockly from 'blockly/core'
import { expect, test } from 'vitest'
import { forgetParted, part, positionOf, tidy } from './positions.ts'

interface Stack {
  readonly type?: string
  readonly x: number
  readonly y: number
  readonly height: number
}

/** A workspace whose stacks are boxes, 100 wide, with a hat of 10 above the position of the first block. */
function workspaceOf(stacks: { readonly [id: string]: Stack }) {
  const workspace = {
    getTopBlocks: () => blocks,
    resizeContents: () => {},
  } as unknown as Blockly.WorkspaceSvg
  const blocks = Object.entries(stacks).map(
    ([id, { type = 'robActions_motorDiff_stop', height, ...at }]) => ({
      ...{ id, type, workspace, isInsertionMarker: () => false },
      getRelativeToSurfaceXY: () => ({ ...at }),
      getBoundingRectangle: () => ({
        ...{ left: at.x, right: at.x + 100 },
        ...{ top: at.y - 10, bottom: at.y - 10 + height },
      }),
      moveBy: (x: number, y: number) => void ((at.x += x), (at.y += y)),
    }),
  ) as unknown as Blockly.BlockSvg[]
  const places = () =>
    blocks.map((block) => {
      const { x, y } = block.getRelativeToSurfaceXY()
      return [x, y]
    })
  return { workspace, blocks, places }
}

test('a stack that lies on another one moves below it, and its file keeps its place', () => {
  const { workspace, blocks, places } = workspaceOf({
    low: { x: 5, y: 50, height: 30 },
    high: { x: 10, y: 10, height: 60 },
    right: { x: 300, y: 20, height: 60 },
  })
  part(workspace)
  // The upper box ends at 10 - 10 + 60 = 60; 24 of air; the position is 10 below the top.
  expect(places()).toEqual([
    [5, 94],
    [10, 10],
    [300, 20],
  ])
  expect(blocks.map(positionOf)).toEqual([
    { x: 5, y: 50 },
    { x: 10, y: 10 },
    { x: 300, y: 20 },
  ])
  blocks[0]!.moveBy(5, 0)
  expect(positionOf(blocks[0]!)).toEqual({ x: 10, y: 94 })
})

test('a stack that moved apart has its shown place in another program', () => {
  const { workspace, blocks } = workspaceOf({
    a: { x: 0, y: 10, height: 60 },
    b: { x: 0, y: 50, height: 30 },
  })
  part(workspace)
  forgetParted(workspace)
  expect(positionOf(blocks[1]!)).toEqual({ x: 0, y: 94 })
})

test('the stack of the start block stays, whatever is above it', () => {
  const { workspace, places } = workspaceOf({
    above: { x: 0, y: 0, height: 60 },
    start: { type: 'robControls_start', x: 0, y: 40, height: 50 },
  })
  part(workspace)
  // The start box ends at 40 - 10 + 50 = 80.
  expect(places()).toEqual([
    [0, 114],
    [0, 40],
  ])
})

test('tidied, all stacks are below the start block in the order in which they are read', () => {
  const { workspace, places } = workspaceOf({
    third: { x: 400, y: 300, height: 20 },
    second: { x: 90, y: 300, height: 50.5 },
    fourth: { x: 500, y: 300, height: 20 },
    start: { type: 'robControls_start', x: 20, y: 200, height: 100 },
    first: { x: 500, y: 0, height: 40 },
  })
  tidy(workspace)
  const first = 200 - 10 + 100 + 24
  const second = first + 40 + 24
  const third = second + 75 // 50.5 + 24, rounded up
  const fourth = third + 20 + 24
  expect(places()).toEqual([third, second, fourth, 190, first].map((top) => [20, top + 10]))
})

test('an empty workspace has nothing to tidy', () => {
  const { workspace, places } = workspaceOf({})
  tidy(workspace)
  part(workspace)
  expect(places()).toEqual([])
})
