import { expect } from '@playwright/test'
import { Learner } from './child-learning.ts'
import type { Child } from './child.ts'

/** Where something that sheet 4.3 explains is seen: in px of the picture, and the side on which its number stands. */
export interface Explained {
  readonly side: Side
  readonly x: number
  readonly y: number
}

type Side = 'top' | 'bottom' | 'left' | 'right'

/** The window, and what of it is in the picture: all below the head of the lab. In px. */
export const viewport = { width: 1366, height: 768 }
export const pictured = { x: 0, y: 122, width: 1366, height: 646 }

/** What is explained, in the order of the numbers on the sheet. */
const explained: readonly (readonly [selector: string, side: Side])[] = [
  ['.statistics > :nth-child(1)', 'top'],
  ['.statistics > :nth-child(2)', 'top'],
  ['.statistics > :nth-child(3)', 'top'],
  ['.statistics .decision', 'right'],
  ['.statistics .stars', 'right'],
  ['.drawer .tabs', 'right'],
  ['.drawer .table', 'right'],
  ['.drawer .lens', 'right'],
  ['.rail .ends', 'left'],
  ['.bar > button:first-child', 'bottom'],
  ['.bar > button:nth-child(2)', 'bottom'],
  ['.bar .tabs', 'bottom'],
  ['.bar .time', 'bottom'],
  ['.screen > .line', 'right'],
]

/** The card Railway with one move made: from then on nothing on the screen changes its place. */
export async function showsExplained(child: Child) {
  await new Learner(child).opens('railway')
  await child.presses('q.step')
  await expect(child.page.locator('.time output')).toHaveText(/^1 /)
}

/** Lets Bo learn until there are stars and a way, for a picture that has something to show. */
export async function learnsABit(child: Child) {
  await child.presses('q.times', { speed: 3 })
  await child.presses('lab.start')
  await expect(child.page.locator('.line .way')).toBeVisible({ timeout: 120_000 })
  await child.presses('q.pause')
  await child.seesSaved()
}

/** Takes the places from the page. */
export async function explainedPlaces(child: Child): Promise<readonly Explained[]> {
  const boxes = await Promise.all(
    explained.map(async ([selector, side]) => ({
      side,
      box: (await child.page.locator(selector).first().boundingBox())!,
    })),
  )
  return boxes.map(({ side, box }) => ({ side, ...pointIn(box, side) }))
}

interface Box {
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
}

/** On the edge that the number stands at. */
function pointIn({ x, y, width, height }: Box, side: Side) {
  const inside = 1
  const middle = { x: Math.round(x + width / 2), y: Math.round(y - pictured.y + height / 2) }
  const edges = {
    left: { ...middle, x: Math.round(x + inside) },
    right: { ...middle, x: Math.round(x + width - inside) },
    top: { ...middle, y: Math.round(y - pictured.y + inside) },
    bottom: { ...middle, y: Math.round(y - pictured.y + height - inside) },
  }
  return edges[side]
}
